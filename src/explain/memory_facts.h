// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "mind/facts.h"

namespace soarbox::explain {

using mind::KnownObjectFact;
using mind::LongTermFacts;
using mind::RememberedFact;

/// What inspectors of living minds also are, see Inspector.
class LongTermSource {
 public:
  virtual ~LongTermSource() = default;

  /// `most`: at most this many known objects; those with `text` in their number or augmentations.
  virtual LongTermFacts LongTerm(std::size_t most, const std::string& text) = 0;
  /// The contents of an episode, objects before what hangs on them; empty if there is no such episode.
  virtual std::vector<RememberedFact> Episode(std::size_t number) = 0;
};

}  // namespace soarbox::explain
