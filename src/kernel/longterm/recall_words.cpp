// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/longterm/recall_words.h"

#include <algorithm>
#include <cstdio>
#include <vector>

#include "kernel/base/symbol_table.h"
#include "kernel/memory/working_memory.h"

namespace soarbox::kernel {
namespace {

constexpr std::size_t kMostWords = 8, kMostConstants = 4;

class CueWriter {
 public:
  CueWriter(const WorkingMemory& memory, const SymbolTable& symbols) : memory_(memory), symbols_(symbols) {}

  void Write(Symbol object, const std::string& path, int depth) {
    open_.push_back(object);
    // An object lists its elements newest first.
    std::vector<WmeId> elements = memory_.WmesOf(object);
    std::ranges::sort(elements, {}, [&](WmeId wme) { return memory_.wme(wme).timetag; });
    for (const WmeId element : elements) {
      const Wme& wme = memory_.wme(element);
      const std::string here = path + (path.empty() ? "" : ".") + ToString(symbols_, wme.attribute, true);
      const std::uint64_t linked = wme.value.IsIdentifier() ? memory_.long_term_identifiers()[wme.value.index()] : 0;
      if (wme.value.IsIdentifier() && depth > 1 && std::ranges::find(open_, wme.value) == open_.end() &&
          !memory_.WmesOf(wme.value).empty()) {
        Write(wme.value, here, depth - 1);
      } else if (linked != 0) {
        Say(here, "@" + std::to_string(linked));
      } else {
        Say(here, wme.value.IsIdentifier() ? "<any>" : ToString(symbols_, wme.value, true));
      }
    }
    open_.pop_back();
  }
  std::string Take() { return count_ > kMostWords ? text_ + " ..." : text_; }

 private:
  void Say(const std::string& path, const std::string& value) {
    if (++count_ > kMostWords) return;
    text_ += (text_.empty() ? "^" : " ^") + path + " " + value;
  }

  const WorkingMemory& memory_;
  const SymbolTable& symbols_;
  std::vector<Symbol> open_;
  std::string text_;
  std::size_t count_ = 0;
};

std::string Activation(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.3f", value);
  return text;
}

std::string Name(const Knowledge& knowledge, std::uint32_t object) {
  return "@" + std::to_string(knowledge.NumberAt(object));
}

}  // namespace

std::string CueWords(const WorkingMemory& memory, const SymbolTable& symbols, Symbol cue, int depth) {
  CueWriter writer(memory, symbols);
  if (cue.IsIdentifier()) writer.Write(cue, {}, depth);
  return writer.Take();
}

std::string ObjectWords(const Knowledge& knowledge, std::uint32_t object) {
  std::string text;
  std::size_t count = 0;
  for (const Edge& edge : knowledge.OrderedEdgesAt(object)) {
    if (edge.value.IsObject()) continue;
    if (++count > kMostConstants) return text + " ...";
    text += text.empty() ? "^" : " ^";
    knowledge.terms().Append(text, edge.attribute);
    text += " ";
    knowledge.terms().Append(text, edge.value, true);
  }
  return text;
}

std::string WhyFound(const Knowledge& knowledge, const Activations& activations, const Cue& cue,
                     std::span<const std::uint32_t> others) {
  for (const CueElement& element : cue.elements) {
    if (element.math == MathTest::kMax) return "its number is the largest of those that fit";
    if (element.math == MathTest::kMin) return "its number is the smallest of those that fit";
  }
  if (others.empty()) return "the most active of many that fit";
  if (others.size() == 1) return "the only one that fits";
  const double best = activations.Of(others[0]), next = activations.Of(others[1]);
  if (activations.Find(others[0]) != nullptr && activations.Find(others[1]) == nullptr) {
    return "the most active of those that fit: " + Activation(best) + "; " + Name(knowledge, others[1]) +
           " was never used";
  }
  if (best == next) {
    return "as active as " + Name(knowledge, others[1]) + " (" + Activation(best) +
           "), which fits too, and stored later";
  }
  return "the most active of those that fit: " + Activation(best) + ", then " + Name(knowledge, others[1]) + " with " +
         Activation(next);
}

std::string WhyNotFound(const Knowledge& knowledge, const WorkingMemory& memory, const SymbolTable& symbols, Symbol cue,
                        bool prohibited_fits) {
  if (prohibited_fits) return "all that fit are prohibited";
  for (const WmeId element : memory.WmesOf(cue)) {
    const Wme& wme = memory.wme(element);
    if (!wme.attribute.IsConstant() || wme.value.IsIdentifier()) continue;
    const Terms& terms = knowledge.terms();
    const StoreTerm attribute = FindTerm(terms, symbols, wme.attribute), value = FindTerm(terms, symbols, wme.value);
    const std::uint32_t list = attribute && value ? knowledge.FindList(attribute, value) : Knowledge::kNowhere;
    if (list != Knowledge::kNowhere && !knowledge.ListAt(list).empty()) continue;
    return "no known object has ^" + ToString(symbols, wme.attribute, true) + " " + ToString(symbols, wme.value, true);
  }
  return "no object has all of it";
}

}  // namespace soarbox::kernel
