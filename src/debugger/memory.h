// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "debugger/json.h"
#include "explain/inspector.h"
#include "mind/event_log.h"

namespace soarbox::debugger {

enum class Change : std::uint8_t { kNone, kAdded, kRemoved };

/// What came into a working memory and left it in a tick, as it was noted (MindDetail::kAll).
class MemoryChanges {
 public:
  MemoryChanges() = default;
  explicit MemoryChanges(const mind::EventLog& events);

  bool WasAdded(std::uint64_t timetag) const { return added_.contains(timetag); }
  const std::map<std::uint64_t, explain::ElementFact>& added() const { return added_; }
  /// Elements that were there before the tick and are gone.
  const std::map<std::uint64_t, explain::ElementFact>& removed() const { return removed_; }

 private:
  std::map<std::uint64_t, explain::ElementFact> added_, removed_;
};

explain::ElementFact FactOf(const mind::ElementChanged& element);

struct MemoryRow {
  explain::ElementFact element;
  std::string about;  ///< Of an object: its ^name or ^type, if it has one.
  Change change = Change::kNone;
  std::vector<MemoryRow> below;  ///< Of trees: the object's elements.
};

/// An identifier with its elements.
struct MemoryObject {
  std::string id;
  std::string about;            ///< "state", "operator seek", "input-link", ...; empty if nothing is known.
  bool exists = false;          ///< False: working memory has no such identifier.
  std::vector<MemoryRow> rows;  ///< By attribute; what was removed comes last.
  std::string note;             ///< Not empty: why there is nothing, or less.
};

/// `depth`: how many levels of objects are opened; 1: this one alone. An object opens once.
MemoryObject LookAtObject(explain::Inspector& mind, std::string_view id, const MemoryChanges& changes = {},
                          std::size_t depth = 1);

/// Everything about one element.
struct ElementStory {
  explain::ElementFact element;
  std::vector<explain::MakerFact> makers;    ///< Who put it there; several rules may agree.
  std::vector<explain::TesterFact> testers;  ///< Rules that test it.
  std::string note;
};
/// Nothing if there is no element with this time tag.
std::optional<ElementStory> LookAtElement(explain::Inspector& mind, std::uint64_t timetag);

/// Elements with this text anywhere in memory, by time tag.
std::vector<explain::ElementFact> SearchMemory(explain::Inspector& mind, std::string_view text, std::size_t most = 500);

std::string ToText(const MemoryObject& object);
Json ToJson(const MemoryObject& object);
std::string ToText(const ElementStory& story);
Json ToJson(const ElementStory& story);

}  // namespace soarbox::debugger
