// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <vector>

#include "Export.h"

namespace sml {

class WMElement;
class WorkingMemory;

/// One change of the output link.
class EXPORT WMDelta {
 public:
  enum ChangeType { kAdded = 1, kRemoved = 2 };

  WMDelta(ChangeType type, WMElement* pWME) : type_(type), wme_(pWME) {}
  ChangeType getChangeType() const { return type_; }
  WMElement* getWME() const { return wme_; }

 private:
  ChangeType type_;
  WMElement* wme_;
};

/// The changes of the output link since the list was last cleared, in order of arrival. Removed elements can be read
/// while they are in the list.
class EXPORT OutputDeltaList {
 public:
  int GetSize() const { return static_cast<int>(deltas_.size()); }
  /// Returns NULL if there is no such change.
  WMDelta* GetDeltaWME(int index);

 private:
  friend class WorkingMemory;
  std::vector<WMDelta> deltas_;
};

}  // namespace sml
