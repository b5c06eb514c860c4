// SPDX-License-Identifier: BSD-2-Clause
#include "editors/lsp_json.h"

#include <algorithm>
#include <cstdio>

#include "debugger/syntax.h"

namespace soarbox::editors {
namespace {

using debugger::TokenKind;

/// Indices into TokenTypes().
enum TokenType : std::size_t {
  kComment,
  kKeyword,
  kFunction,
  kVariable,
  kProperty,
  kString,
  kNumber,
  kOperator,
  kEnumMember
};

std::optional<std::size_t> TypeOf(TokenKind kind) {
  switch (kind) {
    case TokenKind::kComment:
      return kComment;
    case TokenKind::kCommand:
    case TokenKind::kKeyword:
    case TokenKind::kArrow:
      return kKeyword;
    case TokenKind::kRuleName:
      return kFunction;
    case TokenKind::kVariable:
      return kVariable;
    case TokenKind::kAttribute:
      return kProperty;
    case TokenKind::kConstant:
      return kEnumMember;
    case TokenKind::kNumber:
      return kNumber;
    case TokenKind::kQuoted:
      return kString;
    case TokenKind::kSign:
      return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace

Json ToLsp(const language::Position& position) {
  return {{"line", position.line}, {"character", position.character}};
}

Json RangeOf(const language::Lines& lines, const language::Span& span) {
  return {{"start", ToLsp(lines.PositionOf(span.begin))}, {"end", ToLsp(lines.PositionOf(span.end))}};
}

Json ToLsp(const Diagnostic& problem, const language::Document& document) {
  constexpr int kError = 1, kWarning = 2, kInformation = 3;
  Json json = {{"range", RangeOf(document.lines(), document.SpanOf(problem))},
               {"severity", problem.severity == Severity::kError     ? kError
                            : problem.severity == Severity::kWarning ? kWarning
                                                                     : kInformation},
               {"source", "soarbox"},
               {"message", problem.message + (problem.hint.empty() ? "" : "\n" + problem.hint)}};
  if (!problem.hint.empty()) json["data"] = {{"hint", problem.hint}};
  return json;
}

Json ToLsp(const language::Proposal& proposal, const Json& range, std::size_t order) {
  using Kind = language::Proposal::Kind;
  constexpr int kFunctionItem = 3, kField = 5, kVariableItem = 6, kProperty = 10, kEvent = 23, kValue = 12,
                kKeywordItem = 14, kEnumMemberItem = 20;
  const auto kind = [&] {
    switch (proposal.kind) {
      case Kind::kAttribute:
        return kField;
      case Kind::kPercept:
        return kProperty;
      case Kind::kCommand:
        return kEvent;
      case Kind::kValue:
        return kValue;
      case Kind::kOperator:
        return kEnumMemberItem;
      case Kind::kVariable:
        return kVariableItem;
      case Kind::kFunction:
        return kFunctionItem;
      case Kind::kSoarCommand:
        return kKeywordItem;
    }
    return kValue;
  };
  char sorted[16];
  std::snprintf(sorted, sizeof sorted, "%05zu", order);
  Json json = {{"label", proposal.text},
               {"kind", kind()},
               {"sortText", sorted},
               {"filterText", proposal.text},
               {"textEdit", {{"range", range}, {"newText", proposal.text}}}};
  if (!proposal.detail.empty()) json["detail"] = proposal.detail;
  if (!proposal.about.empty()) json["documentation"] = proposal.about;
  return json;
}

const std::vector<std::string>& TokenTypes() {
  static const std::vector<std::string> kTypes = {"comment", "keyword", "function", "variable",  "property",
                                                  "string",  "number",  "operator", "enumMember"};
  return kTypes;
}

std::vector<std::size_t> PackTokens(const language::Document& document) {
  std::vector<std::size_t> packed;
  language::Position before;
  const language::Lines& lines = document.lines();
  for (const debugger::Token& token : debugger::Tokenize(document.text())) {
    const std::optional<std::size_t> type = TypeOf(token.kind);
    if (!type) continue;
    // A token over several lines is split into one per line.
    for (std::size_t at = token.begin, end = token.begin + token.length; at < end;) {
      const std::size_t line = lines.LineOf(at);
      const std::size_t stop = std::min(end, lines.Begin(line) + lines.Line(line).size());
      if (at < stop) {
        const language::Position from = lines.PositionOf(at), to = lines.PositionOf(stop);
        const bool same = from.line == before.line;
        packed.insert(packed.end(), {from.line - before.line, same ? from.character - before.character : from.character,
                                     to.character - from.character, *type, 0});
        before = from;
      }
      at = lines.Begin(line + 1);
      if (line + 1 >= lines.count()) break;
    }
  }
  return packed;
}

std::string MeantBy(std::string_view hint) {
  constexpr std::string_view kBegin = "did you mean ";
  const std::size_t at = hint.find(kBegin);
  if (at == std::string_view::npos) return {};
  std::string_view meant = hint.substr(at + kBegin.size());
  const std::size_t end = meant.rfind('?');
  if (end == std::string_view::npos) return {};
  meant = meant.substr(0, end);
  if (meant.size() > 1 && meant.front() == '\'' && meant.back() == '\'') meant = meant.substr(1, meant.size() - 2);
  if (meant.starts_with('^')) meant.remove_prefix(1);
  if (meant.find_first_of(" ,") != std::string_view::npos) return {};
  return std::string(meant);
}

}  // namespace soarbox::editors
