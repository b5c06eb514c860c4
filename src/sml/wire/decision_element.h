// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <optional>

#include "mind/decision.h"
#include "sml/wire/element.h"

namespace soarbox::wire {

/// The call that asks for it, by the argument "state". Soarbox's own: other kernels answer with an error.
inline constexpr const char* kDecisionCall = "soarbox_decision";

/// Adds <decision> with the bytes that recordings hold of one (mind/decision_codec.h), as hexadecimal digits.
void AddDecision(Element& parent, const mind::Decision& decision);
/// Reads the <decision> of an answer; none if there is none or it is not one of ours.
std::optional<mind::Decision> ReadDecision(const Element& parent);

}  // namespace soarbox::wire
