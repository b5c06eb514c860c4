// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "mind/decision.h"

namespace soarbox::tell {

// Sentences about a decision. Parts of sentences begin in small letters and end without a stop; "it" is the operator
// that they speak of. What the decision does not know they leave out.

/// "reject", "dominated", ...
std::string_view StageName(mind::Stage stage);

/// "seek (O2)", or the identifier alone.
std::string OperatorText(const mind::Decision& decision, std::uint32_t op);

/// Why the selected operator was selected: "the only operator proposed, by rule P", "rule R makes it better than turn
/// (O3)", "a (O3) and b (O2) are each better than the other (rules R and S), so both were dropped". Several reasons are
/// separated by semicolons. Empty if nothing is selected or told.
std::string WhySelected(const mind::Decision& decision);

/// Why this operator was dropped: "rule R rejects it", "rule R makes it worse than seek (O2)"; and whether it would
/// have lost without that, too. Empty if it was not dropped.
std::string WhyDropped(const mind::Decision& decision, std::uint32_t op);

/// Why nothing could be selected: "no preference decides among a (O1) and b (O2)". Empty if something was.
std::string WhyNothing(const mind::Decision& decision);

/// The part of a recording's line about a decision: WhySelected with who proposed the operator, or WhyNothing.
std::string WhyDecided(const mind::Decision& decision);

}  // namespace soarbox::tell
