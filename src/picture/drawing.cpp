// SPDX-License-Identifier: BSD-2-Clause
#include "picture/drawing.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string_view>

#include "picture/stroke_font.h"

namespace soarbox::picture {
namespace {

/// Formats a number with at most two digits after the point, without trailing zeros.
std::string Number(float value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f", static_cast<double>(value));
  std::string number = text;
  while (number.back() == '0') number.pop_back();
  if (number.back() == '.') number.pop_back();
  return number == "-0" ? "0" : number;
}

std::string HexOf(Ink ink) {
  const auto byte = [](float value) { return static_cast<int>(std::lround(std::clamp(value, 0.0f, 1.0f) * 255)); };
  char text[8];
  std::snprintf(text, sizeof text, "#%02x%02x%02x", byte(ink.r), byte(ink.g), byte(ink.b));
  return text;
}

/// Formats an attribute: ` name="value"`.
std::string With(std::string_view name, const std::string& value) {
  return " " + std::string(name) + "=\"" + value + "\"";
}

std::string Alpha(std::string_view name, Ink ink) {
  return ink.a < 1 ? With(name, Number(ink.a)) : std::string();
}

/// Escapes a text for XML. Removes control characters, which XML does not allow.
std::string Escaped(std::string_view text) {
  std::string safe;
  for (const char c : text) {
    if (c == '<') {
      safe += "&lt;";
    } else if (c == '>') {
      safe += "&gt;";
    } else if (c == '&') {
      safe += "&amp;";
    } else if (c == '"') {
      safe += "&quot;";
    } else if (static_cast<unsigned char>(c) >= ' ' && c != '\x7f') {
      safe += c;
    }
  }
  return safe;
}

struct ToSvg {
  std::string operator()(const Drawing::Path& path) const {
    std::string points;
    for (const auto& [x, y] : path.points) points += (points.empty() ? "" : " ") + Number(x) + "," + Number(y);
    return "<polyline fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\"" +
           With("stroke", HexOf(path.ink)) + With("stroke-width", Number(path.width_px)) +
           Alpha("stroke-opacity", path.ink) + With("points", points) + "/>";
  }
  std::string operator()(const Drawing::Disc& disc) const {
    return "<circle" + With("cx", Number(disc.x)) + With("cy", Number(disc.y)) + With("r", Number(disc.radius)) +
           With("fill", HexOf(disc.ink)) + Alpha("fill-opacity", disc.ink) + "/>";
  }
  std::string operator()(const Drawing::Box& box) const {
    return "<rect" + With("x", Number(box.x)) + With("y", Number(box.y)) + With("width", Number(box.w)) +
           With("height", Number(box.h)) + With("fill", HexOf(box.ink)) + Alpha("fill-opacity", box.ink) + "/>";
  }
  std::string operator()(const Drawing::Text& text) const {
    static constexpr const char* kAnchors[] = {"start", "middle", "end"};
    return "<text" + With("x", Number(text.x)) + With("y", Number(text.y)) + With("font-size", Number(text.size_px)) +
           With("text-anchor", kAnchors[static_cast<std::size_t>(text.anchor)]) + With("fill", HexOf(text.ink)) + ">" +
           Escaped(text.words) + "</text>";
  }
};

struct ToPixels {
  Image& image;
  float scale;

  void operator()(const Drawing::Path& path) const {
    for (std::size_t i = 1; i < path.points.size(); ++i) {
      const auto& [x0, y0] = path.points[i - 1];
      const auto& [x1, y1] = path.points[i];
      image.Line(x0 * scale, y0 * scale, x1 * scale, y1 * scale, path.width_px * scale, path.ink);
    }
  }
  void operator()(const Drawing::Disc& disc) const {
    image.Disc(disc.x * scale, disc.y * scale, disc.radius * scale, disc.ink);
  }
  void operator()(const Drawing::Box& box) const {
    image.Box(box.x * scale, box.y * scale, box.w * scale, box.h * scale, box.ink);
  }
  void operator()(const Drawing::Text& text) const {
    constexpr float kCapital = 0.66f, kStroke = 0.085f;  // Of the size of the letters.
    const float height = text.size_px * kCapital * scale, width = TextWidth(text.words, height);
    const float left = text.anchor == Drawing::Anchor::kStart ? 0
                       : text.anchor == Drawing::Anchor::kEnd ? width
                                                              : width / 2;
    WriteText(image, text.x * scale - left, text.y * scale, height, text.words, text.ink,
              text.size_px * kStroke * scale);
  }
};

}  // namespace

std::string SvgOf(const Drawing& drawing) {
  std::string out = "<svg xmlns=\"http://www.w3.org/2000/svg\" font-family=\"sans-serif\" role=\"img\"" +
                    With("width", Number(drawing.width)) + With("height", Number(drawing.height)) +
                    With("viewBox", "0 0 " + Number(drawing.width) + " " + Number(drawing.height)) + ">\n<title>" +
                    Escaped(drawing.title) + "</title>\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
  for (const Drawing::Shape& shape : drawing.shapes) out += std::visit(ToSvg{}, shape) + "\n";
  return out + "</svg>\n";
}

Image ImageOf(const Drawing& drawing, float scale) {
  Image image(static_cast<int>(std::lround(drawing.width * scale)),
              static_cast<int>(std::lround(drawing.height * scale)));
  for (const Drawing::Shape& shape : drawing.shapes) std::visit(ToPixels{image, scale}, shape);
  return image;
}

}  // namespace soarbox::picture
