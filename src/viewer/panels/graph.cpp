// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/panels/graph.h"

#include <algorithm>
#include <cmath>

#include "viewer/panels/layout_audit.h"
#include "viewer/panels/widgets.h"

namespace soarbox::viewer {
namespace {

struct Range {
  double low = 0, high = 1;
  bool is_flat = false;  ///< There is only one value.
};

/// The shortest readable form: "68390", "0.25", "1.2e+07".
std::string NumberText(double value) {
  const double size = std::abs(value);
  return Formatted(size >= 1000 && size < 1e6 ? "%.0f" : "%.4g", value);
}

Range RangeOf(std::span<const GraphCurve> curves) {
  bool any = false;
  Range range;
  for (const GraphCurve& curve : curves) {
    for (const auto& [tick, value] : curve.points) {
      if (!std::isfinite(value)) continue;
      range.low = any ? std::min(range.low, value) : value;
      range.high = any ? std::max(range.high, value) : value;
      any = true;
    }
  }
  if (range.high - range.low < 1e-9) {
    range.is_flat = any;
    range.low -= 0.5;
    range.high += 0.5;
  }
  return range;
}

}  // namespace

void DrawGraph(PanelFrame& frame, const char* id, std::span<const GraphCurve> curves, float height, double first,
               double last, bool is_stepped) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = std::max(frame.Px(60), ImGui::GetContentRegionAvail().x);
  const bool clicked = ImGui::InvisibleButton(id, {width, height});
  const bool hovered = ImGui::IsItemHovered();
  ImDrawList& out = *ImGui::GetWindowDrawList();
  const ImVec2 end{at.x + width, at.y + height};
  out.AddRectFilled(at, end, theme::Packed(theme::kField), 4);
  const Range range = RangeOf(curves);
  const double span = std::max(1.0, last - first);
  const float pad = frame.Px(4);
  const auto x_of = [&](double tick) { return at.x + width * static_cast<float>((tick - first) / span); };
  const auto y_of = [&](double value) {
    return end.y - pad - (height - 2 * pad) * static_cast<float>((value - range.low) / (range.high - range.low));
  };
  out.PushClipRect(at, end, true);
  for (const GraphCurve& curve : curves) {
    std::vector<ImVec2> line;
    for (const auto& [tick, value] : curve.points) {
      if (!std::isfinite(value)) continue;
      if (is_stepped && !line.empty()) line.push_back({x_of(tick), line.back().y});
      line.push_back({x_of(tick), y_of(value)});
    }
    if (line.size() == 1) out.AddCircleFilled(line[0], frame.Px(2), theme::Packed(curve.color));
    out.AddPolyline(line.data(), static_cast<int>(line.size()), theme::Packed(curve.color), 0, frame.Px(1.6f));
  }
  const workbench::Moment& moment = frame.contents.moment;
  const float now = x_of(static_cast<double>(moment.shown_tick));
  out.AddLine({now, at.y}, {now, end.y}, theme::Packed(moment.is_live ? theme::kQuiet : theme::kWarn), 1);
  const float font = ImGui::GetFontSize();
  // With a background, so that they are legible over a curve.
  const auto label = [&](float y, double value) {
    const std::string text = NumberText(value);
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    out.AddRectFilled({at.x, y}, {at.x + size.x + 2 * pad, y + size.y}, theme::Packed(theme::kField, 0.8f), 3);
    PutText(out, {at.x + pad, y}, theme::Packed(theme::kQuiet), text.c_str());
  };
  if (range.is_flat) {
    label(at.y + 1, (range.low + range.high) / 2);
  } else {
    label(at.y + 1, range.high);
    label(end.y - font - 2, range.low);
  }
  out.PopClipRect();
  if (!hovered) return;
  const double tick = first + static_cast<double>((ImGui::GetIO().MousePos.x - at.x) / width) * span;
  ImGui::BeginTooltip();
  ImGui::TextUnformatted(TimeText(tick * moment.step_s).c_str());
  for (const GraphCurve& curve : curves) {
    const auto behind = std::upper_bound(curve.points.begin(), curve.points.end(), tick,
                                         [](double t, const auto& point) { return t < point.first; });
    if (behind != curve.points.begin())
      ColoredText(curve.color, curve.name + ": " + Formatted("%.5g", std::prev(behind)->second));
  }
  ImGui::TextDisabled("click: go there");
  ImGui::EndTooltip();
  if (clicked && tick >= 0) frame.Ask(workbench::SeekRequest{static_cast<std::uint64_t>(tick)});
}

float TimeAxisHeight() {
  return ImGui::GetTextLineHeight() + 5;
}

void DrawTimeAxis(PanelFrame& frame, double first, double last) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = std::max(frame.Px(60), ImGui::GetContentRegionAvail().x);
  ImGui::Dummy({width, TimeAxisHeight()});
  const double step_s = frame.contents.moment.step_s, span = std::max(1.0, last - first);
  // Round steps, large enough that the texts do not overlap.
  const float room = 1.5f * ImGui::CalcTextSize("00:00.00").x;
  const double every_s = RoundStep_s(span * step_s * static_cast<double>(room / width));
  ImDrawList& out = *ImGui::GetWindowDrawList();
  out.AddLine(at, {at.x + width, at.y}, theme::Packed(theme::kEdge));
  const auto begin = static_cast<long>(std::ceil(first * step_s / every_s - 1e-6));
  for (long i = begin; static_cast<double>(i) * every_s <= last * step_s + 1e-6 && i < begin + 1000; ++i) {
    const double time_s = static_cast<double>(i) * every_s;
    const float x = at.x + width * static_cast<float>((time_s / step_s - first) / span);
    out.AddLine({x, at.y}, {x, at.y + 4}, theme::Packed(theme::kQuiet));
    std::string text = every_s < 1 ? Formatted("%.1f s", time_s) : TimeText(time_s);
    // Integer seconds need no hundredths.
    if (every_s >= 1 && text.size() > 3) text.resize(text.size() - 3);
    const float half = ImGui::CalcTextSize(text.c_str()).x / 2;
    PutText(out, {std::clamp(x - half, at.x, at.x + width - 2 * half), at.y + 4}, theme::Packed(theme::kQuiet), text);
  }
}

}  // namespace soarbox::viewer
