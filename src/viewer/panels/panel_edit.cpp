// SPDX-License-Identifier: BSD-2-Clause
#include <SDL_scancode.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <utility>

#include "viewer/panels/layout_audit.h"
#include "viewer/panels/panel.h"
#include "viewer/panels/rule_source.h"
#include "viewer/panels/text_history.h"
#include "viewer/panels/widgets.h"
#include "workbench/empty_panels.h"

namespace soarbox::viewer {
namespace {

int LineCount(std::string_view text) {
  return static_cast<int>(std::count(text.begin(), text.end(), '\n')) + 1;
}

/// A file of rules or a script, edited and reloaded while the world runs.
class EditPanel final : public Panel {
 public:
  void Draw(PanelFrame& frame) override {
    DrawFiles(frame);
    const workbench::EditContents& edit = frame.contents.edit;
    if (edit.file.empty()) {
      OpenOwnRules(frame);
      EmptyNote(
          frame.contents.moment.is_recording ? "A recording has no files to edit." : workbench::kEmptyEdit.what,
          frame.contents.moment.is_recording
              ? "Run its scenario, or go on from a moment of it: soarbox resume FILE --at SECONDS --rules NEW.soar"
              : workbench::kEmptyEdit.advice);
      return;
    }
    if (file_ != edit.file || version_ != edit.version) {
      const bool is_known = histories_.contains(edit.file);
      file_ = edit.file;
      version_ = edit.version;
      TextHistory& history = histories_[file_];
      is_known ? history.Note(edit.text, false) : history.Begin(edit.text);
      Take(edit.text);
    }
    if (edit.go_to_count != went_count_ || went_file_ != edit.file) {
      went_to_ = edit.go_to_line;
      went_count_ = edit.go_to_count;
      went_file_ = edit.file;
      if (went_to_ > 0) scroll_to_ = went_to_;
    }
    DrawFind();
    DrawButtons(frame);
    const auto& problems = edit.problems;
    const float below = problems.empty() ? 0 : std::min(frame.Px(150), ImGui::GetContentRegionAvail().y * 0.4f);
    DrawText(frame, below);
    if (!problems.empty()) DrawProblems(frame);
  }

  std::string Text(const PanelFrame& frame) const override {
    return frame.contents.edit.file.empty() ? std::string() : text_;
  }

 private:
  /// Shows a text that was not typed here.
  void Take(const std::string& text) {
    text_ = text;
    replaces_ = is_active_;  // The active field has its own copy of the text.
    Tokenize();
  }

  void Undo(PanelFrame& frame, bool forth) {
    TextHistory& history = histories_[file_];
    if (forth ? !history.CanRedo() : !history.CanUndo()) return;
    Take(forth ? history.Redo() : history.Undo());
    ScrollTo(history.changed_at());
    frame.Ask(workbench::EditTextRequest{workbench::EditTextRequest::What::kType, text_});
  }

  void ScrollTo(std::size_t place) { scroll_to_ = LineCount(std::string_view(text_).substr(0, place)); }

  void Tokenize() {
    tokens_ = debugger::Tokenize(text_);
    lines_ = LineCount(text_);
  }

  /// When the panel is first opened, it shows the rules of the selected agent.
  void OpenOwnRules(PanelFrame& frame) {
    const auto& files = frame.contents.files;
    if (files.empty() || !files.front().is_rules || frame.contents.moment.is_recording) return;
    if (const std::string own = files.front().file.string(); offered_ != own)
      frame.Ask(workbench::EditRequest{offered_ = own, 0});
  }

  static void DrawFiles(PanelFrame& frame) {
    const workbench::Contents& contents = frame.contents;
    const std::string now =
        contents.edit.file.empty() ? "Choose a file" : std::filesystem::path(contents.edit.file).filename().string();
    const bool can_find = !contents.edit.file.empty();
    ImGui::SetNextItemWidth(can_find ? ImGui::GetContentRegionAvail().x * 0.52f : -1);
    if (!ImGui::BeginCombo("##file", now.c_str())) return;
    const auto offer = [&](const std::filesystem::path& file) {
      const std::string name = file.string();
      const bool is_unsaved =
          std::any_of(contents.open_files.begin(), contents.open_files.end(),
                      [&](const workbench::OpenFile& open) { return open.file == name && open.is_unsaved; });
      const std::string label = file.filename().string() + (is_unsaved ? "  (not saved)" : "") + "##" + name;
      if (ImGui::Selectable(label.c_str(), name == contents.edit.file)) frame.Ask(workbench::EditRequest{name, 0});
      Tooltip(name);
    };
    for (const sim::WatchedFile& file : contents.files) offer(file.file);
    // Files that were opened for other agents stay in the list.
    for (const workbench::OpenFile& open : contents.open_files) {
      const bool is_listed = std::any_of(contents.files.begin(), contents.files.end(),
                                         [&](const sim::WatchedFile& file) { return file.file.string() == open.file; });
      if (!is_listed) offer(open.file);
    }
    ImGui::EndCombo();
  }

