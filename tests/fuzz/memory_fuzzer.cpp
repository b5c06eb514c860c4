// SPDX-License-Identifier: BSD-2-Clause
// Passes foreign input to long-term memory: the text of `smem --add`, `smem --query` and `smem --remove`, and the
// records of database files. The first byte selects which. After each accepted input the invariants must hold, and
// saved data must be readable.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "bytes/byte_stream.h"
#include "kernel/agent.h"
#include "kernel/longterm/episode_records.h"
#include "kernel/longterm/knowledge_reader.h"
#include "kernel/longterm/long_term.h"
#include "kernel/longterm/semantic_memory.h"

namespace {

using namespace soarbox::kernel;

void Require(bool good) {
  if (!good) std::abort();
}

void CheckKnowledge(SemanticMemory& memory) {
  Require(memory.knowledge().CheckInvariants().empty());
  Agent other("again");
  SemanticMemory& again = SemanticMemory::Of(other.long_term());
  Require(again.Load(memory.Image(), {}));
  Require(again.knowledge().edge_count() == memory.knowledge().edge_count());
}

void TryText(SemanticMemory& memory, std::string_view text) {
  const std::string given(text);
  std::string notes;
  static_cast<void>(AddKnowledge(memory, given, notes));
  CheckKnowledge(memory);
  Cue cue;
  if (ReadQuery(memory, given, cue).empty()) static_cast<void>(memory.Search(cue, 3));
  bool failed = false;
  static_cast<void>(RemoveKnowledge(memory, given, true, failed));
  CheckKnowledge(memory);
}

void TryEpisodes(std::string_view bytes) {
  EpisodeStore store;
  EpisodeTerms terms;
  if (!ReadEpisodes(bytes, store, terms)) return;
  Require(*store.CheckInvariants() == '\0');
  EpisodeStore again;
  EpisodeTerms again_terms;
  Require(ReadEpisodes(EpisodeWriter(store, terms).Write(), again, again_terms));
  Require(again.last() == store.last() && again.fact_count() == store.fact_count());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0 || size > 100'000) return 0;
  const std::string_view rest(reinterpret_cast<const char*>(data + 1), size - 1);
  Agent agent("fuzz");
  SemanticMemory& memory = SemanticMemory::Of(agent.long_term());
  switch (data[0] % 4) {
    case 0:
      TryText(memory, rest);
      break;
    case 1:
      if (memory.Load(rest, {})) CheckKnowledge(memory);
      break;
    case 2: {
      // Records, each preceded by its length.
      std::vector<std::string> records;
      soarbox::ByteReader reader(rest);
      while (!reader.AtEnd() && records.size() < 1000) {
        const std::string_view record = reader.Text();
        if (!record.empty()) records.emplace_back(record);
      }
      if (memory.Load({}, records)) CheckKnowledge(memory);
      break;
    }
    default:
      TryEpisodes(rest);
      break;
  }
  return 0;
}
