// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "sml/wire/element.h"

namespace soarbox::wire {

/// Writes elements in the form that the protocol requires: attributes in byte order of their names, double quotes,
/// explicit end tags, no white space between elements, and five entities in text and attributes.
struct WriteOptions {
  bool children = true;
  bool new_lines = false;  ///< A line break after each end tag, for readability. Not part of the protocol.
};

void AppendEscaped(std::string& out, std::string_view text);
void AppendXml(std::string& out, const Element& element, const WriteOptions& options = {});
std::string ToXml(const Element& element, const WriteOptions& options = {});

/// Writes elements directly to a text, for documents that are too frequent to build as Elements first. Attributes must
/// be added in byte order of their names.
class XmlPen {
 public:
  explicit XmlPen(std::string& out) : out_(out) {}

  XmlPen& Begin(std::string_view tag) {
    EndStart();
    out_ += '<';
    out_ += tag;
    in_start_ = true;
    return *this;
  }
  XmlPen& Set(std::string_view name, std::string_view value) {
    BeginValue(name);
    AppendEscaped(out_, value);
    out_ += '"';
    return *this;
  }
  XmlPen& Set(std::string_view name, std::uint64_t value);
  /// Ends the element that was started with this tag.
  XmlPen& End(std::string_view tag) {
    EndStart();
    out_ += "</";
    out_ += tag;
    out_ += '>';
    return *this;
  }

 private:
  void EndStart() {
    if (in_start_) out_ += '>';
    in_start_ = false;
  }
  void BeginValue(std::string_view name) {
    out_ += ' ';
    out_ += name;
    out_ += "=\"";
  }

  std::string& out_;
  bool in_start_ = false;
};

}  // namespace soarbox::wire
