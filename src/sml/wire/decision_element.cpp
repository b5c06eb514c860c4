// SPDX-License-Identifier: BSD-2-Clause
#include "sml/wire/decision_element.h"

#include <charconv>
#include <cstddef>
#include <string>
#include <string_view>

#include "mind/decision_codec.h"

namespace soarbox::wire {

void AddDecision(Element& parent, const mind::Decision& decision) {
  std::string bytes;
  mind::Pack(decision, bytes);
  std::string& text = parent.Add("decision").text;
  for (const char byte : bytes) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    const auto value = static_cast<unsigned char>(byte);
    text += {kDigits[value >> 4], kDigits[value & 15]};
  }
}

std::optional<mind::Decision> ReadDecision(const Element& parent) {
  const Element* const told = parent.Child("decision");
  if (told == nullptr || told->text.size() % 2 != 0) return std::nullopt;
  std::string bytes;
  for (std::size_t at = 0; at < told->text.size(); at += 2) {
    const char* const digits = told->text.data() + at;
    unsigned char byte = 0;
    if (std::from_chars(digits, digits + 2, byte, 16).ptr != digits + 2) return std::nullopt;
    bytes += static_cast<char>(byte);
  }
  return mind::Unpack(bytes);
}

}  // namespace soarbox::wire
