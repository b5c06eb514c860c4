// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <cctype>
#include <utility>

#include "debugger/facts_text.h"
#include "viewer/panels/mind_note.h"
#include "viewer/panels/panel.h"
#include "viewer/panels/widgets.h"

namespace soarbox::viewer {
namespace {

using debugger::Change;
using debugger::MemoryObject;
using debugger::MemoryRow;

/// Working memory as a tree that is unfolded object by object.
class MemoryPanel final : public Panel {
 public:
  void Draw(PanelFrame& frame) override {
    if (!HasMind(frame)) return;
    if (agent_ != frame.contents.agent) Begin(frame);
    if (!frame.shown_object.empty()) GoTo(frame, std::exchange(frame.shown_object, {}));
    DrawBar(frame);
    if (!search_.empty()) {
      DrawFound(frame);
      return;
    }
    const bool has_story = frame.contents.story.has_value();
    {
      const Part tree("tree", {0, has_story ? -ImGui::GetContentRegionAvail().y * 0.42f : 0},
                      ImGuiWindowFlags_HorizontalScrollbar);
      depth_ = 0;
      DrawObject(frame, root_);
    }
    if (has_story) DrawStory(frame, *frame.contents.story);
  }

  std::string Text(const PanelFrame& frame) const override {
    if (!frame.contents.has_mind || !frame.contents.not_available.empty()) return {};
    std::string text;
    if (!search_.empty()) {
      for (const explain::ElementFact& element : frame.contents.found)
        text.append("(").append(debugger::Describe(element)).append(")\n");
      return text;
    }
    if (const auto root = frame.contents.objects.find(root_); root != frame.contents.objects.end())
      text = debugger::ToText(root->second);
    return frame.contents.story ? text + debugger::ToText(*frame.contents.story) : text;
  }

 private:
  void Begin(PanelFrame& frame) {
    agent_ = frame.contents.agent;
    trail_.clear();
    at_ = 0;
    search_.clear();
    const auto& levels = frame.contents.stack.levels;
    GoTo(frame, levels.empty() ? "S1" : levels.front().state);
  }

  void GoTo(PanelFrame& frame, const std::string& id) {
    if (root_ != id || trail_.empty()) {
      trail_.resize(trail_.empty() ? 0 : at_ + 1);
      trail_.push_back(id);
      at_ = trail_.size() - 1;
    }
    root_ = id;
    search_.clear();
    frame.Ask(workbench::ObjectRequest{id, true});
  }

  void Step(PanelFrame& frame, int step) {
    at_ = static_cast<std::size_t>(static_cast<int>(at_) + step);
    root_ = trail_[at_];
    frame.Ask(workbench::ObjectRequest{root_, true});
  }

  void DrawBar(PanelFrame& frame) {
    if (ButtonIf(at_ > 0, "\xe2\x86\x90", "Back to the object looked at before")) Step(frame, -1);
    ImGui::SameLine(0, frame.Px(3));
    if (ButtonIf(at_ + 1 < trail_.size(), "\xe2\x86\x92", "Forward again")) Step(frame, 1);
    for (const debugger::StackLevel& level : frame.contents.stack.levels) {
      ImGui::SameLine(0, frame.Px(3));
      if (ImGui::GetContentRegionAvail().x < frame.Px(130)) break;
      if (ImGui::Button(level.state.c_str())) GoTo(frame, level.state);
      Tooltip("A state of the goal stack");
    }
    ImGui::SameLine(0, frame.Px(6));
    if (SearchField("##search", "Search", search_)) frame.Ask(workbench::SearchMemoryRequest{search_});
  }

  void DrawObject(PanelFrame& frame, const std::string& id) {
    const auto found = frame.contents.objects.find(id);
    if (found == frame.contents.objects.end()) {
      frame.Ask(workbench::ObjectRequest{id, true});
      return;
    }
    const MemoryObject& object = found->second;
    if (depth_ == 0) {
      Heading(frame, id, theme::kVariable);
      if (!object.about.empty()) {
        ImGui::SameLine();
        ColoredText(theme::kQuiet, object.about);
      }
    }
    if (!object.note.empty()) WrappedText(theme::kQuiet, object.note);
    if (!object.exists && object.note.empty())
      ColoredText(theme::kQuiet, "There is no " + id + " in working memory now.");
    for (const MemoryRow& row : object.rows) DrawRow(frame, row);
  }

