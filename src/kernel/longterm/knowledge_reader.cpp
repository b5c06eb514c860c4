// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/longterm/knowledge_reader.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>
#include <vector>

#include "kernel/base/bump_arena.h"
#include "kernel/longterm/semantic_memory.h"
#include "kernel/longterm/written_order.h"
#include "kernel/rules/lexer.h"

namespace soarbox::kernel {
namespace {

/// Minimum size in bytes of texts that are parsed once for all agents.
constexpr std::size_t kWorthRecognising = 1 << 18;

/// An object or a value in the text.
struct WrittenValue {
  enum class Kind : std::uint8_t { kNumber, kAlias, kVariable, kString, kIdentifier, kInteger, kFloat };
  Kind kind = Kind::kString;
  std::string text;  ///< For kAlias, kVariable, kString, kIdentifier.
  std::int64_t integer = 0;
  double real = 0;
  Lti number = 0;     ///< For kNumber.
  double weight = 0;  ///< For a link: its fraction of the spreading activation; 0 if none was written.

  bool IsObject() const { return kind <= Kind::kVariable; }
};

struct WrittenAugmentation {
  std::vector<WrittenValue> path;  ///< The attribute, and those after its dots.
  std::vector<WrittenValue> values;
  bool negative = false;
  std::uint32_t place = 0;  ///< See WrittenOrder.
};

struct WrittenClause {
  WrittenValue object;
  std::vector<WrittenAugmentation> augmentations;
  bool has_weights = false;
};

/// Splits a text into clauses. Stops at the first invalid one.
class ClauseReader {
 public:
  explicit ClauseReader(std::string_view text) : text_(text), lexer_(text, arena_) { Advance(); }

  /// Whether there is another clause. As in Soar 9.6.3, text after the last clause is ignored.
  bool HasMore() const { return token_.kind == TokenKind::kLeftParen; }
  /// For the clause that Read failed to read: whether its object was missing or invalid.
  bool failed_at_object() const { return failed_at_object_; }
  /// Problems with weights, one per line.
  const std::string& notes() const { return notes_; }

  /// `needs_values`: an attribute without a value is an error.
  std::optional<WrittenClause> Read(bool needs_values) {
    failed_at_object_ = true;
    if (token_.kind != TokenKind::kLeftParen) return {};
    Advance();
    WrittenClause clause;
    const std::optional<WrittenValue> object = ReadValue();
    if (!object || !object->IsObject()) return {};
    failed_at_object_ = false;
    clause.object = *object;
    while (token_.kind != TokenKind::kRightParen) {
      WrittenAugmentation made;
      if (token_.kind == TokenKind::kMinus) {
        made.negative = true;
        Advance();
      }
      if (token_.kind != TokenKind::kUpArrow) return {};
      do {
        Advance();
        const std::optional<WrittenValue> attribute = ReadValue();
        if (!attribute || attribute->IsObject() || attribute->kind == WrittenValue::Kind::kIdentifier) return {};
        made.path.push_back(*attribute);
      } while (token_.kind == TokenKind::kPeriod);
      while (token_.kind != TokenKind::kUpArrow && token_.kind != TokenKind::kRightParen &&
             token_.kind != TokenKind::kMinus) {
        const std::optional<WrittenValue> value = ReadValue();
        if (!value) return {};
        made.values.push_back(*value);
        if (token_.kind == TokenKind::kLeftParen) ReadWeight(clause.object, made.values.back());
        clause.has_weights = clause.has_weights || made.values.back().weight != 0;
      }
      if (made.values.empty() && needs_values) return {};
      clause.augmentations.push_back(std::move(made));
    }
    Advance();
    return clause;
  }

 private:
  void Advance() { token_ = lexer_.Next(); }

