// SPDX-License-Identifier: BSD-2-Clause
#include "debugger/memory.h"

#include <algorithm>
#include <set>

#include "debugger/facts_text.h"
#include "debugger/recorded_mind.h"

namespace soarbox::debugger {
namespace {

constexpr std::size_t kMostRows = 2'000;

/// Describes an object: "state", "operator seek", or its ^name or ^type.
std::string AboutObject(const std::vector<explain::ElementFact>& elements) {
  std::string name, type;
  bool is_state = false;
  for (const explain::ElementFact& element : elements) {
    if (element.attribute == "superstate") is_state = true;
    if (element.attribute == "name" && !element.is_object) name = element.value;
    if (element.attribute == "type" && !element.is_object) type = element.value;
  }
  if (is_state) return name.empty() ? "state" : "state " + name;
  return name.empty() ? type : name;
}

class TreeReader {
 public:
  TreeReader(explain::Inspector& mind, const MemoryChanges& changes) : mind_(mind), changes_(changes) {}

  std::vector<MemoryRow> Read(std::string_view id, std::size_t depth, std::string* about, bool* exists) {
    std::vector<MemoryRow> rows;
    const std::vector<explain::ElementFact> elements = mind_.ElementsOf(id);
    opened_.insert(std::string(id));
    if (about != nullptr) *about = AboutObject(elements);
    if (exists != nullptr) *exists = !elements.empty();
    for (const explain::ElementFact& element : elements) {
      if (++count_ > kMostRows) break;
      MemoryRow& row = rows.emplace_back();
      row.element = element;
      row.change = changes_.WasAdded(element.timetag) ? Change::kAdded : Change::kNone;
      if (!element.is_object) continue;
      row.about = AboutObject(mind_.ElementsOf(element.value));
      if (depth > 1 && !opened_.contains(element.value)) row.below = Read(element.value, depth - 1, nullptr, nullptr);
    }
    for (const auto& [timetag, element] : changes_.removed())
      if (element.id == id) rows.push_back({element, "", Change::kRemoved, {}});
    return rows;
  }

  bool is_cut() const { return count_ > kMostRows; }

 private:
  explain::Inspector& mind_;
  const MemoryChanges& changes_;
  std::set<std::string> opened_;
  std::size_t count_ = 0;
};

void AppendRows(std::string& text, const std::vector<MemoryRow>& rows, std::size_t indent) {
  constexpr const char* kMarks[] = {"  ", "+ ", "- "};
  for (const MemoryRow& row : rows) {
    text += kMarks[static_cast<int>(row.change)] + std::string(2 * indent, ' ') + "^" + row.element.attribute + " " +
            row.element.value + (row.element.acceptable ? " +" : "") +
            (row.about.empty() ? "" : " (" + row.about + ")") + "  [" + std::to_string(row.element.timetag) + "]\n";
    AppendRows(text, row.below, indent + 1);
  }
}

}  // namespace

explain::ElementFact FactOf(const mind::ElementChanged& element) {
  return {element.timetag,    std::string(element.id), std::string(element.attribute), std::string(element.value),
          element.acceptable, element.is_object};
}

MemoryChanges::MemoryChanges(const mind::EventLog& events) {
  events.ForEachOf<mind::ElementChanged>([this](const mind::ElementChanged& element) {
    if (element.added) {
      added_[element.timetag] = FactOf(element);
    } else if (added_.erase(element.timetag) == 0) {
      removed_[element.timetag] = FactOf(element);
    }
  });
}

MemoryObject LookAtObject(explain::Inspector& mind, std::string_view id, const MemoryChanges& changes,
                          std::size_t depth) {
  MemoryObject object;
  object.id = id;
  TreeReader reader(mind, changes);
  object.rows = reader.Read(id, std::max<std::size_t>(depth, 1), &object.about, &object.exists);
  if (!object.exists) {
    object.note = MemoryAbsence(mind);
    if (object.note.empty()) object.note = "nothing is known of " + object.id + " now";
  }
  if (reader.is_cut()) object.note = "only the first " + std::to_string(kMostRows) + " elements are shown";
  return object;
}

std::optional<ElementStory> LookAtElement(explain::Inspector& mind, std::uint64_t timetag) {
  const std::optional<explain::ElementFact> element = mind.Element(timetag);
  if (!element) return std::nullopt;
  ElementStory story;
  story.element = *element;
  story.makers = mind.MakersOf(timetag);
  story.testers = mind.TestersOf(timetag);
  if (!mind.TellsAll()) story.note = "which rule made it and which rules test it: " + std::string(Absence(mind));
  return story;
}

std::vector<explain::ElementFact> SearchMemory(explain::Inspector& mind, std::string_view text, std::size_t most) {
  return mind.Search(text, most);
}

std::string ToText(const MemoryObject& object) {
  std::string text = object.id + (object.about.empty() ? "" : " (" + object.about + ")") + "\n";
  AppendRows(text, object.rows, 1);
  return text + (object.note.empty() ? "" : object.note + "\n");
}

std::string ToText(const ElementStory& story) {
  std::string text = "(" + std::to_string(story.element.timetag) + ": " + Describe(story.element) + ")\n";
  for (const explain::MakerFact& maker : story.makers) {
    text += "  made by " + Describe(maker) + "\n";
    for (const explain::ElementFact& element : maker.elements) text += "    from " + Describe(element) + "\n";
  }
  for (const explain::TesterFact& tester : story.testers) {
    text += "  tested by " + tester.rule + ", condition " + std::to_string(tester.condition + 1) +
            (tester.negated ? " (negated)" : "") + (tester.matches ? ", which matches" : "") + "\n";
  }
  return text + (story.note.empty() ? "" : "  " + story.note + "\n");
}

}  // namespace soarbox::debugger
