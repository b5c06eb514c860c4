// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "viewer/panels/command_field.h"
#include "viewer/panels/panel.h"
#include "workbench/document/document.h"
#include "workbench/panel_id.h"

namespace soarbox::viewer {

/// Draws documents (workbench/document/document.h). It stores the user's settings by the keys of the document's parts:
/// filters, sorting, chosen pages, typed text. ImGui stores which parts are unfolded.
class DocumentView {
 public:
  /// The last table or tree fills the remaining height. Actions stay at the lower edge.
  void Draw(PanelFrame& frame, const workbench::document::Nodes& nodes);
  /// A command line that was typed and not sent; empty: none.
  std::string Unsent() const;

 private:
  struct TableState {
    std::string filter;
    int group = 0;
    int sorted_by = -1;  ///< A column; -1: the document's order.
    bool is_descending = false;
    std::vector<std::size_t> rows;  ///< Visible rows, in their order.
    std::vector<float> widths;      ///< Largest widths that the columns have needed so far, px.
    std::uint64_t revision = ~std::uint64_t{0}, measured = ~std::uint64_t{0};
    std::string arranged_for;
    float scale = 0, room = 0;
  };
  struct FieldState {
    std::string text, told;  ///< `told`: the last text of the document.
    int choice = 0;
    bool is_set = false, is_active = false;
  };

  void DrawNodes(PanelFrame& frame, const workbench::document::Nodes& nodes, bool fills);
  void DrawRange(PanelFrame& frame, const workbench::document::Nodes& nodes, std::size_t begin, std::size_t end,
                 bool fills);
  /// Draws the story at this index, with the node after it next to it if there is space.
  void DrawStory(PanelFrame& frame, const workbench::document::Nodes& nodes, std::size_t place);
  void DrawNode(PanelFrame& frame, const workbench::document::Node& node, bool fills);
  void DrawLine(PanelFrame& frame, const workbench::document::Line& line);
  void DrawButton(PanelFrame& frame, const workbench::document::Button& button);
  void DrawForm(PanelFrame& frame, const workbench::document::Form& form);
  bool DrawCommand(PanelFrame& frame, const workbench::document::Form& form, const workbench::document::Field& field,
                   float right);
  bool DrawField(const workbench::document::Form& form, const workbench::document::Field& field, float right);
  static bool DrawSuggested(const workbench::document::Form& form, const workbench::document::Field& field,
                            FieldState& state, float right);
  void Send(PanelFrame& frame, const workbench::document::Form& form);
  void DrawTable(PanelFrame& frame, const workbench::document::Table& table, bool fills);
  void Arrange(PanelFrame& frame, const workbench::document::Table& table, TableState& state) const;
  /// Returns the visible columns, and notes the widths that their texts need.
  static std::vector<std::size_t> MeasureColumns(PanelFrame& frame, const workbench::document::Table& table,
                                                 TableState& state, float room);
  void DrawTableBar(PanelFrame& frame, const workbench::document::Table& table, TableState& state);
  void DrawRows(PanelFrame& frame, const workbench::document::Table& table, TableState& state,
                const std::vector<std::size_t>& columns);
  void DrawTree(PanelFrame& frame, const workbench::document::Tree& tree);
  void DrawTranscript(PanelFrame& frame, const workbench::document::Transcript& transcript);
  /// Notes which section has news that the user waits for.
  void LookForNews(const workbench::document::Nodes& nodes);
  void DrawSection(PanelFrame& frame, const workbench::document::Section& section);
  void DrawTabs(PanelFrame& frame, const workbench::document::Tabs& tabs, bool fills);
  void DrawColumns(PanelFrame& frame, const workbench::document::Columns& columns);

  std::map<std::string, TableState> tables_;
  std::map<std::string, FieldState> fields_;
  std::map<std::string, CommandField> commands_;  ///< By the key of the form.
  CommandHistory history_;
  struct SeenLines {
    std::uint64_t count = 0;
    int frames = 0;           ///< Frames since lines were appended.
    bool is_followed = true;  ///< Whether the newest of them become visible.
  };
  std::map<std::string, SeenLines> seen_lines_;  ///< Of transcripts.
  bool shows_newest_ = false;                    ///< A command line was sent: its answer becomes visible.
  std::string active_command_;                   ///< The form whose command line had the keyboard last.
  int active_frame_ = -1;                        ///< The last frame in which that form had the keyboard.
  std::string focused_form_;                     ///< The form whose field takes the keyboard next.
  std::map<std::string, std::string> reasons_;   ///< Last reasons that documents gave for pages.
  float plot_height_ = 80;                       ///< Of the plots that are currently drawn, px.
  std::map<std::string, int> pages_;
  std::map<std::string, float> heights_;     ///< Of stories and actions when they were last drawn, px.
  std::map<std::string, std::string> news_;  ///< Of sections, by key.
  std::string section_to_show_;              ///< The section to scroll to, in the next frames.
  int frames_to_show_ = 0;
};

/// A panel that is described by a document.
class DocumentPanel final : public Panel {
 public:
  explicit DocumentPanel(workbench::PanelId panel) : panel_(panel) {}
  void Draw(PanelFrame& frame) override;
  std::string Text(const PanelFrame& frame) const override;
  std::string Unsent() const override;

 private:
  const workbench::PanelId panel_;
  workbench::document::Nodes nodes_;
  std::uint64_t revision_ = ~std::uint64_t{0};
  DocumentView view_;
};

}  // namespace soarbox::viewer
