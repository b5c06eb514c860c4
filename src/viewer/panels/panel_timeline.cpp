// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "viewer/panels/layout_audit.h"
#include "viewer/panels/panel.h"
#include "viewer/panels/widgets.h"
#include "workbench/empty_panels.h"

namespace soarbox::viewer {
namespace {

using debugger::MarkKind;
using debugger::TimelineMark;
using debugger::TimelineSpan;
using debugger::TimelineTrack;

/// How a kind of mark is drawn.
struct MarkLook {
  MarkKind kind;
  const ImVec4& color;
  int weight;  ///< Marks of larger weights are drawn over others.
  const char* meaning;
};
constexpr MarkLook kMarks[] = {{MarkKind::kCommand, theme::kNumber, 2, "a command that was given"},
                               {MarkKind::kOutcome, theme::kGood, 1, "how it went"},
                               {MarkKind::kMessage, theme::kVariable, 3, "a message to others"},
                               {MarkKind::kEvent, theme::kQuiet, 0, "another event"},
                               {MarkKind::kError, theme::kBad, 6, "an error or a warning"},
                               {MarkKind::kEdit, theme::kWarn, 4, "a command of yours, or an edit"},
                               {MarkKind::kLearned, theme::kAccent, 5, "a rule was learned"}};

const MarkLook& LookOf(MarkKind kind) {
  return *std::ranges::find(kMarks, kind, &MarkLook::kind);
}

/// An operator has the same colour everywhere.
ImVec4 ColorOf(const TimelineSpan& span) {
  if (span.is_state) return theme::kWarn;
  std::uint32_t hash = 2166136261u;
  for (const char c : span.text) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619u;
  return theme::Series(hash);
}

/// Kinds also differ in shape.
void DrawSign(ImDrawList& out, MarkKind kind, ImVec2 at, float r, float thick) {
  const ImU32 color = theme::Packed(LookOf(kind).color);
  const auto [x, y] = at;
  switch (kind) {
    case MarkKind::kCommand:
      out.AddTriangleFilled({x - r, y - r}, {x - r, y + r}, {x + r, y}, color);
      break;
    case MarkKind::kError:
      out.AddLine({x - r, y - r}, {x + r, y + r}, color, thick);
      out.AddLine({x - r, y + r}, {x + r, y - r}, color, thick);
      break;
    case MarkKind::kMessage:
      out.AddRectFilled({x - r, y - r * 0.7f}, {x + r, y + r * 0.7f}, color);
      break;
    case MarkKind::kEdit:
      out.AddTriangleFilled({x - r, y + r}, {x + r, y + r}, {x, y - r}, color);
      break;
    case MarkKind::kOutcome:
      out.AddCircle(at, r * 0.8f, color, 8, thick * 0.8f);
      break;
    case MarkKind::kLearned:
      // A diamond, larger than others because it is rare.
      out.AddQuadFilled({x - r * 1.3f, y}, {x, y - r * 1.3f}, {x + r * 1.3f, y}, {x, y + r * 1.3f}, color);
      break;
    case MarkKind::kEvent:
      out.AddCircleFilled(at, r * 0.8f, color, 8);
  }
}

/// The operators and states of each agent over time.
class TimelinePanel final : public Panel {
 public:
  void Draw(PanelFrame& frame) override {
    const debugger::Timeline* timeline = frame.contents.timeline;
    if (timeline == nullptr || timeline->empty()) {
      EmptyNote(workbench::kEmptyTimeline.what, workbench::kEmptyTimeline.advice);
      return;
    }
    const workbench::Moment& now = frame.contents.moment;
    const double last = static_cast<double>(std::max(now.last_tick, now.first_tick + 1));
    if (!is_zoomed_) {
      shown_ticks_ = std::clamp(last - static_cast<double>(now.first_tick), 60.0, 900.0);
      first_ = std::max(0.0, static_cast<double>(now.shown_tick) - shown_ticks_ * (now.is_live ? 1.0 : 0.6));
    }
    name_width_ = frame.Px(110);
    const Part tracks("tracks");
    left_ = ImGui::GetCursorScreenPos().x + name_width_;
    width_ = std::max(frame.Px(50), ImGui::GetContentRegionAvail().x - name_width_ - frame.Px(8));
    DrawRuler(frame);
    const float top = ImGui::GetCursorScreenPos().y;
    if (const TimelineTrack* selected = timeline->Find(frame.contents.agent);
        selected != nullptr && !frame.contents.agent.empty())
      DrawTrack(frame, *selected, true);
    for (const TimelineTrack* track : timeline->tracks()) {
      if (track->agent != frame.contents.agent || frame.contents.agent.empty()) DrawTrack(frame, *track, false);
    }
    const float bottom = ImGui::GetCursorScreenPos().y;
    DrawCursor(frame, top, bottom);
    HandleMouse(frame);
  }

