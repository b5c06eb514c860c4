// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <optional>

#include "mind/decision_facts.h"
#include "sml/wire/element.h"

namespace soarbox::wire {

/// The call that requests a decision; its argument is "state". Soarbox only: other kernels answer with an error.
inline constexpr const char* kDecisionCall = "soarbox_decision";

/// Adds <decision> with the bytes of a decision in recordings (mind/decision_codec.h), in hexadecimal.
void AddDecision(Element& parent, const mind::Decision& decision);
/// Reads the <decision> of a response; none if there is none or if it is invalid.
std::optional<mind::Decision> ReadDecision(const Element& parent);

}  // namespace soarbox::wire
