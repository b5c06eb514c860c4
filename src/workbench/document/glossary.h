// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string_view>

namespace soarbox::workbench::document {

/// Explains a term of Soar to a beginner: phases ("propose"), impasses ("operator tie"), preferences ("better"), kinds
/// of rules ("chunk"), and words such as "goal stack". Returns an empty text for other words.
std::string_view MeaningOf(std::string_view term);

}  // namespace soarbox::workbench::document
