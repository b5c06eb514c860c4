// SPDX-License-Identifier: BSD-2-Clause
#include "sml/server/origin_facts.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "cli/lookup.h"
#include "cli/object_printer.h"
#include "cli/printed_rule.h"
#include "kernel/agent.h"
#include "kernel/longterm/origins.h"
#include "mind/decision_codec.h"
#include "sml/server/decision_packer.h"
#include "sml/server/hosted_agent.h"

namespace soarbox::server {
namespace {

using kernel::Origin;
using kernel::Origins;

constexpr std::size_t kMostReported = 96;

static_assert(static_cast<int>(kernel::OriginElement::Source::kArchitecture) ==
              static_cast<int>(mind::OriginElementFact::Source::kArchitecture));

/// Copies an origin and all origins that it refers to, breadth first.
class OriginReader {
 public:
  OriginReader(const kernel::Agent& agent, const Origins& origins) : agent_(agent), origins_(origins) {}

  std::vector<mind::OriginFact> Read(std::uint32_t first) {
    PlaceOf(first);
    for (std::size_t n = 0; n < found_.size(); ++n) {
      distance_ = found_[n].distance + 1;
      follows_ = origins_.IsWithin(found_[n].origin, found_[n].distance, n);
      mind::OriginFact fact = ReadOne(origins_.at(found_[n].origin));
      facts_.push_back(std::move(fact));
    }
    return std::move(facts_);
  }

 private:
  std::uint32_t PlaceOf(std::uint32_t origin) {
    if (origin == Origins::kNone || !follows_) return mind::kNoOrigin;
    const auto known = places_.find(origin);
    if (known != places_.end()) return known->second;
    if (found_.size() >= kMostReported) return mind::kNoOrigin;
    const auto place = static_cast<std::uint32_t>(found_.size());
    found_.push_back({origin, distance_});
    places_.emplace(origin, place);
    return place;
  }

  std::string Text(kernel::Symbol symbol) const { return symbol ? cli::SymbolText(agent_, symbol) : std::string(); }

  mind::OriginFact ReadOne(const Origin& origin) {
    mind::OriginFact fact;
    if (origin.rule != nullptr) fact.rule = cli::RuleName(agent_, *origin.rule);
    fact.decision = origin.decision;
    fact.o_supported = origin.o_supported;
    fact.is_operator = origin.is_operator;
    fact.level = origin.level;
    fact.state = Text(origin.state);
    fact.op = Text(origin.op);
    fact.op_name = Text(origin.op_name);
    fact.op_origin = PlaceOf(origin.op_origin);
    fact.left_out = origin.left_out;
    if (origin.is_operator && !origins_.Decided(origin).empty()) fact.decided = mind::Unpack(origins_.Decided(origin));
    for (const std::uint32_t proposal : origins_.Proposals(origin))
      if (const std::uint32_t place = PlaceOf(proposal); place != mind::kNoOrigin) fact.proposals.push_back(place);
    for (const kernel::OriginElement& matched : origins_.Matched(origin)) {
      mind::OriginElementFact& element = fact.matched.emplace_back();
      element.element = {matched.timetag,     Text(matched.id),   Text(matched.attribute),
                         Text(matched.value), matched.acceptable, matched.value.IsIdentifier()};
      element.source = static_cast<mind::OriginElementFact::Source>(matched.source);
      element.origin = PlaceOf(matched.origin);
    }
    return fact;
  }

  const kernel::Agent& agent_;
  const Origins& origins_;
  std::vector<mind::OriginFact> facts_;
  struct Found {
    std::uint32_t origin = Origins::kNone;
    std::uint32_t distance = 0;  ///< From the first one.
  };
  std::vector<Found> found_;    ///< By index in facts_.
  std::uint32_t distance_ = 0;  ///< Of the origins that are found next.
  bool follows_ = true;         ///< Whether the references of the origin that is being read are followed.
  std::map<std::uint32_t, std::uint32_t> places_;
};

mind::OriginFacts Facts(const HostedAgent& hosted, std::uint64_t timetag, std::uint32_t origin) {
  mind::OriginFacts facts;
  facts.noted = hosted.origins->on();
  facts.timetag = timetag;
  if (origin != Origins::kNone) facts.origins = OriginReader(hosted.agent(), *hosted.origins).Read(origin);
  return facts;
}

mind::OriginFacts Facts(const HostedAgent& hosted, const Origins::Past* past) {
  return past == nullptr ? Facts(hosted, 0, Origins::kNone) : Facts(hosted, past->timetag, past->origin);
}

}  // namespace

void NoteOrigins(HostedAgent& hosted) {
  if (hosted.origins->on() || hosted.agent().running() || hosted.agent().out_of_memory()) return;
  const auto packer = std::make_shared<DecisionPacker>();
  hosted.origins->Begin([packer, &agent = hosted.agent()](const kernel::Goal& goal) {
    return packer->Pack(agent, agent.ExplainDecision(goal));
  });
}

mind::OriginFacts OriginOfElement(const HostedAgent& hosted, std::uint64_t timetag) {
  const kernel::Agent& agent = hosted.agent();
  const kernel::WmeId wme = agent.memory().FindByTimetag(timetag);
  if (wme == kernel::WmeId::kNone)
    return Facts(hosted, hosted.origins->FindPast([&](const Origins::Past& it) { return it.timetag == timetag; }));
  std::uint32_t origin = hosted.origins->Of(wme);
  for (kernel::GoalLevel level = 1; level <= agent.goals().depth(); ++level) {
    const kernel::Goal& goal = agent.goals().at(level);
    if (goal.operator_slot != kernel::SlotId::kNone && agent.memory().record(wme).slot() == goal.operator_slot &&
        agent.OperatorOf(goal) == agent.memory().wme(wme).value)
      origin = hosted.origins->OfOperator(level);
  }
  return Facts(hosted, timetag, origin);
}

mind::OriginFacts OriginOfCommand(const HostedAgent& hosted, std::string_view command) {
  const kernel::Agent& agent = hosted.agent();
  kernel::WmeId newest = kernel::WmeId::kNone;
  if (const kernel::Symbol link = agent.OutputLinkIdentifier()) {
    agent.memory().ForEachWmeOf(link, [&](kernel::WmeId wme) {
      if (cli::SymbolText(agent, agent.memory().wme(wme).attribute) != command) return;
      if (newest == kernel::WmeId::kNone || agent.memory().wme(newest).timetag < agent.memory().wme(wme).timetag)
        newest = wme;
    });
  }
  if (newest != kernel::WmeId::kNone)
    return Facts(hosted, agent.memory().wme(newest).timetag, hosted.origins->Of(newest));
  return Facts(hosted, hosted.origins->FindPast(
                           [&](const Origins::Past& it) { return cli::SymbolText(agent, it.attribute) == command; }));
}

}  // namespace soarbox::server
