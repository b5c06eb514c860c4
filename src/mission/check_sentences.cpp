// SPDX-License-Identifier: BSD-2-Clause
#include "mission/check_sentences.h"

#include <array>
#include <cmath>
#include <cstdio>

namespace soarbox::mission {
namespace {

std::string Joined(const std::vector<std::string>& words, std::string_view last) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) text += i + 1 == words.size() ? " " + std::string(last) + " " : ", ";
    text += words[i];
  }
  return text;
}

std::string BoundsText(const Bounds& bounds, std::string_view unit) {
  const auto number = [&](double value) { return NumberText(value) + std::string(unit); };
  if (bounds.min && bounds.max) {
    if (*bounds.min == *bounds.max) return number(*bounds.min);
    return NumberText(*bounds.min) + " to " + number(*bounds.max);
  }
  if (bounds.min) return "at least " + number(*bounds.min);
  if (bounds.max) return "at most " + number(*bounds.max);
  return "any";
}

std::string WithText(const Condition& condition) {
  std::string text;
  for (const auto& [name, value] : condition.with) text += " ^" + name + " " + value;
  return text;
}

/// A name, or the words for several.
std::string OneOf(const std::string& words, const char* any) {
  if (words == "any") return any;
  if (words == "friend") return "a friend";
  return words == "enemy" ? "an enemy" : words;
}

std::string Plural(const Bounds& times) {
  const bool is_one = times.max.value_or(times.min.value_or(0)) == 1;
  return BoundsText(times, is_one ? " time" : " times");
}

}  // namespace

std::string NumberText(double number) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3f", number);
  std::string result = text.data();
  while (result.ends_with('0')) result.pop_back();
  if (result.ends_with('.')) result.pop_back();
  return result == "-0" ? "0" : result;
}

std::string Infinitive(const Condition& condition) {
  const std::string words = Joined(condition.words, "or");
  if (const NumberRow* number = FindNumber(condition.row->key)) {
    return std::string(number->verb) + BoundsText(condition.bounds, number->unit);
  }
  switch (condition.row->key) {
    case Key::kAt:
      return "be at " + words;
    case Key::kInside:
      return "be inside " + words;
    case Key::kNear:
      return "be " + BoundsText(condition.bounds, " m") + " from " + words;
    case Key::kAlive:
      return condition.truth ? "be alive" : "be dead";
    case Key::kTeamDown:
      return "see nobody of team " + words + " alive";
    case Key::kTeamWins:
      return "see team " + words + " win";
    case Key::kEnded:
      return "reach '" + Joined(condition.words, "or") + "'";
    case Key::kCarries:
      return "carry " + words;
    case Key::kCarried:
      return condition.truth ? "be carried" : "not be carried";
    case Key::kSees:
      return "see " + OneOf(words, "anybody");
    case Key::kCollides:
      return "collide with " + OneOf(words, "anything");
    case Key::kHitBy:
      return "be hit by " + OneOf(words, "anybody");
    case Key::kHits:
      return "hit " + OneOf(words, "anybody");
    case Key::kMessage:
      return "send a message about " + words + WithText(condition);
    case Key::kPrints:
      return "print \"" + Joined(condition.words, "or") + "\"";
    case Key::kOperator:
      return "select operator " + words + WithText(condition) +
             (condition.level ? " at level " + std::to_string(*condition.level) : "") +
             (condition.selected_by.empty()           ? ""
              : condition.selected_by == "chance"     ? " by chance"
              : condition.selected_by == "preference" ? " by a preference"
                                                      : " as the only candidate");
    case Key::kImpasse:
      return (words == "any" ? std::string("meet an impasse") : "meet a " + words + " impasse") + WithText(condition);
    case Key::kCommand:
      if (!condition.status.empty()) {
        return "get " + condition.status + (condition.reason.empty() ? "" : " " + condition.reason) + " for " + words +
               WithText(condition);
      }
      return "give " + words + WithText(condition);
    case Key::kRule:
      return "fire rule " + words;
    case Key::kElement: {
      std::string text = "have ";
      if (condition.count) text += std::to_string(*condition.count) + " or more values of ";
      text += "^" + words;
      if (!condition.is.empty()) text += " " + condition.is;
      if (condition.support != 0) text += std::string(" with ") + condition.support + "-support";
      return text;
    }
    case Key::kRetrieval:
      return "get " + (condition.status.empty() ? std::string("an answer") : "the answer " + condition.status) +
             " from " + (words == "any" ? std::string("a") : "its " + words) + " memory";
    case Key::kProblem:
      return "show " + (words == "any" ? std::string("any problem") : "a problem of severity " + words);
    default:
      return {};
  }
}

std::string Denied(std::string_view infinitive) {
  constexpr std::string_view kNotBe = "not be ", kBe = "be ";
  if (infinitive.starts_with(kNotBe)) return "it was " + std::string(infinitive.substr(kNotBe.size()));
  if (infinitive.starts_with(kBe)) return "it was not " + std::string(infinitive.substr(kBe.size()));
  return "it did not " + std::string(infinitive);
}

std::string Whom(const Check& check) {
  if (!check.item.empty()) return check.item;
  if (check.agents.empty() && check.team.empty()) return "the run";
  const std::string names =
      check.team.empty() ? Joined(check.agents, check.who == Who::kAny ? "or" : "and") : check.team;
  switch (check.who) {
    case Who::kEach:
      return check.team.empty() && check.agents.size() == 1 ? names : "each of " + names;
    case Who::kAny:
      return check.team.empty() ? names : "somebody of " + names;
    case Who::kTogether:
      return "all of " + names + " in one tick";
    case Who::kSome:
      return std::to_string(check.some) + " of " + names + " in one tick";
  }
  return names;
}

std::string OverSeeds(int runs) {
  return "not in this run; it is to be true in " + std::to_string(runs) + (runs == 1 ? " run" : " runs") +
         " of the mission's seeds";
}

std::string Expectation(const Check& check, std::string_view who, const Mission& mission) {
  std::vector<std::string> what;
  for (const Condition& condition : check.conditions) what.push_back(Infinitive(condition));
  std::string text = who.empty() ? Whom(check) : std::string(who);
  const auto name = [&](std::size_t index) {
    return index < mission.checks.size() ? "\"" + mission.checks[index].name + "\"" : std::string("another check");
  };
  text += check.mode == Mode::kNever ? " should never " : check.mode == Mode::kAlways ? " should always " : " should ";
  text += Joined(what, "and");
  const bool is_counter = !check.conditions.empty() && check.conditions.front().row->kind == Kind::kCounter;
  if (check.mode == Mode::kTimes && !is_counter) text += " " + Plural(check.times);
  if (check.for_s) text += " for " + NumberText(*check.for_s) + " s";
  if (check.mode == Mode::kWhenever) {
    text += " within " + NumberText(check.within_s.value_or(0)) + " s whenever " + name(check.whenever);
  } else if (check.within_s) {
    text += " within " + NumberText(*check.within_s) + " s";
  }
  if (check.after != kNoCheck) text += " after " + name(check.after);
  if (check.after_s) text += " after " + NumberText(*check.after_s) + " s";
  if (check.before != kNoCheck) text += " before " + name(check.before);
  if (check.until != kNoCheck) text += " until " + name(check.until);
  if (check.from_s) text += " from " + NumberText(*check.from_s) + " s on";
  if (check.by_s) text += (check.mode == Mode::kComesTrue ? " by " : " up to ") + NumberText(*check.by_s) + " s";
  return text;
}

}  // namespace soarbox::mission
