// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace soarbox::explain {

/// An object of semantic memory.
struct KnownObjectFact {
  std::uint64_t number = 0;  ///< 12 of @12.
  std::string text;          ///< Its augmentations: "^kind ammo ^site @3".
  double activation = 0;
  std::uint64_t uses = 0;  ///< How often it was recalled.
};

/// What stood in working memory when an episode was taken: an element of an object.
struct RememberedFact {
  std::uint32_t object = 0;  ///< 0: the top state.
  std::string attribute, value;
  bool is_object = false;          ///< Then `value` is empty.
  std::uint32_t value_object = 0;  ///< If so.
};

/// What an agent has in semantic and episodic memory.
struct LongTermFacts {
  bool semantic = false, episodic = false;  ///< Switched on.
  std::size_t objects = 0, augmentations = 0;
  std::vector<KnownObjectFact> known;  ///< The most active first; no more than were asked for.
  std::size_t episodes = 0;
  std::vector<std::uint64_t> decisions;  ///< By episode, from 1: in which it was taken; 0: in an earlier run.
};

/// What inspectors of living minds are besides, see Inspector.
class LongTermSource {
 public:
  virtual ~LongTermSource() = default;

  /// `most`: so many known objects; those with `text` in their number or augmentations.
  virtual LongTermFacts LongTerm(std::size_t most, const std::string& text) = 0;
  /// The contents of an episode, objects before what hangs on them; empty if there is no such episode.
  virtual std::vector<RememberedFact> Episode(std::size_t number) = 0;
};

}  // namespace soarbox::explain
