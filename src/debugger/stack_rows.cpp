// SPDX-License-Identifier: BSD-2-Clause
#include "debugger/stack_rows.h"

#include <fmt/format.h>

#include "debugger/facts_text.h"
#include "debugger/recorded_mind.h"

namespace soarbox::debugger {

const std::vector<std::string>& Phases() {
  static const std::vector<std::string> phases = {"input", "propose", "decide", "apply", "output"};
  return phases;
}

StackView LookAtStack(explain::Inspector& mind) {
  StackView view;
  explain::MindFacts facts = mind.Mind();
  if (!mind.TellsAll()) view.note = "phase and counts: " + std::string(Absence(mind));
  view.phase = std::move(facts.phase);
  view.within_phase = facts.within_phase;
  view.halted = facts.halted;
  view.breakdown = std::move(facts.breakdown);
  view.decisions = facts.decisions;
  view.elaborations = facts.elaborations;
  view.firings = facts.firings;
  view.elements = facts.elements;
  view.rules = facts.rules;
  for (explain::StateFact& state : mind.Stack()) {
    const std::string impasse = state.level == 1 ? "" : state.attribute + " " + state.impasse;
    view.levels.push_back(
        {state.level, std::move(state.id), impasse, std::move(state.operator_id), std::move(state.operator_name)});
  }
  return view;
}

std::string ToText(const StackView& view) {
  std::string text = fmt::format("decision {}", view.decisions);
  if (!view.phase.empty()) text += fmt::format(", next phase: {}", view.phase);
  if (view.halted) text += ", halted";
  text += "\n";
  if (!view.breakdown.empty()) text += "out of memory: " + view.breakdown + "\n";
  for (const StackLevel& level : view.levels) {
    const std::string indent(3 * static_cast<std::size_t>(level.level - 1), ' ');
    text += indent + "==>S: " + level.state + (level.impasse.empty() ? "" : " (" + level.impasse + ")") + "\n";
    if (level.operator_id.empty()) continue;
    text += indent + "   O: " + level.operator_id +
            (level.operator_name.empty() ? "" : " (" + level.operator_name + ")") + "\n";
  }
  if (view.note.empty()) {
    text += fmt::format("{} elaborations, {} firings, {} elements, {} rules\n", view.elaborations, view.firings,
                        view.elements, view.rules);
  } else {
    text += view.note + "\n";
  }
  return text;
}

}  // namespace soarbox::debugger