  std::optional<WrittenValue> ReadValue() {
    WrittenValue value;
    switch (token_.kind) {
      case TokenKind::kAt: {
        const std::size_t end = token_.offset + token_.length;
        Advance();
        if (token_.offset != end) return {};
        if (token_.kind == TokenKind::kInteger && token_.integer >= 0) {
          value.kind = WrittenValue::Kind::kNumber;
          value.number = static_cast<Lti>(token_.integer);
        } else if (token_.kind == TokenKind::kString || token_.kind == TokenKind::kIdentifier) {
          value.kind = WrittenValue::Kind::kAlias;
          value.text = text_.substr(token_.offset, token_.length);
        } else {
          return {};
        }
        break;
      }
      case TokenKind::kVariable:
        value.kind = WrittenValue::Kind::kVariable;
        value.text = token_.text;
        break;
      case TokenKind::kString:
        value.kind = WrittenValue::Kind::kString;
        value.text = token_.text;
        break;
      case TokenKind::kIdentifier:
        value.kind = WrittenValue::Kind::kIdentifier;
        value.text = text_.substr(token_.offset, token_.length);
        break;
      case TokenKind::kInteger:
        value.kind = WrittenValue::Kind::kInteger;
        value.integer = token_.integer;
        break;
      case TokenKind::kFloat:
        value.kind = WrittenValue::Kind::kFloat;
        value.real = token_.real;
        break;
      default:
        return {};
    }
    Advance();
    return value;
  }

  /// Reads "(0.5)". Problems are added to the notes, and the value gets no weight.
  void ReadWeight(const WrittenValue& object, WrittenValue& value) {
    const auto note = [&](std::string_view what) {
      notes_ += "Edge weight input for smem -add clause for @" + std::to_string(object.number) + " is " +
                std::string(what) + "\n";
    };
    Advance();
    if (token_.kind == TokenKind::kFloat) {
      value.weight = token_.real;
    } else if (token_.kind == TokenKind::kInteger) {
      value.weight = static_cast<double>(token_.integer);
    } else {
      note("not float or integer: " + std::string(text_.substr(token_.offset, token_.length)));
    }
    Advance();
    if (token_.kind != TokenKind::kRightParen) return note("missing right paren.");
    Advance();
  }

  bool failed_at_object_ = false;
  std::string notes_;
  std::string_view text_;
  Arena arena_;
  Lexer lexer_;
  RuleToken token_;
};

std::string InClause(std::size_t number) {
  return "Error parsing clause #" + std::to_string(number);
}

/// Executes clauses.
class Adder {
 public:
  /// `as_written`: attributes are processed in the order of the text, regardless of the symbols that the agent knows.
  explicit Adder(SemanticMemory& memory, bool as_written) : memory_(memory), as_written_(as_written) {}

  void Add(WrittenClause& clause) {
    const bool is_ordered = Order(clause.augmentations);
    // The objects of a path are created from its end, and may get the number of the clause's object.
    std::vector<std::vector<std::uint32_t>> paths;
    const auto make_path = [&](const WrittenAugmentation& augmentation) {
      std::vector<std::uint32_t>& between = paths.emplace_back(augmentation.path.size() - 1);
      for (std::size_t n = between.size(); n-- > 0;) between[n] = memory_.NewObject();
    };
    const bool makes_paths_first = clause.object.kind == WrittenValue::Kind::kNumber;
    if (makes_paths_first) std::ranges::for_each(clause.augmentations, make_path);
    const std::uint32_t object = ObjectOf(clause.object);
    weighted_.clear();
    for (std::size_t at = 0; at < clause.augmentations.size(); ++at) {
      const WrittenAugmentation& augmentation = clause.augmentations[at];
      if (!makes_paths_first) make_path(augmentation);
      const std::vector<std::uint32_t>& between = paths[at];
      std::uint32_t owner = object;
      for (std::size_t n = 0; n < between.size(); ++n) {
        AddLink(clause, owner, TermOf(augmentation.path[n]), StoreTerm::Object(between[n]), 0);
        owner = between[n];
      }
      const StoreTerm attribute = TermOf(augmentation.path.back());
      for (const WrittenValue& value : augmentation.values) {
        const StoreTerm term = TermOf(value);
        if (term.IsObject()) {
          AddLink(clause, owner, attribute, term, value.weight);
        } else {
          memory_.AddEdge(owner, attribute, term);
        }
      }
    }
    for (const auto& [owner, weighted] : weighted_) {
      if (!weighted.added.empty()) memory_.SetWeights(owner, weighted.before, weighted.added);
    }
    if (!is_ordered) return;
    WrittenOrder& order = memory_.written_order();
    for (const WrittenAugmentation& augmentation : clause.augmentations) {
      for (const WrittenValue& value : augmentation.values) {
        if (IsText(value)) order.Drop(value.text);
      }
      for (const WrittenValue& attribute : augmentation.path) {
        if (IsText(attribute)) order.Drop(attribute.text);
      }
    }
  }

