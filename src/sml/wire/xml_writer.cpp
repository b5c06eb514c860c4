// SPDX-License-Identifier: BSD-2-Clause
#include "sml/wire/xml_writer.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace soarbox::wire {

namespace {

/// The entity for each character that needs one.
constexpr auto kEntities = [] {
  std::array<std::string_view, 256> entities{};
  entities['<'] = "&lt;";
  entities['>'] = "&gt;";
  entities['&'] = "&amp;";
  entities['"'] = "&quot;";
  entities['\''] = "&apos;";
  return entities;
}();

constexpr auto kPlain = [] {
  std::array<bool, 256> plain{};
  for (std::size_t c = 0; c < plain.size(); ++c) plain[c] = kEntities[c].empty();
  return plain;
}();

}  // namespace

void AppendEscaped(std::string& out, std::string_view text) {
  std::size_t from = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto c = static_cast<unsigned char>(text[i]);
    if (kPlain[c]) continue;
    out.append(text, from, i - from);
    out.append(kEntities[c]);
    from = i + 1;
  }
  out.append(text, from);
}

XmlPen& XmlPen::Set(std::string_view name, std::uint64_t value) {
  BeginValue(name);
  char digits[20];
  out_.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
  out_ += '"';
  return *this;
}

void AppendXml(std::string& out, const Element& element, const WriteOptions& options) {
  out += '<';
  out += element.tag;
  const auto append_attribute = [&out](const std::pair<std::string, std::string>& attribute) {
    out += ' ';
    out += attribute.first;
    out += "=\"";
    AppendEscaped(out, attribute.second);
    out += '"';
  };
  const auto by_name = [](const auto& a, const auto& b) { return a.first < b.first; };
  if (std::is_sorted(element.attributes.begin(), element.attributes.end(), by_name)) {
    for (const auto& attribute : element.attributes) append_attribute(attribute);
  } else {
    auto sorted = element.attributes;
    std::stable_sort(sorted.begin(), sorted.end(), by_name);
    for (const auto& attribute : sorted) append_attribute(attribute);
  }
  out += '>';
  AppendEscaped(out, element.text);
  if (options.children) {
    if (options.new_lines && !element.children.empty()) out += '\n';
    for (const Element& child : element.children) AppendXml(out, child, options);
  }
  out += "</";
  out += element.tag;
  out += '>';
  if (options.new_lines) out += '\n';
}

std::string ToXml(const Element& element, const WriteOptions& options) {
  std::string out;
  AppendXml(out, element, options);
  return out;
}

}  // namespace soarbox::wire
