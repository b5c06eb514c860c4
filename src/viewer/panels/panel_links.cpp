// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <tuple>

#include "debugger/percept_help.h"
#include "viewer/panels/mind_note.h"
#include "viewer/panels/panel.h"
#include "viewer/panels/terms.h"
#include "viewer/panels/widgets.h"

namespace soarbox::viewer {
namespace {

using debugger::Change;
using debugger::CommandRow;
using debugger::MemoryRow;

/// What the agent perceives, and what it says.
class LinksPanel final : public Panel {
 public:
  void Draw(PanelFrame& frame) override {
    if (!HasMind(frame)) return;
    const debugger::IoView& io = frame.contents.io;
    Heading(frame, "Commands (output link)");
    TermTooltip("output link");
    if (io.commands.empty())
      WrappedText(theme::kQuiet, "There is no command on the output link. Rules give commands there.");
    int number = 0;
    for (const CommandRow& command : io.commands) {
      const IdScope id(++number);
      DrawCommand(frame, command);
    }
    ImGui::Separator();
    Heading(frame, "Percepts (input link)");
    TermTooltip("input link");
    SearchField("##filter", "Filter by attribute or value", filter_);
    const Part percepts("percepts");
    if (io.input.rows.empty())
      WrappedText(theme::kQuiet, io.input.note.empty() ? "It perceives nothing." : io.input.note);
    for (const MemoryRow& row : io.input.rows) DrawPercept(frame, row, {}, 0);
  }

  std::string Text(const PanelFrame& frame) const override {
    if (!frame.contents.has_mind || !frame.contents.not_available.empty()) return {};
    return debugger::ToText(frame.contents.io);
  }

 private:
  static ImVec4 StatusColor(const std::string& status) {
    if (status == "error") return theme::kBad;
    if (status == "complete") return theme::kGood;
    return status == "interrupted" ? theme::kQuiet : theme::kWarn;
  }

  static void DrawCommand(PanelFrame& frame, const CommandRow& command) {
    if (Link("name", command.name, theme::kNumber))
      frame.AskIn(workbench::PanelId::kWhy,
                  workbench::WhyRequest{workbench::WhyRequest::About::kCommand, command.name});
    Tooltip("Click to ask why it gives this command");
    ImGui::SameLine();
    Tag(command.status.empty() ? "under way" : command.status, StatusColor(command.status));
    if (command.progress >= 0) {
      ImGui::SameLine();
      ImGui::ProgressBar(static_cast<float>(command.progress), {frame.Px(80), ImGui::GetTextLineHeight()});
    }
    std::string parameters;
    for (const MemoryRow& row : command.parameters)
      parameters += (parameters.empty() ? "^" : "  ^") + row.element.attribute + " " + ShortNumber(row.element.value);
    ImGui::Indent();
    if (!parameters.empty()) WrappedText(theme::kQuiet, parameters);
    if (!command.reason.empty()) WrappedText(theme::kBad, command.reason);
    ImGui::Unindent();
  }

  bool IsWanted(const MemoryRow& row) const {
    if (filter_.empty() || HasPart(row.element.attribute, filter_) || HasPart(row.element.value, filter_)) return true;
    for (const MemoryRow& below : row.below) {
      if (IsWanted(below)) return true;
    }
    return false;
  }

  void DrawPercept(PanelFrame& frame, const MemoryRow& row, const std::string& above, int depth) {
    constexpr int kDeepest = 12;
    if (depth > kDeepest || !IsWanted(row)) return;
    const explain::ElementFact& element = row.element;
    const std::string path = above.empty() ? element.attribute : above + "." + element.attribute;
    const IdScope id(static_cast<int>(element.timetag));
    const bool open = element.is_object && !row.below.empty();
    ImGui::Dummy({frame.Px(14) * static_cast<float>(depth), 1});
    ImGui::SameLine(0, 0);
    if (row.change == Change::kAdded) {
      ColoredText(theme::kWarn, "\xe2\x80\xa2");
      Tooltip("Changed in this tick");
      ImGui::SameLine(0, frame.Px(4));
    }
    if (element.is_object) {
      if (Link("object", element.attribute)) ShowObject(frame, element.value);
      Tooltip(debugger::DescribePercept(path));
      if (!row.about.empty()) {
        ImGui::SameLine(0, frame.Px(6));
        CutText(row.about, theme::kQuiet);
      }
    } else {
      ColoredText(theme::kAccent, element.attribute);
      Tooltip(debugger::DescribePercept(path));
      ImGui::SameLine(0, frame.Px(8));
      std::string value = ShortNumber(element.value);
      const vocabulary::PerceptRow* known = debugger::PerceptOf(path);
      if (known != nullptr && !known->unit.empty()) value.append(" ").append(known->unit);
      CutText(value, row.change == Change::kRemoved ? theme::kQuiet : theme::kText);
    }
    if (open) {
      for (const MemoryRow& below : row.below) DrawPercept(frame, below, path, depth + 1);
    }
  }

