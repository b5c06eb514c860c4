// SPDX-License-Identifier: BSD-2-Clause
#include "sml/client/inspection_memory.h"

#include <algorithm>
#include <cctype>
#include <set>
#include <utility>

#include "kernel/longterm/episodic_memory.h"
#include "kernel/longterm/long_term.h"
#include "kernel/longterm/semantic_memory.h"

namespace soarbox {
namespace {

using kernel::EpisodicMemory;
using kernel::Knowledge;
using kernel::SemanticMemory;

std::string ObjectText(const Knowledge& knowledge, std::uint32_t object) {
  std::string text;
  for (const kernel::Edge& edge : knowledge.EdgesAt(object)) {
    text += text.empty() ? "^" : " ^";
    knowledge.terms().Append(text, edge.attribute);
    text += " ";
    if (edge.value.IsObject()) {
      text += "@" + std::to_string(knowledge.NumberAt(edge.value.index()));
    } else {
      knowledge.terms().Append(text, edge.value, true);
    }
  }
  return text;
}

/// Whether `text` contains `part`; case-insensitive.
bool Has(const std::string& text, std::string_view part) {
  const auto same = [](unsigned char a, unsigned char b) { return std::tolower(a) == std::tolower(b); };
  return std::search(text.begin(), text.end(), part.begin(), part.end(), same) != text.end();
}

void InspectSemantic(const SemanticMemory& memory, std::size_t most, std::string_view text, mind::LongTermFacts& to) {
  const Knowledge& knowledge = memory.knowledge();
  to.semantic = memory.settings().enabled;
  to.objects = knowledge.object_count();
  to.augmentations = knowledge.edge_count();
  // Sorted by activation, highest first, then by number. Only the objects shown are described, unless a text is
  // searched.
  std::vector<std::pair<double, std::uint32_t>> order;
  for (std::uint32_t object = 0; object < knowledge.object_count(); ++object) {
    if (knowledge.EdgesAt(object).empty()) continue;
    order.emplace_back(memory.activations().Of(object), object);
  }
  const auto before = [&](const auto& a, const auto& b) {
    if (a.first != b.first) return a.first > b.first;
    return knowledge.NumberAt(a.second) < knowledge.NumberAt(b.second);
  };
  const std::size_t sorted = text.empty() ? std::min(most, order.size()) : order.size();
  std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(sorted), order.end(), before);
  for (std::size_t n = 0; n < sorted && to.known.size() < most; ++n) {
    const auto& [activation, object] = order[n];
    mind::KnownObjectFact told;
    told.number = knowledge.NumberAt(object);
    told.text = ObjectText(knowledge, object);
    if (!text.empty() && !Has(told.text, text) && "@" + std::to_string(told.number) != text) continue;
    told.activation = activation;
    const kernel::Activations::Touched* const touched = memory.activations().Find(object);
    told.uses = touched == nullptr ? 0 : touched->count;
    to.known.push_back(std::move(told));
  }
}

}  // namespace

mind::LongTermFacts InspectLongTerm(kernel::Agent& agent, std::size_t most, std::string_view text) {
  mind::LongTermFacts to;
  if (const SemanticMemory* memory = SemanticMemory::Find(std::as_const(agent.long_term()))) {
    InspectSemantic(*memory, most, text, to);
  }
  if (const EpisodicMemory* memory = EpisodicMemory::Find(std::as_const(agent.long_term()))) {
    to.episodic = memory->settings().learning;
    to.episodes = memory->store().last();
    for (kernel::EpisodeNumber n = 1; n <= memory->store().last(); ++n) {
      to.decisions.push_back(memory->DecisionOf(n));
      if (n == 1 || !memory->store().ChangesOf(n).empty()) to.changed.push_back(n);
    }
  }
  return to;
}

std::vector<mind::RememberedFact> InspectEpisode(kernel::Agent& agent, std::size_t number) {
  std::vector<mind::RememberedFact> told;
  const EpisodicMemory* memory = EpisodicMemory::Find(std::as_const(agent.long_term()));
  if (memory == nullptr || number == 0 || number > memory->store().last()) return told;
  const kernel::EpisodeStore& store = memory->store();
  std::vector<kernel::EpisodeTriple> triples;
  for (const kernel::EpisodeFact fact : store.Replay(static_cast<kernel::EpisodeNumber>(number))) {
    triples.push_back(store.triple(fact));
  }
  std::ranges::stable_sort(triples, {}, &kernel::EpisodeTriple::parent);
  // Breadth first from the top state.
  std::vector<kernel::EpisodeNode> objects{0};
  std::set<kernel::EpisodeNode> seen{0};
  for (std::size_t n = 0; n < objects.size(); ++n) {
    for (auto at = std::ranges::lower_bound(triples, objects[n], {}, &kernel::EpisodeTriple::parent);
         at != triples.end() && at->parent == objects[n]; ++at) {
      const kernel::EpisodeTriple& triple = *at;
      mind::RememberedFact& element = told.emplace_back();
      element.object = triple.parent;
      element.attribute = memory->terms().Show(triple.attribute);
      element.is_object = triple.value.IsNode();
      if (!element.is_object) {
        element.value = memory->terms().Show(triple.value.term());
        continue;
      }
      element.value_object = triple.value.node();
      if (seen.insert(triple.value.node()).second) objects.push_back(triple.value.node());
    }
  }
  return told;
}

}  // namespace soarbox
