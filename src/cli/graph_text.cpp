// SPDX-License-Identifier: BSD-2-Clause
#include "cli/graph_text.h"

#include <fmt/format.h>

#include <deque>
#include <unordered_set>

namespace soarbox::cli {

using kernel::Symbol;

std::string GraphQuoted(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '\n') {
      out += "\\n";
      continue;
    }
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out + "\"";
}

std::string GraphRecordText(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '\n') {
      out += "\\n";
      continue;
    }
    if (std::string_view("\"\\{}|<> ").find(c) != std::string_view::npos) out += '\\';
    out += c;
  }
  return out;
}

namespace {

class Drawing {
 public:
  Drawing(const kernel::Agent& agent, int depth, const GraphStyle& style)
      : agent_(agent), depth_(depth), style_(style) {}

  std::string Draw(std::span<const Symbol> roots) {
    text_ = "digraph working_memory {\n";
    text_ += fmt::format("  graph [rankdir=LR, splines={}];\n", GraphQuoted(style_.line_style));
    text_ += fmt::format("  node [shape={}];\n", style_.records ? "record" : "box");
    for (const Symbol root : roots) Visit(root, 0);
    while (!waiting_.empty()) {
      const auto [object, distance] = waiting_.front();
      waiting_.pop_front();
      Object(object, distance);
    }
    return text_ + "}\n";
  }

 private:
  void Visit(Symbol object, int distance) {
    if (seen_.insert(object.bits()).second) waiting_.emplace_back(object, distance);
  }

  std::string Text(Symbol symbol) const { return ToString(agent_.symbols(), symbol); }

  bool Shown(const kernel::Wme& wme, kernel::WmeKind kind) const {
    if (!style_.architecture && kind == kernel::WmeKind::kArchitecture) return false;
    const kernel::WorkingMemory& memory = agent_.memory();
    return !(style_.separate_states && wme.value.IsIdentifier() && memory.identifier(wme.value).is_goal);
  }

  void Object(Symbol object, int distance) {
    const std::string name = GraphQuoted(Text(object));
    std::string rows, links;
    // Objects beyond the last level are named but not expanded.
    if (distance < depth_) {
      for (const kernel::WmeId id : agent_.memory().WmesOf(object)) {
        const kernel::Wme& wme = agent_.memory().wme(id);
        if (!Shown(wme, agent_.memory().record(id).kind)) continue;
        const std::string attribute = Text(wme.attribute) + (wme.acceptable ? " +" : "");
        if (wme.attribute.IsIdentifier()) Visit(wme.attribute, distance + 1);
        if (wme.value.IsIdentifier()) {
          Visit(wme.value, distance + 1);
          links += fmt::format("  {} -> {} [label={}];\n", name, GraphQuoted(Text(wme.value)), GraphQuoted(attribute));
        } else if (style_.records) {
          rows += fmt::format("|{{{}|{}}}", GraphRecordText(attribute), GraphRecordText(Text(wme.value)));
        } else {
          const std::string leaf = GraphQuoted(fmt::format("w{}", wme.timetag));
          links += fmt::format("  {} [shape=plaintext, label={}];\n", leaf, GraphQuoted(Text(wme.value)));
          links += fmt::format("  {} -> {} [label={}];\n", name, leaf, GraphQuoted(attribute));
        }
      }
    }
    const bool is_state = agent_.memory().identifier(object).is_goal;
    if (style_.records) {
      text_ += fmt::format("  {} [label=\"{{{}{}}}\"{}];\n", name, GraphRecordText(Text(object)), rows,
                           is_state ? ", style=bold" : "");
    } else {
      text_ += fmt::format("  {} [label={}{}];\n", name, name, is_state ? ", style=bold" : "");
    }
    text_ += links;
  }

  const kernel::Agent& agent_;
  int depth_;
  const GraphStyle& style_;
  std::string text_;
  std::unordered_set<std::uint32_t> seen_;
  std::deque<std::pair<Symbol, int>> waiting_;
};

}  // namespace

std::string WorkingMemoryGraph(const kernel::Agent& agent, std::span<const Symbol> roots, int depth,
                               const GraphStyle& style) {
  return Drawing(agent, depth, style).Draw(roots);
}

}  // namespace soarbox::cli
