// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <string>

#include "viewer/panels/mind_note.h"
#include "viewer/panels/panel.h"
#include "viewer/panels/why_tree.h"
#include "viewer/panels/widgets.h"

namespace soarbox::viewer {
namespace {

using debugger::WhyKind;
using debugger::WhyNode;

ImVec4 ColorOfReason(WhyKind kind) {
  switch (kind) {
    case WhyKind::kAgent:
    case WhyKind::kCondition:
      return theme::kText;
    case WhyKind::kCommand:
    case WhyKind::kImagined:
      return theme::kNumber;
    case WhyKind::kOperator:
    case WhyKind::kPercept:
      return theme::kGood;
    case WhyKind::kPreference:
    case WhyKind::kLearned:
      return theme::kWarn;
    case WhyKind::kRule:
      return theme::kAccent;
    case WhyKind::kElement:
      return theme::kVariable;
    case WhyKind::kReason:
    case WhyKind::kRecall:
    case WhyKind::kTopic:
      break;
  }
  return theme::kQuiet;
}

void FollowReason(PanelFrame& frame, const WhyNode& node) {
  using About = workbench::WhyRequest::About;
  if (node.kind == WhyKind::kRule) {
    frame.AskIn(workbench::PanelId::kRules, workbench::RuleRequest{node.link});
  } else if (node.kind == WhyKind::kLearned) {
    frame.AskIn(workbench::PanelId::kLearning, workbench::LearnedRuleRequest{node.link});
  } else if (node.kind == WhyKind::kOperator) {
    frame.Ask(workbench::WhyRequest{About::kOperator, node.link});
  } else if (node.kind == WhyKind::kCommand) {
    frame.Ask(workbench::WhyRequest{About::kCommand, node.link});
  } else if (node.kind == WhyKind::kImagined) {
    frame.AskIn(workbench::PanelId::kImagery, workbench::ImagineRequest{frame.contents.imagined_state, node.link});
  } else if (node.kind == WhyKind::kAgent) {
    frame.Select(node.link);
  } else if (std::all_of(node.link.begin(), node.link.end(), [](unsigned char c) { return std::isdigit(c) != 0; })) {
    frame.Ask(workbench::WhyRequest{About::kElement, node.link});
  }
}

void DrawReason(PanelFrame& frame, const WhyNode& node, int number, int depth, int open_to) {
  constexpr int kDeepest = 40;
  if (depth > kDeepest) return;
  const IdScope id(number);
  const bool leaf = node.below.empty();
  const ImGuiTreeNodeFlags flags = (leaf ? ImGuiTreeNodeFlags_Leaf | ImGuiTreeNodeFlags_Bullet : 0) |
                                   (depth < open_to ? ImGuiTreeNodeFlags_DefaultOpen : 0);
  const float label = ImGui::GetCursorPosX() + ImGui::GetTreeNodeToLabelSpacing() - ImGui::GetFontSize() * 0.3f;
  const bool open = ImGui::TreeNodeEx("node", flags, "%s", "");
  ImGui::SameLine(0, 0);
  ImGui::SetCursorPosX(label);
  ImGui::BeginGroup();
  WrappedText(ColorOfReason(node.kind), node.text);
  ImGui::EndGroup();
  if (ImGui::BeginPopupContextItem("menu")) {
    const workbench::Moment& now = frame.contents.moment;
    if (node.time_s && now.can_go_back && ImGui::MenuItem("Go to that moment"))
      frame.Ask(workbench::SeekRequest{static_cast<std::uint64_t>(std::lround(*node.time_s / now.step_s))});
    if (ImGui::MenuItem("Copy with everything below it")) ImGui::SetClipboardText(debugger::ToText(node, 0).c_str());
    ImGui::EndPopup();
  }
  if (!node.link.empty()) {
    if (ClickedLikeALink()) FollowReason(frame, node);
    Tooltip(node.kind == WhyKind::kRule       ? "Click to see this rule"
            : node.kind == WhyKind::kImagined ? "Click to see it in the picture"
            : node.kind == WhyKind::kLearned  ? "Click to see how it was learned"
                                              : "Click to ask further");
  }
  if (open) {
    int below = 0;
    for (const WhyNode& reason : node.below) DrawReason(frame, reason, ++below, depth + 1, open_to);
    ImGui::TreePop();
  }
}

/// Why the agent does what it does, as a tree of reasons.
class WhyPanel final : public Panel {
 public:
  void Draw(PanelFrame& frame) override {
    const workbench::Contents& contents = frame.contents;
    if (contents.agent.empty()) {
      EmptyNote("No agent is selected.", "Click one: this panel then explains why it does what it does.");
      return;
    }
    if (ImGui::Button("Why this?")) frame.Ask(workbench::WhyRequest{});
    Tooltip("Why does the agent do what it does now?");
    ImGui::SameLine();
    SearchField("##not", "Why not ...", not_);
    if (WasEntered() && !not_.empty()) frame.Ask(workbench::WhyRequest{workbench::WhyRequest::About::kNot, not_});
    Tooltip("The name of an operator or a command, then Enter: why is it not chosen?");
    ImGui::Separator();
    ImGui::PushFont(frame.fonts.bold);
    WrappedText(contents.why.question);
    ImGui::PopFont();
    if (!contents.past_note.empty()) CutText("As recorded. " + contents.past_note, theme::kQuiet);
    if (!contents.why.answer) {
      WrappedText(theme::kQuiet,
                  contents.not_available.empty() ? "There is no answer to this." : contents.not_available);
      return;
    }
    const Part tree("tree");
    DrawWhyTree(frame, *contents.why.answer);
  }

  std::string Text(const PanelFrame& frame) const override {
    if (!frame.contents.why.answer) return {};
    return frame.contents.why.question + "\n" + debugger::ToText(*frame.contents.why.answer, 1);
  }

 private:
  std::string not_;
};

}  // namespace

void DrawWhyTree(PanelFrame& frame, const WhyNode& root, int open_to) {
  DrawReason(frame, root, 0, 0, open_to);
}

std::unique_ptr<Panel> MakeWhyPanel() {
  return std::make_unique<WhyPanel>();
}

}  // namespace soarbox::viewer