  void DrawButtons(PanelFrame& frame) {
    using What = workbench::EditTextRequest::What;
    const workbench::EditContents& edit = frame.contents.edit;
    const auto button = [&](const char* label, What what, const char* tip) {
      if (what != What::kApply) FlowLine(ButtonWidth(label), frame.Px(4));
      if (ImGui::Button(label)) frame.Ask(workbench::EditTextRequest{what, text_});
      Tooltip(tip);
    };
    button("Apply", What::kApply,
           "Use the text in the running world: changed rules replace the old ones, and working memory is kept. The "
           "file is not written. (Ctrl+Enter)");
    button("Check", What::kCheck, "Look for errors; change nothing");
    button("Save", What::kSave, "Write the file. (Ctrl+S)");
    button("Revert", What::kRevert, "Back to the file on disk; you can undo this, too");
    const TextHistory& history = histories_[file_];
    FlowLine(ButtonWidth("Undo"), frame.Px(4));
    const bool back = ButtonIf(history.CanUndo(), "Undo", "Undo the last change (Ctrl+Z)");
    FlowLine(ButtonWidth("Redo"), frame.Px(4));
    const bool forth = ButtonIf(history.CanRedo(), "Redo", "Redo the change that was undone (Ctrl+Y)");
    if (back || forth) Undo(frame, forth);
    FlowLine(ButtonWidth("Open in editor"), frame.Px(4));
    if (ImGui::Button("Open in editor")) frame.Ask(workbench::OpenFileRequest{edit.file, went_to_});
    Tooltip("With $VISUAL, $EDITOR or your desktop's editor; saved changes are reloaded automatically");
    const bool unsaved = text_ != edit.text || edit.is_unsaved, changed = text_ != edit.text || edit.is_changed;
    std::string state = edit.notice;
    if (changed)
      state = "not applied" + std::string(state.empty() ? "" : "; ") + state;
    else if (unsaved)
      state += state.empty() ? "not saved" : " Not saved yet.";
    const auto errors = std::count_if(edit.problems.begin(), edit.problems.end(),
                                      [](const Diagnostic& problem) { return problem.severity == Severity::kError; });
    if (!state.empty()) WrappedText(errors > 0 ? theme::kBad : changed ? theme::kWarn : theme::kGood, state);
  }

  /// Next to the file's name: Enter goes from one match to the next.
  void DrawFind() {
    ImGui::SameLine();
    if (std::exchange(goes_on_, false)) FocusNextField();
    if (SearchField("##find", "Find; Enter: next", find_)) Find();
    Tooltip(find_.empty() ? "Ctrl+F" : std::to_string(places_.size()) + " places; Enter goes to the next");
    if (WasEntered()) {
      if (!places_.empty()) ScrollTo(places_[place_ = (place_ + 1) % places_.size()]);
      goes_on_ = true;  // Enter was pressed again.
    }
    if (find_ != found_ || text_.size() != found_in_) Find();
    if (!places_.empty() || find_.empty()) return;
    ColoredText(theme::kWarn, "'" + find_ + "' is not in this file.");
  }

  void Find() {
    found_ = find_;
    found_in_ = text_.size();
    places_.clear();
    place_ = static_cast<std::size_t>(-1);
    for (std::size_t at = 0; !find_.empty() && (at = FindPart(text_, find_, at)) != std::string_view::npos; ++at)
      places_.push_back(at);
  }

  static int OnEdit(ImGuiInputTextCallbackData* data) {
    auto& self = *static_cast<EditPanel*>(data->UserData);
    if (data->EventFlag == ImGuiInputTextFlags_CallbackResize) {
      self.text_.resize(static_cast<std::size_t>(data->BufTextLen));
      data->Buf = self.text_.data();
    } else if (std::exchange(self.replaces_, false)) {
      const std::string text = self.text_;  // A copy, because the text may be moved while the field changes.
      const int caret = static_cast<int>(std::min(self.histories_[self.file_].changed_at(), text.size()));
      data->DeleteChars(0, data->BufTextLen);
      data->InsertChars(0, text.c_str());
      data->CursorPos = data->SelectionStart = data->SelectionEnd = caret;
    }
    return 0;
  }

