// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/panels/rule_source.h"

#include <algorithm>

namespace soarbox::viewer {

using debugger::Token;
using debugger::TokenKind;

ImVec4 ColorOf(TokenKind kind) {
  switch (kind) {
    case TokenKind::kComment:
      return theme::kQuiet;
    case TokenKind::kCommand:
    case TokenKind::kKeyword:
    case TokenKind::kArrow:
      return theme::kWarn;
    case TokenKind::kRuleName:
    case TokenKind::kAttribute:
      return theme::kAccent;
    case TokenKind::kVariable:
      return theme::kVariable;
    case TokenKind::kNumber:
      return theme::kNumber;
    case TokenKind::kQuoted:
      return theme::kGood;
    case TokenKind::kConstant:
    case TokenKind::kSign:
      break;
  }
  return theme::kText;
}

void DrawSource(ImDrawList& out, ImVec2 at, std::string_view text, const std::vector<Token>& tokens, float top,
                float bottom) {
  const float height = ImGui::GetFontSize();
  std::size_t token = 0;
  float y = at.y;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    if (y > bottom) return;
    if (y + height >= top) {
      float x = at.x;
      std::size_t place = begin;
      const auto put = [&](std::size_t until, ImVec4 color) {
        until = std::min(until, end);
        if (until <= place) return;
        out.AddText({x, y}, theme::Packed(color), text.data() + place, text.data() + until);
        x += ImGui::CalcTextSize(text.data() + place, text.data() + until).x;
        place = until;
      };
      while (token < tokens.size() && tokens[token].begin + tokens[token].length <= begin) ++token;
      for (std::size_t i = token; i < tokens.size() && tokens[i].begin < end; ++i) {
        put(tokens[i].begin, theme::kText);
        put(tokens[i].begin + tokens[i].length, ColorOf(tokens[i].kind));
      }
      put(end, theme::kText);
    }
    y += height;
    begin = end + 1;
  }
}

void SourceItem(std::string_view text, const std::vector<Token>& tokens) {
  const ImVec2 at = ImGui::GetCursorScreenPos(), size = ImGui::CalcTextSize(text.data(), text.data() + text.size());
  ImGui::Dummy(size);
  const ImVec2 from = ImGui::GetWindowPos(), window = ImGui::GetWindowSize();
  DrawSource(*ImGui::GetWindowDrawList(), at, text, tokens, from.y, from.y + window.y);
}

}  // namespace soarbox::viewer
