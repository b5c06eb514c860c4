// SPDX-License-Identifier: BSD-2-Clause
#include "mission/evaluator.h"

#include <algorithm>
#include <cmath>

#include "diagnostics/name_table.h"
#include "mission/check_sentences.h"
#include "mission/conditions.h"

namespace soarbox::mission {
namespace {

std::string ListOf(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

/// Times of ticks are multiples of the step, and bounds may be rounded decimals. The slack makes a bound include the
/// tick that it was rounded from.
constexpr double kSlack_s = 1e-4;
constexpr double kForever_s = 1e30;

int Badness(State state) {
  switch (state) {
    case State::kTrue:
      return 0;
    case State::kOpen:
      return 1;
    case State::kUntested:
      return 2;
    case State::kUndecided:
      return 3;
    case State::kFalse:
      return 4;
  }
  return 0;
}

bool IsCounter(const Check& check) {
  return !check.conditions.empty() && check.conditions.front().row->kind == Kind::kCounter;
}

}  // namespace

std::string_view NameOf(State state) {
  static constexpr const char* kNames[] = {"open", "true", "false", "untested", "undecided"};
  return NameIn(kNames, state);
}

Evaluator::Evaluator(const Mission& mission, bool kernel_tells_all)
    : mission_(mission), wants_(WantsOf(mission)), tells_all_(kernel_tells_all) {
  const std::size_t count = mission.checks.size() + mission.mistakes.size();
  verdicts_.resize(count);
  occurrences_s_.resize(count);
  came_true_s_.resize(count);
  is_followed_.resize(count);
  for (std::size_t i = 0; i < count; ++i)
    if (CheckAt(i).whenever != kNoCheck) is_followed_[CheckAt(i).whenever] = true;
}

const Check& Evaluator::CheckAt(std::size_t index) const {
  const std::size_t first = mission_.checks.size();
  return index < first ? mission_.checks[index] : mission_.mistakes[index - first];
}

void Evaluator::MakeSlots(const TickFacts& facts) {
  for (std::size_t i = 0; i < verdicts_.size(); ++i) {
    const Check& check = CheckAt(i);
    std::vector<std::size_t> subjects;
    for (std::size_t a = 0; a < facts.agents.size() && check.item.empty(); ++a) {
      const AgentFacts& agent = facts.agents[a];
      const bool is_named = std::any_of(check.agents.begin(), check.agents.end(),
                                        [&](const std::string& name) { return MatchesPattern(name, agent.name); });
      if (is_named || (!check.team.empty() && agent.team == check.team)) subjects.push_back(a);
    }
    for (std::size_t a = 0; a < facts.items.size() && !check.item.empty(); ++a)
      if (facts.items[a].name == check.item) subjects.push_back(a);
    Slot slot;
    slot.check = i;
    const bool is_undecided =
        !tells_all_ && std::any_of(check.conditions.begin(), check.conditions.end(),
                                   [](const Condition& condition) { return condition.row->source != Source::kWorld; });
    if (is_undecided) slot.state = verdicts_[i].state = State::kUndecided;
    if (check.who == Who::kEach && subjects.size() > 1) {
      for (const std::size_t subject : subjects) {
        slot.subjects = {subject};
        slots_.push_back(slot);
      }
    } else {
      slot.subjects = std::move(subjects);
      slots_.push_back(std::move(slot));
    }
  }
}

Evaluator::Found Evaluator::Look(const Slot& slot, const Check& check, const TickFacts& facts) const {
  Found found;
  const bool of_world = check.agents.empty() && check.team.empty() && check.item.empty();
  const std::size_t count = of_world ? 1 : slot.subjects.size();
  std::size_t holding = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const bool is_item = !check.item.empty();
    const AgentFacts* agent = of_world || is_item ? nullptr : &facts.agents[slot.subjects[i]];
    const ItemFacts* item = is_item ? &facts.items[slot.subjects[i]] : nullptr;
    Found one;
    one.holds = true;
    one.times = 1;
    for (const Condition& condition : check.conditions) {
      Finding part = LookAt(condition, agent, item, facts, wants_);
      one.conditions += part.holds ? 1 : 0;
      if (condition.row->kind == Kind::kEvent) one.times = part.times;
      if (condition.row->kind == Kind::kCounter) one.value = part.value;
      if (part.holds && (one.detail.empty() || condition.row->kind == Kind::kEvent)) one.detail = part.detail;
      if (part.holds) continue;
      one.holds = false;
      if (!one.missing.empty()) continue;
      one.missing = Infinitive(condition);
      one.away = part.away;
      one.detail = part.detail;
    }
    if (agent != nullptr) one.agent = agent->name;
    if (!one.holds) one.times = 0;
    holding += one.holds ? 1 : 0;
    found.times += one.times;
    found.value += one.value;
    const bool is_better =
        i == 0 || (check.who == Who::kTogether || check.mode == Mode::kAlways ? found.holds && !one.holds
                                                                              : one.holds && !found.holds);
    if (i == 0 || is_better ||
        (one.holds == found.holds &&
         (one.conditions > found.conditions || (one.conditions == found.conditions && one.away < found.away)))) {
      const double times = found.times, value = found.value;
      found = std::move(one);
      found.times = times;
      found.value = value;
    }
  }
  switch (check.who) {
    case Who::kTogether:
      found.holds = count > 0 && holding == count;
      break;
    case Who::kSome:
      found.holds = holding >= static_cast<std::size_t>(check.some);
      break;
    default:
      found.holds = holding > 0;
      break;
  }
  if (check.who == Who::kTogether || check.who == Who::kSome) {
    found.times = found.holds ? 1 : 0;
    if (found.missing.empty() || count > 1)
      found.detail = std::to_string(holding) + " of " + std::to_string(count) + " did";
    found.agent.clear();
  }
  return found;
}

Evaluator::Window Evaluator::WindowOf(const Check& check) const {
  Window window;
  double base_s = 0;
  if (check.from_s) window.open_s = *check.from_s - kSlack_s;
  if (check.after_s) {
    base_s = *check.after_s;
    window.open_s = std::max(window.open_s, base_s + kSlack_s);
  }
  window.has_opened = true;
  if (check.after != kNoCheck) {
    const std::optional<double> came = came_true_s_[check.after];
    window.has_opened = came.has_value();
    base_s = came.value_or(0);
    window.open_s = std::max(window.open_s, base_s + kSlack_s);
  }
  window.close_s = kForever_s;
  const auto close = [&](double at_s) { window.close_s = std::min(window.close_s, at_s + kSlack_s); };
  if (check.by_s) close(*check.by_s);
  if (check.within_s && check.mode != Mode::kWhenever) close(base_s + *check.within_s);
  for (const std::size_t other : {check.before, check.until})
    if (other != kNoCheck && came_true_s_[other]) close(*came_true_s_[other]);
  return window;
}

void Evaluator::Decide(Slot& slot, State state, std::uint64_t tick, double time_s, std::string agent, std::string was) {
  slot.state = state;
  Verdict& verdict = verdicts_[slot.check];
  if (state == State::kTrue) {
    // The check is true when it is true for all its agents.
    for (const Slot& other : slots_)
      if (other.check == slot.check && other.state != State::kTrue) return;
    came_true_s_[slot.check] = time_s;
  } else if (verdict.state != State::kOpen && Badness(state) <= Badness(verdict.state)) {
    return;
  }
  verdict = {state, tick, time_s, std::move(agent), std::move(was)};
}

void Evaluator::Note(Slot& slot, const Check& check, const Found& found) {
  if (!found.agent.empty()) slot.last_agent = found.agent;
  if (check.mode != Mode::kComesTrue) return;
  const bool is_better = found.conditions > slot.most || (found.conditions == slot.most && found.away < slot.nearest);
  if (!is_better) return;
  slot.most = found.conditions;
  slot.nearest = found.away;
  slot.best_s = last_time_s_;
  slot.best_detail = found.detail;
  slot.missing = found.missing;
}

std::string Evaluator::Miss(const Slot& slot, const Check& check) const {
  if (slot.subjects.empty() && (!check.agents.empty() || !check.team.empty() || !check.item.empty()))
    return "there is no agent of that name";
  if (slot.nearest < 1e29 && !slot.missing.empty()) {
    const Key key = check.conditions.front().row->key;
    if (check.conditions.size() == 1 && (key == Key::kAt || key == Key::kInside))
      return "it came within " + NumberText(std::round((slot.nearest + (key == Key::kAt ? 1.5 : 0)) * 10) / 10) +
             " m, at " + SecondsText(slot.best_s);
  }
  if (check.conditions.size() > 1 && slot.most > 0) {
    return std::to_string(slot.most) + " of " + std::to_string(check.conditions.size()) + " conditions held at " +
           SecondsText(slot.best_s) + "; " + Denied(slot.missing) +
           (slot.best_detail.empty() ? "" : ": " + slot.best_detail);
  }
  if (slot.nearest < 1e29 && !slot.best_detail.empty()) return slot.best_detail + " at " + SecondsText(slot.best_s);
  if (check.who == Who::kAny && slot.subjects.size() > 1) {
    const std::string whom = check.team.empty() ? "them" : "team " + check.team;
    return "none of " + (check.team.empty() && check.agents.size() > 1 ? ListOf(check.agents) : whom) + " did";
  }
  return "it never did";
}

void Evaluator::Judge(Slot& slot, const Found& found, bool rises) {
  const Check& check = CheckAt(slot.check);
  const double now_s = last_time_s_;
  const Window window = WindowOf(check);
  const bool is_over = now_s > window.close_s;
  const bool is_in = window.has_opened && now_s >= window.open_s && !is_over;
  const auto decide = [&](State state, std::string was) {
    Decide(slot, state, last_tick_, now_s, found.agent, std::move(was));
  };
  if (is_in) {
    if (!slot.opened_at_s) {
      slot.opened_at_s = now_s;
      // What a counter counted before the window opened does not count.
      if (check.after != kNoCheck || check.after_s || check.from_s) slot.base = found.value;
    }
    Note(slot, check, found);
  }
  switch (check.mode) {
    case Mode::kComesTrue:
      if (is_in && found.holds) {
        if (!slot.held_since_s) slot.held_since_s = now_s;
        if (now_s - *slot.held_since_s >= check.for_s.value_or(0) - kSlack_s) return decide(State::kTrue, found.detail);
      } else {
        slot.held_since_s.reset();
      }
      if (window.has_opened && is_over)
        Decide(slot, State::kFalse, last_tick_, now_s, slot.last_agent, Miss(slot, check));
      return;
    case Mode::kAlways:
      if (is_in && !found.holds) return decide(State::kFalse, found.detail.empty() ? "it did not" : found.detail);
      if (window.has_opened && is_over) decide(State::kTrue, {});
      return;
    case Mode::kNever:
      if (is_in && found.holds) return decide(State::kFalse, found.detail.empty() ? "it did" : found.detail);
      if (is_over) decide(State::kTrue, {});
      return;
    case Mode::kTimes: {
      if (is_in)
        slot.count = IsCounter(check)
                         ? found.value - slot.base
                         : slot.count + (check.conditions.front().row->kind == Kind::kEvent || found.times > 1
                                             ? found.times
                                             : (rises ? 1 : 0));
      const std::string count = NumberText(std::round(slot.count * 10) / 10);
      if (check.times.max && slot.count > *check.times.max + 1e-9)
        return decide(State::kFalse, "it was " + count + " by then");
      if (check.times.min && !check.times.max && slot.count >= *check.times.min) return decide(State::kTrue, {});
      if (window.has_opened && is_over)
        decide(check.times.Hold(slot.count) ? State::kTrue : State::kFalse, "it was " + count);
      return;
    }
    case Mode::kWhenever: {
      const std::vector<double>& triggers = occurrences_s_[check.whenever];
      if (!triggers.empty() && triggers.back() == now_s) slot.deadlines_s.push_back(now_s + *check.within_s + kSlack_s);
      if (found.holds) {
        slot.count += static_cast<double>(slot.deadlines_s.size());
        slot.deadlines_s.clear();
      }
      if (slot.deadlines_s.empty() || slot.deadlines_s.front() >= now_s) return;
      Decide(slot, State::kFalse, last_tick_, now_s, slot.last_agent,
             "it did not, after " + SecondsText(slot.deadlines_s.front() - *check.within_s - kSlack_s));
      return;
    }
  }
}

void Evaluator::Feed(const TickFacts& facts) {
  last_tick_ = facts.tick;
  last_time_s_ = facts.time_s;
  if (!is_begun_) MakeSlots(facts);
  // First all values are computed, then the checks, because checks can refer to each other in any order.
  std::vector<Found> found(slots_.size());
  std::vector<bool> rises(slots_.size());
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    Slot& slot = slots_[i];
    if (slot.state != State::kOpen && !is_followed_[slot.check]) continue;
    const Check& check = CheckAt(slot.check);
    found[i] = Look(slot, check, facts);
    const bool is_event = std::any_of(check.conditions.begin(), check.conditions.end(),
                                      [](const Condition& condition) { return condition.row->kind == Kind::kEvent; });
    rises[i] = found[i].holds && (is_event || !slot.held);
    slot.held = found[i].holds;
    if (rises[i]) occurrences_s_[slot.check].push_back(facts.time_s);
  }
  for (std::size_t i = 0; i < slots_.size(); ++i)
    if (slots_[i].state == State::kOpen) Judge(slots_[i], found[i], rises[i]);
  if (!is_begun_) {
    for (std::size_t i = 0; i < mission_.checks.size(); ++i) {
      const Check& check = mission_.checks[i];
      if (verdicts_[i].state == State::kTrue && !check.marker) idle_checks_.push_back(i);
    }
  }
  is_begun_ = true;
}

