// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>

#include "kernel/base/characters.h"
#include "kernel/base/known_symbols.h"
#include "kernel/rules/rule_reader.h"

namespace soarbox::kernel {

namespace {

constexpr const char* kExpectedTest = "Expected variable or constant for test";

TestDraft Equal(Term term) {
  return MakeTest(TestKind::kEqual, term);
}

TestKind RelationOf(TokenKind kind) {
  switch (kind) {
    case TokenKind::kEqual:
      return TestKind::kEqual;
    case TokenKind::kNotEqual:
      return TestKind::kNotEqual;
    case TokenKind::kLess:
      return TestKind::kLess;
    case TokenKind::kGreater:
      return TestKind::kGreater;
    case TokenKind::kLessOrEqual:
      return TestKind::kLessOrEqual;
    case TokenKind::kGreaterOrEqual:
      return TestKind::kGreaterOrEqual;
    case TokenKind::kSameType:
      return TestKind::kSameType;
    case TokenKind::kAt:
      return TestKind::kSameLti;
    default:
      return TestKind::kBlank;
  }
}

}  // namespace

// Only names of the form <x*...> can clash, and few rules contain any.
void VariableNames::CollectWritten() {
  collected_ = true;
  bool may_clash = false;
  for (std::size_t at = body_.find('*'); at != std::string_view::npos && !may_clash; at = body_.find('*', at + 1)) {
    may_clash = at >= 2 && body_[at - 2] == '<';
  }
  if (!may_clash) {
    return;
  }
  Arena arena;
  Lexer lexer(body_, arena);
  for (RuleToken token = lexer.Next(); token.kind != TokenKind::kEnd; token = lexer.Next()) {
    if (token.kind == TokenKind::kVariable) {
      written_.emplace(token.text);
    }
  }
}

Symbol VariableNames::Make(char letter) {
  if (!collected_) {
    CollectWritten();
  }
  letter = ToLower(letter);
  int& count = count_[static_cast<std::size_t>(letter - 'a')];
  std::string name;
  do {
    name = {'<', letter, '*'};
    name += std::to_string(++count);
    name += '>';
  } while (!written_.empty() && written_.contains(name));
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

/// Negates a list of conditions: one condition changes its sign, several become a conjunctive negation.
void RuleReader::Negate(const Conditions& conditions, Conditions& out) {
  if (conditions.first == conditions.last) {
    ConditionDraft* const only = conditions.first;
    switch (only->kind) {
      case ConditionKind::kPositive:
        only->kind = ConditionKind::kNegative;
        break;
      case ConditionKind::kNegative:
        only->kind = ConditionKind::kPositive;
        break;
      case ConditionKind::kConjunctiveNegation:
        out.Append(only->conditions);
        return;
    }
    out.Add(only);
    return;
  }
  ConditionDraft* const negation = arena_.New<ConditionDraft>();
  negation->kind = ConditionKind::kConjunctiveNegation;
  negation->conditions = conditions;
  out.Add(negation);
}

bool RuleReader::ReadConditions(Conditions& out, int depth) {
  do {
    if (!ReadCondition(out, depth)) {
      return false;
    }
  } while (Is(TokenKind::kMinus) || Is(TokenKind::kLeftParen) || Is(TokenKind::kLeftBrace));
  return true;
}

bool RuleReader::ReadCondition(Conditions& out, int depth) {
  if (!Accept(TokenKind::kMinus)) {
    return ReadPositiveCondition(out, depth);
  }
  Conditions denied;
  if (!ReadPositiveCondition(denied, depth)) {
    return false;
  }
  Negate(denied, out);
  return true;
}

bool RuleReader::ReadPositiveCondition(Conditions& out, int depth) {
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
  TestDraft id;
  Conditions read;
  if (!ReadObject(read, 's', id, depth)) {
    return false;
  }
  FillIn(read, id);
  out.Append(read);
  return true;
}

/// Sets the identifier tests of conditions. Each condition tests the variable of its object; the other tests of the
/// object are added to one positive condition, or to all conditions if none is positive.
void RuleReader::FillIn(const Conditions& conditions, const TestDraft& id) {
  if (id.kind == TestKind::kEqual) {
    return;
  }
  const Symbol variable = EqualitySymbol(id);
  for (ConditionDraft& condition : conditions) {
    if (condition.kind == ConditionKind::kPositive && condition.id.referent == variable) {
      condition.id = Copy(id, arena_);
      return;
    }
  }
  for (ConditionDraft& condition : conditions) {
    if (condition.kind == ConditionKind::kConjunctiveNegation) {
      FillIn(condition.conditions, id);
    } else if (condition.id.referent == variable) {
      condition.id = Copy(id, arena_);
    }
  }
}

/// Reads (<object> ^attribute value ...). Sets `object` to the tests of the object; the conditions refer to its
/// variable.
bool RuleReader::ReadObject(Conditions& out, char id_letter, TestDraft& object, int depth) {
  if (depth > kMaxDepth) {
    return Fail("Conditions are nested too deeply");
  }
  Advance();  // (
  TestDraft goal;
  if (Is(TokenKind::kString) && (token_.text == "state" || token_.text == "impasse")) {
    goal.kind = token_.text == "state" ? TestKind::kState : TestKind::kImpasse;
    Advance();
  }
  const bool is_goal = goal.kind != TestKind::kBlank;

  TestDraft id;
  if (!Is(TokenKind::kUpArrow) && !Is(TokenKind::kMinus) && !Is(TokenKind::kRightParen)) {
    if (!ReadIdTest(id)) {
      return false;
    }
  }
  AddEquality(id, id_letter);
  const TestDraft variable = Equal({EqualitySymbol(id), EqualityVariable(id)});
  if (is_goal) {
    TestDraft both = MakeTest(TestKind::kConjunction);
    both.parts.Add(arena_.New(goal));
    if (id.kind == TestKind::kConjunction) {
      both.parts.Append(id.parts);
    } else {
      both.parts.Add(arena_.New(id));
    }
    id = both;
  }
  object = id;

  if (Is(TokenKind::kRightParen)) {
    if (is_goal) {
      return Fail(
          "Error: Expected attribute-value test after state/impasse test. Did you forget to add "
          "\"^type state\" or \"^superstate nil\"?");
    }
    ConditionDraft* const any = arena_.New<ConditionDraft>();
    any->id = variable;
    AddEquality(any->attribute, 'a');
    AddEquality(any->value, 'v');
    out.Add(any);
  } else if (!ReadAttributes(variable, out, depth)) {
    return false;
  }
  Advance();  // )
  return true;
}

bool RuleReader::ReadIdTest(TestDraft& id) {
  const RuleToken at = token_;
  if (!ReadTest(id)) {
    return false;
  }
  const Symbol symbol = EqualitySymbol(id);
  if (symbol && !symbol.IsVariable()) {
    const std::string name = ToString(symbols_, symbol);
    Say("Warning: Constant " + name + " in id field test.\n         This will never match.\n");
    Report(Severity::kError, at, "constant " + name + " is used where only a variable can match an identifier",
           "write <" + name + "> to name an object");
    return false;
  }
  return true;
}

bool RuleReader::ReadAttributes(const TestDraft& id, Conditions& out, int depth) {
  while (!Is(TokenKind::kRightParen)) {
    const bool negated = Accept(TokenKind::kMinus);
    if (!Is(TokenKind::kUpArrow)) {
      return Fail("Expected ^ followed by attribute");
    }
    Advance();
    Conditions read;
    if (!ReadAttribute(id, read, depth)) {
      return false;
    }
    if (negated) {
      Negate(read, out);
    } else {
      out.Append(read);
    }
  }
  return true;
}

// No two conditions may share the parts of a test, because later stages change them in place.
bool RuleReader::ReadAttribute(const TestDraft& first_id, Conditions& out, int depth) {
  TestDraft id = first_id;
  TestDraft attribute;
  if (!ReadTest(attribute)) {
    return false;
  }
  // Determined before AddEquality, because the value's variable must not be named after a generated one.
  char letter = names_.LetterFor(EqualitySymbol(attribute));
  AddEquality(attribute, 'a');
  while (Accept(TokenKind::kPeriod)) {
    ConditionDraft* const step = arena_.New<ConditionDraft>();
    step->id = Copy(id, arena_);
    step->attribute = attribute;
    step->value = Equal(NewVariable(letter));
    out.Add(step);
    id = step->value;
    attribute = TestDraft();
    if (!ReadTest(attribute)) {
      return false;
    }
    letter = names_.LetterFor(EqualitySymbol(attribute));
    AddEquality(attribute, 'a');
  }
  bool has_value = false;
  while (!Is(TokenKind::kUpArrow) && !Is(TokenKind::kMinus) && !Is(TokenKind::kRightParen)) {
    ConditionDraft* const condition = arena_.New<ConditionDraft>();
    condition->id = Copy(id, arena_);
    if (has_value) {  // All tests of the attribute are in the first condition.
      condition->attribute = Equal({EqualitySymbol(attribute), EqualityVariable(attribute)});
    } else {
      condition->attribute = Copy(attribute, arena_);
    }
    Conditions inner;
    if (Is(TokenKind::kLeftParen)) {
      if (!ReadObject(inner, letter, condition->value, depth + 1)) {
        return false;
      }
    } else {
      if (!ReadTest(condition->value)) {
        return false;
      }
      AddEquality(condition->value, letter);
    }
    condition->tests_acceptable = Accept(TokenKind::kPlus);
    out.Add(condition);
    out.Append(inner);
    has_value = true;
  }
  if (!has_value) {
    ConditionDraft* const condition = arena_.New<ConditionDraft>();
    condition->id = Copy(id, arena_);
    condition->attribute = attribute;
    AddEquality(condition->value, letter);
    out.Add(condition);
  }
  return true;
}

bool RuleReader::ReadTest(TestDraft& test) {
  DraftList<TestDraft> parts;
  if (!Accept(TokenKind::kLeftBrace)) {
    if (!ReadLiteral(parts)) {
      return ReadSimpleTest(test);
    }
  } else {
    do {
      if (ReadLiteral(parts)) {
        continue;
      }
      TestDraft part;
      if (!ReadSimpleTest(part)) {
        return false;
      }
      AddToConjunction(parts, part);
    } while (!Is(TokenKind::kRightBrace));
    Advance();
  }
  if (!CheckLiterals(parts)) {
    return false;
  }
  if (parts.first == parts.last) {
    test = *parts.first;
  } else {
    test = MakeTest(TestKind::kConjunction);
    test.parts = parts;
  }
  return true;
}

/// Reads a sign for literal values. `$ <x>` is a variable for which learning keeps the matched value. `$$ <x>` has the
/// same meaning for a variable that is bound in the same test. `$` before anything else is an ordinary character,
/// because learning keeps constants anyway. Returns false if there is no such sign.
bool RuleReader::ReadLiteral(DraftList<TestDraft>& parts) {
  const std::string_view sign = body_.substr(token_.offset, token_.length);
  if (language_.version == SoarVersion::k963 || !Is(TokenKind::kString) || (sign != "$" && sign != "$$")) {
    return false;
  }
  Advance();
  const bool is_variable = Is(TokenKind::kVariable);
  Term term = ConstantOrVariable();
  if (!term.symbol) {
    term.symbol = symbols_.String(sign);
  }
  if (sign == "$" || !is_variable) {
    AddToConjunction(parts, Equal(term));
  }
  if (is_variable) {
    parts.Add(arena_.New(MakeTest(TestKind::kLiteral, term)));
  }
  return true;
}

/// Checks that a literal variable is the one that its own test binds.
bool RuleReader::CheckLiterals(const DraftList<TestDraft>& parts) {
  for (const TestDraft& part : parts) {
    if (part.kind != TestKind::kLiteral) {
      continue;
    }
    const TestDraft* equality = nullptr;
    for (const TestDraft& other : parts) {
      equality = other.kind == TestKind::kEqual ? &other : equality;
    }
    if (equality == nullptr || equality->variable != part.variable) {
      return Fail("$$ needs the variable of its own test", "write { <x> $$ <x> }, or $ <x> for short");
    }
  }
  return true;
}

void RuleReader::AddToConjunction(DraftList<TestDraft>& parts, const TestDraft& test) {
  if (test.kind == TestKind::kEqual) {
    for (TestDraft& part : parts) {
      if (part.kind != TestKind::kEqual) {
        continue;
      }
      const bool replace = part.referent.IsVariable() && !test.referent.IsVariable();
      const std::string dropped = ToString(symbols_, replace ? part.referent : test.referent);
      const std::string kept = ToString(symbols_, replace ? test.referent : part.referent);
      Say("Soar does not support having two equality tests in one conjunctive test!\nIgnoring " + dropped +
          " in favor of " + (replace ? "constant " : "existing ") + kept + ".  Rule semantics may have changed!\n");
      Report(Severity::kWarning, token_, "two equality tests in one conjunctive test: " + dropped + " is ignored",
             "test " + dropped + " in a condition of its own", Topic::kDroppedText);
      if (replace) {
        part.referent = test.referent;
        part.variable = test.variable;
      }
      return;
    }
  }
  parts.Add(arena_.New(test));
}

bool RuleReader::ReadSimpleTest(TestDraft& test) {
  test = TestDraft();
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
  const Term term = ConstantOrVariable();
  test.referent = term.symbol;
  test.variable = term.variable;
  return term.symbol || Fail(kExpectedTest);
}

bool RuleReader::ReadDisjunction(TestDraft& test) {
  Advance();  // <<
  test.kind = TestKind::kDisjunction;
  disjuncts_.clear();
  while (!Is(TokenKind::kRightAngles)) {
    if (Is(TokenKind::kVariable)) {
      return Fail("Expected constant or >> while reading disjunction test",
                  "a disjunction can contain only constants; write one rule per alternative to test variables");
    }
    const Symbol constant = ConstantOrVariable().symbol;
    if (!constant) {
      return Fail("Expected constant or >> while reading disjunction test");
    }
    disjuncts_.push_back(constant);
  }
  Advance();
  Symbol* const stored = arena_.NewArray<Symbol>(disjuncts_.size());
  std::ranges::copy(disjuncts_, stored);
  test.disjuncts = stored;
  test.disjunct_count = static_cast<std::uint32_t>(disjuncts_.size());
  return true;
}

void RuleReader::AddEquality(TestDraft& test, char letter) {
  if (EqualitySymbol(test)) {
    return;
  }
  const TestDraft equality = Equal(NewVariable(letter));
  if (test.kind == TestKind::kBlank) {
    test = equality;
    return;
  }
  if (test.kind != TestKind::kConjunction) {
    TestDraft conjunction = MakeTest(TestKind::kConjunction);
    conjunction.parts.Add(arena_.New(test));
    test = conjunction;
  }
  test.parts.Add(arena_.New(equality));
}

}  // namespace soarbox::kernel
