// SPDX-License-Identifier: BSD-2-Clause
#include "diagnostics/plain_text.h"

#include <algorithm>

namespace soarbox {
namespace {

void AppendHex(std::string& text, unsigned char byte) {
  constexpr char kDigits[] = "0123456789abcdef";
  text += "\\x";
  text += kDigits[byte >> 4];
  text += kDigits[byte & 15];
}

}  // namespace

std::string_view Beginning(std::string_view text, std::size_t most) {
  if (text.size() <= most) return text;
  // A byte of this form is within a character.
  while (most > 0 && (static_cast<unsigned char>(text[most]) & 0xC0) == 0x80) --most;
  return text.substr(0, most);
}

std::string Printable(std::string_view text, const char* indent, std::size_t most) {
  const std::size_t shown = Beginning(text, most).size();
  std::string safe;
  safe.reserve(shown);
  for (std::size_t i = 0; i < shown; ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    // The control characters that UTF-8 adds to those of ASCII are 0xC2 followed by 0x80 to 0x9F.
    const bool is_c1 = byte == 0xC2 && i + 1 < shown && static_cast<unsigned char>(text[i + 1]) < 0xA0;
    if (byte == '\n') {
      if (indent == nullptr) {
        safe += "\\n";
      } else {
        safe += '\n';
        safe += indent;
      }
    } else if ((byte < 0x20 && byte != '\t') || byte == 0x7F) {
      AppendHex(safe, byte);
    } else if (is_c1) {
      AppendHex(safe, static_cast<unsigned char>(text[++i]));
    } else {
      safe += text[i];
    }
  }
  if (shown < text.size()) {
    safe += " ... (";
    safe += std::to_string(text.size() - shown);
    safe += " more bytes)";
  }
  return safe;
}

std::string WhyNoPlainText(std::string_view content) {
  const bool is_utf16 = content.starts_with("\xFF\xFE") || content.starts_with("\xFE\xFF");
  if (is_utf16) return "this file is UTF-16: save it as UTF-8";
  const std::size_t zero = content.find('\0');
  if (zero == std::string_view::npos) return {};
  const auto line = 1 + std::count(content.begin(), content.begin() + static_cast<std::ptrdiff_t>(zero), '\n');
  return "this is not a text file: line " + std::to_string(line) + " holds a zero byte";
}

std::string_view WithoutByteOrderMark(std::string_view content) {
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  if (content.starts_with(kMark)) content.remove_prefix(kMark.size());
  return content;
}

}  // namespace soarbox