void Evaluator::Finish() {
  for (Slot& slot : slots_) {
    if (slot.state != State::kOpen) continue;
    const Check& check = CheckAt(slot.check);
    const auto decide = [&](State state, std::string was) {
      Decide(slot, state, last_tick_, last_time_s_, slot.last_agent, std::move(was));
    };
    const std::size_t waits_for = check.mode == Mode::kWhenever ? check.whenever : check.after;
    const bool follows_marker = waits_for != kNoCheck && CheckAt(waits_for).marker;
    const bool has_opened =
        slot.opened_at_s.has_value() || (check.mode == Mode::kWhenever && !occurrences_s_[check.whenever].empty());
    if (!has_opened && (waits_for != kNoCheck || check.mode == Mode::kComesTrue || check.mode == Mode::kTimes)) {
      decide(follows_marker ? State::kTrue : State::kUntested,
             waits_for == kNoCheck ? "the run ended before" : "\"" + CheckAt(waits_for).name + "\" never came true");
      continue;
    }
    switch (check.mode) {
      case Mode::kComesTrue:
        decide(State::kFalse, Miss(slot, check));
        break;
      case Mode::kAlways:
      case Mode::kNever:
      case Mode::kWhenever:
        decide(State::kTrue, {});
        break;
      case Mode::kTimes:
        decide(check.times.Hold(slot.count) ? State::kTrue : State::kFalse,
               "it was " + NumberText(std::round(slot.count * 10) / 10));
        break;
    }
  }
}

bool Evaluator::IsDecided() const {
  for (std::size_t i = 0; i < mission_.checks.size(); ++i)
    if (!mission_.checks[i].marker && verdicts_[i].state == State::kOpen) return false;
  return true;
}

bool Evaluator::HasFailed() const {
  for (std::size_t i = 0; i < mission_.checks.size(); ++i) {
    const Check& check = mission_.checks[i];
    if (!check.marker && !check.pass && (verdicts_[i].state == State::kFalse || verdicts_[i].state == State::kUntested))
      return true;
  }
  return false;
}

bool Evaluator::HasPassed() const {
  for (std::size_t i = 0; i < mission_.checks.size(); ++i) {
    const Check& check = mission_.checks[i];
    if (!check.marker && !check.pass && verdicts_[i].state != State::kTrue) return false;
  }
  return true;
}

}  // namespace soarbox::mission
