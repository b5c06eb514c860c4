// SPDX-License-Identifier: BSD-2-Clause
#include "language/soar_help.h"

#include <algorithm>
#include <iterator>

#include "debugger/syntax.h"

namespace soarbox::language {
namespace {

struct Row {
  std::string_view word, meaning;
};

constexpr Row kAttributes[] = {
    {"superstate", "The state above this one; nil in the top state. A substate begins with an impasse."},
    {"operator", "The operator that is selected. With + after the value, a proposal."},
    {"io", "The agent's link to the world: ^input-link holds percepts, ^output-link takes commands."},
    {"input-link", "What the agent perceives. Only the world writes here."},
    {"output-link", "Commands to the world: make an element here, named after the command."},
    {"type", "state, for every state."},
    {"impasse", "Why this substate began: no-change, tie, conflict or constraint-failure."},
    {"attribute", "What the impasse is about: operator or state."},
    {"choices", "How many candidates the impasse has: none or multiple."},
    {"item", "One of the operators that tie or conflict."},
    {"quiescence", "t, if the state above had settled when the impasse began."},
    {"reward-link", "Rewards for reinforcement learning."},
    {"smem", "The link to semantic memory: ^command, ^result."},
    {"epmem", "The link to episodic memory: ^command, ^result."},
    {"svs", "The link to the spatial visual system: ^command, ^spatial-scene."},
};

constexpr Row kWords[] = {
    {"sp", "Adds a rule: sp {name conditions --> actions}."},
    {"gp", "Adds several similar rules: [a b] in its text makes one rule with a and one with b."},
    {"source", "Reads the commands of a file. The name is relative to the folder of this file."},
    {"pushd", "Names of files start from this folder until popd."},
    {"popd", "Ends what the last pushd began."},
    {"state", "This condition matches a state: the top state or a substate. A rule has at least one."},
    {"impasse", "This condition matches a substate."},
    {"-->", "Conditions come before the arrow. The actions after it are carried out when all conditions match."},
    {":o-support", "What the actions make stays when the conditions no longer match."},
    {":i-support", "What the actions make is removed when the conditions no longer match."},
    {"write", "Prints its arguments, without blanks between them. (crlf) ends the line."},
    {"crlf", "The end of a line, for write."},
    {"halt", "Ends the run of this agent."},
    {"interrupt", "Stops the run after this phase."},
    {"log", "Prints its arguments with a level."},
    {"exec", "Calls a function of the program that runs the agent."},
    {"cmd", "Carries out a command and returns its output."},
    {"make-constant-symbol", "Makes a new symbol that begins with its arguments."},
    {"timestamp", "The date and time as a symbol."},
    {"concat", "Its arguments as one symbol."},
};

template <std::size_t N>
std::string_view MeaningIn(const Row (&rows)[N], std::string_view word) {
  const auto found = std::ranges::find(rows, word, &Row::word);
  return found == std::end(rows) ? std::string_view() : found->meaning;
}

}  // namespace

std::string_view MeaningOfAttribute(std::string_view attribute) {
  return MeaningIn(kAttributes, attribute);
}

std::optional<SoarWord> SoarWordAt(const Document& document, std::size_t offset) {
  using debugger::TokenKind;
  const std::string_view text = document.text();
  // A rule, or a line outside of rules.
  const DocumentRule* rule = document.RuleAt(offset);
  const std::size_t line = document.lines().LineOf(offset);
  const std::size_t begin = rule != nullptr ? rule->span.begin : document.lines().Begin(line);
  const std::size_t end = rule != nullptr ? rule->span.end : document.lines().Begin(line + 1);
  for (const debugger::Token& token : debugger::Tokenize(text.substr(begin, end - begin))) {
    const Span span{begin + token.begin, begin + token.begin + token.length};
    if (!span.Holds(offset)) continue;
    const bool is_own =
        token.kind == TokenKind::kCommand || token.kind == TokenKind::kKeyword || token.kind == TokenKind::kArrow;
    // Functions are words after a bracket.
    const bool is_call = token.kind == TokenKind::kConstant && span.begin > 0 && text[span.begin - 1] == '(';
    const std::string_view word = text.substr(span.begin, token.length);
    const std::string_view meaning = is_own || is_call ? MeaningIn(kWords, word) : std::string_view();
    if (!meaning.empty()) return SoarWord{span, "**" + std::string(word) + "**  \n" + std::string(meaning)};
  }
  return std::nullopt;
}

}  // namespace soarbox::language