 private:
  void AddLink(const WrittenClause& clause, std::uint32_t owner, StoreTerm attribute, StoreTerm value, double weight) {
    if (clause.has_weights) {
      const auto [place, added] = weighted_.try_emplace(owner);
      if (added) place->second.before = memory_.WeightsOf(owner);
      if (weight != 0) place->second.added[value.index()] = weight;
    }
    if (!memory_.AddEdge(owner, attribute, value)) memory_.ResetWeights(owner);
  }
  static bool IsText(const WrittenValue& value) {
    return value.kind == WrittenValue::Kind::kString || value.kind == WrittenValue::Kind::kIdentifier;
  }
  /// Sorts augmentations in the order in which the store processes them. Returns false if that is the order of the
  /// text.
  bool Order(std::vector<WrittenAugmentation>& augmentations) {
    if (as_written_) return false;
    std::size_t texts = 0;
    for (const WrittenAugmentation& augmentation : augmentations) {
      texts += augmentation.path.size() + augmentation.values.size();
    }
    if (texts > WrittenOrder::kMostTexts) return false;
    WrittenOrder& order = memory_.written_order();
    for (WrittenAugmentation& augmentation : augmentations) {
      for (const WrittenValue& attribute : augmentation.path) {
        if (!IsText(attribute)) continue;
        const std::uint32_t place = order.Read(attribute.text, memory_.symbols());
        if (&attribute == &augmentation.path.front()) augmentation.place = place;
      }
      for (const WrittenValue& value : augmentation.values) {
        if (IsText(value)) order.Read(value.text, memory_.symbols());
      }
    }
    if (!std::ranges::is_sorted(augmentations, {}, &WrittenAugmentation::place)) {
      std::ranges::stable_sort(augmentations, {}, &WrittenAugmentation::place);
    }
    return true;
  }
  std::uint32_t ObjectOf(const WrittenValue& value) {
    if (value.kind == WrittenValue::Kind::kNumber && value.number != 0) return memory_.ObjectOf(value.number);
    if (value.kind == WrittenValue::Kind::kAlias) {
      if (const Lti known = memory_.knowledge().FindAlias(value.text)) return memory_.ObjectOf(known);
      const std::uint32_t made = memory_.NewObject();
      memory_.SetAlias(value.text, memory_.knowledge().NumberAt(made));
      return made;
    }
    // @0 is a variable, too.
    const auto [place, added] = variables_.try_emplace(value.text, 0);
    if (added) place->second = memory_.NewObject();
    return place->second;
  }
  StoreTerm TermOf(const WrittenValue& value) {
    if (value.IsObject()) return StoreTerm::Object(ObjectOf(value));
    if (value.kind == WrittenValue::Kind::kInteger) return memory_.IntegerTerm(value.integer);
    if (value.kind == WrittenValue::Kind::kFloat) return memory_.FloatTerm(value.real);
    return memory_.StringTerm(value.text);
  }

