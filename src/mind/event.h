// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <variant>
#include <vector>

#include "mind/decision_facts.h"

namespace soarbox::mind {

// What minds do, as typed events. Texts are names and values, never sentences. They belong to the log that the event
// comes from (mind/event_log.h). Levels of the goal stack count from 1, the top state.
//
// `Fields` calls `see(name, field)` for each field of an event, in the order in which files store them.

/// A constant of the input or output link: a word, an integer or a float.
using Value = std::variant<std::string_view, std::int64_t, double>;

/// Deeper levels of the goal stack are reported as this level.
inline constexpr std::uint64_t kDeepestLevel = 1000;
/// Maximum number of parameters of a command that are reported.
inline constexpr std::size_t kMostParameters = 10'000;

/// An element below a command. The elements of an object come directly after it, with a depth that is greater by 1.
struct Parameter {
  std::uint32_t depth = 0;
  bool is_object = false;  ///< It has no value then.
  std::string_view attribute;
  Value value;
  friend bool operator==(const Parameter&, const Parameter&) = default;
};

/// Why a state was created.
enum class StateReason : std::uint8_t { kTop, kTie, kConflict, kConstraintFailure, kNoChange };

enum class CommandStatus : std::uint8_t { kComplete, kInterrupted, kError };

/// A constant of the input link was added or changed. `path` is the path of its object, with a dot at the end, or
/// empty. `key` distinguishes elements with the same attribute; 0 if there is only one.
struct PerceptChanged {
  std::string_view path, attribute;
  std::uint32_t key = 0;
  Value value;
  template <typename Self, typename See>
  static void Fields(Self& self, See&& see) {
    see("path", self.path), see("attribute", self.attribute), see("key", self.key), see("value", self.value);
  }
};

/// A percept was removed, with everything below it.
struct PerceptGone {
  std::string_view path, attribute;
  std::uint32_t key = 0;
  template <typename Self, typename See>
  static void Fields(Self& self, See&& see) {
    see("path", self.path), see("attribute", self.attribute), see("key", self.key);
  }
};

/// A command was added to the output link.
struct CommandSaid {
  std::uint64_t timetag = 0;
  std::string_view name;
  std::string_view rule;  ///< The rule that made it; empty if it is not known.
  std::vector<Parameter> parameters;
  template <typename Self, typename See>
  static void Fields(Self& self, See&& see) {
    see("timetag", self.timetag), see("name", self.name), see("rule", self.rule), see("parameters", self.parameters);
  }
};

/// The result of a command.
struct CommandEnded {
  std::string_view name;
  CommandStatus status = CommandStatus::kComplete;
  std::string_view fault;  ///< For an error: "no-target".
  template <typename Self, typename See>
  static void Fields(Self& self, See&& see) {
    see("name", self.name), see("status", self.status), see("fault", self.fault);
  }
};

struct OperatorSelected {
  int level = 1;
  std::string_view id, name;  ///< The name may be empty.
  std::string_view decision;  ///< The recorded decision, packed (mind/decision_codec.h); may be empty.
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
  std::string_view decision;  ///< As in OperatorSelected.
  template <typename Self, typename See>
  static void Fields(Self& self, See&& see) {
    see("level", self.level), see("id", self.id), see("reason", self.reason), see("on_operator", self.on_operator),
        see("decision", self.decision);
  }
};

/// A state was removed, with all states below it.
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

/// Long-term memory answered a query. The texts are as the kernel reports them.
struct Recalled {
  int level = 1;
  bool is_episode = false;
  std::uint64_t number = 0;  ///< Number of the object or the episode; 0 if nothing was found.
  std::string_view question, answer, reason;
  template <typename Self, typename See>
  static void Fields(Self& self, See&& see) {
    see("level", self.level), see("is_episode", self.is_episode), see("number", self.number),
        see("question", self.question), see("answer", self.answer), see("reason", self.reason);
  }
};

/// A rule was learned from a result of a substate.
struct RuleLearned {
  int level = 1;
  std::string_view rule;
  std::string_view from;   ///< The rule whose firing created the result; empty if it is not known.
  std::string_view state;  ///< The substate; empty if it is not known.
  StateReason reason = StateReason::kNoChange;
  bool on_operator = false;
  template <typename Self, typename See>
  static void Fields(Self& self, See&& see) {
    see("level", self.level), see("rule", self.rule), see("from", self.from), see("state", self.state),
        see("reason", self.reason), see("on_operator", self.on_operator);
  }
};

/// Reinforcement learning changed the value of a rule.
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

/// An episode of reinforcement learning ended.
struct EpisodeEnded {
  template <typename Self, typename See>
  static void Fields(Self&, See&&) {}
};

/// A rule fired, or was retracted because it no longer matches.
struct RuleFired {
  std::string_view rule;
  bool retracts = false;
  template <typename Self, typename See>
  static void Fields(Self& self, See&& see) {
    see("rule", self.rule), see("retracts", self.retracts);
  }
};

/// An element of working memory was added or removed. Symbols are written as Soar prints them.
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

/// A reason in words for the event before this one. Nothing writes it any more; readers still accept it.
struct Remark {
  std::string_view text;
  template <typename Self, typename See>
  static void Fields(Self& self, See&& see) {
    see("text", self.text);
  }
};

/// Files store the index of a type in this list. Add new types at the end.
using Event =
    std::variant<PerceptChanged, PerceptGone, CommandSaid, CommandEnded, OperatorSelected, StateMade, StateGone, Halted,
                 Recalled, RuleLearned, ValueUpdated, RewardReceived, EpisodeEnded, RuleFired, ElementChanged, Remark>;

/// Whether an event is recorded only at MindDetail::kAll (firings, elements).
inline bool IsDetail(const Event& event) {
  return std::holds_alternative<RuleFired>(event) || std::holds_alternative<ElementChanged>(event);
}

/// Combines functions for several kinds of events: `std::visit(Cases{...}, event)`.
template <typename... Functions>
struct Cases : Functions... {
  using Functions::operator()...;
};
template <typename... Functions>
Cases(Functions...) -> Cases<Functions...>;

}  // namespace soarbox::mind
