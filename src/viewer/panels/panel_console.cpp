// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <map>
#include <utility>

#include "viewer/panels/mind_note.h"
#include "viewer/panels/panel.h"
#include "viewer/panels/widgets.h"

namespace soarbox::viewer {
namespace {

ImVec4 LineColor(debugger::ConsoleLine::Kind kind) {
  using Kind = debugger::ConsoleLine::Kind;
  switch (kind) {
    case Kind::kInput:
      return theme::kAccent;
    case Kind::kOutput:
      return theme::kText;
    case Kind::kError:
      return theme::kBad;
    case Kind::kHint:
      return theme::kGood;
  }
  return theme::kText;
}

class ConsolePanel final : public Panel {
 public:
  void Draw(PanelFrame& frame) override {
    const workbench::Contents& contents = frame.contents;
    if (contents.agent != agent_) {
      // A line that was begun for one agent is kept until that agent is shown again.
      const auto begun = lines_.find(contents.agent);
      std::string next = begun != lines_.end() ? begun->second : contents.begun_line;
      if (begun != lines_.end()) lines_.erase(begun);
      if (!line_.empty()) lines_[agent_] = line_;
      line_ = replacement_ = kept_ = std::move(next);
      replaces_ = is_active_;  // The active field has its own copy of the text.
      agent_ = contents.agent;
      offered_.clear();
    }
    if (contents.agent.empty()) {
      EmptyNote("No agent is selected.", "Click one in the scene or in the list of agents to talk to its mind.");
      return;
    }
    if (contents.console == nullptr) return;
    if (!contents.has_mind && contents.console->lines().empty())
      EmptyNote(contents.agent + " has no Soar mind.",
                "Type Lua for its script: agent:GetPosition(), or lua-sandbox #Sandbox.GetAgents(sandbox).");
    DrawOutput(frame);
    Complete(frame);
    DrawField(frame);
  }

  std::string Text(const PanelFrame& frame) const override {
    return frame.contents.console == nullptr ? std::string() : debugger::ToText(frame.contents.console->lines());
  }

  std::string Unsent() const override {
    const auto is_line = [](const std::string& line) { return line.find_first_not_of(" \t") != std::string::npos; };
    if (is_line(line_)) return "Console: \"" + line_ + "\" was typed and not sent.";
    for (const auto& [agent, line] : lines_)
      if (is_line(line)) return "Console of " + agent + ": \"" + line + "\" was typed and not sent.";
    return {};
  }

 private:
  void DrawOutput(PanelFrame& frame) {
    const workbench::Contents& contents = frame.contents;
    const auto* lines = contents.console != nullptr ? &contents.console->lines() : nullptr;
    const float field =
        ImGui::GetFrameHeightWithSpacing() + (offered_.empty() ? 0 : ImGui::GetTextLineHeightWithSpacing());
    {
      ImGui::PushStyleColor(ImGuiCol_ChildBg, theme::kField);
      const Part output("output", {0, -field}, ImGuiWindowFlags_HorizontalScrollbar);
      ImGui::PopStyleColor();
      const FontScope mono(frame.fonts.mono);
      if (lines == nullptr || lines->empty())
        ColoredText(theme::kQuiet, "Type a Soar command: print s1, matches RULE, preferences, help ...");
      const auto draw = [&](int i) {
        const debugger::ConsoleLine& line = (*lines)[static_cast<std::size_t>(i)];
        const IdScope id(i);
        if (line.kind == debugger::ConsoleLine::Kind::kInput) {
          ColoredText(LineColor(line.kind), "> " + line.text);
        } else {
          TextWithPlace(frame, "place", line.text, LineColor(line.kind));
        }
      };
      ForRowsInSight(lines != nullptr ? lines->size() : 0, draw, ImGui::GetTextLineHeightWithSpacing());
      if (seen_lines_ != contents.console_lines) {
        ImGui::SetScrollHereY(1);
        if (++frames_since_new_ > 2) {  // The child window has its new height one frame later.
          seen_lines_ = contents.console_lines;
          frames_since_new_ = 0;
        }
      }
    }
    if (ImGui::BeginPopupContextItem("output-menu")) {
      if (ImGui::MenuItem("Copy all") && lines != nullptr) ImGui::SetClipboardText(debugger::ToText(*lines).c_str());
      if (ImGui::MenuItem("Clear")) frame.Ask(workbench::ClearConsoleRequest{});
      ImGui::EndPopup();
    }
  }

