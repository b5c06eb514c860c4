// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "debugger/why.h"
#include "explain/inspector.h"
#include "explain/learning_facts.h"

namespace soarbox::debugger {

/// What a learned rule does, from its actions: "proposes go", "prefers go to stay", "makes ^cost".
std::string PurposeOf(const explain::LearnedRuleFact& learned);
/// "operator no-change in S1, where price was selected".
std::string ImpasseOf(const explain::LearnedRuleFact& learned);

/// Explains the origin of a learned rule: the substate with its impasse and superstate, the firings that led to the
/// result, and the reason for each condition.
WhyNode TellLearnedRule(const explain::LearnedRuleFact& learned);
/// A short form of it, to be added below an element that the rule made: the substate, and the firings that led to the
/// result.
WhyNode TellOrigin(const explain::LearnedRuleFact& learned);

/// Explains the rule of this name; nothing if it was not learned. If its origin is not known, the answer says so.
std::optional<WhyNode> WhyLearned(explain::Inspector& mind, std::string_view rule);
/// TellOrigin for the rule of this name; nothing if it was not learned, or if its origin is not known.
std::optional<WhyNode> OriginOf(explain::Inspector& mind, std::string_view rule);

}  // namespace soarbox::debugger
