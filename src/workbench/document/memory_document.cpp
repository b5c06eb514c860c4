// SPDX-License-Identifier: BSD-2-Clause
// Memory: working memory as a tree that the user unfolds, a search, and the details of one element.
#include <algorithm>
#include <set>
#include <utility>

#include "workbench/document/build.h"
#include "workbench/document/element_spans.h"
#include "workbench/document/panels.h"

namespace soarbox::workbench::document {
namespace {

using debugger::MemoryObject;
using debugger::MemoryRow;

constexpr std::size_t kDeepestObject = 24, kMostFound = 200;

Button Small(std::string label, Action action, std::string hint = {}) {
  return {std::move(label), std::move(action), std::move(hint)};
}

/// Builds the tree of unfolded objects.
class Unfolded {
 public:
  explicit Unfolded(const Contents& contents) : contents_(contents) {}

  TreeRow Root(const std::string& id, const std::string& impasse) {
    TreeRow row;
    row.key = id;
    row.arguments = {id};
    row.spans.push_back({id, Role::kStrong});
    if (!impasse.empty()) row.spans.push_back({" " + impasse, Role::kWarn});
    Fill(id, row);
    return row;
  }
  bool HasSeen(const std::string& id) const { return seen_.contains(id); }

 private:
  void Fill(const std::string& id, TreeRow& row) {
    row.folds = true;
    const auto found = contents_.objects.find(id);
    if (found == contents_.objects.end()) return;
    row.is_open = true;
    seen_.insert(id);
    const MemoryObject& object = found->second;
    if (!object.about.empty() && path_.empty()) row.spans.push_back(Quiet(" " + object.about));
    path_.push_back(id);
    for (const MemoryRow& element : object.rows) row.below.push_back(Element(element));
    path_.pop_back();
    if (!object.note.empty()) row.below.push_back({"note", {Quiet(object.note)}});
    if (!object.exists && object.note.empty())
      row.below.push_back({"note", {Quiet("There is no " + id + " in working memory now.")}});
  }

  TreeRow Element(const MemoryRow& element) {
    TreeRow row;
    row.key = std::to_string(element.element.timetag);
    row.spans = ElementSpans(element);
    const bool is_loop =
        std::ranges::find(path_, element.element.value) != path_.end() || path_.size() > kDeepestObject;
    if (!element.element.is_object || element.change == debugger::Change::kRemoved || is_loop) return row;
    row.arguments = {element.element.value};
    Fill(element.element.value, row);
    return row;
  }

  const Contents& contents_;
  std::vector<std::string> path_;
  std::set<std::string> seen_;
};

Section ElementStoryPart(const Contents& contents, const debugger::ElementStory& story) {
  const mind::ElementFact& element = story.element;
  Section section{"element", {{ElementText(element), Role::kStrong}}, {}};
  section.is_story = true;
  Line tools;
  const auto step = [&](const char* label, std::uint64_t timetag, const char* hint) {
    Button button = Small(label, {ElementRequest{timetag}}, hint);
    button.is_enabled = timetag != 0;
    tools.nodes.push_back(std::move(button));
  };
  step("\xe2\x86\x90", contents.element_before, "Back to the previous element");
  step("\xe2\x86\x92", contents.element_after, "Forward again");
  tools.nodes.push_back(Small("Why?", AskWhy(WhyRequest::About::kElement, std::to_string(element.timetag)),
                              "Where does this element come from?"));
  if (element.is_object) tools.nodes.push_back(Small("Unfold " + element.value, {ObjectRequest{element.value, true}}));
  if (IsNumber(element.value))
    tools.nodes.push_back(
        Small("Plot it", {PlotRequest{contents.agent, element.id + "." + element.attribute, true}, PanelId::kPlots}));
  if (!contents.moment.is_recording) {
    const std::string what = "* ^" + element.attribute + " " + (element.is_object ? "*" : element.value);
    tools.nodes.push_back(
        Small("Break on such an element",
              {BreakRequest{debugger::BreakKind::kElement, contents.agent, what}, PanelId::kBreakpoints},
              "Stop the world when such an element appears"));
  }
  Button copy{"Copy", std::nullopt};
  copy.copies = ElementText(element);
  tools.nodes.push_back(std::move(copy));
  tools.nodes.push_back(Small("Close", {ElementRequest{0}}));
  section.nodes.push_back(std::move(tools));
  section.nodes.push_back(Text("time tag " + std::to_string(element.timetag), Role::kQuiet));
  if (!story.note.empty()) section.nodes.push_back(Text(story.note, Role::kQuiet));
  // If the kernel does not report the makers, the note says so; "no rule" would be wrong.
  const bool is_known = story.note.empty();
  if (is_known || !story.makers.empty()) section.nodes.push_back(Heading("Made by"));
  if (is_known && story.makers.empty()) section.nodes.push_back(Text("not known", Role::kQuiet));
  for (const mind::MakerFact& maker : story.makers) AddMaker(maker, section.nodes);
  if (is_known || !story.testers.empty()) section.nodes.push_back(Heading("Tested by"));
  if (is_known && story.testers.empty()) section.nodes.push_back(Text("no rule", Role::kQuiet));
  for (const mind::TesterFact& tester : story.testers) {
    std::string how =
        std::string(tester.negated ? ", negated" : ",") + " condition " + std::to_string(tester.condition + 1);
    if (tester.matches) how += ", in a match";
    section.nodes.push_back(
        Text(Spans{RuleLink(tester.rule), {std::move(how), tester.matches ? Role::kGood : Role::kQuiet}}));
  }
  return section;
}

}  // namespace

Nodes MemoryDocument(const Contents& contents) {
  Nodes nodes{LineForm("search", SearchMemoryRequest{},
                       {Field::Kind::kLine, "text", "Search in memory", "Search", contents.memory_search})};
  if (contents.story) nodes.push_back(ElementStoryPart(contents, *contents.story));
  if (!contents.memory_search.empty()) {
    const std::size_t count = contents.found.size();
    nodes.push_back(Heading(count >= kMostFound ? std::to_string(count) + " elements or more"
                                                : Count(count, "element", "elements")));
    Tree found{"found", "Found", {}};
    for (const mind::ElementFact& element : contents.found)
      found.rows.push_back({std::to_string(element.timetag), {ElementLink(element)}});
    nodes.push_back(std::move(found));
    return nodes;
  }
  Tree tree{"memory", "Working memory", {}};
  tree.press = RowAction{{ElementRequest{}}, "timetag", 0, kElementHint};
  tree.unfold = RowAction{{ObjectRequest{}}, "id", 1};
  Unfolded unfolded(contents);
  for (const debugger::StackLevel& level : contents.stack.levels)
    tree.rows.push_back(unfolded.Root(level.state, level.impasse));
  // Unfolded objects that no other unfolded object leads to come first.
  std::vector<TreeRow> others;
  for (const auto& [id, object] : contents.objects)
    if (!unfolded.HasSeen(id)) others.push_back(unfolded.Root(id, {}));
  tree.rows.insert(tree.rows.begin(), std::make_move_iterator(others.begin()), std::make_move_iterator(others.end()));
  nodes.push_back(std::move(tree));
  return nodes;
}

}  // namespace soarbox::workbench::document
