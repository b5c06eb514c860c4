// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "mind/event_log.h"
#include "tell/mind_words.h"

namespace soarbox::record {

/// What recordings of formats 2 to 4 hold of a mind in a tick, in words, as facts. The only place where our own words
/// are read back. Reasons in words stay remarks; time tags of commands are not known, nor is what a decision rested on.
mind::EventLog ReadWords(const tell::MindWords& words);

}  // namespace soarbox::record
