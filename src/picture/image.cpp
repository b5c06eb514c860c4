// SPDX-License-Identifier: BSD-2-Clause
#include "picture/image.h"

#include <algorithm>
#include <cmath>

namespace soarbox::picture {
namespace {

std::uint8_t ByteOf(float value) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0f, 1.0f) * 255));
}

/// Blends a colour into all pixels of a box. `away(x, y)` is the distance of a position outside the shape, in pixels.
template <typename Away>
void Fill(Image& image, float x0, float y0, float x1, float y1, Ink ink, Away away) {
  if (!(std::isfinite(x0) && std::isfinite(y0) && std::isfinite(x1) && std::isfinite(y1))) return;
  const auto within = [](float value, int most) {
    return static_cast<int>(std::clamp(value, 0.0f, static_cast<float>(most)));
  };
  const int left = within(std::floor(x0) - 1, image.width), right = within(std::ceil(x1) + 1, image.width);
  const int top = within(std::floor(y0) - 1, image.height), bottom = within(std::ceil(y1) + 1, image.height);
  for (int y = top; y < bottom; ++y)
    for (int x = left; x < right; ++x)
      image.Mix(x, y, ink, 0.5f - away(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f));
}

}  // namespace

Image::Image(int w, int h, Ink background) : width(w), height(h) {
  rgb.resize(3 * static_cast<std::size_t>(w) * static_cast<std::size_t>(h));
  const std::uint8_t color[] = {ByteOf(background.r), ByteOf(background.g), ByteOf(background.b)};
  for (std::size_t i = 0; i < rgb.size(); ++i) rgb[i] = color[i % 3];
}

void Image::Mix(int x, int y, Ink ink, float cover) {
  if (x < 0 || y < 0 || x >= width || y >= height) return;
  const float share = std::clamp(cover, 0.0f, 1.0f) * ink.a;
  if (share <= 0) return;
  std::uint8_t* const pixel = At(x, y);
  const float color[] = {ink.r, ink.g, ink.b};
  for (int i = 0; i < 3; ++i) pixel[i] = ByteOf(static_cast<float>(pixel[i]) / 255 * (1 - share) + color[i] * share);
}

void Image::Line(float x0, float y0, float x1, float y1, float width_px, Ink ink) {
  const float half = width_px / 2, dx = x1 - x0, dy = y1 - y0, length = dx * dx + dy * dy;
  Fill(*this, std::min(x0, x1) - half, std::min(y0, y1) - half, std::max(x0, x1) + half, std::max(y0, y1) + half, ink,
       [=](float x, float y) {
         const float along = length > 0 ? std::clamp(((x - x0) * dx + (y - y0) * dy) / length, 0.0f, 1.0f) : 0;
         return std::hypot(x - x0 - along * dx, y - y0 - along * dy) - half;
       });
}

void Image::Disc(float cx, float cy, float radius, Ink ink) {
  Fill(*this, cx - radius, cy - radius, cx + radius, cy + radius, ink,
       [=](float x, float y) { return std::hypot(x - cx, y - cy) - radius; });
}

void Image::Ring(float cx, float cy, float radius, float width_px, Ink ink) {
  const float outer = radius + width_px / 2;
  Fill(*this, cx - outer, cy - outer, cx + outer, cy + outer, ink,
       [=](float x, float y) { return std::abs(std::hypot(x - cx, y - cy) - radius) - width_px / 2; });
}

void Image::Box(float left, float top, float w, float h, Ink ink) {
  Fill(*this, left, top, left + w, top + h, ink, [=](float x, float y) {
    return std::max({left - x, x - left - w, top - y, y - top - h});
  });
}

Image Halved(const Image& image) {
  Image half(image.width / 2, image.height / 2);
  for (int y = 0; y < half.height; ++y) {
    for (int x = 0; x < half.width; ++x) {
      for (int i = 0; i < 3; ++i) {
        const int sum = image.At(2 * x, 2 * y)[i] + image.At(2 * x + 1, 2 * y)[i] + image.At(2 * x, 2 * y + 1)[i] +
                        image.At(2 * x + 1, 2 * y + 1)[i];
        half.At(x, y)[i] = static_cast<std::uint8_t>((sum + 2) / 4);
      }
    }
  }
  return half;
}

}  // namespace soarbox::picture
