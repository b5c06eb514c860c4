// SPDX-License-Identifier: BSD-2-Clause
#include "report/report_plots.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>
#include <utility>

namespace soarbox::report {
namespace {

using Json = nlohmann::ordered_json;
using picture::Drawing;
using picture::Ink;
using Anchor = Drawing::Anchor;

constexpr std::size_t kMostMetrics = 24, kMostNames = 40, kMostDots = 200, kMostCurves = 24;
constexpr float kWidth = 720, kRow = 46, kLetter = 7.2f;
constexpr Ink kText{0.10f, 0.11f, 0.13f, 1}, kQuiet{0.38f, 0.40f, 0.44f, 1}, kLine{0.84f, 0.85f, 0.87f, 1},
    kMark{0.05f, 0.36f, 0.66f, 1}, kDot{0.05f, 0.36f, 0.66f, 0.35f}, kThing{0.78f, 0.79f, 0.81f, 1};

/// Colours that also differ in lightness.
Ink ColorOf(std::size_t index) {
  constexpr std::array<Ink, 8> kColors = {{{0.05f, 0.36f, 0.66f, 1},
                                           {0.85f, 0.37f, 0.01f, 1},
                                           {0.11f, 0.56f, 0.38f, 1},
                                           {0.56f, 0.22f, 0.55f, 1},
                                           {0.65f, 0.54f, 0.05f, 1},
                                           {0.20f, 0.66f, 0.80f, 1},
                                           {0.75f, 0.15f, 0.30f, 1},
                                           {0.35f, 0.35f, 0.38f, 1}}};
  return kColors[index % kColors.size()];
}

std::string Digits(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", std::abs(number) < 1e-12 ? 0 : number);
  return text;
}

/// Truncates a text to a width in px.
std::string Cut(std::string text, float width) {
  const auto most = static_cast<std::size_t>(std::max(4.0f, width / kLetter));
  if (text.size() <= most) return text;
  text.resize(most - 2);
  return text + "..";
}

void Write(Drawing& drawing, float x, float y, std::string words, Anchor anchor = Anchor::kStart, Ink ink = kText,
           float size = 12) {
  drawing.shapes.emplace_back(Drawing::Text{x, y, size, anchor, ink, std::move(words)});
}

/// Converts numbers to positions on an axis.
class Scale {
 public:
  Scale(double low, double high, float from, float to) : low_(low), high_(high), from_(from), to_(to) {
    if (!(high_ > low_)) high_ = low_ + 1;
  }
  float operator()(double value) const {
    return from_ + static_cast<float>((value - low_) / (high_ - low_)) * (to_ - from_);
  }
  /// Round numbers on the axis: multiples of 1, 2 or 5 times a power of ten.
  std::vector<double> Ticks(int about) const {
    const double rough = (high_ - low_) / about, power = std::pow(10, std::floor(std::log10(rough)));
    const double step = power * (rough / power < 1.5 ? 1 : rough / power < 3.5 ? 2 : rough / power < 7.5 ? 5 : 10);
    std::vector<double> ticks;
    for (double at = std::ceil(low_ / step) * step; at <= high_ + step * 1e-9 && ticks.size() < 50; at += step)
      ticks.push_back(at);
    return ticks;
  }

