// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
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
  /// Valid even after the rule was excised. Null for an operator.
  const Production* rule = nullptr;
  std::uint64_t decision = 0;  ///< The decision of the firing or selection; 0 if unknown.
  Symbol state;  ///< The lowest state that the rule matched, or the state in which the operator was selected.
  /// The operator that was selected in `state`, or in the nearest state above that had one; else none. For an operator:
  /// itself.
  Symbol op, op_name;
  std::uint32_t op_origin = 0xFFFFFFFFu;
  std::uint32_t left_out = 0;  ///< Number of matched elements beyond Origins::kMostMatched.
  GoalLevel level = 0;         ///< Level of `state`.
  bool o_supported = false;
  bool is_operator = false;

 private:
  friend class Origins;
  std::uint32_t serial = 0;  ///< Serial number of the instantiation, to check whether it still exists.
  /// `first`: index of the first matched element; for an operator, of the first proposal. `count`: their number.
  std::uint32_t first = 0, count = 0;
  std::uint32_t text = 0, text_size = 0;  ///< For an operator: position of the reason of its selection.
};

/// Records the origin of each o-supported element, of each element whose firing also created an element directly on the
/// output link, and of each selected operator. Off until it is first needed; it records only what is created
/// afterwards.
///
/// Origins are appended to a log. They refer to older ones only. When the log has grown to a multiple of what it kept
/// last time, Collect copies the origins that are still needed to its beginning.
///
/// Limits: an origin is kept as long as its element, and longer if a newer origin leads to it. An origin
/// leads to origins of removed elements only within kDeepest references, and to at most kMostBehind of them (IsWithin).
///
/// Recording does not change the agent's decisions. But it keeps identifiers and constants in memory, so an agent near
/// its memory limit may be stopped in another decision.
class Origins final : public Module {
 public:
  static constexpr std::uint32_t kNone = 0xFFFFFFFFu;
  static constexpr std::size_t kMostMatched = 24, kMostBehind = 48;
  static constexpr std::uint32_t kDeepest = 6;
  static constexpr std::size_t kMostPast = 8;
  static constexpr int kPlace = 100;  ///< Its place among the modules.

  /// The agent must outlive this object. Nothing is recorded before Begin.
  explicit Origins(const AgentParts& parts);

  /// Returns the encoded reason why the operator of a goal is selected (Agent::ExplainDecision). It is copied.
  using Describe = std::function<std::string_view(const Goal&)>;

  /// Starts recording. Call it between two runs. A second call has no effect on what was recorded.
  void Begin(Describe describe);
  bool on() const { return on_; }

  /// The index of an element's origin, or kNone.
  std::uint32_t Of(WmeId wme) const { return Index(wme) < of_.size() ? of_[Index(wme)] : kNone; }
  /// The index of the origin of the operator selected at a level, or kNone.
  std::uint32_t OfOperator(GoalLevel level) const { return level < selected_.size() ? selected_[level] : kNone; }
  /// Origins and their parts are valid until the agent runs again.
  const Origin& at(std::uint32_t place) const { return origins_[place]; }
  /// The elements that the rule matched, at most kMostMatched. None for an operator.
  std::span<const OriginElement> Matched(const Origin& origin) const {
    if (origin.is_operator) return {};
    return std::span(elements_).subspan(origin.first, origin.count);
  }
  /// The origins of an operator's proposals.
  std::span<const std::uint32_t> Proposals(const Origin& origin) const {
    if (!origin.is_operator) return {};
    return std::span(proposals_).subspan(origin.first, origin.count);
  }
  /// Why an operator was selected, as returned by Describe.
  std::string_view Decided(const Origin& origin) const {
    return std::string_view(texts_).substr(origin.text, origin.text_size);
  }
  /// Whether to follow the references of an origin that is the nth one, at this distance from the first one.
  bool IsWithin(std::uint32_t place, std::uint32_t distance, std::size_t n) const {
    return (distance < kDeepest && n < kMostBehind) || IsAttached(place);
  }
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
  /// The number of origins, including those that are no longer needed.
  std::size_t count() const { return origins_.size(); }
  /// Approximate size in bytes. Not part of the agent's MemoryBytes.
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

  static constexpr std::size_t kLeastRoom = 32;

  /// An element that is about to be created.
  struct Pending {
    Symbol id, attribute, value;
    std::uint32_t origin = kNone;
  };
  struct Attached {
    WmeId wme = WmeId::kNone;
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
  const Production* Hold(ProductionId id);
  void Attach(WmeId wme, std::uint32_t origin);
  bool IsAttached(std::uint32_t origin) const;
  std::uint32_t AddFiring(const Origin& made, std::span<const WmeId> matched, std::span<const std::uint32_t> origins);
  void ForgetSelected(GoalLevel level);
  void Collect();
  void FindNeeded();
  void FindBehind(std::uint32_t root);
  void KeepNeeded();
  void ForgetUnusedRules();
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
  bool on_ = false, is_module_ = false;
  Describe describe_;
  std::vector<Origin> origins_;          ///< Each refers to smaller indices only.
  std::vector<OriginElement> elements_;  ///< What rules matched, in the order of the origins.
  std::vector<std::uint32_t> proposals_;
  std::string texts_;                         ///< Reasons why operators were selected.
  std::vector<std::uint32_t> of_, selected_;  ///< of_: by element; selected_: by level.
  std::vector<Attached> attached_;            ///< Elements with origins; also some that were removed since.
  std::vector<Pending> pending_;
  std::vector<Past> past_;                  ///< Oldest first.
  std::vector<ProductionPtr> rules_;        ///< Those of the origins, so that they outlive their removal.
  std::vector<std::uint32_t> rule_places_;  ///< By rule: its index in rules_.
  std::size_t next_collection_ = kLeastRoom, next_rules_ = kLeastRoom;  ///< Numbers of origins and rules.
  std::vector<GoalLevel> installed_;  ///< Levels whose operators are not recorded yet.
  /// The last origin recorded in this elaboration for an instantiation, by its serial number.
  std::uint32_t last_serial_ = 0, last_origin_ = kNone;
  std::uint32_t asked_serial_ = 0;
  bool gives_command_ = false;  ///< For the firing with asked_serial_.
  std::vector<WmeId> traced_;
  // Temporary, while the log is collected.
  enum class Need : std::uint8_t { kNone, kKept, kRoot };
  std::vector<Need> needs_;                   ///< By origin.
  std::vector<std::uint32_t> seen_, places_;  ///< By origin: the last root; the new index.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> queue_;
};

}  // namespace soarbox::kernel
