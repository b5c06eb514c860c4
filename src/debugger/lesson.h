// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "debugger/why.h"
#include "explain/inspector.h"
#include "explain/learning_facts.h"

namespace soarbox::debugger {

/// What a learned rule is good for, from its actions: "proposes go", "prefers go to stay", "makes ^cost".
std::string PurposeOf(const explain::LessonFact& lesson);
/// "operator no-change in S1, where price was selected".
std::string ImpasseOf(const explain::LessonFact& lesson);

/// Where a learned rule comes from: the substate with its impasse and superstate, the firings behind it, and why each
/// of its conditions is there.
WhyNode TellLesson(const explain::LessonFact& lesson);
/// The same in short, to stand below what the rule made: the substate, and the firings that led to the result.
WhyNode TellOrigin(const explain::LessonFact& lesson);

/// Of a rule of this name; nothing if it was not learned. Where it is not known how, the answer says so.
std::optional<WhyNode> WhyLearned(explain::Inspector& mind, std::string_view rule);
/// TellOrigin of a rule of this name; nothing if it was not learned, or nobody knows how.
std::optional<WhyNode> OriginOf(explain::Inspector& mind, std::string_view rule);

}  // namespace soarbox::debugger
