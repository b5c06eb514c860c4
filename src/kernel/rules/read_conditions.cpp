// SPDX-License-Identifier: BSD-2-Clause
#include <utility>

#include "kernel/base/characters.h"
#include "kernel/base/words.h"
#include "kernel/rules/rule_reader.h"

namespace soarbox::kernel {

namespace {

constexpr const char* kExpectedTest = "Expected variable or constant for test";

Test Equal(Symbol symbol) {
  Test test;
  test.kind = TestKind::kEqual;
  test.referent = symbol;
  return test;
}

/// Denies a list of conditions: one is toggled, several become a conjunctive negation.
void Negate(std::vector<Condition> conditions, std::vector<Condition>& out) {
  if (conditions.size() == 1) {
    Condition& only = conditions.front();
    switch (only.kind) {
      case ConditionKind::kPositive: only.kind = ConditionKind::kNegative; break;
      case ConditionKind::kNegative: only.kind = ConditionKind::kPositive; break;
      case ConditionKind::kConjunctiveNegation:
        for (Condition& inner : only.conditions) {
          out.push_back(std::move(inner));
        }
        return;
    }
    out.push_back(std::move(only));
    return;
  }
  Condition negation;
  negation.kind = ConditionKind::kConjunctiveNegation;
  negation.conditions = std::move(conditions);
  out.push_back(std::move(negation));
}

TestKind RelationOf(TokenKind kind) {
  switch (kind) {
    case TokenKind::kEqual: return TestKind::kEqual;
    case TokenKind::kNotEqual: return TestKind::kNotEqual;
    case TokenKind::kLess: return TestKind::kLess;
    case TokenKind::kGreater: return TestKind::kGreater;
    case TokenKind::kLessOrEqual: return TestKind::kLessOrEqual;
    case TokenKind::kGreaterOrEqual: return TestKind::kGreaterOrEqual;
    case TokenKind::kSameType: return TestKind::kSameType;
    case TokenKind::kAt: return TestKind::kSameLti;
    default: return TestKind::kBlank;
  }
}

}  // namespace

Symbol EqualitySymbol(const Test& test) {
  if (test.kind == TestKind::kEqual) {
    return test.referent;
  }
  for (const Test& part : test.parts) {
    if (part.kind == TestKind::kEqual) {
      return part.referent;
    }
  }
  return {};
}

VariableNames::VariableNames(SymbolTable& symbols, std::string_view body) : symbols_(symbols) {
  // Only names of the form <x*...> can clash, and few rules write any.
  bool may_clash = false;
  for (std::size_t at = body.find('*'); at != std::string_view::npos && !may_clash; at = body.find('*', at + 1)) {
    may_clash = at >= 2 && body[at - 2] == '<';
  }
  if (!may_clash) {
    return;
  }
  Lexer lexer(body);
  for (Token token = lexer.Next(); token.kind != TokenKind::kEnd; token = lexer.Next()) {
    if (token.kind == TokenKind::kVariable) {
      written_.insert(std::move(token.text));
    }
  }
}

Symbol VariableNames::Make(char letter) {
  letter = ToLower(letter);
  int& count = count_[static_cast<std::size_t>(letter - 'a')];
  std::string name;
  do {
    name = std::string("<") + letter + "*" + std::to_string(++count) + ">";
  } while (written_.contains(name));
  return symbols_.Variable(name);
}

char VariableNames::LetterFor(Symbol attribute) const {
  char first = 'v';
  if (attribute.IsInteger()) {
    first = 'i';
  } else if (attribute.IsFloat()) {
    first = 'f';
  } else if (attribute.IsString() || attribute.IsVariable()) {
    const std::string_view text = symbols_.Text(attribute);
    const std::size_t at = attribute.IsVariable() ? 1 : 0;
    first = at < text.size() ? text[at] : 'v';
  }
  return IsLetter(first) ? ToLower(first) : 'v';
}

bool RuleReader::ReadConditions(std::vector<Condition>& out, int depth) {
  do {
    if (!ReadCondition(out, depth)) {
      return false;
    }
  } while (Is(TokenKind::kMinus) || Is(TokenKind::kLeftParen) || Is(TokenKind::kLeftBrace));
  return true;
}

bool RuleReader::ReadCondition(std::vector<Condition>& out, int depth) {
  if (!Accept(TokenKind::kMinus)) {
    return ReadPositiveCondition(out, depth);
  }
  std::vector<Condition> denied;
  if (!ReadPositiveCondition(denied, depth)) {
    return false;
  }
  Negate(std::move(denied), out);
  return true;
}

bool RuleReader::ReadPositiveCondition(std::vector<Condition>& out, int depth) {
  if (depth > kMaxDepth) {
    return Fail("Conditions are nested too deeply");
  }
  if (Accept(TokenKind::kLeftBrace)) {
    if (!ReadConditions(out, depth + 1)) {
      return false;
    }
    if (!Is(TokenKind::kRightBrace)) {
      return Fail("Expected } to end conjunctive condition");
    }
    Advance();
    return true;
  }
  if (!Is(TokenKind::kLeftParen)) {
    return Fail("Expected ( to begin condition element");
  }
  Symbol id;
  return ReadObject(out, true, 's', id, depth);
}

bool RuleReader::ReadObject(std::vector<Condition>& out, bool may_be_goal, char id_letter, Symbol& id_symbol, int depth) {
  if (depth > kMaxDepth) {
    return Fail("Conditions are nested too deeply");
  }
  Advance();  // (
  std::vector<Test> parts;
  if (may_be_goal && Is(TokenKind::kString) && (token_.text == "state" || token_.text == "impasse")) {
    Test goal;
    goal.kind = token_.text == "state" ? TestKind::kState : TestKind::kImpasse;
    parts.push_back(goal);
    Advance();
  }
  const bool is_goal = !parts.empty();

  Test id;
  if (!Is(TokenKind::kUpArrow) && !Is(TokenKind::kMinus) && !Is(TokenKind::kRightParen)) {
    if (!ReadIdTest(id)) {
      return false;
    }
  }
  AddEquality(id, id_letter);
  id_symbol = EqualitySymbol(id);
  if (is_goal) {
    if (id.kind == TestKind::kConjunction) {
      parts.insert(parts.end(), id.parts.begin(), id.parts.end());
    } else {
      parts.push_back(id);
    }
    id = Test{};
    id.kind = TestKind::kConjunction;
    id.parts = std::move(parts);
  }

  if (Is(TokenKind::kRightParen)) {
    if (is_goal) {
      return Fail("Error: Expected attribute-value test after state/impasse test. Did you forget to add "
                  "\"^type state\" or \"^superstate nil\"?");
    }
    Condition any;
    any.id = id;
    AddEquality(any.attribute, 'a');
    AddEquality(any.value, 'v');
    out.push_back(std::move(any));
  } else if (!ReadAttributes(id, out, depth)) {
    return false;
  }
  Advance();  // )
  return true;
}

bool RuleReader::ReadIdTest(Test& id) {
  const Token at = token_;
  if (!ReadTest(id)) {
    return false;
  }
  const Symbol symbol = EqualitySymbol(id);
  if (symbol && !symbol.IsVariable()) {
    const std::string name = ToString(symbols_, symbol);
    Say("Warning: Constant " + name + " in id field test.\n         This will never match.\n");
    Report(Severity::kError, at, "constant " + name + " stands where only a variable can match an identifier",
           "write <" + name + "> to name an object");
    return false;
  }
  return true;
}

bool RuleReader::ReadAttributes(const Test& id, std::vector<Condition>& out, int depth) {
  while (!Is(TokenKind::kRightParen)) {
    const bool negated = Accept(TokenKind::kMinus);
    if (!Is(TokenKind::kUpArrow)) {
      return Fail("Expected ^ followed by attribute");
    }
    Advance();
    std::vector<Condition> read;
    if (!ReadAttribute(id, read, depth)) {
      return false;
    }
    if (negated) {
      Negate(std::move(read), out);
    } else {
      for (Condition& condition : read) {
        out.push_back(std::move(condition));
      }
    }
  }
  return true;
}

bool RuleReader::ReadAttribute(const Test& first_id, std::vector<Condition>& out, int depth) {
  Test id = first_id;
  Test attribute;
  if (!ReadTest(attribute)) {
    return false;
  }
  AddEquality(attribute, 'a');
  while (Accept(TokenKind::kPeriod)) {
    Condition step;
    step.id = std::move(id);
    step.value = Equal(names_.Make(names_.LetterFor(EqualitySymbol(attribute))));
    step.attribute = std::move(attribute);
    id = step.value;
    out.push_back(std::move(step));
    attribute = Test{};
    if (!ReadTest(attribute)) {
      return false;
    }
    AddEquality(attribute, 'a');
  }
  const char letter = names_.LetterFor(EqualitySymbol(attribute));
  bool has_value = false;
  while (!Is(TokenKind::kUpArrow) && !Is(TokenKind::kMinus) && !Is(TokenKind::kRightParen)) {
    Condition condition;
    condition.id = id;
    condition.attribute = attribute;
    std::vector<Condition> inner;
    if (Is(TokenKind::kLeftParen)) {
      Symbol object;
      if (!ReadObject(inner, false, letter, object, depth + 1)) {
        return false;
      }
      condition.value = Equal(object);
    } else {
      if (!ReadTest(condition.value)) {
        return false;
      }
      AddEquality(condition.value, letter);
    }
    condition.tests_acceptable = Accept(TokenKind::kPlus);
    out.push_back(std::move(condition));
    for (Condition& nested : inner) {
      out.push_back(std::move(nested));
    }
    has_value = true;
  }
  if (!has_value) {
    Condition condition;
    condition.id = std::move(id);
    condition.attribute = std::move(attribute);
    AddEquality(condition.value, letter);
    out.push_back(std::move(condition));
  }
  return true;
}

bool RuleReader::ReadTest(Test& test) {
  if (!Accept(TokenKind::kLeftBrace)) {
    return ReadSimpleTest(test);
  }
  std::vector<Test> parts;
  do {
    Test part;
    if (!ReadSimpleTest(part)) {
      return false;
    }
    AddToConjunction(parts, std::move(part));
  } while (!Is(TokenKind::kRightBrace));
  Advance();
  if (parts.size() == 1) {
    test = std::move(parts.front());
  } else {
    test = Test{};
    test.kind = TestKind::kConjunction;
    test.parts = std::move(parts);
  }
  return true;
}

void RuleReader::AddToConjunction(std::vector<Test>& parts, Test test) {
  if (test.kind == TestKind::kEqual) {
    for (Test& part : parts) {
      if (part.kind != TestKind::kEqual) {
        continue;
      }
      const bool replace = part.referent.IsVariable() && !test.referent.IsVariable();
      const std::string dropped = ToString(symbols_, replace ? part.referent : test.referent);
      const std::string kept = ToString(symbols_, replace ? test.referent : part.referent);
      Say("Soar does not support having two equality tests in one conjunctive test!\nIgnoring " + dropped +
          " in favor of " + (replace ? "constant " : "existing ") + kept + ".  Rule semantics may have changed!\n");
      Report(Severity::kWarning, token_, "two equality tests in one conjunctive test: " + dropped + " is ignored",
             "test " + dropped + " in a condition of its own");
      if (replace) {
        part = std::move(test);
      }
      return;
    }
  }
  parts.push_back(std::move(test));
}

bool RuleReader::ReadSimpleTest(Test& test) {
  test = Test{};
  if (Accept(TokenKind::kAtPlus)) {
    test.kind = TestKind::kIsLti;
    return true;
  }
  if (Accept(TokenKind::kAtMinus)) {
    test.kind = TestKind::kIsNotLti;
    return true;
  }
  if (Is(TokenKind::kLeftAngles)) {
    return ReadDisjunction(test);
  }
  test.kind = TestKind::kEqual;
  if (Is(TokenKind::kExclamation)) {
    Advance();
    if (!Is(TokenKind::kAt)) {
      return Fail(kExpectedTest);
    }
    Advance();
    test.kind = TestKind::kNotSameLti;
  } else if (RelationOf(token_.kind) != TestKind::kBlank) {
    test.kind = RelationOf(token_.kind);
    Advance();
  }
  test.referent = ConstantOrVariable();
  if (!test.referent) {
    return Fail(kExpectedTest);
  }
  return true;
}

bool RuleReader::ReadDisjunction(Test& test) {
  Advance();  // <<
  test.kind = TestKind::kDisjunction;
  while (!Is(TokenKind::kRightAngles)) {
    if (Is(TokenKind::kVariable)) {
      return Fail("Expected constant or >> while reading disjunction test",
                  "a disjunction holds constants only; write one rule per alternative to test variables");
    }
    const Symbol constant = ConstantOrVariable();
    if (!constant) {
      return Fail("Expected constant or >> while reading disjunction test");
    }
    test.disjuncts.push_back(constant);
  }
  Advance();
  return true;
}

void RuleReader::AddEquality(Test& test, char letter) {
  if (EqualitySymbol(test)) {
    return;
  }
  Test equality = Equal(names_.Make(letter));
  if (test.kind == TestKind::kBlank) {
    test = std::move(equality);
    return;
  }
  if (test.kind != TestKind::kConjunction) {
    Test conjunction;
    conjunction.kind = TestKind::kConjunction;
    conjunction.parts.push_back(std::move(test));
    test = std::move(conjunction);
  }
  test.parts.push_back(std::move(equality));
}

}  // namespace soarbox::kernel
