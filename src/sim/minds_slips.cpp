// SPDX-License-Identifier: BSD-2-Clause
// Reports likely slips in loaded rules when they begin to run.
#include <algorithm>

#include "diagnostics/read_text.h"
#include "explain/odd_characters.h"
#include "explain/reasons.h"
#include "explain/rule_slips.h"
#include "explain/rule_surroundings.h"
#include "sim/check.h"
#include "sim/live_edits.h"
#include "sim/minds.h"
#include "sim/sourced_files.h"
#include "sml_Client.h"

namespace soarbox::sim {
namespace {

std::vector<explain::RuleFile> FilesOf(const std::filesystem::path& rules, const Scenario& scenario) {
  const auto read = [](const std::filesystem::path& file) {
    return explain::RuleFile{file, explain::BlankComments(ReadText(file).value_or(""))};
  };
  std::vector<explain::RuleFile> files = {read(rules)};
  for (const std::filesystem::path& file : WithSourcedFiles(rules, ReadableRuleFolders(scenario)))
    if (file != rules) files.push_back(read(file));
  return files;
}

Diagnostic Placed(const explain::Slip& slip, const std::vector<explain::RuleFile>& files) {
  for (const explain::RuleFile& file : files) {
    Diagnostic warning = explain::PlaceSlip(slip, file.file, file.text);
    if (warning.line != 0) return warning;
  }
  return explain::PlaceSlip(slip, {}, {});  // A typed rule.
}

/// Converts "Error: attempt to divide ('/') by zero." to a slip: the rule, and what to do.
explain::Slip SlipOf(const mind::RuleOutput::Failure& failure) {
  constexpr std::string_view kError = "Error: ", kDivision = "attempt to divide ('";
  std::string text = failure.text;
  text.erase(0, text.find_first_not_of(" \t\n"));
  text.erase(text.find_last_not_of(" \t\n.") + 1);
  if (text.starts_with(kError)) text.erase(0, kError.size());
  explain::Slip slip;
  slip.rule = failure.rule;
  slip.in_actions = true;
  constexpr std::string_view kScene = "svs: ";
  if (text.starts_with(kScene)) {
    const std::size_t end = text.find('\n');
    slip.message = "rule " + failure.rule + ": " + text.substr(kScene.size(), end - kScene.size());
    if (end != std::string::npos) slip.hint = text.substr(end + 1);
    constexpr std::string_view kCommand = "svs: command ";
    const std::size_t begin = std::min(kCommand.size(), text.size());
    slip.word = text.substr(begin, text.find(':', begin) - begin);
    slip.is_attribute = true;
    return slip;
  }
  if (failure.text.empty()) {
    slip.topic = Topic::kEndless;
    slip.message = "rules fire again and again in one phase, rule " + failure.rule +
                   " among them: each firing makes one match again, until max-elaborations ends the phase";
    slip.hint =
        "let its conditions test that the work is not done yet, or let an operator do it: one step per decision";
    return slip;
  }
  if (text.starts_with(kDivision)) {
    slip.word = text.substr(kDivision.size(), text.find('\'', kDivision.size()) - kDivision.size());
    slip.message = "rule " + failure.rule + " divides by zero with " + slip.word + ": the action does nothing";
    slip.hint = "test the divisor in a condition: <> 0";
  } else {
    slip.message = "rule " + failure.rule + ": an action failed: " + text;
    slip.hint = "the action does nothing; print or the panel Memory shows the values that it was given";
  }
  return slip;
}

}  // namespace

std::vector<Diagnostic> Minds::FindSlips(Mind& mind, const std::set<std::string>& only, Neighbours& beside) {
  explain::MindReasons reasons(mind.soar.agent());
  explain::KnownWords known;
  known.attributes = KnownAttributes();
  known.complete = !only.empty() || !failed_.contains(mind.rules);
  known.places.is_known = !mind.is_scripted;
  known.own_world = mind.by_sandbox;
  for (const Waypoint& waypoint : arena_.places().waypoints) known.places.waypoints.insert(waypoint.name);
  for (const Region& region : arena_.places().regions) known.places.regions.insert(region.name);
  std::vector<std::filesystem::path> folders;
  if (mind.is_scripted) folders = scenario_.script_folders;
  folders.push_back(mind.rules.parent_path());
  for (const std::filesystem::path& folder : folders) {
    const auto [at, is_new] = beside.try_emplace(folder);
    if (is_new) at->second = explain::LookAround(folder, {&folder, 1});
    const explain::Surroundings& around = at->second;
    known.scripts.insert(around.lua_words.begin(), around.lua_words.end());
    known.attributes.insert(around.made_by_rules.begin(), around.made_by_rules.end());
    known.made_values.insert(around.made_values.begin(), around.made_values.end());
    known.has_database |= around.has_database;
  }
  if (explain::MentionsScenes(reasons.rules()))
    known.scene = explain::ReadSceneKinds(mind.soar.agent().ExecuteCommandLine("svs commands all"));
  std::vector<explain::RuleFile> files = FilesOf(mind.rules, scenario_);
  std::vector<Diagnostic> warnings;
  for (const explain::Slip& slip : explain::FindSlips(reasons.rules(), known)) {
    if (!only.empty() && !only.contains(slip.rule)) continue;
    Diagnostic warning = Placed(slip, files);
    if (!warning.file.empty()) warning.file = scenario_.Original(warning.file).string();
    warnings.push_back(std::move(warning));
  }
  std::set<std::string> loaded = only;
  if (only.empty())
    for (const explain::RuleText& rule : reasons.rules()) loaded.insert(rule.name);
  for (const explain::RuleFile& file : files) {
    for (Diagnostic& warning : explain::FindOddCharacters(file)) {
      if (!loaded.contains(warning.rule)) continue;
      warning.file = scenario_.Original(file.file).string();
      warnings.push_back(std::move(warning));
    }
  }
  if (!only.empty()) return warnings;
  for (explain::RuleFile& file : files) file.file = scenario_.Original(file.file);
  for (Diagnostic& twice : explain::FindDuplicates(files)) warnings.push_back(std::move(twice));
  return warnings;
}

void Minds::TellSlips() {
  has_new_rules_ = false;
  Neighbours beside;
  for (Mind& mind : minds_) {
    if (mind.gone || mind.lost || !looked_over_.insert(mind.rules).second) continue;
    const std::string& name = world_.FindAgent(mind.agent)->name();
    std::vector<Diagnostic> slips = FindSlips(mind, {}, beside);
    // Only our own kernel warns when it loads rules.
    if (!host_.settings().remote_host.empty())
      for (Diagnostic& warning : WarningsOfRules(mind.rules, host_.settings().folders))
        slips.push_back(std::move(warning));
    for (Diagnostic& slip : slips) {
      if (!reported_.insert(Format(slip)).second) continue;
      RunEvent event;
      event.kind = EventKind::kDiagnostic;
      event.agent = name;
      event.diagnostic = std::move(slip);
      report_(std::move(event));
    }
  }
}

void Minds::TellFailures(Mind& mind, const world::Agent& body) {
  for (const mind::RuleOutput::Failure& failure : mind.soar.TakeFailures()) {
    // Arguments may differ each time, so only the first failure of a rule is reported.
    const bool is_scene = failure.text.starts_with("svs: ");
    const std::string kind = is_scene ? "\n" + failure.text : failure.text.empty() ? "\nfires without end" : "\nfailed";
    if (!reported_.insert(mind.rules.string() + '\n' + failure.rule + kind).second) continue;
    RunEvent event;
    event.kind = EventKind::kDiagnostic;
    event.agent = body.name();
    event.diagnostic = Placed(SlipOf(failure), FilesOf(mind.rules, scenario_));
    if (!event.diagnostic.file.empty()) event.diagnostic.file = scenario_.Original(event.diagnostic.file).string();
    report_(std::move(event));
  }
}

std::vector<Diagnostic> Minds::SlipsOf(std::string_view agent, const std::set<std::string>& rules) {
  Mind* mind = FindNamed(agent);
  if (mind == nullptr || mind->gone || mind->lost || rules.empty()) return {};
  Neighbours beside;
  return FindSlips(*mind, rules, beside);
}

}  // namespace soarbox::sim
