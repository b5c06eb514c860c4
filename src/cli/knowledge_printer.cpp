// SPDX-License-Identifier: BSD-2-Clause
#include "cli/knowledge_printer.h"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <map>
#include <set>
#include <vector>

#include "cli/graph_text.h"
#include "kernel/agent.h"
#include "kernel/longterm/knowledge_reader.h"
#include "kernel/longterm/long_term.h"
#include "kernel/longterm/semantic_memory.h"

namespace soarbox::cli {
namespace {

using kernel::Edge;
using kernel::Knowledge;
using kernel::StoreTerm;

/// Names the objects of a memory, by number or, as in Soar 9.6.5, by alias.
class Names {
 public:
  Names(const kernel::SemanticMemory& memory, kernel::SoarVersion like) : memory_(memory) {
    if (like == kernel::SoarVersion::k963) return;
    for (const auto& [name, number] : memory.knowledge().Aliases()) alias_of_.insert_or_assign(number, name);
  }
  const kernel::SemanticMemory& memory() const { return memory_; }
  const Knowledge& knowledge() const { return memory_.knowledge(); }
  /// "@steel", or "@3" for an object without a name.
  std::string Of(std::uint32_t object) const {
    const kernel::Lti number = knowledge().NumberAt(object);
    const auto alias = alias_of_.find(number);
    return "@" + (alias != alias_of_.end() ? alias->second : std::to_string(number));
  }

