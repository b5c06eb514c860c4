// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <vector>

#include "Export.h"

namespace sml {

class WMElement;
class WorkingMemory;

/// A buffered change of the input link that waits for Agent::Commit().
struct TagWme {
  bool remove = false;
  long long time_tag = 0;
  WMElement* wme = nullptr;  ///< The element to add; NULL for removals.
  unsigned int input = 0;    ///< For removals: the handle of the element in the connection to the kernel.
};

/// The buffered changes of the input link in the order in which they were made. They wait for Agent::Commit().
class EXPORT DeltaList {
 public:
  int GetSize() const { return static_cast<int>(changes_.size()); }
  /// Returns NULL if there is no such change.
  TagWme* GetDelta(int index);

 private:
  friend class WorkingMemory;
  std::vector<TagWme> changes_;
};

}  // namespace sml