  std::string Text(const PanelFrame& frame) const override {
    const debugger::Timeline* timeline = frame.contents.timeline;
    if (timeline == nullptr || timeline->empty()) return {};
    return debugger::ToText(debugger::TracksWithin(*timeline, {}, static_cast<std::uint64_t>(std::max(0.0, first_)),
                                                   static_cast<std::uint64_t>(std::max(0.0, first_ + shown_ticks_))));
  }

 private:
  float X(double tick) const { return left_ + width_ * static_cast<float>((tick - first_) / shown_ticks_); }
  double TickAt(float x) const { return first_ + static_cast<double>((x - left_) / width_) * shown_ticks_; }

  void DrawRuler(PanelFrame& frame) {
    ImDrawList& out = *ImGui::GetWindowDrawList();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const double step_s = frame.contents.moment.step_s, shown_s = shown_ticks_ * step_s;
    const double every = RoundStep_s(shown_s / std::max(1.0, static_cast<double>(width_ / frame.Px(80))));
    const double begin = first_ * step_s;
    for (double t = std::ceil(begin / every) * every; t < begin + shown_s; t += every) {
      const float x = X(t / step_s);
      out.AddLine({x, at.y}, {x, at.y + ImGui::GetTextLineHeight()}, theme::Packed(theme::kEdge));
      const std::string text = every < 1 ? Formatted("%.1f s", t) : Formatted("%.0f s", t);
      const float room = left_ + width_ - x;
      if (ImGui::CalcTextSize(text.c_str()).x + frame.Px(4) < room)
        PutText(out, {x + frame.Px(3), at.y}, theme::Packed(theme::kQuiet), text.c_str());
    }
    ColoredText(theme::kQuiet, "signs");
    if (ImGui::IsItemHovered()) DrawLegend(frame);
  }

  /// The meanings of bars and signs.
  static void DrawLegend(PanelFrame& frame) {
    ImGui::BeginTooltip();
    const float line = ImGui::GetTextLineHeight(), room = frame.Px(22);
    const auto row = [&](const char* meaning, const auto& draw) {
      const ImVec2 at = ImGui::GetCursorScreenPos();
      draw(*ImGui::GetWindowDrawList(), ImVec2(at.x + room * 0.4f, at.y + line / 2));
      ImGui::SetCursorPosX(ImGui::GetCursorPosX() + room);
      ImGui::TextUnformatted(meaning);
    };
    const auto bar = [&](ImVec4 color, float alpha) {
      return [=](ImDrawList& out, ImVec2 at) {
        const float half = line * 0.35f;
        out.AddRectFilled({at.x - half, at.y - half}, {at.x + half, at.y + half}, theme::Packed(color, alpha), 3);
      };
    };
    row("an operator, for as long as it is selected; the same colour, the same operator", bar(theme::kAccent, 0.42f));
    row("a substate: an impasse that is being worked on", bar(theme::kWarn, 0.25f));
    row("rules that fired in a tick, of the selected agent", bar(theme::kGood, 0.8f));
    for (const MarkLook& look : kMarks) {
      row(look.meaning, [&](ImDrawList& out, ImVec2 at) { DrawSign(out, look.kind, at, frame.Px(3.4f), frame.Px(2)); });
    }
    ImGui::EndTooltip();
  }

