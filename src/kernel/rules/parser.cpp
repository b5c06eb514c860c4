// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/rules/parser.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "kernel/base/known_symbols.h"
#include "kernel/rules/draft.h"
#include "kernel/rules/finish_rule.h"
#include "kernel/rules/ordered_rule.h"
#include "kernel/rules/rule_reader.h"
#include "kernel/rules/syntax_help.h"

namespace soarbox::kernel {

namespace {

/// The line of `text` that contains `offset`.
std::string_view LineAt(std::string_view text, std::size_t offset) {
  const std::size_t at = std::min(offset, text.size());
  const std::size_t before = at == 0 ? std::string_view::npos : text.rfind('\n', at - 1);
  const std::size_t begin = before == std::string_view::npos ? 0 : before + 1;
  return text.substr(begin, text.find('\n', at) - begin);
}

}  // namespace

RuleReader::RuleReader(std::string_view body, const SourcePlace& place, SymbolTable& symbols, VariableIndex& variables,
                       Arena& arena, const RuleLanguage& language, ParseOutcome& out)
    : body_(body),
      place_(place),
      symbols_(symbols),
      variables_(variables),
      arena_(arena),
      language_(language),
      out_(out),
      names_(symbols, body),
      lexer_(body, arena),
      places_(body) {
  Advance();
}

/// Reports the error at the current token.
void RuleReader::Complain() {
  Say(token_.Warning(), Is(TokenKind::kString));
  const std::string text(token_.text);
  switch (token_.kind) {
    case TokenKind::kUnclosed:
      Report(Severity::kError, token_, "this bar or quote is not closed", "close it, or write \\ in front of it");
      break;
    case TokenKind::kString:
      Report(Severity::kWarning, token_, text + " is read as a string, not as a variable",
             "a variable begins with <, ends with > and has no blanks");
      break;
    default:
      Report(Severity::kWarning, token_, "the number " + text + " is too large and is read as 0", "",
             Topic::kDroppedText);
      break;
  }
}

void RuleReader::Say(std::string text, bool is_warning) {
  (out_.name.empty() ? out_.messages : out_.late_messages).push_back({std::move(text), false, is_warning});
}

void RuleReader::Report(Severity severity, const RuleToken& token, std::string message, std::string hint, Topic topic) {
  const TextPlace at = places_.Find(token.offset);
  Diagnostic diagnostic;
  diagnostic.severity = severity;
  diagnostic.topic = topic;
  diagnostic.file = place_.file.text();
  diagnostic.line = place_.line + at.line - 1;
  diagnostic.column = at.line == 1 ? place_.column + at.column - 1 : at.column;
  diagnostic.message = std::move(message);
  diagnostic.message.shrink_to_fit();  // Some sources have very many diagnostics.
  diagnostic.excerpt = LineAt(body_, token.offset);
  if (at.line == 1) {
    // The first line of the text may begin in the middle of a line of the file.
    diagnostic.excerpt.insert(0, static_cast<std::size_t>(std::max(0, place_.column - 1)), ' ');
  }
  diagnostic.excerpt_length = std::max(1, static_cast<int>(token.length));
  diagnostic.hint = std::move(hint);
  out_.diagnostics.push_back(std::move(diagnostic));
}

/// Adds Soar's message to the transcript, and a diagnostic with the place, what is missing, and any open bracket.
bool RuleReader::Fail(std::string_view message, std::string_view hint) {
  if (!is_refused_) Say(std::string(message) + "\n");
  std::string text = out_.name.empty() ? std::string() : "rule " + out_.name + ": ";
  // Soar's own messages repeat the word "Error".
  constexpr std::string_view kError = "Error: ";
  std::string_view described = DescribeSyntaxError(message);
  if (described.starts_with(kError)) described.remove_prefix(kError.size());
  text += described;
  const bool at_end = token_.kind == TokenKind::kEnd;
  text += at_end ? std::string(", but the rule ends here")
                 : ", found '" + std::string(body_.substr(token_.offset, token_.length)) + "'";
  std::string advice(hint);
  if (const std::optional<std::size_t> open = FindOpenBracket(body_, token_.offset)) {
    const TextPlace at = PlaceFinder(body_).Find(*open);
    const int line = place_.line + at.line - 1, column = at.line == 1 ? place_.column + at.column - 1 : at.column;
    const std::string bracket(1, body_[*open]);
    if (!advice.empty()) advice += "; ";
    advice += "the " + bracket + " of line " + std::to_string(line) + ", column " + std::to_string(column) +
              (at_end ? " is never closed" : " is still open here");
  }
  Report(Severity::kError, token_, std::move(text), std::move(advice));
  return false;
}

/// Reads a constant or variable and advances. Returns an empty term, without advancing, if the token is neither.
Term RuleReader::ConstantOrVariable() {
  Term term;
  switch (token_.kind) {
    case TokenKind::kVariable:
      term.symbol = symbols_.Variable(token_.text);
      term.variable = variables_.Add(term.symbol);
      break;
    case TokenKind::kString:
      term.symbol = symbols_.String(token_.text);
      break;
    case TokenKind::kIdentifier:
      Report(Severity::kWarning, token_,
             std::string(body_.substr(token_.offset, token_.length)) +
                 " looks like an identifier and is read as the string |" + std::string(token_.text) + "|",
             "rules cannot name identifiers; put bars around a constant of this form");
      term.symbol = symbols_.String(token_.text);
      break;
    case TokenKind::kInteger:
      term.symbol = symbols_.Integer(token_.integer);
      break;
    case TokenKind::kFloat:
      term.symbol = symbols_.Float(token_.real);
      break;
    default:
      return term;
  }
  Advance();
  return term;
}

/// Creates a variable that is not in the rule's text.
Term RuleReader::NewVariable(char letter) {
  const Symbol symbol = names_.Make(letter);
  return {symbol, variables_.Add(symbol)};
}

bool RuleReader::ReadFlags(RuleDraft& rule) {
  if (Is(TokenKind::kQuoted)) {
    rule.documentation = token_.text;
    rule.has_documentation = true;
    Advance();
  }
  while (Is(TokenKind::kString)) {
    if (token_.text == ":o-support") {
      rule.declared_support = DeclaredSupport::kOSupport;
    } else if (token_.text == ":i-support") {
      rule.declared_support = DeclaredSupport::kISupport;
    } else if (token_.text == ":chunk") {
      rule.type = ProductionType::kChunk;
    } else if (token_.text == ":default") {
      rule.type = ProductionType::kDefault;
    } else if (token_.text == ":template") {
      rule.type = ProductionType::kTemplate;
    } else if (token_.text == ":interrupt") {
      rule.interrupt = true;
    } else if (token_.text == ":explain") {
      rule.explain = true;
    } else {
      return token_.text[0] != ':' || Fail("Expected ( to begin condition element",
                                           "there is no flag of this name; flags are :o-support :i-support "
                                           ":default :chunk :template :interrupt :explain");
    }
    Advance();
  }
  return true;
}

bool RuleReader::ReadRule(RuleDraft& rule) {
  if (!Is(TokenKind::kString)) {
    return Fail(
        "Expected symbol for production name",
        Is(TokenKind::kIdentifier) ? "a name of this form reads as an identifier; use at least two letters" : "");
  }
  rule.name = token_.text;
  symbols_.String(rule.name);
  Advance();  // Messages about the token after the name precede the excision of the older rule.
  out_.name = rule.name;
  if (!ReadFlags(rule)) {
    return false;
  }
  if (!ReadConditions(rule.conditions, 0)) {
    return false;
  }
  if (!Is(TokenKind::kArrow)) {
    return Fail("Expected --> in production");
  }
  Advance();
  return ReadActions(rule.actions);
}

static ParseOutcome Parse(std::string_view body, const SourcePlace& place, SymbolTable& symbols,
                          const ExpectedValues& expected, const RuleLanguage& language, bool keeps_order) {
  const SymbolTable::PinScope pin(symbols);
  ParseOutcome out;
  Arena arena;
  RuleDraft rule;
  rule.file = place.file;
  rule.line = place.line;
  rule.column = place.column;
  rule.keeps_order = keeps_order;
  VariableIndex variables;
  RuleReader reader(body, place, symbols, variables, arena, language, out);
  if (reader.ReadRule(rule) && FinishRule(rule, variables, place, symbols, expected, arena, out)) {
    out.production = Production::Make(rule);
  } else if (!out.name.empty() && !out.is_told) {
    out.late_messages.push_back(
        {"(Ignoring production " + ToString(symbols, symbols.String(out.name)) + ")\n\n", false, false});
  }
  return out;
}

ParseOutcome ParseProduction(std::string_view body, const SourcePlace& place, SymbolTable& symbols,
                             const ExpectedValues& expected, const RuleLanguage& language) {
  return Parse(body, place, symbols, expected, language, false);
}

ParseOutcome ParseOrderedProduction(std::string_view body, const SourcePlace& place, SymbolTable& symbols,
                                    const RuleLanguage& language) {
  return Parse(body, place, symbols, {}, language, true);
}

}  // namespace soarbox::kernel
