// SPDX-License-Identifier: BSD-2-Clause
#include "cli/object_printer.h"

#include <algorithm>
#include <cstdio>
#include <unordered_map>

#include "kernel/longterm/long_term.h"
#include "kernel/longterm/wm_activation.h"

namespace soarbox::cli {
namespace {

using kernel::Agent;
using kernel::Symbol;
using kernel::Wme;
using kernel::WmeId;

/// Text that would reach this column is moved to the next line.
constexpr int kLineWidth = 79;
constexpr std::string_view kContinuation = "       ";

std::string Show(const Agent& agent, Symbol symbol, bool variables) {
  std::string text = SymbolText(agent, symbol);
  if (variables && symbol.IsIdentifier()) return "<" + text + ">";
  return text;
}

/// The same with the long-term identifier of which an identifier is an instance: L3 (@12).
std::string ShowLinked(const Agent& agent, Symbol symbol, bool variables) {
  std::string text = Show(agent, symbol, variables);
  if (!symbol.IsIdentifier()) return text;
  const std::uint64_t number = agent.memory().long_term_identifiers()[symbol.index()];
  return number == 0 ? text : text + " (@" + std::to_string(number) + ")";
}

/// " [0.75]" for an element while activation of working memory is on; else empty.
std::string ActivationText(const Agent& agent, WmeId wme, bool is_new = false) {
  const kernel::WmActivation* const module = kernel::WmActivation::Find(agent.long_term());
  if (module == nullptr || !module->settings().activation) return {};
  char digits[40];
  std::snprintf(digits, sizeof(digits), " [%.2g]", is_new ? module->OfNew(wme) : module->Of(wme));
  return digits;
}

class ObjectPrinter {
 public:
  ObjectPrinter(PrintStream& stream, const Agent& agent, const ObjectStyle& style, ResultNode& structured)
      : stream_(stream), agent_(agent), style_(style), structured_(structured) {}

  void Print(Symbol root) {
    FindDepths(root);
    PrintLevel(root, 1);
  }

 private:
  /// Breadth first, so that each object gets its smallest depth.
  void FindDepths(Symbol root) {
    const int depth_limit = std::max(style_.depth, 1);
    std::vector<Symbol> level{root};
    depth_[root.bits()] = 1;
    for (int depth = 2; depth <= depth_limit && !level.empty(); ++depth) {
      std::vector<Symbol> next;
      for (const Symbol id : level) {
        for (const WmeId wme : agent_.memory().WmesOf(id)) {
          const Symbol value = agent_.memory().wme(wme).value;
          if (value.IsIdentifier() && depth_.try_emplace(value.bits(), depth).second) next.push_back(value);
        }
      }
      level = std::move(next);
    }
  }

  /// Uses an explicit stack, because the user determines the depth of nesting.
  void PrintLevel(Symbol root, int root_depth) {
    struct Frame {
      std::vector<WmeId> wmes;
      std::size_t next;
      int depth;
    };
    std::vector<Frame> stack;
    const auto open = [&](Symbol id, int depth) {
      const auto found = depth_.find(id.bits());
      if (found == depth_.end() || found->second != depth) return;
      depth_.erase(found);
      Frame frame{SortedWmes(agent_, id), 0, depth};
      if (frame.wmes.empty()) return;
      if (!style_.tree) PrintWhole(id, frame.wmes, depth);
      stack.push_back(std::move(frame));
    };
    open(root, root_depth);
    while (!stack.empty()) {
      Frame& frame = stack.back();
      if (frame.next == frame.wmes.size()) {
        stack.pop_back();
        continue;
      }
      const WmeId wme = frame.wmes[frame.next++];
      if (style_.tree) PrintLine(wme, frame.depth);
      const Symbol value = agent_.memory().wme(wme).value;
      if (value.IsIdentifier()) open(value, frame.depth + 1);
    }
  }

  void PrintLine(WmeId wme, int depth) {
    stream_.Print(std::string(static_cast<std::size_t>(2 * (depth - 1)), ' ') +
                  WmeText(agent_, wme, style_.internal, style_.variables) + "\n");
    if (depth == 1) AddWmeNode(structured_, agent_, wme, style_.internal);
  }

