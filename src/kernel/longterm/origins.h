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
  std::uint32_t origin = 0xFFFFFFFFu;  ///< Index of the element's own origin, or Origins::kNone.
};

/// What created an element: the rule, and the elements that it matched when it fired. For a selected operator: its
/// proposals.
struct Origin {
  ProductionPtr rule;          ///< Valid even after the rule was excised. Null for an operator.
  std::uint64_t decision = 0;  ///< The decision of the firing or selection; 0 if unknown.
  bool o_supported = false;
  bool is_operator = false;
  GoalLevel level = 0;  ///< Level of `state`.
  Symbol state;         ///< The lowest state that the rule matched, or the state in which the operator was selected.
  /// The operator that was selected in `state`, or in the nearest state above that had one; else none. For an operator:
  /// itself.
  Symbol op, op_name;
  std::uint32_t op_origin = 0xFFFFFFFFu;
  std::vector<OriginElement> matched;    ///< At most Origins::kMostMatched.
  std::uint32_t left_out = 0;            ///< Number of further matched elements.
  std::vector<std::uint32_t> proposals;  ///< For an operator: the origins of its proposals.
  std::string decided;                   ///< For an operator: why it was selected, as returned by Origins::Describe.

 private:
  friend class Origins;
  std::uint32_t references = 0;  ///< 0: the entry is free.
  std::uint32_t serial = 0;      ///< Serial number of the instantiation, to check whether it still exists.
  std::uint32_t seen = 0;
  std::uint32_t attached = 0;  ///< Number of live elements and selected operators with this origin.
};

/// Records the origin of each o-supported element, of each element whose firing also created an element directly on the
/// output link, and of each selected operator. Off until it is first needed; it records only what is created
/// afterwards.
///
/// Limits: an origin is freed with its element, unless a newer origin refers to it. A chain of references from an
/// origin contains at most kDeepest origins of removed elements. In total, an origin leads to at most kMostBehind of
/// them.
///
/// Read-only: the agent's behaviour does not depend on it.
class Origins final : public Module {
 public:
  static constexpr std::uint32_t kNone = 0xFFFFFFFFu;
  static constexpr std::size_t kMostMatched = 24, kMostBehind = 48;
  static constexpr std::uint32_t kDeepest = 6;
  static constexpr std::size_t kMostPast = 8;
  static constexpr int kPlace = 100;  ///< Its place among the modules.

  /// The agent must outlive this object. Nothing is recorded before Begin.
  explicit Origins(const AgentParts& parts);

  /// Returns the encoded reason why the operator of a goal is selected (Agent::ExplainDecision).
  using Describe = std::function<std::string(const Goal&)>;

  /// Starts recording. Call it between two runs. A second call has no effect on what was recorded.
  void Begin(Describe describe);
  bool on() const { return on_; }

  /// The index of an element's origin, or kNone.
  std::uint32_t Of(WmeId wme) const { return Index(wme) < of_.size() ? of_[Index(wme)] : kNone; }
  /// The index of the origin of the operator selected at a level, or kNone.
  std::uint32_t OfOperator(GoalLevel level) const { return level < selected_.size() ? selected_[level] : kNone; }
  const Origin& at(std::uint32_t place) const { return origins_[place]; }
  /// A removed element that was directly on the output link. The last kMostPast of them are kept.
  struct Past {
    Symbol attribute;
    std::uint64_t timetag = 0;
    std::uint32_t origin = kNone;
  };
  /// The latest one that satisfies `test`, or null.
  template <typename Test>
  const Past* FindPast(Test test) const {
    for (std::size_t n = past_.size(); n-- > 0;)
      if (test(past_[n])) return &past_[n];
    return nullptr;
  }
  /// The number of origins.
  std::size_t count() const { return origins_.size() - free_.size(); }
  /// Approximate size in bytes. Not part of the agent's MemoryBytes, because limits must not depend on observers.
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

  /// An element that is about to be created.
  struct Pending {
    Symbol id, attribute, value;
    std::uint32_t origin = kNone;
  };

  template <typename Work>
  void Guarded(Work work);
  bool IsOutput(Symbol id) const;
  /// Whether the firing that created the preference also created an element directly on the output link.
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

  /// The parts of the agent that it uses.
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
  std::vector<GoalLevel> installed_;                 ///< Levels whose operators are not recorded yet.
  /// The last origin recorded in this elaboration for an instantiation, by its serial number.
  std::uint32_t last_serial_ = 0, last_origin_ = kNone;
  std::uint32_t asked_serial_ = 0;
  bool gives_command_ = false;  ///< For the firing with asked_serial_.
  std::uint32_t seen_ = 0;
  std::vector<std::uint32_t> work_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> queue_;
  std::vector<WmeId> traced_;
};

}  // namespace soarbox::kernel
