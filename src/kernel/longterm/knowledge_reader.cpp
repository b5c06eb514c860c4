// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/longterm/knowledge_reader.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>
#include <vector>

#include "kernel/base/arena.h"
#include "kernel/longterm/semantic_memory.h"
#include "kernel/rules/lexer.h"

namespace soarbox::kernel {
namespace {

/// What stands for an object or a value in such a text.
struct WrittenValue {
  enum class Kind : std::uint8_t { kNumber, kAlias, kVariable, kString, kIdentifier, kInteger, kFloat };
  Kind kind = Kind::kString;
  std::string text;  ///< kAlias, kVariable, kString, kIdentifier.
  std::int64_t integer = 0;
  double real = 0;
  Lti number = 0;  ///< kNumber.

  bool IsObject() const { return kind <= Kind::kVariable; }
};

struct WrittenAugmentation {
  std::vector<WrittenValue> path;  ///< The attribute, and those behind its dots.
  std::vector<WrittenValue> values;
  bool negative = false;
};

struct WrittenClause {
  WrittenValue object;
  std::vector<WrittenAugmentation> augmentations;
};

/// Cuts a text into clauses. Stops at the first that cannot be read.
class ClauseReader {
 public:
  explicit ClauseReader(std::string_view text) : text_(text), lexer_(text, arena_) { Advance(); }

  bool AtEnd() const { return token_.kind == TokenKind::kEnd; }