  void DrawRow(PanelFrame& frame, const MemoryRow& row) {
    constexpr int kDeepest = 24;
    const explain::ElementFact& element = row.element;
    const IdScope id(static_cast<int>(element.timetag));
    bool open = false;
    const float label = ImGui::GetCursorPosX() + ImGui::GetTreeNodeToLabelSpacing() - frame.Px(5);
    if (element.is_object && row.change != Change::kRemoved && depth_ < kDeepest) {
      open = ImGui::TreeNodeEx("object", ImGuiTreeNodeFlags_None, "%s", "");
      if (ImGui::IsItemToggledOpen()) frame.Ask(workbench::ObjectRequest{element.value, open});
      ImGui::SameLine(0, 0);
    }
    ImGui::SetCursorPosX(label);
    const bool removed = row.change == Change::kRemoved;
    if (row.change == Change::kAdded) {
      ColoredText(theme::kGood, "+");
      Tooltip("New in this tick");
      ImGui::SameLine(0, frame.Px(4));
    } else if (removed) {
      ColoredText(theme::kBad, "\xe2\x88\x92");
      Tooltip("Gone in this tick");
      ImGui::SameLine(0, frame.Px(4));
    }
    ImGui::BeginGroup();
    ColoredText(removed ? theme::kQuiet : theme::kAccent, "^" + element.attribute);
    ImGui::SameLine(0, frame.Px(6));
    ColoredText(removed ? theme::kQuiet : ValueColor(element),
                ShortNumber(element.value) + (element.acceptable ? " +" : ""));
    if (!row.about.empty()) {
      ImGui::SameLine(0, frame.Px(6));
      ColoredText(theme::kQuiet, row.about);
    }
    ImGui::EndGroup();
    if (ImGui::IsItemClicked()) frame.Ask(workbench::ElementRequest{element.timetag});
    Tooltip("Click: which rule made it and which rules test it (time tag " + std::to_string(element.timetag) + ")");
    if (ImGui::BeginPopupContextItem("menu")) {
      if (element.is_object && ImGui::MenuItem("Begin the tree here")) GoTo(frame, element.value);
      if (ImGui::MenuItem("Where does it come from?"))
        frame.AskIn(workbench::PanelId::kWhy,
                    workbench::WhyRequest{workbench::WhyRequest::About::kElement, std::to_string(element.timetag)});
      if (ImGui::MenuItem("Break when such an element appears")) {
        const std::string what = "* ^" + element.attribute + " " + (element.is_object ? "*" : element.value);
        frame.AskIn(workbench::PanelId::kBreakpoints,
                    workbench::BreakRequest{debugger::BreakKind::kElement, frame.contents.agent, what});
      }
      const std::string path = element.id + "." + element.attribute;
      if (IsNumber(element.value) && ImGui::MenuItem("Plot it"))
        frame.AskIn(workbench::PanelId::kPlots, workbench::PlotRequest{frame.contents.agent, path, true});
      if (ImGui::MenuItem("Copy"))
        ImGui::SetClipboardText(("(" + element.id + " ^" + element.attribute + " " + element.value + ")").c_str());
      ImGui::EndPopup();
    }
    if (open) {
      ++depth_;
      DrawObject(frame, element.value);
      --depth_;
      ImGui::TreePop();
    }
  }

  void DrawFound(PanelFrame& frame) {
    const auto& found = frame.contents.found;
    ColoredText(theme::kQuiet,
                std::to_string(found.size()) + (found.size() == 200 ? " elements or more" : " elements"));
    const Part part("found", {0, 0}, ImGuiWindowFlags_HorizontalScrollbar);
    for (const explain::ElementFact& element : found) DrawElement(frame, element);
  }

  /// "(S1 ^io I1)" with its identifiers as links.
  void DrawElement(PanelFrame& frame, const explain::ElementFact& element) {
    const IdScope id(static_cast<int>(element.timetag));
    ColoredText(theme::kQuiet, "(");
    ImGui::SameLine(0, 0);
    if (Link("id", element.id, theme::kVariable)) GoTo(frame, element.id);
    ImGui::SameLine(0, frame.Px(5));
    ColoredText(theme::kAccent, "^" + element.attribute);
    ImGui::SameLine(0, frame.Px(5));
    if (!element.is_object) {
      ColoredText(ValueColor(element), element.value);
    } else if (Link("value", element.value, theme::kVariable)) {
      GoTo(frame, element.value);
    }
    ImGui::SameLine(0, 0);
    ColoredText(theme::kQuiet, ")");
  }

  void DrawStory(PanelFrame& frame, const debugger::ElementStory& story) {
    ImGui::Separator();
    const Part part("story");
    DrawElement(frame, story.element);
    ImGui::SameLine();
    if (ImGui::SmallButton("Close")) frame.Ask(workbench::ElementRequest{0});
    if (!story.note.empty()) WrappedText(theme::kQuiet, story.note);
    // What a kernel does not tell stands in the note; "no rule" would be wrong.
    const bool is_told = story.note.empty();
    if (is_told || !story.makers.empty()) Heading(frame, "Made by");
    if (is_told && story.makers.empty()) ColoredText(theme::kQuiet, "not known");
    int number = 0;
    for (const explain::MakerFact& maker : story.makers) {
      const IdScope id(number++);
      if (maker.kind == explain::MakerFact::Kind::kInput) {
        ColoredText(theme::kGood, "the world: it is a percept");
      } else if (maker.kind == explain::MakerFact::Kind::kArchitecture) {
        ColoredText(theme::kQuiet, "the architecture");
      } else {
        RuleLink(frame, maker.rule);
        for (const explain::ElementFact& element : maker.elements) {
          ImGui::Indent();
          DrawElement(frame, element);
          ImGui::Unindent();
        }
      }
    }
    if (is_told || !story.testers.empty()) Heading(frame, "Tested by");
    if (is_told && story.testers.empty()) ColoredText(theme::kQuiet, "no rule");
    for (const explain::TesterFact& tester : story.testers) {
      const IdScope id(number++);
      RuleLink(frame, tester.rule);
      ImGui::SameLine();
      ColoredText(tester.matches ? theme::kGood : theme::kQuiet,
                  (tester.negated ? "negated " : "") + std::string("condition ") +
                      std::to_string(tester.condition + 1) + (tester.matches ? ", in a match" : ""));
    }
  }

  static bool IsNumber(std::string_view value) {
    return !value.empty() && (std::isdigit(static_cast<unsigned char>(value.front())) != 0 ||
                              (value.size() > 1 && (value.front() == '-' || value.front() == '.')));
  }

  static ImVec4 ValueColor(const explain::ElementFact& element) {
    if (element.is_object) return theme::kVariable;
    return IsNumber(element.value) ? theme::kNumber : theme::kText;
  }

  std::string agent_, root_ = "S1", search_;
  std::vector<std::string> trail_;  ///< Objects looked at, to go back and forth along.
  std::size_t at_ = 0;
  int depth_ = 0;
};

}  // namespace

std::unique_ptr<Panel> MakeMemoryPanel() {
  return std::make_unique<MemoryPanel>();
}

}  // namespace soarbox::viewer
