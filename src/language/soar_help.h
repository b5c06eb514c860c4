// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "language/text_document.h"

namespace soarbox::language {

/// Explains an attribute that the architecture creates, such as "superstate". Empty for others.
std::string_view MeaningOfAttribute(std::string_view attribute);

/// Explains a word or sign of Soar's language at an offset of a file: `state`, `-->`, `write`, `sp`.
struct SoarWord {
  Span span;
  std::string text;  ///< As Markdown.
};
std::optional<SoarWord> SoarWordAt(const Document& document, std::size_t offset);

}  // namespace soarbox::language
