// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/script_ui.h"

#include <algorithm>

#include "viewer/draw_colors.h"
#include "viewer/markup.h"
#include "viewer/palette.h"

namespace soarbox::viewer {
namespace {

using world::Color;
using world::UiSnapshot;

/// ImGui counts the corners of a frame's letters in 16 bits; what exceeds this is left out.
constexpr std::size_t kMostCorners = 60000;

Color Middle(Color a, Color b) {
  return {(a.r + b.r) / 2, (a.g + b.g) / 2, (a.b + b.b) / 2, (a.a + b.a) / 2};
}

/// The part of a box for text.
struct TextArea {
  float left, top, right, bottom;
};

void DrawGradient(ImDrawList& out, const UiSnapshot& ui, ImVec2 corner, ImVec2 end) {
  const ImU32 from = Packed(ui.gradient_from), to = Packed(ui.gradient_to);
  if (ui.gradient_is_diagonal) {
    const ImU32 middle = Packed(Middle(ui.gradient_from, ui.gradient_to));
    out.AddRectFilledMultiColor(corner, end, from, middle, to, middle);
  } else if (ui.gradient_is_vertical) {
    out.AddRectFilledMultiColor(corner, end, from, from, to, to);
  } else {
    out.AddRectFilledMultiColor(corner, end, from, to, to, from);
  }
}

/// Draws a bar that fills a fraction of the panel's width.
void DrawBar(ImDrawList& out, const UiSnapshot& ui, ImVec2 corner, ImVec2 end) {
  out.AddRectFilled(corner, {corner.x + ui.bar * ui.width, end.y}, Packed(ui.bar_color));
}

/// Draws the edge of a button, and a shade while the button is hovered or held down.
void DrawButtonEdge(ImDrawList& out, ImVec2 corner, ImVec2 end, bool is_hovered, bool is_held) {
  constexpr ImU32 kEdge = IM_COL32(255, 255, 255, 150), kBrightEdge = IM_COL32(255, 255, 255, 240),
                  kHovered = IM_COL32(255, 255, 255, 40), kHeld = IM_COL32(0, 0, 0, 90);
  if (is_held || is_hovered) out.AddRectFilled(corner, end, is_held ? kHeld : kHovered);
  out.AddRect({corner.x + 0.5f, corner.y + 0.5f}, {end.x - 0.5f, end.y - 0.5f}, is_hovered ? kBrightEdge : kEdge, 0, 0,
              2);
}

void DrawBackground(ImDrawList& out, const UiSnapshot& ui, ImVec2 corner, PanelImages& images,
                    const ButtonState& buttons) {
  const ImVec2 end{corner.x + ui.width, corner.y + ui.height};
  Look look;
  if (ui.has_gradient) DrawGradient(out, ui, corner, end);
  if (FindLook(ui.material, look)) {
    out.AddRectFilled(corner, end, Packed(look.base));
  } else if (!ui.material.empty()) {
    if (const Ogre::ResourceHandle image = images.Find(ui.material); image != 0)
      out.AddImage(reinterpret_cast<ImTextureID>(image), corner, end);
  }
  if (ui.has_bar) DrawBar(out, ui, corner, end);
  if (!ui.button.empty()) DrawButtonEdge(out, corner, end, buttons.hovered == ui.id, buttons.held == ui.id);
}

/// Draws a run from x on and returns where it ends; characters that do not fit are left out.
float DrawRun(ImDrawList& out, const TextRun& run, ImFont* font, ImU32 color, float x, float y, const TextArea& area) {
  const float size = LineHeight(run.font);
  if (!run.fixed_width) {
    const char* begin = run.text.data();
    const char* end = begin + run.text.size();
    const char* fits = end;
    float width = font->CalcTextSizeA(size, area.right - x, 0, begin, end, &fits).x;
    if (fits < end) width = font->CalcTextSizeA(size, FLT_MAX, 0, begin, fits).x;
    out.AddText(font, size, {x, y}, color, begin, fits);
    return fits < end ? area.right : x + width;
  }
  for (const char& c : run.text) {
    const float step = FixedWidth(run.font);
    if (x + step > area.right) return area.right;
    const float own = font->CalcTextSizeA(size, FLT_MAX, 0, &c, &c + 1).x;
    out.AddText(font, size, {x + std::max(0.0f, (step - own) / 2), y}, color, &c, &c + 1);
    x += step;
  }
  return x;
}

float WidthOf(const TextRun& run, const PanelHost& host) {
  if (run.fixed_width) return FixedWidth(run.font) * static_cast<float>(run.text.size());
  const char* begin = run.text.data();
  return host.FontFor(run.font)->CalcTextSizeA(LineHeight(run.font), FLT_MAX, 0, begin, begin + run.text.size()).x;
}

/// Splits a line into lines of at most this width, broken before words. A wider word gets a line of its own.
void AppendWrapped(const TextLine& line, const PanelHost& host, float width, std::vector<TextLine>& wrapped) {
  wrapped.emplace_back();
  float x = 0;
  for (const TextRun& run : line) {
    for (std::size_t begin = 0; begin < run.text.size();) {
      const std::size_t word_end = std::min(run.text.find(' ', begin), run.text.size());
      const std::size_t end = std::min(run.text.find_first_not_of(' ', word_end), run.text.size());
      TextRun word = run;
      word.text = run.text.substr(begin, word_end - begin);
      if (x > 0 && x + WidthOf(word, host) > width) {
        wrapped.emplace_back();
        x = 0;
      }
      word.text = run.text.substr(begin, end - begin);
      x += WidthOf(word, host);
      wrapped.back().push_back(std::move(word));
      begin = end;
    }
  }
}

void DrawLines(ImDrawList& out, const std::vector<TextLine>& lines, const PanelHost& host, const TextArea& area,
               const auto& color_of) {
  std::vector<TextLine> wrapped;
  for (const TextLine& line : lines) AppendWrapped(line, host, area.right - area.left, wrapped);
  float y = area.top;
  for (const TextLine& line : wrapped) {
    float height = line.empty() ? LineHeight(world::UiFont::kSmall) : 0;
    for (const TextRun& run : line) height = std::max(height, LineHeight(run.font));
    // A line that begins inside is drawn; the part below the panel's edge is clipped.
    if (y + 0.5f >= area.bottom) return;
    float x = area.left;
    for (const TextRun& run : line) {
      if (static_cast<std::size_t>(out.VtxBuffer.Size) + 4 * run.text.size() > kMostCorners) return;
      // Runs of smaller fonts have the same baseline as the tallest.
      const float lowered = y + (height - LineHeight(run.font)) * 0.8f;
      x = DrawRun(out, run, host.FontFor(run.font), color_of(run), x, lowered, area);
    }
    y += height;
  }
}

std::vector<TextLine> PlainLines(const std::string& text, world::UiFont font) {
  std::vector<TextLine> lines(1);
  TextRun run;
  run.font = font;
  for (const char c : text + "\n") {
    if (c != '\n') {
      run.text.push_back(c);
      continue;
    }
    lines.back().push_back(run);
    lines.emplace_back();
    run.text.clear();
  }
  lines.pop_back();
  return lines;
}

void DrawPanel(ImDrawList& out, const UiSnapshot& ui, ImVec2 corner, const world::SceneSnapshot& snapshot,
               const PanelHost& host, bool is_in_world, PanelImages& images, const ButtonState& buttons) {
  DrawBackground(out, ui, corner, images, buttons);
  // A panel in the world is drawn without clipping and then moved to its place.
  if (!is_in_world) out.PushClipRect(corner, {corner.x + ui.width, corner.y + ui.height}, true);
  // The margin applies to the start of texts; a line that needs the space may use the margin at its end.
  const TextArea area{corner.x + ui.margin_left, corner.y + ui.margin_top, corner.x + ui.width,
                      corner.y + ui.height - ui.margin_top};
  const ImU32 plain = Packed(ui.text_color);
  const auto plain_color = [plain](const TextRun&) { return plain; };
  const auto markup_color = [&](const TextRun& run) {
    return Packed(snapshot.markup_palette[static_cast<std::size_t>(run.palette_index)]);
  };
  if (ui.is_markup) {
    DrawLines(out, ParseMarkup(ui.text), host, area, markup_color);
    if (!ui.caption.empty()) DrawLines(out, PlainLines(ui.caption, ui.font), host, area, plain_color);
  } else if (!ui.text.empty()) {
    DrawLines(out, PlainLines(ui.text, ui.font), host, area, plain_color);
  }
  if (!is_in_world) out.PopClipRect();
}

/// Moves everything drawn since `first` from the panel's pixels to the panel's place in the world. Removes it if a part
/// of it is behind the camera.
void MoveIntoWorld(ImDrawList& out, int first, const UiSnapshot& ui, const Projection& projection) {
  const world::Vec3 right = Rotate(ui.world_orientation, {kPanelMetresPerPixel, 0, 0});
  const world::Vec3 down = Rotate(ui.world_orientation, {0, -kPanelMetresPerPixel, 0});
  bool visible = true;
  for (int i = first; i < out.VtxBuffer.Size; ++i) {
    ImVec2& at = out.VtxBuffer[i].pos;
    const auto pixel = projection.Project(ui.world_position + right * at.x + down * at.y);
    visible = visible && pixel.has_value();
    if (pixel) at = {pixel->x, pixel->y};
  }
  if (visible) return;
  for (int i = first; i < out.VtxBuffer.Size; ++i) out.VtxBuffer[i].col = 0;
}

}  // namespace

void DrawScriptUi(const world::SceneSnapshot& snapshot, const Projection& projection, const PanelHost& host,
                  const ScreenRoom& room, PanelImages& images, const ButtonState& buttons) {
  if (snapshot.ui.empty()) return;
  const ScriptUiPlaces places(snapshot, room);
  std::vector<const UiSnapshot*> order;
  for (const UiSnapshot& ui : snapshot.ui) order.push_back(&ui);
  std::stable_sort(order.begin(), order.end(),
                   [](const UiSnapshot* a, const UiSnapshot* b) { return a->layer < b->layer; });
  ImDrawList& out = *ImGui::GetBackgroundDrawList();
  for (const UiSnapshot* ui : order) {
    if (!ui->visible || static_cast<std::size_t>(out.VtxBuffer.Size) > kMostCorners) continue;
    const auto [corner, top] = places.Of(*ui);
    const int first = out.VtxBuffer.Size;
    if (top->in_world) out.PushClipRectFullScreen();
    DrawPanel(out, *ui, {corner.x, corner.y}, snapshot, host, top->in_world, images, buttons);
    if (top->in_world) {
      MoveIntoWorld(out, first, *top, projection);
      out.PopClipRect();
    }
  }
}

}  // namespace soarbox::viewer