  void DrawText(PanelFrame& frame, float below) {
    const FontScope mono(frame.fonts.mono);
    const float gutter = ImGui::CalcTextSize("00000").x;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + gutter);
    // The field has the text and the caret; the coloured text is drawn over the field's own text, which is transparent.
    ImGui::PushStyleColor(ImGuiCol_Text, ImVec4(0, 0, 0, 0));
    // The panel has its own history, which includes versions from the disk.
    const ImGuiInputTextFlags flags = ImGuiInputTextFlags_CallbackResize | ImGuiInputTextFlags_CallbackAlways |
                                      ImGuiInputTextFlags_AllowTabInput | ImGuiInputTextFlags_NoUndoRedo;
    const bool edited = ImGui::InputTextMultiline("##text", text_.data(), text_.capacity() + 1,
                                                  {-1, below > 0 ? -below : -1}, flags, &EditPanel::OnEdit, this);
    ImGui::PopStyleColor();
    if (edited) {
      constexpr double kPause_s = 1;
      const double now = ImGui::GetTime();
      histories_[file_].Note(text_, now - std::exchange(edited_at_, now) < kPause_s);
      Tokenize();
      frame.Ask(workbench::EditTextRequest{workbench::EditTextRequest::What::kType, text_});
    }
    const ImGuiIO& io = ImGui::GetIO();
    is_active_ = ImGui::IsItemActive();
    const auto asks = [&](int key) { return is_active_ && io.KeyCtrl && ImGui::IsKeyPressed(key); };
    const bool asks_redo = asks(ImGui::GetKeyIndex(ImGuiKey_Y));
    if (asks_redo || asks(ImGui::GetKeyIndex(ImGuiKey_Z))) Undo(frame, asks_redo || io.KeyShift);
    if (asks(ImGui::GetKeyIndex(ImGuiKey_Enter)))
      frame.Ask(workbench::EditTextRequest{workbench::EditTextRequest::What::kApply, text_});
    if (asks(SDL_SCANCODE_S)) frame.Ask(workbench::EditTextRequest{workbench::EditTextRequest::What::kSave, text_});
    MayCut(corner,
           ImGui::GetItemRectMax());  // Long lines continue beyond its right edge.
    const auto& children = ImGui::GetCurrentWindow()->DC.ChildWindows;
    if (!children.empty()) DrawOver(frame, *children.back(), corner, gutter);
  }

  void DrawOver(PanelFrame& frame, ImGuiWindow& field, ImVec2 corner, float gutter) {
    const float line = ImGui::GetFontSize();
    if (scroll_to_ > 0) {
      ImGui::SetScrollY(&field, std::max(0.0f, line * static_cast<float>(scroll_to_ - 4)));
      scroll_to_ = 0;
    }
    const ImVec2 at{field.InnerRect.Min.x + ImGui::GetStyle().FramePadding.x - field.Scroll.x,
                    field.InnerRect.Min.y + ImGui::GetStyle().FramePadding.y - field.Scroll.y};
    ImDrawList& out = *field.DrawList;
    const float top = field.InnerRect.Min.y, bottom = field.InnerRect.Max.y;
    out.PushClipRect(field.InnerRect.Min, field.InnerRect.Max, false);
    const workbench::EditContents& edit = frame.contents.edit;
    if (edit.stopped_line > 0) {
      const float y = at.y + line * static_cast<float>(edit.stopped_line - 1);
      out.AddRectFilled({field.InnerRect.Min.x, y}, {field.InnerRect.Max.x, y + line},
                        theme::Packed(theme::kWarn, 0.35f));
    }
    DrawPlaces(out, at, top, bottom);
    DrawSource(out, at, text_, tokens_, top, bottom);
    for (const Diagnostic& problem : frame.contents.edit.problems) {
      if (problem.line < 1) continue;
      const float y = at.y + line * static_cast<float>(problem.line);
      out.AddLine({at.x, y}, {field.InnerRect.Max.x, y}, theme::Packed(theme::ColorOf(problem.severity)),
                  frame.Px(1.5f));
    }
    out.PopClipRect();
    out.PushClipRect({corner.x, top}, {corner.x + gutter, bottom}, false);
    const int first = std::max(1, static_cast<int>((top - at.y) / line));
    const int last = std::min(lines_, static_cast<int>((bottom - at.y) / line) + 1);
    for (int number = first; number <= last; ++number) {
      const auto& problems = frame.contents.edit.problems;
      const bool is_bad = std::any_of(problems.begin(), problems.end(),
                                      [number](const Diagnostic& problem) { return problem.line == number; });
      const std::string text = Formatted("%4d", number);
      const float y = at.y + line * static_cast<float>(number - 1);
      PutText(out, {corner.x, y}, theme::Packed(is_bad ? theme::kBad : theme::kQuiet), text.c_str());
      if (std::ranges::find(edit.stops, number) != edit.stops.end())
        out.AddCircleFilled({corner.x + line * 0.35f, y + line / 2}, line * 0.3f, theme::Packed(theme::kBad));
    }
    out.PopClipRect();
    if (edit.can_stop) SetStop(frame, {corner.x, top}, {corner.x + gutter, bottom}, at.y);
  }