  void DrawField(PanelFrame& frame) {
    if (!offered_.empty()) CutText(offered_, ImGui::GetContentRegionAvail().x, theme::kQuiet);
    ImGui::AlignTextToFramePadding();
    ColoredText(theme::kAccent, frame.contents.agent + ">");
    ImGui::SameLine();
    const FontScope mono(frame.fonts.mono);
    ImGui::SetNextItemWidth(-1);
    constexpr ImGuiInputTextFlags kFlags = ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_CallbackHistory |
                                           ImGuiInputTextFlags_CallbackCompletion | ImGuiInputTextFlags_CallbackAlways |
                                           ImGuiInputTextFlags_CallbackResize;
    if (wants_focus_) FocusNextField();
    TakeFocus();
    wants_focus_ = false;
    asked_ = false;
    const bool entered = ImGui::InputTextWithHint("##line", "a Soar command; Tab completes", line_.data(),
                                                  line_.capacity() + 1, kFlags, &ConsolePanel::OnEdit, this);
    is_active_ = ImGui::IsItemActive();
    if (is_active_ && !line_.empty()) KeepKeyboard();
    if (asked_) frame.Ask(workbench::CompleteRequest{frame.contents.agent, line_});
    if (entered) Send(frame);
    if (line_ == kept_) return;
    kept_ = line_;
    frame.Ask(workbench::KeepLineRequest{frame.contents.agent, line_});
  }

  void Send(PanelFrame& frame) {
    wants_focus_ = true;
    if (line_.find_first_not_of(" \t") == std::string::npos) return;
    frame.Ask(workbench::ConsoleRequest{frame.contents.agent, line_});
    if (history_.empty() || history_.back() != line_) history_.push_back(line_);
    at_ = history_.size();
    line_.clear();
    offered_.clear();
  }

  /// Applies the result of the last Tab.
  void Complete(const PanelFrame& frame) {
    if (waiting_for_.empty() || frame.contents.completed_line != waiting_for_) return;
    waiting_for_.clear();
    const debugger::Completion& found = frame.contents.completion;
    offered_.clear();
    if (found.words.empty()) return;
    replacement_ = line_.substr(0, std::min(found.begin, line_.size())) + found.common;
    if (found.words.size() == 1) replacement_ += " ";
    replaces_ = true;
    if (found.words.size() < 2) return;
    for (const std::string& word : found.words) offered_ += (offered_.empty() ? "" : "  ") + word;
  }

  static int OnEdit(ImGuiInputTextCallbackData* data) {
    auto& self = *static_cast<ConsolePanel*>(data->UserData);
    switch (data->EventFlag) {
      case ImGuiInputTextFlags_CallbackResize:
        self.line_.resize(static_cast<std::size_t>(data->BufTextLen));
        data->Buf = self.line_.data();
        break;
      case ImGuiInputTextFlags_CallbackCompletion:
        self.waiting_for_.assign(data->Buf, static_cast<std::size_t>(data->BufTextLen));
        self.asked_ = !self.waiting_for_.empty();
        break;
      case ImGuiInputTextFlags_CallbackHistory:
        self.Recall(*data);
        break;
      case ImGuiInputTextFlags_CallbackAlways:
        if (self.replaces_) Replace(*data, self.replacement_);
        self.replaces_ = false;
        break;
      default:
        break;
    }
    return 0;
  }

  void Recall(ImGuiInputTextCallbackData& data) {
    if (history_.empty()) return;
    if (data.EventKey == ImGuiKey_UpArrow && at_ > 0) --at_;
    if (data.EventKey == ImGuiKey_DownArrow && at_ < history_.size()) ++at_;
    Replace(data, at_ < history_.size() ? history_[at_] : "");
  }

  static void Replace(ImGuiInputTextCallbackData& data, const std::string& text) {
    data.DeleteChars(0, data.BufTextLen);
    data.InsertChars(0, text.c_str());
  }

  std::string agent_;
  std::map<std::string, std::string> lines_;  ///< Lines that were begun and not sent, by agent, except that of agent_.
  std::string line_, offered_, waiting_for_, replacement_;
  std::string kept_;  ///< The application's copy of line_.
  bool asked_ = false, replaces_ = false, wants_focus_ = false, is_active_ = false;
  std::vector<std::string> history_;
  std::size_t at_ = 0;
  std::uint64_t seen_lines_ = 0;
  int frames_since_new_ = 0;
};

}  // namespace

std::unique_ptr<Panel> MakeConsolePanel() {
  return std::make_unique<ConsolePanel>();
}

}  // namespace soarbox::viewer
