// SPDX-License-Identifier: BSD-2-Clause
#include "wording/mind_words.h"

#include <algorithm>
#include <cstdio>
#include <optional>
#include <utility>
#include <variant>

#include "diagnostics/name_table.h"
#include "mind/decision_codec.h"
#include "wording/decision_text.h"
#include "wording/sentences.h"

namespace soarbox::wording {
namespace {

using mind::Cases;

std::string NumberText(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", number);
  return text;
}

std::string DecidedText(std::string_view packed) {
  if (packed.empty()) return {};
  const std::optional<mind::Decision> decision = mind::Unpack(packed);
  return decision ? WhyDecided(*decision) : std::string();
}

std::string RecalledWhat(const mind::Recalled& recall) {
  if (recall.number == 0) return recall.is_episode ? "no episode" : "no fact";
  return (recall.is_episode ? "episode " : "@") + std::to_string(recall.number);
}

/// Indents a line by three blanks per level below the first, up to a limit.
std::string Indented(int level, std::string line) {
  constexpr int kDeepest = 100;
  return std::string(3 * static_cast<std::size_t>(std::clamp(level, 1, kDeepest) - 1), ' ') + std::move(line);
}

}  // namespace

std::string ValueText(const mind::Value& value) {
  return std::visit(Cases{[](std::string_view word) { return std::string(word); },
                          [](std::int64_t integer) { return std::to_string(integer); },
                          [](double number) { return NumberText(number); }},
                    value);
}

std::string PerceptName(std::string_view attribute, std::uint32_t key) {
  std::string name(attribute);
  if (key != 0) name.append("#").append(std::to_string(key));
  return name;
}

std::string PerceptPath(std::string_view path, std::string_view attribute, std::uint32_t key) {
  return std::string(path) + PerceptName(attribute, key);
}

std::string ParametersText(std::span<const mind::Parameter> parameters) {
  std::string text;
  std::uint32_t depth = 0;
  bool is_first = true;
  for (const mind::Parameter& parameter : parameters) {
    for (; depth > parameter.depth; --depth, is_first = false) text += ')';
    if (!is_first) text += ' ';
    is_first = parameter.is_object;
    text.append("^").append(parameter.attribute).append(" ");
    if (parameter.is_object) {
      text += '(';
      depth = parameter.depth + 1;
      continue;
    }
    const std::string value = ValueText(parameter.value);
    // Bars around a value that contains text like an attribute.
    const bool is_quoted =
        std::holds_alternative<std::string_view>(parameter.value) && value.find(" ^") != std::string::npos;
    text += is_quoted ? "|" + value + "|" : value;
  }
  for (; depth > 0; --depth) text += ')';
  return text;
}

std::string CommandText(const mind::CommandSaid& command) {
  std::string text(command.name);
  if (!command.parameters.empty()) text += " " + ParametersText(command.parameters);
  return text;
}

std::string CommandText(const mind::CommandEnded& command) {
  std::string text(command.name);
  text.append(": ").append(StatusName(command.status));
  if (!command.fault.empty()) text.append(" ").append(command.fault);
  return text;
}

std::string_view StatusName(mind::CommandStatus status) {
  static constexpr const char* kNames[] = {"complete", "interrupted", "error"};
  return NameIn(kNames, status);
}

std::string_view ReasonName(mind::StateReason reason) {
  static constexpr const char* kNames[] = {"none", "tie", "conflict", "constraint-failure", "no-change"};
  return NameIn(kNames, reason);
}

std::string ImpasseText(mind::StateReason reason, bool on_operator) {
  if (reason == mind::StateReason::kTop) return {};
  return (on_operator ? "operator " : "state ") + std::string(ReasonName(reason));
}

std::string DecisionLine(const mind::Event& event) {
  return std::visit(
      Cases{[](const mind::OperatorSelected& e) {
              std::string line = "O: " + std::string(e.id);
              if (!e.name.empty()) line.append(" (").append(e.name).append(")");
              return line;
            },
            [](const mind::StateMade& e) {
              std::string line = "==>S: " + std::string(e.id);
              if (e.level > 1) line += " (" + ImpasseText(e.reason, e.on_operator) + ")";
              return line;
            },
            [](const mind::StateGone& e) { return "<==S: " + std::string(e.id); },
            [](const mind::Halted&) { return std::string("halt"); },
            [](const mind::Recalled& e) {
              std::string line = "recall " + RecalledWhat(e);
              line.append(" {").append(e.answer).append("} for {").append(e.question).append("}");
              return line;
            },
            [](const mind::RuleLearned& e) { return "learn " + std::string(e.rule); },
            [](const mind::ValueUpdated& e) { return "value " + std::string(e.rule) + " " + NumberText(e.value); },
            [](const mind::RewardReceived& e) { return "reward " + NumberText(e.reward); },
            [](const mind::EpisodeEnded&) { return std::string("episode ends"); },
            [](const auto&) { return std::string(); }},
      event);
}

int LevelOf(const mind::Event& event) {
  return std::visit(
      [](const auto& e) {
        if constexpr (requires { e.level; }) {
          return e.level;
        } else {
          return 1;
        }
      },
      event);
}

bool IsOfReward(const mind::Event& event) {
  return std::holds_alternative<mind::ValueUpdated>(event) || std::holds_alternative<mind::RewardReceived>(event) ||
         std::holds_alternative<mind::EpisodeEnded>(event);
}

std::string ReasonText(const mind::Event& event) {
  return std::visit(Cases{[](const mind::OperatorSelected& e) { return DecidedText(e.decision); },
                          [](const mind::StateMade& e) { return DecidedText(e.decision); },
                          [](const mind::Recalled& e) { return std::string(e.reason); },
                          [](const mind::RuleLearned& e) {
                            if (e.state.empty()) return std::string();
                            const std::string impasse = ImpasseText(e.reason, e.on_operator);
                            return e.from.empty()
                                       ? Say(Situation::kLearnedIn, {{"state", e.state}, {"impasse", impasse}})
                                       : Say(Situation::kLearnedFrom,
                                             {{"rule", e.from}, {"state", e.state}, {"impasse", impasse}});
                          },
                          [](const mind::Remark& e) {
                            return Say(Situation::kAsRecorded, {{"reason", e.text}});
                          },
                          [](const auto&) { return std::string(); }},
                    event);
}

std::string DetailLine(const mind::Event& event) {
  return std::visit(
      Cases{[](const mind::RuleFired& e) { return (e.retracts ? "retract " : "fire ") + std::string(e.rule); },
            [](const mind::ElementChanged& e) {
              std::string line = (e.added ? "+ " : "- ") + std::to_string(e.timetag) + ": ";
              line.append(e.id).append(" ^").append(e.attribute).append(" ").append(e.value);
              return e.acceptable ? line + " +" : line;
            },
            [](const auto&) { return std::string(); }},
      event);
}

MindWords Words(const mind::EventLog& log, bool with_details) {
  MindWords words;
  mind::Event event;
  for (std::size_t at = 0; log.Next(at, event);) {
    if (const auto* percept = std::get_if<mind::PerceptChanged>(&event)) {
      words.percepts.push_back(PerceptPath(percept->path, percept->attribute, percept->key) + " " +
                               ValueText(percept->value));
    } else if (const auto* gone = std::get_if<mind::PerceptGone>(&event)) {
      words.percepts.push_back("-" + PerceptPath(gone->path, gone->attribute, gone->key));
    } else if (const auto* said = std::get_if<mind::CommandSaid>(&event)) {
      words.commands.push_back(CommandText(*said));
      words.command_rules.emplace_back(said->rule);
    } else if (const auto* ended = std::get_if<mind::CommandEnded>(&event)) {
      words.commands.push_back(CommandText(*ended));
      words.command_rules.emplace_back();
    } else if (const auto* remark = std::get_if<mind::Remark>(&event)) {
      if (!words.reasons.empty()) words.reasons.back() = ReasonText(*remark);
    } else if (mind::IsDetail(event)) {
      if (with_details) words.details.push_back(std::to_string(words.decisions.size()) + " " + DetailLine(event));
    } else {
      words.decisions.push_back(Indented(LevelOf(event), DecisionLine(event)));
      words.reasons.push_back(ReasonText(event));
    }
  }
  return words;
}

}  // namespace soarbox::wording
