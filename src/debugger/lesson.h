// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "debugger/why.h"
#include "sim/inspector.h"
#include "sim/learning_facts.h"

namespace soarbox::debugger {

/// What a learned rule is good for, from its actions: "proposes go", "prefers go to stay", "makes ^cost".
std::string PurposeOf(const sim::LessonFact& lesson);
/// "operator no-change in S1, where price was selected".
std::string ImpasseOf(const sim::LessonFact& lesson);

/// Where a learned rule comes from: the substate with its impasse and superstate, the firings behind it, and why each
/// of its conditions is there.
WhyNode TellLesson(const sim::LessonFact& lesson);
/// The same in short, to stand below what the rule made: the substate, and the firings that led to the result.
WhyNode TellOrigin(const sim::LessonFact& lesson);

/// Of a rule of this name; nothing if it was not learned. Where it is not known how, the answer says so.
std::optional<WhyNode> WhyLearned(sim::Inspector& mind, std::string_view rule);
/// TellOrigin of a rule of this name; nothing if it was not learned, or nobody knows how.
std::optional<WhyNode> OriginOf(sim::Inspector& mind, std::string_view rule);

}  // namespace soarbox::debugger
