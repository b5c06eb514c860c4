// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "mind/event_log.h"
#include "tell/mind_words.h"

namespace soarbox::record {

/// Turns the words that recordings of formats 2 to 4 hold of a mind's tick into facts. The only place that reads our
/// own words back. Reasons in words stay remarks. The time tags of commands and the grounds of a decision are unknown.
mind::EventLog ReadWords(const tell::MindWords& words);

}  // namespace soarbox::record
