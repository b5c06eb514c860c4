// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "record/tick_source.h"

namespace soarbox::record {

/// The elements of the last operator that an agent selected in a tick: "O13 ^name report ^about blue-3". Empty if it
/// selected none, or if the recording contains no elements (it needs Level::kAll). Reads all ticks up to that one.
Result<std::string> ElementsOfOperator(TickSource& recording, std::string_view agent, std::uint64_t tick);

}  // namespace soarbox::record
