// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "explain/inspector.h"
#include "mind/event_log.h"

namespace soarbox::debugger {

enum class Change : std::uint8_t { kNone, kAdded, kRemoved };

/// Elements that were added to or removed from a working memory in a tick, as recorded (MindDetail::kAll).
class MemoryChanges {
 public:
  MemoryChanges() = default;
  explicit MemoryChanges(const mind::EventLog& events);

  bool WasAdded(std::uint64_t timetag) const { return added_.contains(timetag); }
  const std::map<std::uint64_t, explain::ElementFact>& added() const { return added_; }
  /// Elements that existed before the tick and have been removed.
  const std::map<std::uint64_t, explain::ElementFact>& removed() const { return removed_; }

 private:
  std::map<std::uint64_t, explain::ElementFact> added_, removed_;
};

explain::ElementFact FactOf(const mind::ElementChanged& element);

struct MemoryRow {
  explain::ElementFact element;
  std::string about;  ///< For an object: its ^name or ^type, if it has one.
  Change change = Change::kNone;
  std::vector<MemoryRow> below;  ///< In a tree: the elements of the object.
};

/// An identifier with its elements.
struct MemoryObject {
  std::string id;
  std::string about;            ///< "state", "operator seek", "input-link", ...; empty if it is not known.
  bool exists = false;          ///< False if working memory has no such identifier.
  std::vector<MemoryRow> rows;  ///< Sorted by attribute; removed elements come last.
  std::string note;             ///< If not empty: why there are no rows, or why some are missing.
};

/// `depth`: number of levels of objects that are expanded; 1 means this object only. Each object is expanded once.
MemoryObject LookAtObject(explain::Inspector& mind, std::string_view id, const MemoryChanges& changes = {},
                          std::size_t depth = 1);

/// An element with the rules that made it and those that test it.
struct ElementStory {
  explain::ElementFact element;
  std::vector<explain::MakerFact> makers;    ///< What made it. Several rules may have made the same element.
  std::vector<explain::TesterFact> testers;  ///< Rules that test it.
  std::string note;
};
/// Returns nothing if there is no element with this time tag.
std::optional<ElementStory> LookAtElement(explain::Inspector& mind, std::uint64_t timetag);

/// Elements that contain `text` anywhere, by time tag.
std::vector<explain::ElementFact> SearchMemory(explain::Inspector& mind, std::string_view text, std::size_t most = 500);

std::string ToText(const MemoryObject& object);
std::string ToText(const ElementStory& story);

}  // namespace soarbox::debugger
