// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/decide/rule_sharing.h"

#include <cstdint>
#include <iterator>
#include <map>
#include <memory>
#include <mutex>
#include <utility>

#include "kernel/base/symbol_table.h"
#include "kernel/decide/production_record.h"
#include "kernel/decide/rule_directory.h"
#include "kernel/match/rete.h"

namespace soarbox::kernel {
namespace {

struct SharedRules {
  std::shared_ptr<const FrozenSymbols> symbols;
  std::shared_ptr<const Network> network;
  RuleDirectory directory;
};

using Key = std::pair<std::uint64_t, std::uint64_t>;

struct Store {
  std::mutex mutex;
  std::map<Key, SharedRules> entries;
};

Store& TheStore() {
  static Store store;
  return store;
}

}  // namespace

void ShareRules(SymbolTable& symbols, Rete& rete, RuleDirectory& rules, std::vector<ProductionRecord>& productions) {
  if (rules.loading_order().empty()) return;
  const Key key{symbols.Digest(), rete.NetworkDigest()};
  Store& store = TheStore();
  const std::lock_guard<std::mutex> lock(store.mutex);
  // Removes entries that only the store refers to: the agents that shared them no longer exist.
  std::erase_if(store.entries, [](const auto& entry) { return entry.second.network.use_count() == 1; });
  const auto found = store.entries.find(key);
  if (found == store.entries.end()) {
    store.entries.emplace(key, SharedRules{symbols.Freeze(), rete.network(), rules});
    return;
  }
  if (rete.network() == found->second.network) return;
  // The network's handles are valid only with the constants with which they were created.
  if (symbols.Adopt(found->second.symbols) && rete.AdoptNetwork(found->second.network)) {
    rules.Adopt(found->second.directory);
    productions.shrink_to_fit();
  }
}

}  // namespace soarbox::kernel