  /// A click on the number of a line sets a stop there, or removes it. The first line is at `y`.
  static void SetStop(PanelFrame& frame, ImVec2 from, ImVec2 to, float y) {
    if (!ImGui::IsWindowHovered() || !ImGui::IsMouseHoveringRect(from, to)) return;
    Tooltip("Click: scripts stop at this line, or no longer");
    if (!ImGui::IsMouseClicked(ImGuiMouseButton_Left)) return;
    const workbench::EditContents& edit = frame.contents.edit;
    const int line = static_cast<int>((ImGui::GetMousePos().y - y) / ImGui::GetFontSize()) + 1;
    const bool is_on = std::ranges::find(edit.stops, line) == edit.stops.end();
    frame.Ask(workbench::LineStopRequest{edit.file, line, is_on});
  }

  /// Highlights the matches; the current one is brighter.
  void DrawPlaces(ImDrawList& out, ImVec2 at, float top, float bottom) const {
    const float height = ImGui::GetFontSize();
    std::size_t begin = 0;
    float y = at.y;
    for (std::size_t i = 0; i < places_.size() && y <= bottom; ++i) {
      if (places_[i] + find_.size() > text_.size()) return;
      for (std::size_t end; (end = text_.find('\n', begin)) < places_[i]; begin = end + 1) y += height;
      if (y + height < top || y > bottom) continue;
      const char* line = text_.data() + begin;
      const char* place = text_.data() + places_[i];
      const float x = at.x + ImGui::CalcTextSize(line, place).x;
      const float width = ImGui::CalcTextSize(place, place + find_.size()).x;
      out.AddRectFilled({x, y}, {x + width, y + height}, theme::Packed(theme::kWarn, i == place_ ? 0.55f : 0.28f), 2);
    }
  }

  void DrawProblems(PanelFrame& frame) {
    const Part problems("problems");
    int number = 0;
    for (const Diagnostic& problem : frame.contents.edit.problems) {
      const IdScope id(++number);
      const std::string line = problem.line > 0 ? "line " + std::to_string(problem.line) : "file";
      if (Link("line", line, theme::ColorOf(problem.severity))) scroll_to_ = problem.line;
      ImGui::SameLine();
      WrappedText(problem.message);
      if (!problem.hint.empty()) WrappedText(theme::kGood, problem.hint);
    }
  }

  std::string file_, text_, went_file_, find_, found_;
  std::string offered_;  ///< The file that was opened automatically; if that failed, it is not tried again.
  std::map<std::string, TextHistory> histories_;  ///< By file.
  bool is_active_ = false;                        ///< The field had the keyboard in the last frame.
  bool replaces_ = false;                         ///< The active field must be set to text_.
  double edited_at_ = -10;
  std::vector<std::size_t> places_;  ///< The occurrences of `found_` in the text.
  std::size_t place_ = static_cast<std::size_t>(-1), found_in_ = 0;
  bool goes_on_ = false;
  std::uint64_t went_count_ = 0;
  std::uint64_t version_ = 0;
  int went_to_ = 0, scroll_to_ = 0, lines_ = 1;
  std::vector<debugger::Token> tokens_;
};

}  // namespace

std::unique_ptr<Panel> MakeEditPanel() {
  return std::make_unique<EditPanel>();
}

}  // namespace soarbox::viewer
