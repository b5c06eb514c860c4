// SPDX-License-Identifier: BSD-2-Clause
#include "mission/account.h"

#include <algorithm>
#include <filesystem>

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
  bool is_idle_one_of_them = false;
  for (std::size_t i = 0; i < simulation_.soar_agents(); ++i) {
    const std::string agent = simulation_.AgentOfMind(i);
    const auto inspector = simulation_.Inspect(agent);
    if (inspector == nullptr) continue;
    for (const explain::RuleFact& rule : inspector->Rules()) {
      if (FileName(rule.file) != settings_.file) continue;
      is_idle_one_of_them |= agent == idle_agent_;
      if (rule.firings > 0) continue;
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
          .push_back(start + "never fired: it " + Trimmed(*line).substr(start.size()));
    }
  }
  std::vector<std::string> told = slips_;
  if (is_idle_one_of_them && idle_s_ <= failed_s) told.insert(told.end(), idle_.begin(), idle_.end());
  // What another rule waits for in vain is often the fault of one's own.
  for (const std::vector<std::string>* rules : {&own, &given}) {
    if (rules == &given && !told.empty()) break;
    for (std::size_t i = 0; i < rules->size() && i < kMostRules; ++i) told.push_back((*rules)[i]);
  }
  return told;
}

}  // namespace soarbox::mission