 private:
  const kernel::SemanticMemory& memory_;
  std::map<kernel::Lti, std::string> alias_of_;
};

std::string TermText(const Names& names, StoreTerm term, bool short_floats = false) {
  if (term.IsObject()) return names.Of(term.index());
  std::string text;
  names.knowledge().terms().Append(text, term, short_floats);
  return text;
}

/// Augmentations in the order in which they are shown. `by_name`: attributes in alphabetical order, else in the order
/// of their first occurrence in the store.
std::string Augmentations(const Names& names, std::uint32_t object, bool by_name, bool short_floats = false) {
  struct Group {
    std::string attribute;
    std::vector<Edge> edges;
  };
  std::vector<Group> groups;
  for (const Edge& edge : names.knowledge().OrderedEdgesAt(object)) {
    if (groups.empty() || groups.back().edges.front().attribute != edge.attribute) {
      groups.push_back({TermText(names, edge.attribute), {}});
    }
    groups.back().edges.push_back(edge);
  }
  if (by_name) std::ranges::stable_sort(groups, {}, &Group::attribute);
  std::string text;
  for (const Group& group : groups) {
    text += " ^" + group.attribute;
    for (const Edge& edge : group.edges) text += " " + TermText(names, edge.value, short_floats);
  }
  return text;
}

std::string Line(const Names& names, std::uint32_t object, std::optional<double> activation) {
  return fmt::format("({}{} [{:+.3f}])\n", names.Of(object),
                     Augmentations(names, object, true, names.memory().TakeFirstLine()),
                     activation ? *activation : names.memory().ActivationOf(object));
}

}  // namespace

std::string ObjectLine(const kernel::SemanticMemory& memory, std::uint32_t object, kernel::SoarVersion like,
                       std::optional<double> activation) {
  return Line(Names(memory, like), object, activation);
}

std::string ObjectTree(const kernel::SemanticMemory& memory, std::uint32_t object, int depth,
                       kernel::SoarVersion like) {
  const Knowledge& knowledge = memory.knowledge();
  const Names names(memory, like);
  std::string text;
  std::deque<std::pair<std::uint32_t, int>> open{{object, 1}};
  std::set<std::uint32_t> seen{object};
  while (!open.empty()) {
    const auto [next, level] = open.front();
    open.pop_front();
    text += std::string(static_cast<std::size_t>(2 * (level - 1)), ' ') + Line(names, next, {});
    if (level >= depth) continue;
    std::map<kernel::Lti, std::uint32_t> children;
    for (const Edge& edge : knowledge.EdgesAt(next)) {
      if (edge.value.IsObject()) children.emplace(knowledge.NumberAt(edge.value.index()), edge.value.index());
    }
    for (const auto& [number, child] : children) {
      if (seen.insert(child).second) open.emplace_back(child, level + 1);
    }
  }
  return text;
}

namespace {

std::vector<std::uint32_t> ByNumber(const Knowledge& knowledge) {
  std::vector<std::uint32_t> objects(knowledge.object_count());
  for (std::uint32_t n = 0; n < objects.size(); ++n) objects[n] = n;
  std::ranges::sort(objects, {}, [&](std::uint32_t object) { return knowledge.NumberAt(object); });
  return objects;
}

}  // namespace

std::string AllObjects(const kernel::SemanticMemory& memory, kernel::SoarVersion like) {
  const Names names(memory, like);
  std::string text;
  for (const std::uint32_t object : ByNumber(memory.knowledge())) text += Line(names, object, {});
  return text;
}

std::string ExportText(const kernel::SemanticMemory& memory, std::optional<std::uint32_t> root,
                       kernel::SoarVersion like) {
  const Knowledge& knowledge = memory.knowledge();
  const Names names(memory, like);
  std::vector<std::uint32_t> objects = ByNumber(knowledge);
  if (root) {
    std::set<std::uint32_t> reached{*root};
    std::vector<std::uint32_t> open{*root};
    while (!open.empty()) {
      const std::uint32_t next = open.back();
      open.pop_back();
      for (const Edge& edge : knowledge.EdgesAt(next)) {
        if (edge.value.IsObject() && reached.insert(edge.value.index()).second) open.push_back(edge.value.index());
      }
    }
    std::erase_if(objects, [&](std::uint32_t object) { return !reached.contains(object); });
  }
  std::string text = "smem --add {\n";
  for (const std::uint32_t object : objects) {
    // An object without augmentations is restored by the links that lead to it.
    if (knowledge.EdgesAt(object).empty()) continue;
    text += fmt::format("({}{})\n", names.Of(object), Augmentations(names, object, false));
  }
  return text + "}\n";
}

std::string KnowledgeGraph(const kernel::SemanticMemory& memory, std::optional<std::uint32_t> root, int depth,
                           kernel::SoarVersion like) {
  const Knowledge& knowledge = memory.knowledge();
  const Names names(memory, like);
  std::deque<std::pair<std::uint32_t, int>> open;
  std::set<std::uint32_t> seen;
  if (root) {
    open.emplace_back(*root, 0);
  } else {
    for (const std::uint32_t object : ByNumber(knowledge)) open.emplace_back(object, 0);
  }
  for (const auto& [object, distance] : open) seen.insert(object);
  std::string text = "digraph smem {\n  node [shape=record];\n";
  while (!open.empty()) {
    const auto [object, distance] = open.front();
    open.pop_front();
    const std::string name = GraphQuoted(names.Of(object));
    std::string rows, links;
    // Objects beyond the last level are named but not expanded.
    for (const Edge& edge : distance < depth ? knowledge.EdgesAt(object) : std::span<const Edge>()) {
      const std::string attribute = TermText(names, edge.attribute);
      const std::string value = TermText(names, edge.value);
      if (!edge.value.IsObject()) {
        rows += fmt::format("|{{{}|{}}}", GraphRecordText(attribute), GraphRecordText(value));
        continue;
      }
      links += fmt::format("  {} -> {} [label={}];\n", name, GraphQuoted(value), GraphQuoted(attribute));
      if (seen.insert(edge.value.index()).second) open.emplace_back(edge.value.index(), distance + 1);
    }
    text += fmt::format("  {} [label=\"{{{}{}}}\"];\n{}", name, GraphRecordText(names.Of(object)), rows, links);
  }
  return text + "}\n";
}

std::string PrintedKnowledge(kernel::Agent& agent, const std::string& word, int depth) {
  if (kernel::SemanticMemory::Find(agent.long_term()) != nullptr) {
    kernel::SemanticMemory& asked = kernel::SemanticMemory::Of(agent.long_term());
    if (asked.waits_for_file()) asked.EnsureOpen();
  }
  const kernel::SemanticMemory* const memory = kernel::SemanticMemory::Find(agent.long_term());
  const kernel::SoarVersion like = agent.settings().like;
  if (word == "@" || word == "@0") return memory == nullptr ? std::string() : AllObjects(*memory, like);
  const kernel::Lti number = memory == nullptr ? 0 : kernel::ObjectNamed(*memory, word);
  if (number == 0) return "LTI " + word + " not found in semantic memory.\n";
  return ObjectTree(*memory, memory->knowledge().Find(number), depth, like);
}

}  // namespace soarbox::cli
