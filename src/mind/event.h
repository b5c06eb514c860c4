// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <variant>
#include <vector>

#include "mind/decision.h"

namespace soarbox::mind {

// What minds do, as facts: each kind of event is a type. Texts are names and values, never sentences, and belong to the
// log that the event comes from (mind/event_log.h). Levels of the goal stack count from 1, the top state.
//
// `Fields` shows the fields of an event to `see(name, field)` in the order in which files hold them.

/// A constant as links have it: a word, an integer or a float.
using Value = std::variant<std::string_view, std::int64_t, double>;

/// Levels of the goal stack below this one count as this one.
inline constexpr std::uint64_t kDeepestLevel = 1000;
/// At most this much of a command is reported.
inline constexpr std::size_t kMostParameters = 10'000;

/// An element below a command. Those of an object come right after it, one step deeper.
struct Parameter {
  std::uint32_t depth = 0;
  bool is_object = false;  ///< Then it has no value.
  std::string_view attribute;
  Value value;
  friend bool operator==(const Parameter&, const Parameter&) = default;
};

/// Why a state is there.
enum class StateReason : std::uint8_t { kTop, kTie, kConflict, kConstraintFailure, kNoChange };

enum class CommandStatus : std::uint8_t { kComplete, kInterrupted, kError };

/// A constant of the input link has come or changed. The path is that of its object, with a dot at its end, or empty; a
/// key tells siblings of one attribute apart, 0: there is one.
struct PerceptChanged {
  std::string_view path, attribute;
  std::uint32_t key = 0;
  Value value;
  template <typename Self, typename See>
  static void Fields(Self& self, See&& see) {
    see("path", self.path), see("attribute", self.attribute), see("key", self.key), see("value", self.value);
  }
};

/// A percept has gone, with all below it.
struct PerceptGone {
  std::string_view path, attribute;
  std::uint32_t key = 0;
  template <typename Self, typename See>
  static void Fields(Self& self, See&& see) {
    see("path", self.path), see("attribute", self.attribute), see("key", self.key);
  }
};

/// A command came to the output link.
struct CommandSaid {
  std::uint64_t timetag = 0;
  std::string_view name;
  std::string_view rule;  ///< That made it; empty: not known.
  std::vector<Parameter> parameters;
  template <typename Self, typename See>
  static void Fields(Self& self, See&& see) {
    see("timetag", self.timetag), see("name", self.name), see("rule", self.rule), see("parameters", self.parameters);
  }
};

/// How a command went.
struct CommandEnded {
  std::string_view name;
  CommandStatus status = CommandStatus::kComplete;
  std::string_view fault;  ///< Of an error: "no-target".
  template <typename Self, typename See>
  static void Fields(Self& self, See&& see) {
    see("name", self.name), see("status", self.status), see("fault", self.fault);
  }
};

struct OperatorSelected {
  int level = 1;
  std::string_view id, name;  ///< The name may be empty.
  std::string_view decision;  ///< What the decision procedure said, packed (mind/decision_codec.h); may be empty.
  template <typename Self, typename See>
  static void Fields(Self& self, See&& see) {
    see("level", self.level), see("id", self.id), see("name", self.name), see("decision", self.decision);
  }
};

struct StateMade {
  int level = 1;
  std::string_view id;
  StateReason reason = StateReason::kTop;
  bool on_operator = false;   ///< The impasse is about operators, not about the state.
  std::string_view decision;  ///< As above.
  template <typename Self, typename See>
  static void Fields(Self& self, See&& see) {
    see("level", self.level), see("id", self.id), see("reason", self.reason), see("on_operator", self.on_operator),
        see("decision", self.decision);
  }
};

/// A state went, with all below it.
struct StateGone {
  int level = 1;
  std::string_view id;
  template <typename Self, typename See>
  static void Fields(Self& self, See&& see) {
    see("level", self.level), see("id", self.id);
  }
};

struct Halted {
  template <typename Self, typename See>
  static void Fields(Self&, See&&) {}
};

/// Long-term memory answered. The question, the answer and the reason are as the kernel gives them.
struct Recalled {
  int level = 1;
  bool is_episode = false;
  std::uint64_t number = 0;  ///< Of the object or the episode; 0: nothing came.
  std::string_view question, answer, reason;
  template <typename Self, typename See>
  static void Fields(Self& self, See&& see) {
    see("level", self.level), see("is_episode", self.is_episode), see("number", self.number),
        see("question", self.question), see("answer", self.answer), see("reason", self.reason);
  }
};

/// A rule was learned from what went on in a state.
struct RuleLearned {
  int level = 1;
  std::string_view rule;
  std::string_view from;   ///< The rule whose firing gave the result; empty: not known.
  std::string_view state;  ///< The substate; empty: not known.
  StateReason reason = StateReason::kNoChange;
  bool on_operator = false;
  template <typename Self, typename See>
  static void Fields(Self& self, See&& see) {
    see("level", self.level), see("rule", self.rule), see("from", self.from), see("state", self.state),
        see("reason", self.reason), see("on_operator", self.on_operator);
  }
};

/// Learning by reward gave a rule another number.
struct ValueUpdated {
  std::string_view rule;
  double value = 0;
  template <typename Self, typename See>
  static void Fields(Self& self, See&& see) {
    see("rule", self.rule), see("value", self.value);
  }
};

struct RewardReceived {
  double reward = 0;
  template <typename Self, typename See>
  static void Fields(Self& self, See&& see) {
    see("reward", self.reward);
  }
};

/// What was learned by reward up to here belongs together.
struct EpisodeEnded {
  template <typename Self, typename See>
  static void Fields(Self&, See&&) {}
};

/// A rule fired, or what it made goes because the rule no longer matches.
struct RuleFired {
  std::string_view rule;
  bool retracts = false;
  template <typename Self, typename See>
  static void Fields(Self& self, See&& see) {
    see("rule", self.rule), see("retracts", self.retracts);
  }
};

/// A working memory element came or went; its symbols as Soar prints them.
struct ElementChanged {
  bool added = true;
  std::uint64_t timetag = 0;
  std::string_view id, attribute, value;
  bool acceptable = false;
  bool is_object = false;  ///< The value is an identifier.
  template <typename Self, typename See>
  static void Fields(Self& self, See&& see) {
    see("added", self.added), see("timetag", self.timetag), see("id", self.id), see("attribute", self.attribute),
        see("value", self.value), see("acceptable", self.acceptable), see("is_object", self.is_object);
  }
};

/// What an old recording says, in words, of the event before this one.
struct Remark {
  std::string_view text;
  template <typename Self, typename See>
  static void Fields(Self& self, See&& see) {
    see("text", self.text);
  }
};

/// The place of a type in this list is its number in files: new ones come at the end.
using Event =
    std::variant<PerceptChanged, PerceptGone, CommandSaid, CommandEnded, OperatorSelected, StateMade, StateGone, Halted,
                 Recalled, RuleLearned, ValueUpdated, RewardReceived, EpisodeEnded, RuleFired, ElementChanged, Remark>;

/// What is noted in detail only (firings, elements).
inline bool IsDetail(const Event& event) {
  return std::holds_alternative<RuleFired>(event) || std::holds_alternative<ElementChanged>(event);
}

/// Functions for the kinds of events that somebody wants: `std::visit(Cases{...}, event)`.
template <typename... Functions>
struct Cases : Functions... {
  using Functions::operator()...;
};
template <typename... Functions>
Cases(Functions...) -> Cases<Functions...>;

}  // namespace soarbox::mind
