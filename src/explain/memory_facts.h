// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "mind/inspection_facts.h"

namespace soarbox::explain {

using mind::KnownObjectFact;
using mind::LongTermFacts;
using mind::RememberedFact;

/// Reports long-term memory. Only inspectors of our own kernel in this process also implement this class. Callers get
/// it from an Inspector by dynamic_cast.
class LongTermSource {
 public:
  virtual ~LongTermSource() = default;

  /// Returns at most `most` objects of semantic memory that contain `text` in their number or augmentations.
  virtual LongTermFacts LongTerm(std::size_t most, const std::string& text) = 0;
  /// Returns the contents of an episode; each object comes before its children. Empty if there is no such episode.
  virtual std::vector<RememberedFact> Episode(std::size_t number) = 0;
};

}  // namespace soarbox::explain
