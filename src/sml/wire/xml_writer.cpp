// SPDX-License-Identifier: BSD-2-Clause
#include "sml/wire/xml_writer.h"

#include <algorithm>

namespace soarbox::wire {

void AppendEscaped(std::string& out, std::string_view text) {
  std::size_t from = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    std::string_view entity;
    switch (text[i]) {
      case '<': entity = "&lt;"; break;
      case '>': entity = "&gt;"; break;
      case '&': entity = "&amp;"; break;
      case '"': entity = "&quot;"; break;
      case '\'': entity = "&apos;"; break;
      default: continue;
    }
    out.append(text, from, i - from);
    out.append(entity);
    from = i + 1;
  }
  out.append(text, from);
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
