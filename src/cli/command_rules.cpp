// SPDX-License-Identifier: BSD-2-Clause
#include <fmt/format.h>

#include <functional>

#include "cli/command.h"
#include "cli/generate_rules.h"
#include "cli/interpreter.h"
#include "cli/printed_rule.h"
#include "cli/source_run.h"

namespace soarbox::cli {
namespace {

/// Whether `output warnings off` suppresses this message. It does not suppress errors in the text of a rule.
bool IsWarning(std::string_view text) {
  while (text.starts_with('\n')) text.remove_prefix(1);
  return text.starts_with("Warning: On the LHS") || text.starts_with("Attempted to add rule with ungrounded");
}

void PrintMessages(CommandCall& call, const std::vector<kernel::RuleMessage>& messages) {
  for (const kernel::RuleMessage& message : messages) {
    if (!call.session.output().warnings && IsWarning(message.text)) continue;
    if (message.fresh_line) call.stream().FreshLine();
    call.stream().Print(message.text);
  }
}

/// Adds messages about a rule. A file may cause the same warning (for example about a constant that looks like an
/// identifier) in thousands of places: the first is kept, the others are counted.
void Keep(std::vector<Diagnostic>& kept, std::vector<Diagnostic>& messages, SourceRun* source) {
  for (Diagnostic& message : messages) {
    if (source && message.severity != Severity::kError) {
      const std::size_t hash = std::hash<std::string>()(message.message);
      const auto [known, is_new] = source->warnings.try_emplace(hash, kept.size());
      if (!is_new && known->second < kept.size() && kept[known->second].message == message.message) {
        ++kept[known->second].more;
        continue;
      }
    }
    kept.push_back(std::move(message));
  }
}

/// Loads a rule and replies like Soar: "*", "#*" if it replaced a rule of the same name, or the error.
bool LoadRule(CommandCall& call, std::string_view body, const Word& word, std::string_view failure) {
  PrintStream::Capture capture(call.stream(), &call.result.text);
  kernel::Agent& agent = call.agent();
  SourceRun* source = call.interpreter.source_run();
  kernel::SourcePlace place;
  place.line = word.line;
  place.column = word.column;
  if (source && !source->files.empty()) place.file = source->files.back();
  kernel::LoadOutcome outcome = agent.LoadProduction(body, place);

  PrintMessages(call, outcome.printed);
  if (outcome.replaced) {
    call.stream().Print("#");
    if (source) source->counts.excised.push_back(outcome.name);
  }
  PrintMessages(call, outcome.printed_late);
  Keep(call.result.diagnostics, outcome.messages, source);
  if (!outcome.duplicate_of.empty()) {
    call.stream().Print(fmt::format("Ignoring {} because it is a duplicate of {}\n", RuleName(agent, outcome.name),
                                    RuleName(agent, outcome.duplicate_of)));
    if (source) ++source->counts.ignored;
    return true;
  }
  if (!outcome.loaded) {
    call.Out(failure);
    call.failure = CommandCall::Failure::kWithMessage;
    return false;
  }
  call.stream().PrintUncounted("*");
  if (source) {
    ++source->counts.sourced;
    source->stars_pending = true;
  }
  return true;
}

}  // namespace

bool CommandSp(CommandCall& call) {
  if (call.words.size() != 2) return call.Fail("Syntax: sp {production_body}");
  return LoadRule(call, call.words[1].text, call.words[1], "Production addition failed.");
}

bool CommandGp(CommandCall& call) {
  if (call.words.size() != 2) return call.Fail("Syntax: gp { production_body }");
  const GeneratedRules rules =
      GenerateRules(call.words[1].text, static_cast<std::uint64_t>(call.agent().settings().max_gp));
  if (!rules.error.empty()) return call.Fail(rules.error);
  for (std::uint64_t i = 0; i < rules.count; ++i) {
    if (!LoadRule(call, rules.Body(i), call.words[1], "Production addition failed.")) return false;
  }
  return true;
}

}  // namespace soarbox::cli
