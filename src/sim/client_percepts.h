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

/// What a recorded client has told an agent: names the elements of its input link by paths, so that they can be noted
/// as percepts.
///
/// Takes the lines `add`, `set` and `remove` of a client's log, as their parts. Owned by the agent's mind.
class ClientPercepts {
 public:
  /// Notes what the line changes on the input link. `input_link`: the name of the identifier of the input link. `log`
  /// may be null. False if the line is about an element elsewhere.
  bool Note(const std::vector<std::string>& parts, std::string_view input_link, mind::EventLog* log);
  /// init-soar: the client tells everything again.
  void Clear();
  /// All attributes so far.
  const std::set<std::string>& attributes() const { return attributes_; }

 private:
  struct Place {
    std::string path;  ///< With a dot at its end, or empty.
    std::string attribute;
    std::uint32_t key = 0;
  };
  bool NoteAdd(const std::vector<std::string>& parts, std::string_view input_link, mind::EventLog* log);
  std::uint32_t FreeKey(const Place& place);

  std::map<std::string, std::string, std::less<>> paths_;      ///< Of objects, by the names that the client gave them.
  std::map<std::string, Place, std::less<>> places_;           ///< Of elements, by their handles.
  std::map<std::string, std::set<std::uint32_t>> taken_keys_;  ///< By path and attribute.
  std::set<std::string> attributes_;
};

/// A value of the log as a percept has it. Valid as long as the text is.
mind::Value ClientValue(std::string_view type, const std::string& text);

}  // namespace soarbox::sim
