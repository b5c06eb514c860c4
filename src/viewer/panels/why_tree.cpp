// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/panels/why_tree.h"

#include <algorithm>
#include <cctype>
#include <string>

#include "viewer/panels/widgets.h"

namespace soarbox::viewer {
namespace {

using debugger::WhyNode;

ImVec4 ColorOfReason(const std::string& kind) {
  if (kind == "agent") return theme::kText;
  if (kind == "command") return theme::kNumber;
  if (kind == "operator") return theme::kGood;
  if (kind == "preference") return theme::kWarn;
  if (kind == "rule") return theme::kAccent;
  if (kind == "element") return theme::kVariable;
  if (kind == "learned") return theme::kWarn;
  if (kind == "condition") return theme::kText;
  if (kind == "percept") return theme::kGood;
  return theme::kQuiet;
}

void FollowReason(PanelFrame& frame, const WhyNode& node) {
  using About = workbench::WhyRequest::About;
  if (node.kind == "rule") {
    frame.Ask(workbench::RuleRequest{node.link});
    frame.layout.Show(workbench::PanelId::kRules);
  } else if (node.kind == "learned") {
    frame.Ask(workbench::LearnedRuleRequest{node.link});
    frame.layout.Show(workbench::PanelId::kLearning);
  } else if (node.kind == "operator") {
    frame.Ask(workbench::WhyRequest{About::kOperator, node.link});
  } else if (node.kind == "command") {
    frame.Ask(workbench::WhyRequest{About::kCommand, node.link});
  } else if (node.kind == "agent") {
    for (const world::AgentSnapshot& agent : frame.scene.agents) {
      if (agent.name == node.link) frame.selected = agent.id;
    }
  } else if (std::all_of(node.link.begin(), node.link.end(), [](unsigned char c) { return std::isdigit(c) != 0; })) {
    frame.Ask(workbench::WhyRequest{About::kElement, node.link});
  }
}

void DrawReason(PanelFrame& frame, const WhyNode& node, int number, int depth, int open_to) {
  constexpr int kDeepest = 40;
  if (depth > kDeepest) return;
  ImGui::PushID(number);
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
    if (ImGui::MenuItem("Copy with everything below it")) ImGui::SetClipboardText(debugger::ToText(node, 0).c_str());
    ImGui::EndPopup();
  }
  if (!node.link.empty()) {
    if (ImGui::IsItemHovered()) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    if (ImGui::IsItemClicked()) FollowReason(frame, node);
    Tooltip(node.kind == "rule"      ? "Click to see this rule"
            : node.kind == "learned" ? "Click to see how it was learned"
                                     : "Click to ask further");
  }
  if (open) {
    int below = 0;
    for (const WhyNode& reason : node.below) DrawReason(frame, reason, ++below, depth + 1, open_to);
    ImGui::TreePop();
  }
  ImGui::PopID();
}

}  // namespace

void DrawWhyTree(PanelFrame& frame, const WhyNode& root, int open_to) {
  DrawReason(frame, root, 0, 0, open_to);
}

}  // namespace soarbox::viewer
