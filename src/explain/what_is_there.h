// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <vector>

#include "explain/inspector.h"
#include "explain/mind_view.h"
#include "explain/rule_text.h"
#include "explain/rule_wait.h"
#include "vocabulary/vocabulary.h"

namespace soarbox::explain {

// What a mind has instead of an element that a condition requires. The paths begin at a state.

/// The part of a path that begins at ^io.input-link: rules may reach the link of the top state through ^superstate or
/// an element of their own, such as ^top. Empty if the path does not lead through the link.
std::vector<std::string> FromLink(const std::vector<std::string>& path);

/// The percept at this path from the state; null if there is none.
const vocabulary::PerceptRow* RowAt(const std::vector<std::string>& from_state);

/// Percepts of the same object whose names begin with that of an absent one: "^io.input-link.radar-status is off" for
/// ^io.input-link.radar. Empty if there are none.
std::string RelatedPercepts(MindView& view, Inspector& inspector, const std::string& state,
                            const std::vector<std::string>& path);

/// For a condition whose path ends in objects although it tests a word: the attribute below these objects that has the
/// word. "^content" for ^my-location.<direction> normalfood; empty if none has it.
std::string AttributeWithWord(MindView& view, Inspector& inspector, const std::string& state,
                              const ConditionText& condition);

/// For an element that a condition requires and that is absent from this state: the attributes that its object has
/// instead, or the places below the state that have it. The text is empty if nothing useful is known.
RuleWait::Found WhatIsThere(MindView& view, Inspector& inspector, const std::string& state,
                            const ConditionText& condition);

}  // namespace soarbox::explain
