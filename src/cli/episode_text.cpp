// SPDX-License-Identifier: BSD-2-Clause
#include "cli/episode_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <vector>

#include "kernel/longterm/episodic_memory.h"

namespace soarbox::cli {
namespace {

using kernel::EpisodeFact;
using kernel::EpisodeNode;
using kernel::EpisodeNumber;
using kernel::EpisodeTriple;
using kernel::EpisodicMemory;

std::vector<EpisodeTriple> TriplesOf(const EpisodicMemory& memory, EpisodeNumber episode) {
  std::vector<EpisodeTriple> triples;
  for (const EpisodeFact fact : memory.store().Replay(episode)) triples.push_back(memory.store().triple(fact));
  return triples;
}

std::string Escape(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '"' || c == '\\') escaped += '\\';
    escaped += c;
  }
  return escaped;
}

}  // namespace

std::string EpisodeText(const EpisodicMemory& memory, EpisodeNumber episode) {
  const auto name = [&](EpisodeNode node) {
    const std::uint64_t lti = memory.store().Link(node, episode);
    return lti != 0 ? fmt::format("@{}", lti) : fmt::format("<id{}>", node);
  };
  std::map<EpisodeNode, std::map<std::string, std::string>> objects;
  for (const EpisodeTriple& triple : TriplesOf(memory, episode)) {
    std::string& values = objects[triple.parent][memory.terms().Show(triple.attribute)];
    values += " ";
    values += triple.value.IsNode() ? name(triple.value.node()) : memory.terms().Show(triple.value.term());
  }
  std::string text;
  for (const auto& [node, attributes] : objects) {
    text += "(" + name(node);
    for (const auto& [attribute, values] : attributes) text += " ^" + attribute + values;
    text += ")\n";
  }
  return text;
}

std::string EpisodeGraph(const EpisodicMemory& memory, EpisodeNumber episode) {
  const auto name = [&](EpisodeNode node) {
    const std::uint64_t lti = memory.store().Link(node, episode);
    return lti != 0 ? fmt::format("L_{}", lti) : fmt::format("ID_{}", node);
  };
  const std::vector<EpisodeTriple> triples = TriplesOf(memory, episode);
  std::set<EpisodeNode> nodes = {0};
  std::string edges, constants, values;
  std::size_t number = 0;
  std::vector<EpisodeTriple> links;
  for (const EpisodeTriple& triple : triples) {
    const std::string label = Escape(memory.terms().Show(triple.attribute));
    if (triple.value.IsNode()) {
      nodes.insert(triple.value.node());
      links.push_back(triple);
      continue;
    }
    ++number;
    constants += fmt::format("C_{} [ label=\"{}\" ];\n", number, Escape(memory.terms().Show(triple.value.term())));
    values += fmt::format("{} -> C_{} [ label=\"{}\" ];\n", name(triple.parent), number, label);
  }
  std::sort(links.begin(), links.end(), [](const EpisodeTriple& a, const EpisodeTriple& b) {
    return std::pair(a.parent, a.value.bits()) < std::pair(b.parent, b.value.bits());
  });
  for (const EpisodeTriple& link : links) {
    edges += fmt::format("{} -> {} [ label=\"{}\" ];\n", name(link.parent), name(link.value.node()),
                         Escape(memory.terms().Show(link.attribute)));
  }
  std::string plain, linked;
  for (const EpisodeNode node : nodes) (memory.store().Link(node, episode) == 0 ? plain : linked) += name(node) + " ";
  if (!linked.empty()) linked += ";";
  return fmt::format(
      "digraph epmem {{\nnode [ shape = circle ];\n{};\nnode [ shape = doublecircle ];\n{}\n{}node [ shape = plaintext "
      "];\n{}{}\n}}\n",
      plain, linked, edges, constants, values);
}

}  // namespace soarbox::cli
