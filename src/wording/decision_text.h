// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "mind/decision_facts.h"

namespace soarbox::wording {

// Sentences about a decision. Parts of sentences begin with a lower-case letter and have no full stop at the end; "it"
// is the operator of the sentence. They omit what the decision does not contain.

/// "reject", "dominated", ...
std::string_view StageName(mind::Stage stage);

/// "seek (O2)", or only the identifier if it has no name.
std::string OperatorText(const mind::Decision& decision, std::uint32_t op);

/// Explains why the selected operator was selected: "the only operator proposed, by rule P", "rule R makes it better
/// than turn (O3)", "a (O3) and b (O2) are each better than the other (rules R and S), so both were dropped". Several
/// reasons are separated by semicolons. Empty if none is selected or recorded.
std::string WhySelected(const mind::Decision& decision);

/// Explains why this operator was dropped: "rule R rejects it", "rule R makes it worse than seek (O2)"; and whether it
/// would have lost without that, too. Empty if it was not dropped.
std::string WhyDropped(const mind::Decision& decision, std::uint32_t op);

/// Explains why no operator could be selected: "no preference decides among a (O1) and b (O2)". Empty if one was.
std::string WhyNothing(const mind::Decision& decision);

/// The text about a decision in a line of a recording: WhySelected with the proposing rule, or WhyNothing.
std::string WhyDecided(const mind::Decision& decision);

}  // namespace soarbox::wording