  SemanticMemory& memory_;
  bool as_written_;
  std::map<std::string, std::uint32_t> variables_;
  struct Weighted {
    LinkWeights::Weights before, added;
  };
  std::map<std::uint32_t, Weighted> weighted_;  ///< Objects whose links have weights in a clause.
};

std::uint32_t FindObject(const SemanticMemory& memory, const WrittenValue& value) {
  const Knowledge& knowledge = memory.knowledge();
  if (value.kind == WrittenValue::Kind::kNumber) {
    return value.number == 0 ? Knowledge::kNowhere : knowledge.Find(value.number);
  }
  const Lti number = value.kind == WrittenValue::Kind::kAlias ? knowledge.FindAlias(value.text) : 0;
  return number == 0 ? Knowledge::kNowhere : knowledge.Find(number);
}

StoreTerm FindTerm(const SemanticMemory& memory, const WrittenValue& value) {
  const Terms& terms = memory.knowledge().terms();
  if (value.IsObject()) {
    const std::uint32_t object = FindObject(memory, value);
    return object == Knowledge::kNowhere ? StoreTerm() : StoreTerm::Object(object);
  }
  if (value.kind == WrittenValue::Kind::kInteger) return terms.FindInteger(value.integer);
  if (value.kind == WrittenValue::Kind::kFloat) return terms.FindFloat(value.real);
  return terms.FindString(value.text);
}

struct Removal {
  std::uint32_t object;
  StoreTerm attribute, value;
};

/// Determines what a clause removes. Appends missing things to `errors`. Returns false if the clause fails because of
/// them.
bool Plan(const SemanticMemory& memory, const WrittenClause& clause, bool force, std::vector<Removal>& plan,
          std::string& errors) {
  const Knowledge& knowledge = memory.knowledge();
  const auto note = [&](std::string_view message) { errors += "Error: " + std::string(message) + "\n"; };
  const std::uint32_t object = FindObject(memory, clause.object);
  if (object == Knowledge::kNowhere) {
    note(clause.object.kind == WrittenValue::Kind::kVariable ? "The lti id must be an integer."
                                                             : "No LTI found for that id.");
    return false;
  }
  const std::span<const Edge> edges = knowledge.EdgesAt(object);
  if (clause.augmentations.empty()) {
    for (const Edge& edge : edges) plan.push_back({object, edge.attribute, edge.value});
  }
  for (const WrittenAugmentation& augmentation : clause.augmentations) {
    const StoreTerm attribute = FindTerm(memory, augmentation.path.front());
    const bool has = attribute && knowledge.Has(object, attribute);
    // An attribute that the agent knows is not an error, unless a value is specified, too.
    const WrittenValue& named = augmentation.path.front();
    const bool is_text = named.kind == WrittenValue::Kind::kString || named.kind == WrittenValue::Kind::kIdentifier;
    if (!has && augmentation.path.size() == 1 && augmentation.values.empty() && is_text &&
        memory.symbols().FindString(named.text)) {
      continue;
    }
    if (augmentation.path.size() > 1 || !has) {
      note("Attribute was not found.");
      // `force` skips a missing attribute without values if another one follows.
      if (force && augmentation.values.empty() && &augmentation != &clause.augmentations.back()) continue;
      return false;
    }
    if (augmentation.values.empty()) {
      for (const Edge& edge : edges) {
        if (edge.attribute == attribute) plan.push_back({object, attribute, edge.value});
      }
    }
    for (const WrittenValue& written : augmentation.values) {
      const StoreTerm value = FindTerm(memory, written);
      if (value && knowledge.Has(object, attribute, value)) {
        plan.push_back({object, attribute, value});
      } else {
        note("Value does not exist on attribute.");
      }
    }
  }
  return true;
}

}  // namespace

std::string AddKnowledge(SemanticMemory& memory, std::string_view text, std::string& notes) {
  // Shared knowledge must not depend on a particular agent.
  const bool is_large = text.size() >= kWorthRecognising;
  const bool is_first = is_large && memory.knowledge().object_count() == 0 && memory.knowledge().terms().empty();
  if (is_first && memory.TakeText(text)) return {};
  const Lti next_number = memory.knowledge().next_number();
  ClauseReader reader(text);
  Adder adder(memory, is_large);
  std::size_t number = 0;
  // Clauses before an invalid clause are added.
  do {
    std::optional<WrittenClause> clause = reader.Read(true);
    notes = reader.notes();
    if (!clause || clause->augmentations.empty() ||
        std::ranges::any_of(clause->augmentations, &WrittenAugmentation::negative)) {
      return InClause(number);
    }
    adder.Add(*clause);
    ++number;
  } while (reader.HasMore());
  if (is_first) memory.NoteText(text, next_number);
  return {};
}

std::string ReadQuery(const SemanticMemory& memory, std::string_view text, Cue& cue) {
  const auto problem = [&](std::string_view what, std::size_t clause) {
    return "Error while parsing query\n" + std::string(what) + InClause(clause) + ".";
  };
  ClauseReader reader(text);
  std::string variable;
  std::size_t number = 0;
  do {
    const bool begins = reader.HasMore();
    const std::optional<WrittenClause> clause = reader.Read(true);
    const bool is_variable = clause ? clause->object.kind == WrittenValue::Kind::kVariable : !reader.failed_at_object();
    if (number == 0 && !is_variable) return problem(begins ? "Error: The cue must be a variable.\n" : "", 0);
    if (!is_variable || (clause && number > 0 && clause->object.text != variable)) {
      return problem("Error: Additional clauses must share same variable.\n", number);
    }
    ++number;
    if (!clause) return problem("", number);
    variable = clause->object.text;
    for (const WrittenAugmentation& augmentation : clause->augmentations) {
      if (augmentation.path.size() > 1) return problem("", number);
      if (augmentation.negative && cue.elements.empty() && !cue.impossible) return problem("", number);
      const StoreTerm attribute = FindTerm(memory, augmentation.path.front());
      for (const WrittenValue& written : augmentation.values) {
        const bool any =
            written.kind == WrittenValue::Kind::kVariable || written.kind == WrittenValue::Kind::kIdentifier;
        const StoreTerm value = any ? StoreTerm() : FindTerm(memory, written);
        if (written.IsObject() && !any && !value) return problem("Error: LTI was not found.\n", number);
        const bool unknown = !attribute || (!any && !value);
        if (unknown && augmentation.negative) continue;
        cue.impossible = cue.impossible || unknown;
        cue.elements.push_back({attribute, value, augmentation.negative});
      }
    }
  } while (reader.HasMore());
  return {};
}

std::string RemoveKnowledge(SemanticMemory& memory, std::string_view text, bool force, bool& failed) {
  // As in Soar 9.6.3, only the first clause counts.
  ClauseReader reader(text);
  const std::optional<WrittenClause> clause = reader.Read(false);
  failed = true;
  if (!clause && reader.failed_at_object()) {
    return "Error: The lti id must be an integer.\n";
  }
  if (!clause) return "Error: Expected ')' or '^'.\n... Neither was found.\n";
  std::vector<Removal> plan;
  std::string errors;
  failed = !Plan(memory, *clause, force, plan, errors);
  if (failed) return errors;
  for (const Removal& removal : plan) memory.RemoveEdge(removal.object, removal.attribute, removal.value);
  memory.Rewrite(FindObject(memory, clause->object));
  return errors;
}

Lti ObjectNamed(const SemanticMemory& memory, std::string_view text) {
  if (text.size() < 2 || text.front() != '@') return 0;
  text.remove_prefix(1);
  Lti number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error == std::errc() && end == text.data() + text.size()) {
    return memory.knowledge().Find(number) == Knowledge::kNowhere ? 0 : number;
  }
  return memory.knowledge().FindAlias(text);
}

}  // namespace soarbox::kernel
