// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "kernel/longterm/episode_store.h"
#include "kernel/longterm/episode_terms.h"

namespace soarbox::kernel {

/// Writes episodes for a journal, one after the other. Each record contains the new constants and facts, the facts that
/// became true or false, and the links of nodes to objects of semantic memory.
class EpisodeWriter {
 public:
  EpisodeWriter(const EpisodeStore& store, const EpisodeTerms& terms) : store_(store), terms_(terms) {}

  /// The episodes since the last call.
  std::string Write();
  /// Marks everything in the store as written, because it was read from the journal.
  void SkipAll();
  /// The next call writes everything.
  void Restart() { *this = EpisodeWriter(store_, terms_); }
  EpisodeWriter& operator=(const EpisodeWriter& other) {
    terms_written_ = other.terms_written_;
    facts_written_ = other.facts_written_;
    episodes_written_ = other.episodes_written_;
    return *this;
  }
  EpisodeWriter(const EpisodeWriter&) = default;

 private:
  const EpisodeStore& store_;
  const EpisodeTerms& terms_;
  std::size_t terms_written_ = 0, facts_written_ = 0;
  EpisodeNumber episodes_written_ = 0;
};

/// Appends episodes to a store. Returns false if the bytes are invalid; then the store contains the episodes before the
/// error, and the caller must clear it.
bool ReadEpisodes(std::string_view bytes, EpisodeStore& store, EpisodeTerms& terms);

}  // namespace soarbox::kernel
