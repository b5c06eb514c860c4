// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string_view>

namespace soarbox::workbench::document {

/// What a term of Soar means, for somebody who meets it for the first time: phases ("propose"), impasses ("operator
/// tie"), preferences ("better"), kinds of rules ("chunk"), and words such as "goal stack". Empty for other words.
std::string_view MeaningOf(std::string_view term);

}  // namespace soarbox::workbench::document
