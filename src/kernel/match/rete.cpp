// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/match/rete.h"

#include "kernel/match/fixed_match.h"
#include "kernel/match/rete_builder.h"
#include "kernel/match/rete_state.h"

namespace soarbox::kernel {

ReteState::ReteState(MatchSet& match_set, const SymbolTable& symbol_table, const WmeTable& wme_table)
    : matches(match_set),
      symbols(symbol_table),
      wmes(wme_table),
      network(std::make_shared<Network>()),
      support(match_set, wme_table),
      pair_tests(network, tokens, wme_table, symbol_table, goals),
      builder(std::make_unique<ReteBuilder>(*this)) {
  nodes.MakeRoom(1);
  sparse.ParkAfter(256);
}

ReteState::~ReteState() = default;

Rete::Rete(const SymbolTable& symbols, const WmeTable& wmes)
    : state_(std::make_unique<ReteState>(matches_, symbols, wmes)) {}

Rete::~Rete() = default;

Rete::Added Rete::AddProduction(ProductionPtr production, const GoalView& goals, const AddOptions& options) {
  state_->goals = goals;
  return state_->builder->AddProduction(std::move(production), options);
}

void Rete::ExciseProduction(ProductionId production) {
  if (Index(production) < state_->network->rule_limit() && state_->network->rule(Index(production))) {
    state_->builder->ExciseProduction(Index(production));
  }
}

namespace {
[[gnu::noinline]] const ProductionPtr& RetiredRule(const ReteState& state, ProductionId id) {
  return state.rules.Retired(Index(id));
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
  state_->support.MixedIsO(is_o);
}

void Rete::OnMixedSupport(std::function<void(ProductionId)> callback) {
  state_->support.OnMixed(std::move(callback));
}

void Rete::AddWme(WmeId wme, const GoalView& goals) {
  state_->goals = goals;
  state_->AddWme(Index(wme));
}

void Rete::RemoveWme(WmeId wme, const GoalView& goals) {
  state_->goals = goals;
  state_->RemoveWme(Index(wme));
}

bool IsUntested(const Rete& rete, WmeId wme, Symbol value) {
  const ReteState& state = *rete.state_;
  const WmeLinks& link = state.links[Index(wme)];
  if (link.first_item != kNil || link.first_token != kNil) {
    return false;
  }
  const Wme& element = state.wmes[Index(wme)];
  const std::uint32_t fields[3] = {element.id.bits(), element.attribute.bits(), value.bits()};
  bool is_tested = false;
  state.network->ForEachAlpha(fields, element.acceptable, [&](std::uint32_t) { is_tested = true; });
  return !is_tested;
}

void Renew(Rete& rete, WmeId wme) {
  ReteState& state = *rete.state_;
  state.links.Renew(Index(wme), state.tokens.TakeSerial(), state.wmes[Index(wme)].timetag);
}

std::uint64_t ArrivalOf(const Rete& rete, WmeId wme) {
  const ElementLinks& links = rete.state_->links;
  return links.Holds(Index(wme)) ? links.ArrivalOf(Index(wme)) : 0;
}

void Rete::Clear() {
  state_->Clear();
}

void Rete::Abandon() {
  state_->Abandon();
}

MatchId Rete::AddFixedMatch(std::span<const WmeId> wmes, Symbol goal, GoalLevel level, InstantiationId instantiation) {
  return kernel::AddFixedMatch(state_->tokens, state_->links, matches_, wmes, goal, level, instantiation);
}

void Rete::RetractFixedMatch(MatchId match) {
  if (state_->abandoned || match == MatchId::kNone || matches_.StateOf(match) != MatchState::kFired) return;
  state_->RetractFixedMatch(matches_.TokenOf(match));
}

void Rete::LimitPartialMatches(std::uint32_t most) {
  if (most == state_->most_partial_matches) {
    return;
  }
  state_->tokens.SetLimit(most);
  state_->sparse.SetLimit(most);
  state_->most_partial_matches = most;
}
bool Rete::at_limit() const {
  return state_->tokens.at_limit() || state_->sparse.at_limit();
}

void Rete::ParkAfter(std::uint32_t matches) {
  state_->sparse.ParkAfter(matches);
}

void Rete::BusyFrom(std::uint32_t nodes) {
  state_->only_ids.set_busy_from(nodes);
}

void Rete::ShareConjunctions(bool share) {
  state_->shared.allowed = share;
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
  // A topology with more than one owner is never changed: Network::Own copies it first.
  state_->network = std::const_pointer_cast<Network>(network);
  // Many agents may share it, and most of them get no more rules.
  state_->nodes.ShrinkToFit();
  state_->alphas.ShrinkToFit();
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
  statistics.tokens = state_->tokens.CountInUse();
  state_->sparse.ForEach(
      [&](const SparseState& memory) { statistics.tokens += state_->nodes[memory.node].count - memory.tokens; });
  statistics.wmes = state_->links.count();
  return statistics;
}

std::size_t Rete::MemoryBytes() const {
  const ReteState& s = *state_;
  return s.tokens.MemoryBytes() + s.alphas.MemoryBytes() + s.nodes.MemoryBytes() + s.links.MemoryBytes() +
         s.sparse.MemoryBytes() + matches_.MemoryBytes();
}

std::size_t Rete::NetworkBytes() const {
  return state_->network->MemoryBytes();
}

}  // namespace soarbox::kernel
