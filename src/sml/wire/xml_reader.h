// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <string_view>

#include "diagnostics/result.h"
#include "sml/wire/element.h"

namespace soarbox::wire {

/// The limits of a document, because documents come from untrusted sources.
struct ReadLimits {
  int max_depth = 200;                   ///< Maximum nesting of elements.
  std::size_t max_elements = 1'000'000;  ///< In the whole document.
  std::size_t max_attributes = 1'000;    ///< Maximum per element: each attribute is compared with the previous ones.
};

/// Parses one document. Accepts more than kernels and clients write: a header, comments, self-closing tags, white
/// space, single quotes, CDATA sections and numeric character references. Of mixed content, the last text block of an
/// element is used; text that is only white space next to child elements is dropped. Document type declarations are
/// refused. The error contains a description, line and column.
Result<Element> ReadXml(std::string_view document, const ReadLimits& limits = {});

}  // namespace soarbox::wire
