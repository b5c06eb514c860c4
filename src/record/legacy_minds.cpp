// SPDX-License-Identifier: BSD-2-Clause
#include "record/legacy_minds.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace soarbox::record {
namespace {

template <typename Number>
std::optional<Number> NumberIn(std::string_view text) {
  Number number{};
  const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
  if (read.ec != std::errc() || read.ptr != text.data() + text.size()) return std::nullopt;
  return number;
}

/// A number only if it is printed like that: 007 is a word.
mind::Value ValueIn(std::string_view text) {
  if (const auto integer = NumberIn<std::int64_t>(text); integer && tell::ValueText(*integer) == text) return *integer;
  if (const auto number = NumberIn<double>(text); number && tell::ValueText(*number) == text) return *number;
  return text;
}

/// Takes `begin` off the front of a text, if it stands there.
bool Take(std::string_view& text, std::string_view begin) {
  if (!text.starts_with(begin)) return false;
  text.remove_prefix(begin.size());
  return true;
}

/// "O1 (seek)" apart.
std::pair<std::string_view, std::string_view> IdAndAbout(std::string_view text) {
  const std::size_t open = text.find(" (");
  if (open == std::string_view::npos || !text.ends_with(')')) return {text, {}};
  return {text.substr(0, open), text.substr(open + 2, text.size() - open - 3)};
}

void ReadPercept(std::string_view line, mind::EventLog& log) {
  const bool is_gone = Take(line, "-");
  const std::size_t blank = is_gone ? line.size() : std::min(line.find(' '), line.size());
  std::string_view path = line.substr(0, blank), attribute = path;
  const std::size_t dot = path.rfind('.');
  attribute.remove_prefix(dot == std::string_view::npos ? 0 : dot + 1);
  path = path.substr(0, path.size() - attribute.size());
  std::uint32_t key = 0;
  if (const std::size_t mark = attribute.rfind('#'); mark != std::string_view::npos) {
    const auto number = NumberIn<std::uint32_t>(attribute.substr(mark + 1));
    if (number && *number != 0) {
      key = *number;
      attribute = attribute.substr(0, mark);
    }
  }
  if (is_gone) {
    log.Add(mind::PerceptGone{path, attribute, key});
  } else if (blank < line.size()) {
    log.Add(mind::PerceptChanged{path, attribute, key, ValueIn(line.substr(blank + 1))});
  }
}

/// "operator tie"
void ReadImpasse(std::string_view about, mind::StateReason& reason, bool& on_operator) {
  using mind::StateReason;
  const std::size_t blank = about.find(' ');
  on_operator = about.substr(0, blank) == "operator";
  const std::string_view name = blank == std::string_view::npos ? std::string_view() : about.substr(blank + 1);
  reason = StateReason::kNoChange;
  for (const StateReason one : {StateReason::kTie, StateReason::kConflict, StateReason::kConstraintFailure})
    if (name == tell::ReasonName(one)) reason = one;
}

/// "@12 {^kind ammo} for {^kind <any>}", "no episode {} for {...}", behind "recall ".
bool ReadRecall(std::string_view line, mind::Recalled& recall) {
  const std::size_t open = line.find(" {"), between = line.rfind("} for {");
  if (open == std::string_view::npos || between == std::string_view::npos || between < open + 2 || !line.ends_with('}'))
    return false;
  std::string_view what = line.substr(0, open);
  recall.answer = line.substr(open + 2, between - open - 2);
  recall.question = line.substr(between + 7, line.size() - between - 8);
  recall.is_episode = what == "no episode" || Take(what, "episode ");
  if (!recall.is_episode) Take(what, "@");
  recall.number = NumberIn<std::uint64_t>(what).value_or(0);
  return true;
}

/// A line and its reason, if it has one.
void ReadDecision(std::string_view line, std::string_view reason, mind::EventLog& log) {
  const std::size_t indent = std::min(line.find_first_not_of(' '), line.size());
  constexpr std::size_t kDeepest = 1000;
  const int level = 1 + static_cast<int>(std::min(indent / 3, kDeepest));
  line.remove_prefix(indent);
  mind::Recalled recall;
  if (line == "halt") {
    log.Add(mind::Halted{});
  } else if (line == "episode ends") {
    log.Add(mind::EpisodeEnded{});
  } else if (Take(line, "<==S: ")) {
    log.Add(mind::StateGone{level, line});
  } else if (Take(line, "==>S: ")) {
    const auto [id, about] = IdAndAbout(line);
    mind::StateMade state{level, id, mind::StateReason::kTop, false, {}};
    if (level > 1) ReadImpasse(about, state.reason, state.on_operator);
    log.Add(state);
  } else if (Take(line, "O: ")) {
    const auto [id, name] = IdAndAbout(line);
    log.Add(mind::OperatorSelected{level, id, name, {}});
  } else if (Take(line, "recall ") && ReadRecall(line, recall)) {
    recall.level = level;
    recall.reason = std::exchange(reason, {});
    log.Add(recall);
  } else if (Take(line, "learn ")) {
    log.Add(mind::RuleLearned{level, line, {}, {}, mind::StateReason::kNoChange, false});
  } else if (Take(line, "value ")) {
    const std::size_t blank = std::min(line.rfind(' '), line.size());
    const auto value = NumberIn<double>(line.substr(std::min(blank + 1, line.size())));
    log.Add(mind::ValueUpdated{line.substr(0, blank), value.value_or(0)});
  } else if (Take(line, "reward ")) {
    log.Add(mind::RewardReceived{NumberIn<double>(line).value_or(0)});
  } else {
    return;
  }
  if (!reason.empty()) log.Add(mind::Remark{reason});
}

/// "fire RULE", "retract RULE", "+ 12: S1 ^a b +".
void ReadDetail(std::string_view line, mind::EventLog& log) {
  if (Take(line, "fire ")) return log.Add(mind::RuleFired{line, false});
  if (Take(line, "retract ")) return log.Add(mind::RuleFired{line, true});
  mind::ElementChanged element;
  element.added = line.starts_with("+ ");
  if (!element.added && !line.starts_with("- ")) return;
  line.remove_prefix(2);
  const std::size_t colon = line.find(": "), caret = line.find(" ^");
  const auto timetag = NumberIn<std::uint64_t>(line.substr(0, colon));
  if (colon == std::string_view::npos || caret == std::string_view::npos || caret < colon || !timetag) return;
  element.timetag = *timetag;
  element.id = line.substr(colon + 2, caret - colon - 2);
  std::string_view rest = line.substr(caret + 2);
  // An attribute in bars may hold blanks.
  std::size_t end = 0;
  for (bool quoted = false; end < rest.size() && (quoted || rest[end] != ' '); ++end)
    if (rest[end] == '|') quoted = !quoted;
  if (end >= rest.size()) return;
  element.attribute = rest.substr(0, end);
  rest.remove_prefix(end + 1);
  if (rest.ends_with(" +") && rest.size() > 2) {
    element.acceptable = true;
    rest.remove_suffix(2);
  }
  element.value = rest;
  const bool is_letter = !rest.empty() && rest[0] >= 'A' && rest[0] <= 'Z';
  element.is_object = is_letter && rest.size() > 1 && rest.find_first_not_of("0123456789", 1) == std::string_view::npos;
  log.Add(element);
}

/// "^waypoint gate ^at (^x 3 ^z 4) ^text |go ^fast|".
std::vector<mind::Parameter> ReadParameters(std::string_view text) {
  std::vector<mind::Parameter> parameters;
  std::uint32_t depth = 0;
  constexpr std::uint32_t kDeepest = 64;
  while (!text.empty()) {
    if (Take(text, " ")) continue;
    if (depth > 0 && Take(text, ")")) {
      --depth;
      continue;
    }
    const std::size_t blank = text.find(' ');
    if (!Take(text, "^") || blank == std::string_view::npos) break;
    mind::Parameter& parameter = parameters.emplace_back();
    parameter.depth = depth;
    parameter.attribute = text.substr(0, blank - 1);
    text.remove_prefix(blank);
    if (depth < kDeepest && (text.starts_with("(^") || text.starts_with("()")) && Take(text, "(")) {
      parameter.is_object = true;
      ++depth;
      continue;
    }
    if (text.starts_with('|')) {
      // Bars are put around what holds " ^" only.
      const std::size_t end = text.find('|', 1);
      const std::string_view within = end == std::string_view::npos ? text : text.substr(1, end - 1);
      if (end != std::string_view::npos && within.find(" ^") != std::string_view::npos) {
        parameter.value = within;
        text.remove_prefix(end + 1);
        continue;
      }
    }
    std::size_t end = std::min(text.find(" ^"), text.size());
    // What closes the objects that are open belongs to them.
    std::size_t closing = 0;
    while (closing < depth && closing < end && text[end - 1 - closing] == ')') ++closing;
    parameter.value = ValueIn(text.substr(0, end - closing));
    text.remove_prefix(end - closing);
  }
  return parameters;
}

/// "move-to ^waypoint gate", or how one went: "move-to: complete", "shoot: error no-target".
void ReadCommand(std::string_view line, std::string_view rule, mind::EventLog& log) {
  const std::size_t colon = line.find(": "), blank = line.find(' ');
  if (colon == std::string_view::npos || colon > blank) {
    const std::string_view parameters = blank == std::string_view::npos ? std::string_view() : line.substr(blank + 1);
    return log.Add(mind::CommandSaid{0, line.substr(0, blank), rule, ReadParameters(parameters)});
  }
  std::string_view outcome = line.substr(colon + 2);
  const std::string_view status = outcome.substr(0, outcome.find(' '));
  outcome.remove_prefix(std::min(status.size() + 1, outcome.size()));
  mind::CommandEnded ended{line.substr(0, colon), mind::CommandStatus::kError, outcome};
  for (const mind::CommandStatus one : {mind::CommandStatus::kComplete, mind::CommandStatus::kInterrupted})
    if (status == tell::StatusName(one)) ended.status = one;
  log.Add(ended);
}

std::string_view At(const std::vector<std::string>& texts, std::size_t place) {
  return place < texts.size() ? std::string_view(texts[place]) : std::string_view();
}

}  // namespace

mind::EventLog ReadWords(const tell::MindWords& words) {
  mind::EventLog log;
  for (const std::string& percept : words.percepts) ReadPercept(percept, log);
  std::size_t decided = 0;
  const auto decide = [&](std::size_t until) {
    for (; decided < std::min(until, words.decisions.size()); ++decided)
      ReadDecision(words.decisions[decided], At(words.reasons, decided), log);
  };
  for (const std::string_view detail : words.details) {
    const std::size_t blank = std::min(detail.find(' '), detail.size());
    decide(static_cast<std::size_t>(NumberIn<std::uint64_t>(detail.substr(0, blank)).value_or(0)));
    ReadDetail(detail.substr(std::min(blank + 1, detail.size())), log);
  }
  decide(words.decisions.size());
  for (std::size_t i = 0; i < words.commands.size(); ++i)
    ReadCommand(words.commands[i], At(words.command_rules, i), log);
  return log;
}

}  // namespace soarbox::record
