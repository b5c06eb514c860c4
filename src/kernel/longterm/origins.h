// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "kernel/base/ids.h"
#include "kernel/base/symbol.h"
#include "kernel/decide/module.h"
#include "kernel/memory/preference.h"
#include "kernel/memory/working_memory.h"
#include "kernel/rules/production.h"

namespace soarbox::kernel {

struct AgentCounters;
struct AgentParts;
struct Goal;
class GoalChanges;
class GoalStack;
class InstantiationTable;
class Modules;
class Rete;

/// An element as it was when a rule matched it.
struct OriginElement {
  enum class Source : std::uint8_t { kRule, kInput, kArchitecture };

  Symbol id, attribute, value;
  std::uint64_t timetag = 0;
  bool acceptable = false;
  Source source = Source::kRule;
  std::uint32_t origin = 0xFFFFFFFFu;  ///< Place of the element's own origin, or Origins::kNone.
};

/// What made an element: the rule, and what it matched when it fired. Of a selected operator: who proposed it.
struct Origin {
  ProductionPtr rule;          ///< Also after the rule was excised. Null for an operator.
  std::uint64_t decision = 0;  ///< In which the rule fired or the operator was selected; 0 if that was not noted.
  bool o_supported = false;
  bool is_operator = false;
  GoalLevel level = 0;  ///< Of `state`.
  Symbol state;         ///< The lowest state that the rule matched, or the state that the operator was selected in.
  /// The operator that was selected in `state`, or in the nearest state above it that had one; none if none had. Of an
  /// operator: itself.
  Symbol op, op_name;
  std::uint32_t op_origin = 0xFFFFFFFFu;
  std::vector<OriginElement> matched;    ///< No more than Origins::kMostMatched.
  std::uint32_t left_out = 0;            ///< How many more were matched.
  std::vector<std::uint32_t> proposals;  ///< Of an operator: the origins of its proposals.
  std::string decided;                   ///< Of an operator: why it was selected, as Origins::Describe wrote it.

 private:
  friend class Origins;
  std::uint32_t references = 0;  ///< 0: the place is free.
  std::uint32_t serial = 0;      ///< Of the instantiation, to find out whether it is still the maker.
  std::uint32_t seen = 0;
  std::uint32_t attached = 0;  ///< How many elements that live, or selected operators, have it.
};

/// Remembers what made each element with o-support, each element of a command, and each selected operator. Off until
/// somebody asks for it; then it begins with what is made from that moment on.
///
/// Bounds: an origin is freed with its element unless a younger origin links to it. From each origin one can follow
/// links through no more than kDeepest origins of elements that have gone, and no more than kMostBehind in all.
///
/// It only reads: an agent runs the same with it and without.
class Origins final : public Module {
 public:
  static constexpr std::uint32_t kNone = 0xFFFFFFFFu;
  static constexpr std::size_t kMostMatched = 24, kMostBehind = 48;
  static constexpr std::uint32_t kDeepest = 6;
  static constexpr std::size_t kMostPast = 8;
  static constexpr int kPlace = 100;  ///< Among the modules.

  /// Of an agent that lives no longer than this. Nothing is noted before Begin.
  explicit Origins(const AgentParts& parts);

  /// Why the operator of a goal is selected (Agent::ExplainDecision), as bytes.
  using Describe = std::function<std::string(const Goal&)>;

  /// Begins, between two runs. Forgets nothing if it has begun already.
  void Begin(Describe describe);
  bool on() const { return on_; }

  /// The place of an element's origin, or kNone.
  std::uint32_t Of(WmeId wme) const { return Index(wme) < of_.size() ? of_[Index(wme)] : kNone; }
  /// That of the operator that is selected at a level, or kNone.
  std::uint32_t OfOperator(GoalLevel level) const { return level < selected_.size() ? selected_[level] : kNone; }
  const Origin& at(std::uint32_t place) const { return origins_[place]; }
  /// An element that was directly on the output link and has gone: the last kMostPast of them are kept.
  struct Past {
    Symbol attribute;
    std::uint64_t timetag = 0;
    std::uint32_t origin = kNone;
  };
  /// The last one that passes the test, or null.
  template <typename Test>
  const Past* FindPast(Test test) const {
    for (std::size_t n = past_.size(); n-- > 0;)
      if (test(past_[n])) return &past_[n];
    return nullptr;
  }
  /// How many origins there are.
  std::size_t count() const { return origins_.size() - free_.size(); }
  /// What they take, about. Not part of the agent's MemoryBytes: limits must not depend on who looks.
  std::size_t Bytes() const;

 private:
  void RulesFire() override;
  void Asserted(PreferenceId preference) override;
  void AfterElaboration() override;
  void Flushed(std::span<const WmeId> added, std::span<const WmeId> removed) override;
  void OperatorInstalled(GoalLevel level, Symbol op) override;
  void StateRemoved(GoalLevel level) override;
  void BeforeInit() override;
  void Mark(const std::function<void(Symbol)>& mark) override;

  /// An element that is about to be made.
  struct Pending {
    Symbol id, attribute, value;
    std::uint32_t origin = kNone;
  };

  template <typename Work>
  void Guarded(Work work);
  bool IsOutput(Symbol id) const;
  /// Whether the firing that made the preference made something directly below the output link.
  bool GivesCommand(const Preference& preference);
  const Preference& MadeBy(const Preference& preference) const;
  std::uint32_t OriginOfFiring(const Preference& preference, std::uint32_t depth);
  std::uint32_t OriginOfElement(WmeId wme, std::uint32_t depth);
  std::span<const WmeId> MatchedBy(InstantiationId instantiation);
  void NoteSelected(GoalLevel level);
  Symbol NameOf(Symbol op) const;
  WmeId ElementOf(const Pending& pending) const;
  void Attach(WmeId wme, std::uint32_t origin);
  void Detach(WmeId wme);
  void ForgetSelected(GoalLevel level);
  std::uint32_t Take();
  void Hold(std::uint32_t origin) { ++origins_[origin].references; }
  void Drop(std::uint32_t origin);
  void ReleaseLinks(std::uint32_t origin, std::vector<std::uint32_t>& work);
  void CutBehind(std::uint32_t origin);
  void Clear();

  /// What it uses of the agent.
  struct Uses {
    WorkingMemory& memory;
    const GoalStack& goals;
    const InstantiationTable& instantiations;
    const Rete& rete;
    const AgentCounters& counters;
    const GoalChanges& goal_changes;
    Modules& modules;
  };
  Uses uses_;
  bool on_ = false, attached_ = false;
  Describe describe_;
  std::vector<Origin> origins_;
  std::vector<std::uint32_t> free_, of_, selected_;  ///< of_: by element; selected_: by level.
  std::vector<Pending> pending_;                     ///< Each holds its origin.
  std::vector<Past> past_;                           ///< Oldest first. Each holds its origin.
  std::vector<GoalLevel> installed_;                 ///< Levels whose operators have not been noted yet.
  /// The last origin of an instantiation that was noted in this elaboration, by its serial.
  std::uint32_t last_serial_ = 0, last_origin_ = kNone;
  std::uint32_t asked_serial_ = 0;
  bool gives_command_ = false;  ///< Of the firing with asked_serial_.
  std::uint32_t seen_ = 0;
  std::vector<std::uint32_t> work_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> queue_;
  std::vector<WmeId> traced_;
};

}  // namespace soarbox::kernel