  /// `needs_values`: an attribute without one is an error.
  std::optional<WrittenClause> Read(bool needs_values) {
    if (token_.kind != TokenKind::kLeftParen) return {};
    Advance();
    WrittenClause clause;
    const std::optional<WrittenValue> object = ReadValue();
    if (!object || !object->IsObject()) return {};
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
        if (!attribute || attribute->IsObject()) return {};
        made.path.push_back(*attribute);
      } while (token_.kind == TokenKind::kPeriod);
      while (token_.kind != TokenKind::kUpArrow && token_.kind != TokenKind::kRightParen &&
             token_.kind != TokenKind::kMinus) {
        const std::optional<WrittenValue> value = ReadValue();
        if (!value) return {};
        made.values.push_back(*value);
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
        if (token_.kind == TokenKind::kInteger && token_.integer > 0) {
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

  std::string_view text_;
  Arena arena_;
  Lexer lexer_;
  RuleToken token_;
};

std::string InClause(std::size_t number) {
  return "Error parsing clause #" + std::to_string(number);
}

/// All clauses; the number of the first that cannot be read in `failed`.
std::optional<std::vector<WrittenClause>> ReadClauses(std::string_view text, bool needs_values, std::size_t& failed) {
  ClauseReader reader(text);
  std::vector<WrittenClause> clauses;
  do {
    std::optional<WrittenClause> clause = reader.Read(needs_values);
    failed = clauses.size();
    if (!clause) return {};
    clauses.push_back(std::move(*clause));
  } while (!reader.AtEnd());
  return clauses;
}

/// Carries clauses out.
class Adder {
 public:
  explicit Adder(SemanticMemory& memory) : memory_(memory) {}

  void Add(const WrittenClause& clause) {
    const std::uint32_t object = ObjectOf(clause.object);
    for (const WrittenAugmentation& augmentation : clause.augmentations) {
      std::uint32_t owner = object;
      for (std::size_t n = 0; n + 1 < augmentation.path.size(); ++n) {
        const StoreTerm attribute = TermOf(augmentation.path[n]);
        const std::uint32_t made = memory_.NewObject();
        memory_.AddEdge(owner, attribute, StoreTerm::Object(made));
        owner = made;
      }
      const StoreTerm attribute = TermOf(augmentation.path.back());
      for (const WrittenValue& value : augmentation.values) memory_.AddEdge(owner, attribute, TermOf(value));
    }
  }

 private:
  std::uint32_t ObjectOf(const WrittenValue& value) {
    if (value.kind == WrittenValue::Kind::kNumber) return memory_.ObjectOf(value.number);
    if (value.kind == WrittenValue::Kind::kAlias) {
      if (const Lti known = memory_.knowledge().FindAlias(value.text)) return memory_.ObjectOf(known);
      const std::uint32_t made = memory_.NewObject();
      memory_.SetAlias(value.text, memory_.knowledge().NumberAt(made));
      return made;
    }
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
  std::map<std::string, std::uint32_t> variables_;
};

std::uint32_t FindObject(const SemanticMemory& memory, const WrittenValue& value) {
  const Knowledge& knowledge = memory.knowledge();
  if (value.kind == WrittenValue::Kind::kNumber) return knowledge.Find(value.number);
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

/// What one clause removes; errors are appended to `errors`. False at the first error unless `force`.
bool Plan(const SemanticMemory& memory, const WrittenClause& clause, bool force, std::vector<Removal>& plan,
          std::string& errors) {
  const Knowledge& knowledge = memory.knowledge();
  const auto fail = [&](std::string_view message) {
    errors += "Error: " + std::string(message) + "\n";
    return force;
  };
  const std::uint32_t object = FindObject(memory, clause.object);
  if (object == Knowledge::kNowhere) return fail("No LTI found for that id.");
  const std::span<const Edge> edges = knowledge.EdgesAt(object);
  if (clause.augmentations.empty()) {
    for (const Edge& edge : edges) plan.push_back({object, edge.attribute, edge.value});
  }
  for (const WrittenAugmentation& augmentation : clause.augmentations) {
    const StoreTerm attribute = FindTerm(memory, augmentation.path.front());
    if (augmentation.path.size() > 1 || !attribute || !knowledge.Has(object, attribute)) {
      if (!fail("Attribute was not found.")) return false;
      continue;
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
      } else if (!fail("Attribute contained a value that could not be found.")) {
        return false;
      }
    }
  }
  return true;
}

}  // namespace

std::string AddKnowledge(SemanticMemory& memory, std::string_view text) {
  std::size_t failed = 0;
  const std::optional<std::vector<WrittenClause>> clauses = ReadClauses(text, true, failed);
  if (!clauses) return InClause(failed);
  for (const WrittenClause& clause : *clauses) {
    for (const WrittenAugmentation& augmentation : clause.augmentations) {
      if (augmentation.negative) return InClause(static_cast<std::size_t>(&clause - clauses->data()));
    }
  }
  Adder adder(memory);
  for (const WrittenClause& clause : *clauses) adder.Add(clause);
  return {};
}

std::string ReadQuery(const SemanticMemory& memory, std::string_view text, Cue& cue) {
  std::size_t failed = 0;
  const std::optional<std::vector<WrittenClause>> clauses = ReadClauses(text, true, failed);
  const auto problem = [&](std::string_view what, std::size_t clause) {
    return "Error while parsing query\n" + std::string(what) + InClause(clause) + ".";
  };
  if (!clauses) return problem("", failed);
  for (std::size_t n = 0; n < clauses->size(); ++n) {
    const WrittenClause& clause = (*clauses)[n];
    const WrittenValue& first = clauses->front().object;
    if (clause.object.kind != first.kind || clause.object.text != first.text || clause.object.number != first.number) {
      return problem("Error: Additional clauses must share same variable.\n", n);
    }
    for (const WrittenAugmentation& augmentation : clause.augmentations) {
      if (augmentation.path.size() > 1) return problem("", n);
      const StoreTerm attribute = FindTerm(memory, augmentation.path.front());
      for (const WrittenValue& written : augmentation.values) {
        const bool any =
            written.kind == WrittenValue::Kind::kVariable || written.kind == WrittenValue::Kind::kIdentifier;
        const StoreTerm value = any ? StoreTerm() : FindTerm(memory, written);
        const bool unknown = !attribute || (!any && !value);
        if (unknown && augmentation.negative) continue;
        cue.impossible = cue.impossible || unknown;
        cue.elements.push_back({attribute, value, augmentation.negative});
      }
    }
  }
  return {};
}

std::string RemoveKnowledge(SemanticMemory& memory, std::string_view text, bool force) {
  std::size_t failed = 0;
  const std::optional<std::vector<WrittenClause>> clauses = ReadClauses(text, false, failed);
  if (!clauses) return InClause(failed) + "\n";
  std::vector<Removal> plan;
  std::string errors;
  for (const WrittenClause& clause : *clauses) {
    if (!Plan(memory, clause, force, plan, errors)) return errors;
  }
  for (const Removal& removal : plan) memory.RemoveEdge(removal.object, removal.attribute, removal.value);
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
