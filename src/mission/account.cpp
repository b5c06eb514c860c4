// SPDX-License-Identifier: BSD-2-Clause
#include "mission/account.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <map>
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

/// Why a rule never fired, from what it waits for at the end: what was there before is not the reason.
std::string NeverFired(const std::string& rule, const std::string& why,
                       const std::map<std::string, std::uint64_t>& firings) {
  const std::string_view now = ", but there is none now; rule ", requires_text = "requires ";
  const std::size_t at = why.find(now);
  if (at != std::string::npos && why.starts_with(requires_text)) {
    const std::size_t begin = at + now.size();
    const std::string maker = why.substr(begin, why.find(' ', begin) - begin);
    if (const auto found = firings.find(maker); found != firings.end() && found->second > 0) {
      return "rule " + rule + " never fired, although " + why.substr(requires_text.size(), at - requires_text.size()) +
             " was there (rule " + maker + " made it): which of its other conditions was not met then?";
    }
  }
  return "rule " + rule + " never fired: it " + why;
}

}  // namespace

void Account::See(const sim::EventList& events) {
  for (const sim::RunEvent& event : events) {
    if (event.kind == sim::EventKind::kGap && idle_.empty()) {
      idle_agent_ = event.agent;
      idle_s_ = event.time_s - kToldAfter_s;
      idle_.push_back("At " + SecondsText(event.time_s) + " " + event.agent + " has nothing to do: " + event.text);
      for (std::size_t i = 0; i < event.reasons.size() && idle_.size() <= kMostIdleReasons; ++i) {
        // All that it perceives says nothing about its rules.
        if (std::string line = Trimmed(event.reasons[i]); !line.starts_with("it perceives "))
          idle_.push_back(std::move(line));
      }
    }
    if (event.kind == sim::EventKind::kOutcome && refused_.empty()) {
      if (const std::string text = RefusedText(event.text); !text.empty()) {
        refused_agent_ = event.agent;
        refused_s_ = event.time_s;
        refused_ = "At " + SecondsText(event.time_s) + " the world refused " + event.news + " of " + event.agent +
                   ": " + WithoutContents(text);
      }
    }
    const Diagnostic& problem = event.diagnostic;
    if (event.kind != sim::EventKind::kDiagnostic || problem.severity == Severity::kNote ||
        FileName(problem.file) != settings_.file || slips_.size() >= kMostSlips)
      continue;
    std::string text = settings_.file + (problem.line > 0 ? ":" + std::to_string(problem.line) : "") + ": " +
                       problem.message + (problem.hint.empty() ? "" : "; " + problem.hint);
    if (std::find(slips_.begin(), slips_.end(), text) == slips_.end()) slips_.push_back(std::move(text));
  }
}

std::vector<std::string> Account::Finish(double failed_s) {
  std::vector<std::string> own, given;
  bool is_idle_one_of_them = false, is_refused_one_of_them = false;
  for (std::size_t i = 0; i < simulation_.soar_agents(); ++i) {
    const std::string agent = simulation_.AgentOfMind(i);
    const auto inspector = simulation_.Inspect(agent);
    if (inspector == nullptr) continue;
    const std::vector<explain::RuleFact> rules = inspector->Rules();
    std::map<std::string, std::uint64_t> firings;
    for (const explain::RuleFact& rule : rules) firings[rule.name] = rule.firings;
    for (const explain::RuleFact& rule : rules) {
      if (FileName(rule.file) != settings_.file) continue;
      is_idle_one_of_them |= agent == idle_agent_;
      is_refused_one_of_them |= agent == refused_agent_;
      if (rule.firings > 0) continue;
      // Whoever never fires does not write too often.
      std::erase_if(slips_, [&](const std::string& slip) {
        return slip.find("rule " + rule.name + " writes again") != std::string::npos;
      });
      const Result<std::vector<explain::WhyNode>> why = simulation_.WhyTopic(agent, rule.name);
      const std::string start = "rule " + rule.name + " ";
      if (!why) continue;
      std::vector<std::string> lines;
      for (const explain::WhyNode& node : *why) {
        const std::vector<std::string> more = explain::Lines(node, 0);
        lines.insert(lines.end(), more.begin(), more.end());
      }
      const auto line =
          std::ranges::find_if(lines, [&](const std::string& each) { return Trimmed(each).starts_with(start); });
      if (line == lines.end()) continue;
      (settings_.given.contains(rule.name) ? given : own)
          .push_back(NeverFired(rule.name, Trimmed(*line).substr(start.size()), firings));
    }
  }
  std::vector<std::string> told = slips_;
  if (is_refused_one_of_them && slips_.empty() && refused_s_ <= failed_s) told.push_back(refused_);
  if (is_idle_one_of_them && idle_s_ <= failed_s) told.insert(told.end(), idle_.begin(), idle_.end());
  // What another rule waits for in vain is often the fault of one's own.
  for (const std::vector<std::string>* rules : {&own, &given}) {
    if (rules == &given && !told.empty()) break;
    for (std::size_t i = 0; i < rules->size() && i < kMostRules; ++i) told.push_back((*rules)[i]);
  }
  return told;
}

}  // namespace soarbox::mission
