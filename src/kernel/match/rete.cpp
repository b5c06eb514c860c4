// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/match/rete.h"

#include "kernel/match/rete_builder.h"
#include "kernel/match/rete_state.h"

namespace soarbox::kernel {

ReteState::ReteState(MatchSet& match_set, const SymbolTable& symbol_table, const WmeTable& wme_table)
    : matches(match_set),
      symbols(symbol_table),
      wmes(wme_table),
      network(std::make_shared<Network>()),
      builder(std::make_unique<ReteBuilder>(*this)) {
  nodes.emplace_back();
  marks.emplace_back();
  ParkAfter(256);
}

ReteState::~ReteState() = default;

Rete::Rete(const SymbolTable& symbols, const WmeTable& wmes)
    : state_(std::make_unique<ReteState>(matches_, symbols, wmes)) {}

Rete::~Rete() = default;

Rete::Added Rete::AddProduction(ProductionPtr production, const GoalView& goals, const AddOptions& options) {
  state_->goals = goals;
  return state_->AddProduction(std::move(production), options);
}

void Rete::ExciseProduction(ProductionId production) {
  if (Index(production) < state_->network->rule_limit() && state_->network->rule(Index(production))) {
    state_->ExciseProduction(Index(production));
  }
}

namespace {
[[gnu::noinline]] const ProductionPtr& RetiredRule(const ReteState& state, ProductionId id) {
  static const ProductionPtr kNone;
  return Index(id) < state.retired.size() ? state.retired[Index(id)] : kNone;
}
}  // namespace

const ProductionPtr& Rete::production(ProductionId id) const {
  const Network& network = *state_->network;
  const RuleInfo* const info = Index(id) < network.rule_limit() ? network.rule(Index(id)).get() : nullptr;
  if (info == nullptr) [[unlikely]] {
    return RetiredRule(*state_, id);
  }
  return info->rule;
}

void Rete::MixedSupportIsO(bool is_o) {
  state_->mixed_is_o = is_o;
}

void Rete::OnMixedSupport(std::function<void(ProductionId)> callback) {
  state_->on_mixed_support = std::move(callback);
}

void Rete::AddWme(WmeId wme, const GoalView& goals) {
  state_->goals = goals;
  state_->AddWme(Index(wme));
}

void Rete::RemoveWme(WmeId wme, const GoalView& goals) {
  state_->goals = goals;
  state_->RemoveWme(Index(wme));
}

void Rete::Clear() {
  state_->Clear();
}

void Rete::Abandon() {
  state_->Abandon();
}

MatchId Rete::AddFixedMatch(std::span<const WmeId> wmes, Symbol goal, GoalLevel level, InstantiationId instantiation) {
  return state_->AddFixedMatch(wmes, goal, level, instantiation);
}

void Rete::RetractFixedMatch(MatchId match) {
  if (state_->abandoned || match == MatchId::kNone || matches_.StateOf(match) != MatchState::kFired) return;
  state_->RetractFixedMatch(matches_.TokenOf(match));
}

void Rete::RemoveFixedMatch(MatchId match) {
  if (!state_->abandoned) state_->FreeFixedMatch(matches_.TokenOf(match));
  matches_.Drop(match);
}

void Rete::LimitPartialMatches(std::uint32_t most) {
  if (most == state_->most_partial_matches) {
    return;
  }
  state_->tokens.SetLimit(most);
  state_->parked.SetLimit(most);
  state_->most_partial_matches = most;
}
bool Rete::at_limit() const {
  return state_->tokens.at_limit() || state_->parked.at_limit() || state_->log_at_limit;
}

void Rete::ParkAfter(std::uint32_t matches) {
  state_->ParkAfter(matches);
}

void Rete::BusyFrom(std::uint32_t nodes) {
  state_->busy_from = nodes;
}

void Rete::ShareConjunctions(bool share) {
  state_->share_conjunctions = share;
}

std::shared_ptr<const Network> Rete::network() const {
  return state_->network;
}

std::uint64_t Rete::NetworkDigest() const {
  return state_->network->digest();
}

bool Rete::AdoptNetwork(const std::shared_ptr<const Network>& network) {
  if (network == state_->network) {
    return true;
  }
  if (!network->SameAs(*state_->network)) {
    return false;
  }
  // Nobody changes a topology that has more than one owner: OwnNetwork copies it first.
  state_->network = std::const_pointer_cast<Network>(network);
  // Many agents may share it, and hardly any of them gets more rules.
  state_->nodes.shrink_to_fit();
  state_->marks.shrink_to_fit();
  state_->alphas.shrink_to_fit();
  matches_.ShrinkRules();
  return true;
}

Rete::Statistics Rete::statistics() const {
  Statistics statistics;
  const Network& network = *state_->network;
  for (std::uint32_t n = 0; n < network.rule_limit(); ++n) {
    statistics.productions += network.rule(n) != nullptr ? 1 : 0;
  }
  for (std::uint32_t n = 0; n < network.node_limit(); ++n) {
    const Node& node = network.node(n);
    statistics.nodes += node.kind != NodeKind::kFree ? 1 : 0;
    statistics.shared_conjunctions += node.IsShared() ? 1 : 0;
  }
  for (std::uint32_t n = 0; n < network.alpha_limit(); ++n) {
    statistics.alpha_memories += network.alpha(n).uses != 0 ? 1 : 0;
  }
  statistics.tokens = state_->CountTokens();
  for (const auto& memory : state_->sparse) {
    if (memory->node != kNil) {
      statistics.tokens += state_->nodes[memory->node].count - memory->tokens;
    }
  }
  statistics.wmes = state_->wme_count;
  return statistics;
}

std::size_t Rete::MemoryBytes() const {
  const ReteState& s = *state_;
  std::size_t logs = s.sparse.size() * (sizeof(SparseState) + sizeof(s.sparse[0]));
  for (const auto& memory : s.sparse) {
    logs += memory->log.capacity() * sizeof(ParkedPair);
  }
  return s.tokens.MemoryBytes() + s.items.MemoryBytes() + s.parked.MemoryBytes() + logs +
         s.alphas.capacity() * sizeof(AlphaState) + s.nodes.capacity() * sizeof(NodeState) +
         s.marks.capacity() * sizeof(NodeMarks) + s.links.capacity() * sizeof(WmeLinks) + s.tables.MemoryBytes() +
         matches_.MemoryBytes();
}

std::size_t Rete::NetworkBytes() const {
  return state_->network->MemoryBytes();
}

}  // namespace soarbox::kernel
