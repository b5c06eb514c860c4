// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "mind/event.h"
#include "mind/event_log.h"

namespace soarbox::sim {

/// Converts the changes that a recorded client made to an agent's input link to percepts: it gives each element a path.
///
/// Call Note with the parts of each line `add`, `set` or `remove` of the client's log. Owned by the agent's mind.
class ClientPercepts {
 public:
  /// Records the changes of a line to the input link. `input_link`: name of the identifier of the input link. `log` may
  /// be null. Returns false if the line is about an element that is not below the input link.
  bool Note(const std::vector<std::string>& parts, std::string_view input_link, mind::EventLog* log);
  /// Call it after init-soar: the client adds everything again.
  void Clear();
  /// All attributes so far.
  const std::set<std::string>& attributes() const { return attributes_; }

 private:
  struct Place {
    std::string path;  ///< Ends with a dot, or is empty.
    std::string attribute;
    std::uint32_t key = 0;
  };
  bool NoteAdd(const std::vector<std::string>& parts, std::string_view input_link, mind::EventLog* log);
  std::uint32_t FreeKey(const Place& place);

  std::map<std::string, std::string, std::less<>> paths_;      ///< Paths of objects, by the client's names of them.
  std::map<std::string, Place, std::less<>> places_;           ///< Places of elements, by their handles.
  std::map<std::string, std::set<std::uint32_t>> taken_keys_;  ///< By path and attribute.
  std::set<std::string> attributes_;
};

/// Converts a value of the log to a percept. Valid as long as `text`.
mind::Value ClientValue(std::string_view type, const std::string& text);

}  // namespace soarbox::sim