  void PrintWhole(Symbol id, const std::vector<WmeId>& wmes, int depth) {
    if (style_.internal) {
      for (const WmeId wme : wmes) PrintLine(wme, depth);
      return;
    }
    const std::string indent(static_cast<std::size_t>(2 * (depth - 1)), ' ');
    ResultNode& node = structured_.Add("id");
    node.Set("id", SymbolText(agent_, id));
    stream_.Print(indent + "(" + Show(agent_, id, style_.variables));
    stream_.SetColumn(stream_.column() - BracketsOf(id));
    for (const WmeId wme_id : wmes) {
      const Wme& wme = agent_.memory().wme(wme_id);
      std::string text =
          " ^" + Show(agent_, wme.attribute, style_.variables) + " " + ShowLinked(agent_, wme.value, style_.variables);
      if (wme.acceptable) text += " +";
      const int width = static_cast<int>(text.size()) - BracketsOf(wme.attribute) - BracketsOf(wme.value);
      if (stream_.column() + width >= kLineWidth) {
        stream_.Print("\n" + indent + std::string(kContinuation.substr(0, kContinuation.size() - 1)));
      }
      stream_.Print(text);
      stream_.SetColumn(stream_.column() - BracketsOf(wme.attribute) - BracketsOf(wme.value));
      AddWmeNode(node, agent_, wme_id);
    }
    stream_.Print(")\n");
  }

  /// The brackets around variables do not count for the width of lines.
  int BracketsOf(Symbol symbol) const { return style_.variables && symbol.IsIdentifier() ? 2 : 0; }

  PrintStream& stream_;
  const Agent& agent_;
  const ObjectStyle& style_;
  ResultNode& structured_;
  std::unordered_map<std::uint32_t, int> depth_;  ///< Objects still to be printed, by symbol; never iterated.
};

}  // namespace

const char* ValueTypeName(Symbol value) {
  return value.IsIdentifier() ? "id" : value.IsInteger() ? "int" : value.IsFloat() ? "double" : "string";
}

void PrintObject(PrintStream& stream, const Agent& agent, Symbol id, const ObjectStyle& style, ResultNode& structured) {
  ObjectPrinter(stream, agent, style, structured).Print(id);
}

std::string SymbolText(const Agent& agent, Symbol symbol) {
  return kernel::ToString(agent.symbols(), symbol);
}

std::string WmeText(const Agent& agent, WmeId id, bool timetag, bool variables) {
  const Wme& wme = agent.memory().wme(id);
  std::string text = "(";
  if (timetag) text += std::to_string(wme.timetag) + ": ";
  text += Show(agent, wme.id, variables) + " ^" + Show(agent, wme.attribute, variables) + " " +
          Show(agent, wme.value, variables);
  if (timetag) text += ActivationText(agent, id);
  if (wme.acceptable) text += " +";
  return text + ")";
}

std::string WmeText(const Agent& agent, const kernel::WmeInfo& wme, bool timetag, bool is_new) {
  std::string text = "(";
  if (timetag) text += std::to_string(wme.timetag) + ": ";
  text += SymbolText(agent, wme.id) + " ^" + SymbolText(agent, wme.attribute) + " " + SymbolText(agent, wme.value);
  if (timetag) text += ActivationText(agent, wme.wme, is_new);
  if (wme.acceptable) text += " +";
  return text + ")";
}

std::string MatchedText(const Agent& agent, WmeId wme, kernel::GoalLevel level) {
  if (level > 1) return " " + WmeText(agent, wme);
  return "WME with time tag " + std::to_string(agent.memory().wme(wme).timetag);
}

std::vector<WmeId> SortedWmes(const Agent& agent, Symbol id) {
  std::vector<WmeId> wmes = agent.memory().WmesOf(id);
  // Among equal attributes, those of the architecture and input come first.
  std::stable_partition(wmes.begin(), wmes.end(),
                        [&](WmeId wme) { return agent.memory().record(wme).slot() == kernel::SlotId::kNone; });
  std::vector<std::pair<std::string, WmeId>> named;
  named.reserve(wmes.size());
  for (const WmeId wme : wmes) named.emplace_back(SymbolText(agent, agent.memory().wme(wme).attribute), wme);
  std::stable_sort(named.begin(), named.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (std::size_t i = 0; i < wmes.size(); ++i) wmes[i] = named[i].second;
  return wmes;
}

void AddWmeNode(ResultNode& parent, const Agent& agent, WmeId id, bool with_tag) {
  const Wme& wme = agent.memory().wme(id);
  ResultNode& node = parent.Add("wme");
  node.Set("attr", kernel::ToString(agent.symbols(), wme.attribute, false));
  node.Set("id", SymbolText(agent, wme.id));
  if (wme.acceptable) node.Set("preference", "+");
  if (with_tag) node.Set("tag", std::to_string(wme.timetag));
  node.Set("valtype", ValueTypeName(wme.value));
  node.Set("value", kernel::ToString(agent.symbols(), wme.value, false));
}

}  // namespace soarbox::cli
