// SPDX-License-Identifier: BSD-2-Clause
#include "mission/account.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <string_view>

#include "explain/inspector.h"
#include "mission/sentences.h"
#include "sim/simulation.h"

namespace soarbox::mission {
namespace {

/// An agent is told to have nothing to do when it has done nothing for so long.
constexpr double kToldAfter_s = 1;
constexpr std::size_t kMostSlips = 3, kMostIdleReasons = 4, kMostRules = 3;

std::string FileName(const std::string& path) {
  return std::filesystem::path(path).filename().string();
}

/// Without the blanks that make it a line of a tree.
std::string Trimmed(const std::string& line) {
  return line.substr(std::min(line.find_first_not_of(' '), line.size()));
}

/// The sentence of an outcome that says how a command was written wrong, without the reason's name; empty if another
/// thing was wrong, or none.
std::string RefusedText(const std::string& outcome) {
  for (const std::string_view reason : {"bad-value", "unknown-parameter", "missing-parameter", "unknown-command"}) {
    const std::string start = "error " + std::string(reason) + ": ";
    if (outcome.starts_with(start)) return outcome.substr(start.size());
  }
  return {};
}

/// What an object holds says little where a word was expected.
std::string WithoutContents(std::string text) {
  const std::size_t begin = text.find('('), end = text.rfind(')');
  if (begin != std::string::npos && end != std::string::npos && end > begin)
    text.replace(begin, end + 1 - begin, "an object, not its name");
  return text;
}

/// Of a reason that says that a command failed because a parameter is an identifier: what that means. Empty otherwise.
std::string IdentifierText(const std::string& reason) {
  const std::string text = Trimmed(reason);
  if (!text.starts_with("its last command ") || text.find(" is an identifier") == std::string::npos) return {};
  return text + ". Either no condition binds the variable that the rule gives it, or it is bound to an object";
}

/// "rule x never fired: it requires ^next 3, but it is 2; at 1.0 s it got furthest"
std::string NeverFired(const RuleWatch::Waiting& waiting) {
  if (!waiting.maker.empty())
    return "rule " + waiting.rule + " never fired, although " + waiting.wanted + " was there (rule " + waiting.maker +
           " made it): which of its other conditions was not met then?";
  std::string text = "rule " + waiting.rule + " never fired: it " + waiting.why;
  if (waiting.time_s > 0) text += ". That was at " + SecondsText(waiting.time_s) + ", when it got furthest";
  return text;
}

/// "operator go has been applied (rule r) and stays selected: ..."
bool IsStall(const std::string& line) {
  return line.starts_with("operator ") && line.find(" has been applied ") != std::string::npos;
}

bool IsEndless(const Diagnostic& problem) {
  return problem.message.starts_with("rules fire again and again in one phase");
}

/// Rules of a file that never fired, in words: those that came with the lesson.
std::vector<std::string> GivenThatNeverFired(sim::Simulation& simulation, const AccountSettings& settings) {
  std::vector<std::string> told;
  for (std::size_t i = 0; i < simulation.soar_agents(); ++i) {
    const std::string agent = simulation.AgentOfMind(i);
    const auto inspector = simulation.Inspect(agent);
    if (inspector == nullptr || !settings.IsAboutAgent(agent)) continue;
    for (const explain::RuleFact& rule : inspector->Rules()) {
      if (!settings.IsAbout(rule.file) || rule.firings > 0 || !settings.given.contains(rule.name)) continue;
      const std::string why = WhyRuleWaits(simulation, agent, rule.name);
      if (!why.empty() && told.size() < kMostRules) told.push_back("rule " + rule.name + " never fired: it " + why);
    }
  }
  return told;
}

}  // namespace

bool AccountSettings::IsAbout(const std::string& rule_file) const {
  return file.empty() ? !rule_file.empty() : FileName(rule_file) == file;
}

Account::Account(sim::Simulation& simulation, AccountSettings settings)
    : simulation_(simulation), settings_(std::move(settings)), watch_(simulation, settings_) {}

bool Account::IsAboutGiven(const std::string& message) const {
  constexpr std::string_view kRule = "rule ";
  const std::size_t at = message.find(kRule);
  if (at == std::string::npos) return false;
  const std::size_t begin = at + kRule.size();
  std::string name = message.substr(begin, message.find(' ', begin) - begin);
  while (!name.empty() && (name.back() == ':' || name.back() == ',')) name.pop_back();
  return settings_.given.contains(name);
}

void Account::See(const sim::EventList& events) {
  if (!settings_.IsAsked()) return;
  watch_.See();
  for (const sim::RunEvent& event : events) {
    if (event.kind == sim::EventKind::kGap && idle_.empty() && settings_.IsAboutAgent(event.agent)) {
      idle_agent_ = event.agent;
      idle_s_ = event.time_s - kToldAfter_s;
      for (std::size_t i = 0; i < event.reasons.size() && idle_.size() < kMostIdleReasons; ++i) {
        if (const std::string text = IdentifierText(event.reasons[i]); !text.empty() && refused_.empty()) {
          refused_agent_ = event.agent;
          refused_s_ = event.time_s;
          refused_ = text;
        }
        // All that it perceives says nothing about its rules.
        if (std::string line = Trimmed(event.reasons[i]); !line.starts_with("it perceives "))
          idle_.push_back(std::move(line));
      }
      idle_.push_back("At " + SecondsText(event.time_s) + " " + event.agent + " has nothing to do: " + event.text);
    }
    if (event.kind == sim::EventKind::kOutcome && refused_.empty() && settings_.IsAboutAgent(event.agent)) {
      if (const std::string text = RefusedText(event.text); !text.empty()) {
        refused_agent_ = event.agent;
        refused_s_ = event.time_s;
        refused_ = "At " + SecondsText(event.time_s) + " the world refused " + event.news + " of " + event.agent +
                   ": " + WithoutContents(text);
      }
    }
    const Diagnostic& problem = event.diagnostic;
    if (event.kind != sim::EventKind::kDiagnostic || problem.severity == Severity::kNote ||
        !settings_.IsAbout(problem.file) || slips_.size() >= kMostSlips || IsAboutGiven(problem.message))
      continue;
    std::string text = FileName(problem.file) + (problem.line > 0 ? ":" + std::to_string(problem.line) : "") + ": " +
                       problem.message + (problem.hint.empty() ? "" : "; " + problem.hint);
    if (std::ranges::find(slips_, text, &RunFinding::text) == slips_.end())
      slips_.push_back({IsEndless(problem) ? Cause::kEndless : Cause::kSlip, std::move(text)});
  }
}

std::vector<RunFinding> Account::Finish(double failed_s) {
  std::vector<RunFinding> found;
  std::set<std::string> agents;  // That run the rules of this file.
  for (std::size_t i = 0; i < simulation_.soar_agents(); ++i) {
    const std::string agent = simulation_.AgentOfMind(i);
    const auto inspector = simulation_.Inspect(agent);
    if (inspector != nullptr && settings_.IsAboutAgent(agent) &&
        std::ranges::any_of(inspector->Rules(),
                            [&](const explain::RuleFact& rule) { return settings_.IsAbout(rule.file); }))
      agents.insert(agent);
  }
  const std::vector<RuleWatch::Waiting> waiting = watch_.Finish();
  for (const RuleWatch::Waiting& each : waiting) {
    // A rule that never fires does not write too often.
    std::erase_if(slips_, [&](const RunFinding& slip) {
      return slip.text.find("rule " + each.rule + " writes again") != std::string::npos;
    });
  }
  found = slips_;
  if (agents.contains(refused_agent_) && refused_s_ <= failed_s) found.push_back({Cause::kRefused, refused_});
  const bool is_idle = agents.contains(idle_agent_) && idle_s_ <= failed_s;
  // Between operators that tie none is applied: what rules wait for then comes of the tie.
  const bool is_torn = is_idle && std::ranges::any_of(idle_, [](const std::string& line) {
                         return line.starts_with("operator tie in ") || line.starts_with("operator conflict in ");
                       });
  for (std::size_t i = 0; i < waiting.size() && i < kMostRules; ++i)
    found.push_back(
        {is_torn || waiting[i].waits_for_operator ? Cause::kWaiting : Cause::kFurthest, NeverFired(waiting[i])});
  if (is_idle)
    for (const std::string& line : idle_) found.push_back({IsStall(line) ? Cause::kStalled : Cause::kSymptom, line});
  // What a rule of the lesson waits for in vain is often the fault of one's own.
  if (found.empty())
    for (std::string& line : GivenThatNeverFired(simulation_, settings_))
      found.push_back({Cause::kSymptom, std::move(line)});
  std::ranges::stable_sort(found, {}, &RunFinding::cause);
  return found;
}

}  // namespace soarbox::mission
