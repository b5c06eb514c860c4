// SPDX-License-Identifier: BSD-2-Clause
#include "text.h"

#include <cstdint>

#include "problems.h"

namespace soarbox::java {

namespace {

constexpr char32_t kReplacement = 0xFFFD;

/// Number of bytes of the UTF-8 sequence that begins with this byte; 0 if no sequence begins with it.
std::size_t LengthOf(unsigned char first) {
  if (first < 0x80) return 1;
  if (first >= 0xC2 && first <= 0xDF) return 2;
  if (first >= 0xE0 && first <= 0xEF) return 3;
  if (first >= 0xF0 && first <= 0xF4) return 4;
  return 0;
}

/// Reads the first code point of `text` and its number of bytes. The number is 0 if the bytes are not UTF-8.
std::size_t Read(std::string_view text, char32_t& point) {
  static constexpr unsigned char kPayload[] = {0, 0x7F, 0x1F, 0x0F, 0x07};
  static constexpr char32_t kSmallest[] = {0, 0, 0x80, 0x800, 0x10000};
  const std::size_t length = LengthOf(static_cast<unsigned char>(text[0]));
  if (length == 0 || length > text.size()) return 0;
  point = static_cast<unsigned char>(text[0]) & kPayload[length];
  for (std::size_t i = 1; i < length; ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    if ((byte & 0xC0) != 0x80) return 0;
    point = point << 6 | (byte & 0x3F);
  }
  const bool is_surrogate = point >= 0xD800 && point <= 0xDFFF;
  return point < kSmallest[length] || point > 0x10FFFF || is_surrogate ? 0 : length;
}

void Append(std::string& text, char32_t point) {
  if (point < 0x80) {
    text += static_cast<char>(point);
    return;
  }
  const int followers = point < 0x800 ? 1 : point < 0x10000 ? 2 : 3;
  static constexpr unsigned char kLead[] = {0, 0xC0, 0xE0, 0xF0};
  text += static_cast<char>(kLead[followers] | point >> (6 * followers));
  for (int i = followers - 1; i >= 0; --i) text += static_cast<char>(0x80 | (point >> (6 * i) & 0x3F));
}

}  // namespace

jstring NewText(JNIEnv* env, std::string_view text) {
  std::u16string units;
  units.reserve(text.size());
  while (!text.empty()) {
    char32_t point = 0;
    const std::size_t length = Read(text, point);
    if (length == 0) {
      units += static_cast<char16_t>(0xDC00 + static_cast<unsigned char>(text[0]));
    } else if (point < 0x10000) {
      units += static_cast<char16_t>(point);
    } else {
      units += static_cast<char16_t>(0xD800 + ((point - 0x10000) >> 10));
      units += static_cast<char16_t>(0xDC00 + ((point - 0x10000) & 0x3FF));
    }
    text.remove_prefix(length == 0 ? 1 : length);
  }
  return env->NewString(reinterpret_cast<const jchar*>(units.data()), static_cast<jsize>(units.size()));
}

jstring NewText(JNIEnv* env, const char* text) {
  return text ? NewText(env, std::string_view(text)) : nullptr;
}

std::string TextOf(JNIEnv* env, jstring text) {
  std::u16string units(static_cast<std::size_t>(env->GetStringLength(text)), u'\0');
  env->GetStringRegion(text, 0, static_cast<jsize>(units.size()), reinterpret_cast<jchar*>(units.data()));
  std::string result;
  result.reserve(units.size());
  for (std::size_t i = 0; i < units.size(); ++i) {
    const char32_t unit = units[i];
    const char32_t next = i + 1 < units.size() ? units[i + 1] : 0;
    if (unit >= 0xD800 && unit <= 0xDBFF && next >= 0xDC00 && next <= 0xDFFF) {
      Append(result, 0x10000 + ((unit - 0xD800) << 10) + (next - 0xDC00));
      ++i;
    } else if (unit >= 0xDC80 && unit <= 0xDCFF) {
      result += static_cast<char>(unit - 0xDC00);
    } else {
      Append(result, unit >= 0xD800 && unit <= 0xDFFF ? kReplacement : unit);
    }
  }
  return result;
}

bool Text::Take(JNIEnv* env, jstring text, const char* method, Null null) {
  is_null_ = text == nullptr;
  if (is_null_) {
    if (null == Null::kAllowed) return true;
    ThrowForArgument(env, Problem::kNull, method, "an argument is null");
    return false;
  }
  text_ = TextOf(env, text);
  if (text_.find('\0') == std::string::npos) return true;
  ThrowForArgument(env, Problem::kArgument, method, "a text contains the character 0");
  return false;
}

}  // namespace soarbox::java
