// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <string_view>

#include "diagnostics/result.h"
#include "sml/wire/element.h"

namespace soarbox::wire {

/// The limits of a document. Documents come from strangers.
struct ReadLimits {
  int max_depth = 200;                   ///< Elements inside elements.
  std::size_t max_elements = 1'000'000;  ///< In the whole document.
  std::size_t max_attributes = 1'000;    ///< Of one element: each is compared with those before it.
};

/// Reads one document. Takes more than is ever written: a header, comments, self-closing tags, white space, single
/// quotes, character data sections and numeric character references. Of mixed text, the last block of an element
/// counts; text that is only white space beside child elements is dropped. Document types are refused. The error says
/// what is wrong and where (line and column).
Result<Element> ReadXml(std::string_view document, const ReadLimits& limits = {});

}  // namespace soarbox::wire
