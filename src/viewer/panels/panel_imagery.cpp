// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>

#include "viewer/panels/mind_note.h"
#include "viewer/panels/panel.h"
#include "viewer/panels/why_tree.h"
#include "viewer/panels/widgets.h"

namespace soarbox::viewer {
namespace {

using debugger::SceneExtractRow;
using debugger::SceneNodeRow;
using debugger::SceneValueRow;
using debugger::SceneView;

std::string TagsText(const SceneNodeRow& node) {
  std::string text;
  for (const auto& [name, value] : node.tags) text += (text.empty() ? "^" : " ^") + name + " " + value;
  return text;
}

/// What it is about: its nodes, or what the filter was given.
std::string AboutText(const SceneValueRow& value) {
  std::string text;
  if (value.nodes.empty()) {
    const std::string& why = value.why.text;
    const std::size_t filter = why.find(": "), given = filter == std::string::npos ? filter : why.find(' ', filter + 2);
    return given == std::string::npos ? text : why.substr(given + 1);
  }
  for (const std::string& node : value.nodes) text += (text.empty() ? "" : ", ") + node;
  return text;
}

/// What a mind imagines, state by state: the tree of nodes, what rules ask, and the answers.
class ImageryPanel final : public Panel {
 public:
  void Draw(PanelFrame& frame) override {
    if (!HasMind(frame)) return;
    const debugger::ImageryView& view = frame.contents.imagery;
    if (!view.note.empty()) return EmptyNote(view.note);
    DrawChoice(frame, view);
    const Part scenes("scenes");
    for (const SceneView& scene : view.scenes) DrawScene(frame, scene, view.scenes.size() == 1);
  }

  std::string Text(const PanelFrame& frame) const override {
    return frame.contents.has_mind ? debugger::ToText(frame.contents.imagery) : std::string();
  }

 private:
  /// What of it is drawn over the world.
  static void DrawChoice(PanelFrame& frame, const debugger::ImageryView& view) {
    const auto choice = [&](const std::string& state, const std::string& label, const char* tip) {
      if (LitButton(label.c_str(), frame.contents.imagined_state == state, tip))
        frame.Ask(workbench::ImagineRequest{state, frame.contents.imagined_record});
    };
    ImGui::AlignTextToFramePadding();
    ColoredText(theme::kQuiet, "Draw");
    ImGui::SameLine();
    choice({}, "made up", "Draw what the agent made up in any state: what the world did not feed");
    for (const SceneView& scene : view.scenes) {
      const std::string label = "all of " + scene.state;
      FlowLine(ButtonWidth(label.c_str()));
      choice(scene.state, label, "Draw the whole scene of this state over the world");
    }
  }

  void DrawScene(PanelFrame& frame, const SceneView& scene, bool is_only) {
    const IdScope id(scene.state);
    Heading(frame, scene.state);
    if (!scene.extracts.empty()) {
      for (const SceneExtractRow& extract : scene.extracts) DrawExtract(frame, extract);
    } else {
      ColoredText(theme::kQuiet, "No rule asks anything of this scene.");
    }
    const std::string nodes = std::to_string(scene.nodes.size()) + (scene.nodes.size() == 1 ? " node" : " nodes");
    if (ImGui::TreeNodeEx("nodes", is_only ? ImGuiTreeNodeFlags_DefaultOpen : 0, "%s", nodes.c_str())) {
      DrawNodes(scene);
      ImGui::TreePop();
    }
  }

  static void DrawExtract(PanelFrame& frame, const SceneExtractRow& extract) {
    const IdScope id(extract.id);
    ColoredText(theme::kNumber, extract.filter.empty() ? extract.command : extract.filter);
    ImGui::SameLine();
    ColoredText(theme::kQuiet, extract.id + (extract.rule.empty() ? "" : ", asked by"));
    if (!extract.rule.empty()) {
      ImGui::SameLine();
      RuleLink(frame, extract.rule);
    }
    if (!extract.problem.empty()) WrappedText(theme::kBad, extract.problem + ": " + extract.hint);
    ImGui::Indent(frame.Px(14));
    for (const SceneValueRow& value : extract.values) DrawValue(frame, value);
    if (!extract.filter.empty() && extract.count == 0) ColoredText(theme::kQuiet, "no answer");
    if (extract.count > extract.values.size())
      ColoredText(theme::kQuiet, "and " + std::to_string(extract.count - extract.values.size()) + " more");
    ImGui::Unindent(frame.Px(14));
  }

  static void DrawValue(PanelFrame& frame, const SceneValueRow& value) {
    const bool is_shown = !value.record.empty() && frame.contents.imagined_record == value.record;
    const IdScope id(&value);
    if (ImGui::Selectable("##value", is_shown, ImGuiSelectableFlags_AllowItemOverlap) && !value.record.empty())
      frame.Ask(workbench::ImagineRequest{frame.contents.imagined_state, is_shown ? std::string() : value.record});
    Tooltip(value.lines.empty() ? "Click to see what it was made from"
                                : "Click to see it in the picture, and what it was made from");
    ImGui::SameLine(0, 0);
    ColoredText(theme::kText, ShortNumber(value.text));
    if (const std::string about = AboutText(value); !about.empty()) {
      ImGui::SameLine();
      CutText(about, theme::kQuiet);
    }
    if (is_shown) DrawWhyTree(frame, value.why);
  }

  static void DrawNodes(const SceneView& scene) {
    const float height = ImGui::GetTextLineHeightWithSpacing() * (static_cast<float>(scene.nodes.size()) + 1.5f);
    const List list("nodes", {{"Node", 3}, {"At", 3}, {"Tags", 4}},
                    ImGuiTableFlags_SizingStretchProp | ImGuiTableFlags_RowBg, height);
    if (!list) return;
    ForRowsInSight(scene.nodes.size(), [&](int i) {
      const SceneNodeRow& node = scene.nodes[static_cast<std::size_t>(i)];
      NextRow();
      ImGui::SetCursorPosX(ImGui::GetCursorPosX() + ImGui::GetFontSize() * 0.7f * static_cast<float>(node.depth));
      CutText(node.name, node.tags.contains("solid") ? theme::kText : theme::kVariable);
      ImGui::TableNextColumn();
      if (node.depth > 0) CutText(Formatted("%.2f, %.2f, %.2f", node.at[0], node.at[1], node.at[2]), theme::kQuiet);
      CutCell((node.shape == "hull" || node.depth == 0 ? "" : node.shape + " ") + TagsText(node), theme::kQuiet);
    });
  }
};

}  // namespace

std::unique_ptr<Panel> MakeImageryPanel() {
  return std::make_unique<ImageryPanel>();
}

}  // namespace soarbox::viewer