 private:
  double low_, high_;
  float from_, to_;
};

/// Names on the left, an axis at the bottom, and a line for each round number.
struct Frame {
  float left, right, top, bottom;
  Scale x;
};

void DrawAxis(Drawing& drawing, const Frame& frame) {
  for (const double tick : frame.x.Ticks(7)) {
    drawing.Line(frame.x(tick), frame.top, frame.x(tick), frame.bottom, 1, kLine);
    Write(drawing, frame.x(tick), frame.bottom + 16, Digits(tick), Anchor::kMiddle, kQuiet, 11);
  }
}

float LeftFor(const std::vector<std::string>& names) {
  std::size_t longest = 4;
  for (const std::string& name : names) longest = std::max(longest, name.size());
  return std::clamp(22 + kLetter * static_cast<float>(longest), 70.0f, kWidth * 0.35f);
}

/// A drawing with a row for each name and a heading.
Drawing Rows(const std::string& title, const std::vector<std::string>& names) {
  Drawing drawing;
  drawing.width = kWidth;
  drawing.height = 44 + kRow * static_cast<float>(names.size()) + 36;
  drawing.title = title;
  Write(drawing, 12, 24, title, Anchor::kStart, kText, 15);
  return drawing;
}

Frame FrameOf(const Drawing& drawing, const std::vector<std::string>& names, double low, double high) {
  const double margin = high > low ? (high - low) * 0.04 : 0.5;
  const float left = LeftFor(names), right = kWidth - 24;
  return {left, right, 40, drawing.height - 30, Scale(low - margin, high + margin, left, right)};
}

void WriteNames(Drawing& drawing, const Frame& frame, const std::vector<std::string>& names) {
  for (std::size_t i = 0; i < names.size(); ++i)
    Write(drawing, 12, frame.top + kRow * (static_cast<float>(i) + 0.5f) + 4, Cut(names[i], frame.left - 18));
}

/// Draws a mark for the middle and a line from low to high.
void DrawInterval(Drawing& drawing, const Frame& frame, float y, double low, double middle, double high, Ink ink) {
  drawing.Line(frame.x(low), y, frame.x(high), y, 2, ink);
  for (const double end : {low, high}) drawing.Line(frame.x(end), y - 4, frame.x(end), y + 4, 2, ink);
  drawing.shapes.emplace_back(Drawing::Disc{frame.x(middle), y, 4.5f, ink});
}

std::vector<std::string> NamesOf(const Json& list, const char* key) {
  std::vector<std::string> names;
  for (const Json& each : list)
    if (names.size() < kMostNames) names.push_back(each.value(key, ""));
  return names;
}

std::vector<double> Numbers(const Json& list) {
  std::vector<double> numbers;
  for (const Json& each : list)
    if (each.is_number()) numbers.push_back(each.get<double>());
  return numbers;
}

/// Converts the name of a plot to a file name.
std::string FileName(const char* kind, const std::string& of) {
  std::string name = kind;
  if (!of.empty()) name += "-" + of;
  for (char& c : name) {
    const bool is_plain =
        (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '.';
    if (!is_plain) c = '_';
  }
  constexpr std::size_t kMost = 80;
  if (name.size() > kMost) name.resize(kMost);
  return name;
}

/// The rate of passed runs of each variant, or of a check, with Wilson's intervals.
Plot RatesPlot(const Json& variants, const std::string& name, std::optional<std::size_t> check) {
  const std::vector<std::string> names = NamesOf(variants, "name");
  Drawing drawing =
      Rows((check ? "Check \"" + name + "\"" : "Passed") + ", % of runs, with 95 % intervals (Wilson)", names);
  const Frame frame = FrameOf(drawing, names, 0, 100);
  DrawAxis(drawing, frame);
  WriteNames(drawing, frame, names);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const Json& of = check ? variants[i]["checks"][*check] : variants[i];
    const double good = of.value(check ? "true" : "passed", 0.0), all = of.value(check ? "of" : "judged", 0.0);
    if (all == 0) continue;
    const float y = frame.top + kRow * (static_cast<float>(i) + 0.5f);
    DrawInterval(drawing, frame, y, 100 * of.value("low", 0.0), 100 * good / all, 100 * of.value("high", 0.0), kMark);
  }
  return {FileName("rate", check ? name : "passed"), std::move(drawing)};
}

double Quantile(const std::vector<double>& sorted, double share) {
  const double at = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (at - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

/// Draws each run as a dot; many runs as a box from the first to the third quartile, and a line from 5 % to 95 %.
void DrawRuns(Drawing& drawing, const Frame& frame, float y, std::vector<double> values) {
  if (values.size() <= kMostDots) {
    // The dots are at five different heights, so that equal values can be distinguished.
    for (std::size_t i = 0; i < values.size(); ++i)
      drawing.shapes.emplace_back(
          Drawing::Disc{frame.x(values[i]), y + static_cast<float>(i % 5) * 2.2f - 4.4f, 3, kDot});
    return;
  }
  std::ranges::sort(values);
  const float from = frame.x(Quantile(values, 0.25)), to = frame.x(Quantile(values, 0.75)),
              middle = frame.x(Quantile(values, 0.5));
  drawing.Line(frame.x(Quantile(values, 0.05)), y, frame.x(Quantile(values, 0.95)), y, 1.5f, kMark);
  drawing.shapes.emplace_back(Drawing::Box{from, y - 7, std::max(1.0f, to - from), 14, {0.72f, 0.81f, 0.90f, 1}});
  drawing.Line(middle, y - 7, middle, y + 7, 2, kMark);
}

Plot DistributionPlot(const Json& metric, const std::vector<std::string>& names) {
  const std::string name = metric.value("name", "");
  Drawing drawing = Rows(name + ": each run, and the mean with its 95 % interval (Student)", names);
  double low = std::numeric_limits<double>::max(), high = -low;
  for (const Json& variant : metric["variants"]) {
    for (const double value : Numbers(variant["values"])) {
      low = std::min(low, value);
      high = std::max(high, value);
    }
    low = std::min(low, variant.value("low", low));
    high = std::max(high, variant.value("high", high));
  }
  const Frame frame = FrameOf(drawing, names, low, high);
  DrawAxis(drawing, frame);
  WriteNames(drawing, frame, names);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const Json& variant = metric["variants"][i];
    const float y = frame.top + kRow * (static_cast<float>(i) + 0.5f);
    const std::vector<double> values = Numbers(variant["values"]);
    if (values.empty()) continue;
    DrawRuns(drawing, frame, y - 8, values);
    DrawInterval(drawing, frame, y + 11, variant.value("low", 0.0), variant.value("mean", 0.0),
                 variant.value("high", 0.0), ColorOf(1));
  }
  return {FileName("distribution", name), std::move(drawing)};
}

/// Number of runs of each variant for each interval of the axis.
Plot HistogramPlot(const Json& metric, const std::vector<std::string>& names) {
  const std::string name = metric.value("name", "");
  Drawing drawing = Rows(name + ": number of runs", names);
  double low = std::numeric_limits<double>::max(), high = -low;
  std::size_t most_runs = 1;
  for (const Json& variant : metric["variants"]) {
    const std::vector<double> values = Numbers(variant["values"]);
    most_runs = std::max(most_runs, values.size());
    for (const double value : values) {
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
  // Sturges' rule with twice as many bins.
  const auto bins =
      static_cast<std::size_t>(std::clamp(2 * (1 + std::ceil(std::log2(static_cast<double>(most_runs)))), 5.0, 40.0));
  const double width = high > low ? (high - low) / static_cast<double>(bins) : 1;
  std::vector<std::vector<std::size_t>> counts(names.size(), std::vector<std::size_t>(bins));
  std::size_t most = 1;
  for (std::size_t i = 0; i < names.size(); ++i) {
    for (const double value : Numbers(metric["variants"][i]["values"])) {
      const auto bin = std::min(bins - 1, static_cast<std::size_t>((value - low) / width));
      most = std::max(most, ++counts[i][bin]);
    }
  }
  const Frame frame = FrameOf(drawing, names, low, high);
  DrawAxis(drawing, frame);
  WriteNames(drawing, frame, names);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const float base = frame.top + kRow * static_cast<float>(i + 1) - 4;
    drawing.Line(frame.left, base, frame.right, base, 1, kLine);
    for (std::size_t bin = 0; bin < bins; ++bin) {
      if (counts[i][bin] == 0) continue;
      const float from = frame.x(low + width * static_cast<double>(bin)),
                  to = frame.x(low + width * static_cast<double>(bin + 1));
      const float high_px = (kRow - 8) * static_cast<float>(counts[i][bin]) / static_cast<float>(most);
      drawing.shapes.emplace_back(
          Drawing::Box{from + 0.5f, base - high_px, std::max(1.0f, to - from - 1), high_px, ColorOf(i)});
    }
  }
  Write(drawing, frame.right, 24, "most: " + std::to_string(most), Anchor::kEnd, kQuiet, 11);
  return {FileName("histogram", name), std::move(drawing)};
}

std::optional<Plot> DifferencesPlot(const Json& metric, const std::string& first) {
  const Json differences = metric.value("differences", Json::array());
  if (differences.empty()) return std::nullopt;
  const std::string name = metric.value("name", "");
  std::vector<std::string> names = NamesOf(differences, "variant");
  Drawing drawing = Rows(name + ": difference from " + first + " on equal seeds, 95 % (Student)", names);
  double low = 0, high = 0;
  for (const Json& each : differences) {
    low = std::min(low, each.value("low", 0.0));
    high = std::max(high, each.value("high", 0.0));
  }
  // Leaves room for the probabilities on the right.
  const Frame frame = FrameOf(drawing, names, low, high + (high - low) * 0.3);
  DrawAxis(drawing, frame);
  drawing.Line(frame.x(0), frame.top, frame.x(0), frame.bottom, 1.5f, kQuiet);
  WriteNames(drawing, frame, names);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const Json& each = differences[i];
    const float y = frame.top + kRow * (static_cast<float>(i) + 0.5f);
    const double holm = each.value("holm", 1.0);
    DrawInterval(drawing, frame, y, each.value("low", 0.0), each.value("mean", 0.0), each.value("high", 0.0),
                 holm < 0.05 ? kMark : kQuiet);
    Write(drawing, frame.right, y + 4, "p " + Digits(holm) + " after Holm", Anchor::kEnd, kQuiet, 11);
  }
  return Plot{FileName("difference", name), std::move(drawing)};
}

Plot RatingsPlot(const Json& standings) {
  const std::vector<std::string> names = NamesOf(standings, "agent");
  Drawing drawing = Rows("Ratings, with 95 % intervals from resampling the seeds", names);
  double low = std::numeric_limits<double>::max(), high = -low;
  for (const Json& each : standings) {
    low = std::min(low, each.value("low", 0.0));
    high = std::max(high, each.value("high", 0.0));
  }
  const Frame frame = FrameOf(drawing, names, low, high);
  DrawAxis(drawing, frame);
  WriteNames(drawing, frame, names);
  for (std::size_t i = 0; i < names.size(); ++i)
    DrawInterval(drawing, frame, frame.top + kRow * (static_cast<float>(i) + 0.5f), standings[i].value("low", 0.0),
                 standings[i].value("rating", 0.0), standings[i].value("high", 0.0), kMark);
  return {"ratings", std::move(drawing)};
}

std::vector<Plot> SweepPlots(const Json& data) {
  std::vector<Plot> plots;
  const Json& variants = data["variants"];
  const std::vector<std::string> names = NamesOf(variants, "name");
  if (data.contains("standings")) plots.push_back(RatingsPlot(data["standings"]));
  const Json checks = data.value("check_names", Json::array());
  if (!checks.empty() && !data.contains("standings")) plots.push_back(RatesPlot(variants, "passed", std::nullopt));
  for (std::size_t i = 0; i < checks.size() && checks.size() > 1; ++i)
    plots.push_back(RatesPlot(variants, checks[i].get<std::string>(), i));
  std::size_t count = 0;
  for (const Json& metric : data["metrics"]) {
    if (count++ == kMostMetrics) break;
    plots.push_back(DistributionPlot(metric, names));
    plots.push_back(HistogramPlot(metric, names));
    if (std::optional<Plot> differences = DifferencesPlot(metric, names.empty() ? "" : names.front()))
      plots.push_back(std::move(*differences));
  }
  return plots;
}

/// The values of a series of an agent, which is stored as differences.
std::vector<double> SeriesOf(const Json& agent, const char* key, double unit) {
  std::vector<double> values = Numbers(agent.value(key, Json::array()));
  double sum = 0;
  for (double& value : values) value = (sum += value) / unit;
  return values;
}

void WriteLegend(Drawing& drawing, const std::vector<std::string>& names, float y) {
  float x = 12;
  for (std::size_t i = 0; i < names.size() && i < kMostCurves; ++i) {
    const float width = 22 + kLetter * static_cast<float>(names[i].size());
    if (x + width > drawing.width) break;
    drawing.shapes.emplace_back(Drawing::Disc{x + 5, y - 4, 4, ColorOf(i)});
    Write(drawing, x + 13, y, names[i], Anchor::kStart, kText, 11);
    x += width;
  }
}

/// A quantity of all agents over time.
Plot CurvesPlot(const Json& data, const char* key, double unit, const std::string& title, const char* name) {
  const std::vector<double> times = Numbers(data["times"]);
  Drawing drawing;
  drawing.width = kWidth;
  drawing.height = 340;
  drawing.title = title;
  Write(drawing, 12, 24, title, Anchor::kStart, kText, 15);
  double high = 1;
  std::vector<std::pair<std::size_t, std::vector<double>>> curves;
  std::vector<std::string> names;
  for (const Json& agent : data["agents"]) {
    if (curves.size() == kMostCurves) break;
    curves.emplace_back(agent.value("from", std::size_t{0}), SeriesOf(agent, key, unit));
    names.push_back(agent.value("name", ""));
    for (const double value : curves.back().second) high = std::max(high, value);
  }
  const Frame frame{56, kWidth - 20, 54, 300, Scale(0, times.empty() ? 1 : times.back(), 56, kWidth - 20)};
  const Scale y(0, high, frame.bottom, frame.top);
  DrawAxis(drawing, frame);
  Write(drawing, frame.right, frame.bottom + 32, "s", Anchor::kEnd, kQuiet, 11);
  for (const double tick : y.Ticks(5)) {
    drawing.Line(frame.left, y(tick), frame.right, y(tick), 1, kLine);
    Write(drawing, frame.left - 6, y(tick) + 4, Digits(tick), Anchor::kEnd, kQuiet, 11);
  }
  for (std::size_t i = 0; i < curves.size(); ++i) {
    Drawing::Path path;
    path.width_px = 1.6f;
    path.ink = ColorOf(i);
    const auto& [from, values] = curves[i];
    for (std::size_t at = 0; at < values.size() && from + at < times.size(); ++at)
      path.points.emplace_back(frame.x(times[from + at]), y(values[at]));
    if (path.points.size() > 1) drawing.shapes.emplace_back(std::move(path));
  }
  WriteLegend(drawing, names, 44);
  return {name, std::move(drawing)};
}

/// The paths of all agents; x to the right, z down.
Plot MapPlot(const Json& data) {
  double x0 = std::numeric_limits<double>::max(), x1 = -x0, z0 = x0, z1 = -x0;
  std::vector<std::pair<std::vector<double>, std::vector<double>>> ways;
  std::vector<std::string> names;
  for (const Json& agent : data["agents"]) {
    constexpr double kCentimetres = 100;
    ways.emplace_back(SeriesOf(agent, "x", kCentimetres), SeriesOf(agent, "z", kCentimetres));
    names.push_back(agent.value("name", ""));
    for (const double x : ways.back().first) x0 = std::min(x0, x), x1 = std::max(x1, x);
    for (const double z : ways.back().second) z0 = std::min(z0, z), z1 = std::max(z1, z);
  }
  if (x0 > x1) x0 = x1 = z0 = z1 = 0;
  const double side = std::max({x1 - x0, z1 - z0, 8.0}) * 1.12;
  Drawing drawing;
  drawing.width = kWidth;
  drawing.height = kWidth + 60;
  drawing.title = "Paths, in m; each begins at a ring and ends at a disc";
  Write(drawing, 12, 24, drawing.title, Anchor::kStart, kText, 15);
  const Scale x((x0 + x1 - side) / 2, (x0 + x1 + side) / 2, 20, kWidth - 20),
      z((z0 + z1 - side) / 2, (z0 + z1 + side) / 2, 60, kWidth + 20);
  const float metre = (kWidth - 40) / static_cast<float>(side);
  for (const Json& thing : data.value("things", Json::array())) {
    const float cx = x(thing.value("x", 0.0)), cy = z(thing.value("z", 0.0));
    const auto w = static_cast<float>(thing.value("w", 1.0)) * metre,
               d = static_cast<float>(thing.value("d", 1.0)) * metre;
    if (cx < 0 || cx > kWidth || cy < 40 || cy > kWidth + 40) continue;
    if (thing.value("round", false)) {
      drawing.shapes.emplace_back(Drawing::Disc{cx, cy, w / 2, kThing});
      continue;
    }
    // A rotated box is drawn as a thick line through its centre.
    const double turn = -thing.value("turn", 0.0) * std::numbers::pi / 180;
    if (std::abs(std::sin(2 * turn)) < 0.01) {
      const bool is_across = std::abs(std::sin(turn)) > 0.5;
      const float bw = is_across ? d : w, bd = is_across ? w : d;
      drawing.shapes.emplace_back(Drawing::Box{cx - bw / 2, cy - bd / 2, bw, bd, kThing});
      continue;
    }
    const bool is_wide = w >= d;
    const auto along = static_cast<float>(is_wide ? turn : turn + std::numbers::pi / 2);
    const float half = (is_wide ? w - d : d - w) / 2;
    drawing.Line(cx - half * std::cos(along), cy - half * std::sin(along), cx + half * std::cos(along),
                 cy + half * std::sin(along), std::min(w, d), kThing);
  }
  for (std::size_t i = 0; i < ways.size(); ++i) {
    Drawing::Path path;
    path.width_px = 1.8f;
    path.ink = ColorOf(i);
    const auto& [xs, zs] = ways[i];
    for (std::size_t at = 0; at < std::min(xs.size(), zs.size()); ++at) path.points.emplace_back(x(xs[at]), z(zs[at]));
    if (path.points.empty()) continue;
    const auto first = path.points.front(), last = path.points.back();
    drawing.shapes.emplace_back(std::move(path));
    drawing.shapes.emplace_back(Drawing::Disc{first.first, first.second, 5, ColorOf(i)});
    drawing.shapes.emplace_back(Drawing::Disc{first.first, first.second, 3, {1, 1, 1, 1}});
    drawing.shapes.emplace_back(Drawing::Disc{last.first, last.second, 5, ColorOf(i)});
    if (i < kMostCurves) Write(drawing, last.first + 8, last.second + 4, names[i], Anchor::kStart, kText, 11);
  }
  // A scale bar with a round length in metres.
  const double bar = Scale(0, side, 0, 1).Ticks(5)[1];
  const float from = 20, y = drawing.height - 14;
  drawing.Line(from, y, from + static_cast<float>(bar) * metre, y, 2, kText);
  Write(drawing, from, y - 6, Digits(bar) + " m", Anchor::kStart, kText, 11);
  WriteLegend(drawing, names, 44);
  return {"map", std::move(drawing)};
}

}  // namespace

std::vector<Plot> PlotsOf(const std::string& data) {
  const Json read = Json::parse(data, nullptr, false);
  if (!read.is_object()) return {};
  if (read.value("kind", "") == "sweep") return SweepPlots(read);
  std::vector<Plot> plots;
  plots.push_back(MapPlot(read));
  constexpr double kTenths = 10;
  plots.push_back(CurvesPlot(read, "v", kTenths, "Speed, m/s", "speed"));
  plots.push_back(CurvesPlot(read, "hp", 1, "Health", "health"));
  return plots;
}

}  // namespace soarbox::report