  void DrawTrack(PanelFrame& frame, const TimelineTrack& track, bool is_whole) {
    int lines = 1;
    const auto first = static_cast<std::uint64_t>(std::max(0.0, first_));
    const auto last = static_cast<std::uint64_t>(std::max(0.0, first_ + shown_ticks_));
    // The top state is always there. In a narrow track, only the operators of other states are drawn.
    const auto line_of = [&](const TimelineSpan& span) { return is_whole ? std::max(0, span.line - 1) : 0; };
    if (is_whole) {
      debugger::ForSpansWithin(track, first, last, [&](const TimelineSpan& span) {
        if (!(span.is_state && span.level == 1)) lines = std::max(lines, line_of(span) + 1);
      });
    }
    const float height = ImGui::GetTextLineHeight() + frame.Px(2);
    const float marks_height = frame.Px(11);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    // Firings are recorded only for the selected agent.
    const float fired_height = is_whole && !track.firings.empty() ? frame.Px(14) : 0;
    const float full = height * static_cast<float>(lines) + fired_height + marks_height + frame.Px(4);
    if (!ImGui::IsRectVisible({width_, full})) {
      ImGui::Dummy({1, full});
      return;
    }
    // In a window of its own: ImGui counts the vertices of a window with 16 bits.
    const Part part(("track " + track.agent).c_str(), {0, full},
                    ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    ImDrawList& out = *ImGui::GetWindowDrawList();
    if (ImGui::InvisibleButton("name", {name_width_ - frame.Px(6), full})) frame.Select(track.agent);
    Tooltip(track.agent.empty() ? std::string("What belongs to no agent") : track.agent + ": click to select");
    MayCut(at, {at.x + name_width_ - frame.Px(6), at.y + full});
    out.PushClipRect(at, {at.x + name_width_ - frame.Px(6), at.y + full}, true);
    PutText(out, {at.x, at.y}, theme::Packed(is_whole ? theme::kText : theme::kQuiet),
            track.agent.empty() ? std::string("world") : CutBeforeNumber(track.agent, name_width_ - frame.Px(8)));
    out.PopClipRect();
    out.PushClipRect({left_, at.y}, {left_ + width_, at.y + full}, true);
    std::map<int, float> drawn_to;  // The end of the last bar of each line, px.
    const auto draw = [&](const TimelineSpan& span) {
      if ((span.is_state && span.level == 1) || (!is_whole && span.is_state)) return;
      float& line_end = drawn_to.try_emplace(span.line, left_).first->second;
      const float ends = X(static_cast<double>(span.open ? frame.contents.moment.last_tick : span.last_tick) + 1);
      if (ends < line_end + 1) return;  // At most one bar per pixel.
      const float x = std::max(line_end, X(static_cast<double>(span.first_tick))),
                  end = std::max(x + frame.Px(2), ends);
      line_end = end;
      const float y = at.y + height * static_cast<float>(line_of(span));
      const ImVec4 color = ColorOf(span);
      const std::string& text = span.text.empty() ? span.id : span.text;
      if (ImGui::IsMouseHoveringRect({x, y}, {end, y + height})) hover_ = text + "  " + span.id;
      const bool is_wide = end - x >= frame.Px(14);
      out.AddRectFilled({x, y + 1}, {end, y + height - 1}, theme::Packed(color, span.is_state ? 0.25f : 0.42f),
                        is_wide ? 3.0f : 0.0f);
      if (end - x >= frame.Px(4)) out.AddRectFilled({x, y + 1}, {x + 1, y + height - 1}, theme::Packed(color));
      const float from = x + frame.Px(3);
      // The next bar begins in the tick in which the previous one ended, so the texts of both would overlap.
      const bool is_moment = !span.open && span.first_tick == span.last_tick;
      const float text_end = span.open || is_moment ? end - 1 : X(static_cast<double>(span.last_tick)) - 1;
      if (text_end - from > frame.Px(is_moment ? 60 : 13)) {
        out.PushClipRect({from, y}, {text_end, y + height}, true);
        MayCut({from, y}, {text_end, y + height});
        // Clipped letters cost as much as visible ones.
        const auto most = static_cast<std::size_t>((std::min(text_end, left_ + width_) - from) / frame.Px(2.5f)) + 1;
        PutText(out, {from, y + frame.Px(1)}, theme::Packed(theme::kText), std::string_view(text).substr(0, most));
        out.PopClipRect();
      }
    };
    debugger::ForSpansWithin(track, first, last, draw);
    const float below = at.y + height * static_cast<float>(lines);
    if (fired_height > 0) DrawFirings(frame, track, {at.x, below}, fired_height, first, last);
    DrawMarks(frame, track, below + fired_height + marks_height / 2, first, last);
    out.PopClipRect();
    out.AddLine({at.x, at.y + full - 1}, {left_ + width_, at.y + full - 1}, theme::Packed(theme::kEdge, 0.6f));
    DrawCursor(frame, at.y, at.y + full);
  }

  /// The number of rules that fired in each tick, as columns; the highest visible column fills the strip.
  void DrawFirings(PanelFrame& frame, const TimelineTrack& track, ImVec2 at, float height, std::uint64_t first,
                   std::uint64_t last) {
    ImDrawList& out = *ImGui::GetWindowDrawList();
    const auto begin = std::lower_bound(track.firings.begin(), track.firings.end(), first,
                                        [](const auto& firing, std::uint64_t tick) { return firing.first < tick; });
    std::uint32_t most = 1;
    auto end = begin;
    for (; end != track.firings.end() && end->first <= last; ++end) most = std::max(most, end->second);
    const float floor = at.y + height - frame.Px(2), room = height - frame.Px(4);
    float drawn_to = left_;
    for (auto firing = begin; firing != end; ++firing) {
      const float next = X(static_cast<double>(firing->first) + 1);
      if (next < drawn_to + 1) continue;  // One column per pixel.
      const float x = X(static_cast<double>(firing->first));
      drawn_to = next;
      const float top = floor - std::max(1.0f, room * static_cast<float>(firing->second) / static_cast<float>(most));
      const float right = std::max(x + 1, next - (next - x > 3 ? 1.0f : 0.0f));
      out.AddRectFilled({x, top}, {right, floor}, theme::Packed(theme::kGood, 0.8f));
      if (ImGui::IsMouseHoveringRect({x, at.y}, {right, floor}))
        hover_ = std::to_string(firing->second) + (firing->second == 1 ? " rule fired" : " rules fired");
    }
  }

  void DrawMarks(PanelFrame& frame, const TimelineTrack& track, float y, std::uint64_t first, std::uint64_t last) {
    const float r = frame.Px(3.4f);
    // By weight and place: the most important ones are drawn last.
    std::map<std::pair<int, int>, const TimelineMark*> shown;
    for (auto mark = std::ranges::lower_bound(track.marks, first, {}, &TimelineMark::tick);
         mark != track.marks.end() && mark->tick <= last; ++mark) {
      const float x = X(static_cast<double>(mark->tick));
      shown.try_emplace({LookOf(mark->kind).weight, static_cast<int>(x / r)}, &*mark);
      if (ImGui::IsMouseHoveringRect({x - r, y - r}, {x + r, y + r}))
        hover_ = std::string(debugger::NameOf(mark->kind)) + ": " + mark->text;
    }
    for (const auto& [place, mark] : shown)
      DrawSign(*ImGui::GetWindowDrawList(), mark->kind, {X(static_cast<double>(mark->tick)), y}, r, frame.Px(2));
  }

  void DrawCursor(PanelFrame& frame, float top, float bottom) {
    const workbench::Moment& now = frame.contents.moment;
    ImDrawList& out = *ImGui::GetWindowDrawList();
    if (now.branch_tick) {
      const float x = X(static_cast<double>(*now.branch_tick));
      if (x >= left_ && x <= left_ + width_)
        out.AddLine({x, top}, {x, bottom}, theme::Packed(theme::kVariable), frame.Px(1.5f));
    }
    const float x = X(static_cast<double>(now.shown_tick) + 0.5);
    if (x < left_ || x > left_ + width_ + 1) return;
    out.AddLine({x, top}, {x, bottom}, theme::Packed(now.is_live ? theme::kText : theme::kWarn), frame.Px(1.5f));
  }

  void HandleMouse(PanelFrame& frame) {
    const ImGuiIO& io = ImGui::GetIO();
    const bool over = ImGui::IsWindowHovered(ImGuiHoveredFlags_ChildWindows) && io.MousePos.x >= left_;
    if (!over) {
      hover_.clear();
      return;
    }
    const double tick = TickAt(io.MousePos.x);
    if (io.KeyCtrl && io.MouseWheel != 0) {
      is_zoomed_ = true;
      const double ticks = std::clamp(shown_ticks_ * std::pow(0.8, static_cast<double>(io.MouseWheel)), 10.0, 200000.0);
      first_ = tick - (tick - first_) * ticks / shown_ticks_;
      shown_ticks_ = ticks;
    }
    if (ImGui::IsMouseDragging(ImGuiMouseButton_Right)) {
      is_zoomed_ = true;
      first_ -= static_cast<double>(io.MouseDelta.x / width_) * shown_ticks_;
    }
    if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Right)) is_zoomed_ = false;
    if (ImGui::IsMouseClicked(ImGuiMouseButton_Left) && tick >= 0)
      frame.Ask(workbench::SeekRequest{static_cast<std::uint64_t>(tick)});
    ImGui::BeginTooltip();
    ImGui::TextUnformatted(TimeText(tick * frame.contents.moment.step_s).c_str());
    if (!hover_.empty()) {
      ImGui::PushTextWrapPos(ImGui::GetFontSize() * 24);
      ImGui::TextUnformatted(hover_.c_str());
      ImGui::PopTextWrapPos();
    }
    ImGui::TextDisabled("click: go there; Ctrl+wheel: zoom; right drag: move");
    ImGui::EndTooltip();
    hover_.clear();
  }

  bool is_zoomed_ = false;  ///< The user has chosen the shown span; else it follows the run.
  double first_ = 0, shown_ticks_ = 300;
  float name_width_ = 0, left_ = 0, width_ = 1;
  std::string hover_;
};

}  // namespace

std::unique_ptr<Panel> MakeTimelinePanel() {
  return std::make_unique<TimelinePanel>();
}

}  // namespace soarbox::viewer
