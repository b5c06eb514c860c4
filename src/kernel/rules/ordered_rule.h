// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string_view>

#include "kernel/rules/parser.h"

namespace soarbox::kernel {

/// Like ParseProduction, for a rule whose conditions are in match order already: PrintProduction with `internal` prints
/// them like that.
ParseOutcome ParseOrderedProduction(std::string_view body, const SourcePlace& place, SymbolTable& symbols,
                                    const RuleLanguage& language);

}  // namespace soarbox::kernel
