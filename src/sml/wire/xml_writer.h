// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>

#include "sml/wire/element.h"

namespace soarbox::wire {

/// Writes elements in the one form that the protocol fixes: attributes in byte order of their names, double quotes,
/// explicit end tags, no white space between elements, and five entities in text and attributes alike.
struct WriteOptions {
  bool children = true;
  bool new_lines = false;  ///< For people: a line break after each end tag. Not part of the protocol.
};

void AppendEscaped(std::string& out, std::string_view text);
void AppendXml(std::string& out, const Element& element, const WriteOptions& options = {});
std::string ToXml(const Element& element, const WriteOptions& options = {});

}  // namespace soarbox::wire