  std::string filter_;
};

/// What agents said to each other.
class MessagesPanel final : public Panel {
 public:
  void Draw(PanelFrame& frame) override {
    if (frame.contents.messages == nullptr || frame.contents.messages->rows().empty()) {
      EmptyNote("No agent has sent a message yet.",
                "Agents talk with the commands say and broadcast: see docs/commands.md.");
      return;
    }
    if (!frame.contents.agent.empty()) {
      ImGui::Checkbox("selected agent", &only_selected_);
      Tooltip("Only messages that the selected agent sends or hears");
      ImGui::SameLine();
    }
    SearchField("##filter", "Search", filter_);
    Find(frame.contents.messages->revision(), only_selected_ ? frame.contents.agent : std::string{},
         *frame.contents.messages);
    const std::vector<debugger::MessageRow>& rows = rows_;
    // Where columns would leave no room for what is said, all of it is one text.
    constexpr float kNarrow_em = 22;
    const bool is_narrow = ImGui::GetContentRegionAvail().x < kNarrow_em * ImGui::GetFontSize();
    // As wide as the newest names are, so that the message has the rest.
    constexpr std::size_t kLookAt = 40;
    float from = ImGui::CalcTextSize("From").x, to = ImGui::CalcTextSize("To").x;
    for (std::size_t i = 0; i < std::min(rows.size(), kLookAt); ++i) {
      from = std::max(from, ImGui::CalcTextSize(rows[rows.size() - 1 - i].from.c_str()).x);
      to = std::max(to, ImGui::CalcTextSize(rows[rows.size() - 1 - i].to.c_str()).x);
    }
    const float most = 9 * ImGui::GetFontSize();
    constexpr ImGuiTableColumnFlags kFixed = ImGuiTableColumnFlags_WidthFixed;
    std::vector<ListColumn> columns{{"Time", ImGui::CalcTextSize("00:00.00").x, kFixed}};
    if (!is_narrow)
      columns.insert(columns.end(), {{"From", std::min(from, most), kFixed}, {"To", std::min(to, most), kFixed}});
    columns.push_back({"Message", 0, ImGuiTableColumnFlags_WidthStretch});
    const List list(is_narrow ? "messages-narrow" : "messages", columns, List::kUsual | ImGuiTableFlags_Resizable);
    if (!list) return;
    ForRowsInSight(rows.size(), [&](int i) {
      const debugger::MessageRow& row = rows[rows.size() - 1 - static_cast<std::size_t>(i)];  // The newest first.
      const IdScope id(i);
      NextRow();
      TimeLink(frame, row.tick, {}, theme::kQuiet);
      const std::string who = row.from.empty() ? "you" : row.from;
      if (is_narrow) return CutCell(who + " to " + row.to + ": " + row.text);
      CutCell(who);
      CutCell(row.to);
      CutCell(row.text);
    });
  }

  std::string Text(const PanelFrame& frame) const override {
    return frame.contents.messages == nullptr || rows_.empty() ? std::string() : debugger::ToText(rows_);
  }

 private:
  /// Looks again only if the messages or what is looked for have changed.
  void Find(std::uint64_t revision, std::string who, const debugger::MessageLog& messages) {
    const auto key = std::make_tuple(revision, std::move(who), filter_);
    if (key == key_) return;
    rows_ = messages.Find(std::get<1>(key), filter_);
    key_ = key;
  }

  bool only_selected_ = false;
  std::string filter_;
  std::tuple<std::uint64_t, std::string, std::string> key_;
  std::vector<debugger::MessageRow> rows_;
};

}  // namespace

std::unique_ptr<Panel> MakeLinksPanel() {
  return std::make_unique<LinksPanel>();
}
std::unique_ptr<Panel> MakeMessagesPanel() {
  return std::make_unique<MessagesPanel>();
}

}  // namespace soarbox::viewer
