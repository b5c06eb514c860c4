// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "kernel/base/ids.h"
#include "kernel/decide/module.h"
#include "kernel/longterm/agent_parts.h"

namespace soarbox::kernel {

class LongTerm;

/// The settings of `wm activation --set`.
struct WmaSettings {
  bool activation = false;
  double decay_rate = -0.5;
  double decay_thresh = -2;
  bool petrov_approx = false;
  enum class Forgetting : std::uint8_t { kOff, kNaive, kBisection } forgetting = Forgetting::kOff;
  bool forget_linked_only = false;  ///< forget-wme lti: forget only elements of instances of long-term identifiers.
  bool fake_forgetting = false;     ///< Count the elements that would be forgotten, but keep them.
};

/// The activation of working memory elements, and forgetting of elements with low activation.
///
/// An o-supported element has a history if it was created while activation was on: how often it was used, for the last
/// ten decision cycles with uses. Its strength is the sum of uses * age^decay_rate over its history. Its activation is
/// ln of the strength. Elements without a history show activation 1.
///
/// Creation counts as 1 use for each preference for the element, plus a mean strength: that of the elements on which
/// its o-supported preferences depend. In the mean, an i-supported element is replaced by those on which it depends,
/// and an element without a history counts e.
///
/// When rules fire, each waiting match uses the elements that it tests. A preference of a rule for an existing element
/// uses this element. A use of an i-supported element counts as a use of the o-supported elements on which it depends.
/// A use of an item of an impasse counts as a use of the operator's proposal. If an i-supported element becomes
/// o-supported, its history begins at its next use. The uses of a cycle are added to the histories in its output phase.
///
/// At the end of the output phase, forgetting retracts the preferences of elements whose activation is below the
/// threshold.
class WmActivation final : public Module {
 public:
  static constexpr std::size_t kHistory = 10;

  struct History {
    std::array<std::uint64_t, kHistory> cycles{};  ///< Newest first.
    std::array<std::uint64_t, kHistory> uses{};
    std::uint64_t total = 0;    ///< Total number of uses.
    std::uint64_t first = 0;    ///< Cycle of the first use.
    std::uint64_t pending = 0;  ///< Uses in this cycle.
    std::uint8_t count = 0;     ///< Number of entries.
    bool gone = false;      ///< The element was removed, but elements that depended on it may still need its history.
    std::uint64_t due = 0;  ///< The cycle in which it may be forgotten unless it is used.
    std::uint64_t timetag = 0;  ///< The element's time tag, because WmeIds are reused.
  };

  static WmActivation& Of(LongTerm& long_term);
  static const WmActivation* Find(const LongTerm& long_term);
  explicit WmActivation(LongTerm& long_term);

  const WmaSettings& settings() const { return settings_; }
  WmaSettings& mutable_settings() { return settings_; }
  void SettingsChanged();

  /// A module created the elements of `answer` with o-support from existing ones: the elements of a command, and the
  /// three links of the architecture that lead to the command and its result.
  void NoteAnswer(InstantiationId answer, std::span<const WmeId> command);
  /// The elements of all results exist now.
  void ForgetAnswers() { answers_.clear(); }

  /// The current activation of an element: 1 without a history, -1e9 if its first use has not been added yet.
  double Of(WmeId wme) const;
  /// The activation of an element that is about to enter working memory.
  double OfNew(WmeId wme) const;
  /// Returns null if the element has no history.
  const History* HistoryOf(WmeId wme) const;
  std::uint64_t forgotten() const { return forgotten_; }
  /// The current decision cycle. After the uses of a cycle were added, the next one is current.
  std::uint64_t now() const;

  // Module
  /// Adds the uses of the elements that each waiting match tests, including matches that wait for the apply phase.
  void RulesFire() override;
  void Flushed(std::span<const WmeId> added, std::span<const WmeId> removed) override;
  void Asserted(PreferenceId preference) override;
  void Output(bool output_changed) override;
  void OutputEnd() override;
  void BeforeInit() override { ReleaseGrounds(); }
  void AfterInit() override;
  std::size_t MemoryBytes() const override;

 private:
  double ActivationAt(const History& history, std::uint64_t cycle) const;
  /// Whether an element gets a history when it is created: o-supported ones do, except operators.
  bool IsForHistory(WmeId wme) const;
  /// The sum of uses * age^decay_rate.
  double StrengthAt(const History& history, std::uint64_t cycle) const;
  void Use(WmeId wme);
  void AddUse(WmeId wme);
  void Follow(WmeId wme, std::uint64_t uses);
  void TellOfLink(WmeId wme);
  void UseWhatHolds(WmeId wme);
  template <class Held, class Other>
  void ForWhatHolds(const Held& held, const Other& other);
  /// The mean strength that an element gets from the elements on which its preferences depend. Elements with no added
  /// uses yet are left out of the mean.
  std::uint64_t MeanStrength(WmeId wme);
  /// Appends the elements on which a preference depends to open_. Returns the number of further such elements that no
  /// rule created.
  std::uint64_t OpenGrounds(WmeId wme, PreferenceId preference);
  void ReleaseGrounds();
  void ReleaseGroundsOf(WmeId wme);
  void Enter(WmeId wme, History& history);
  /// The first cycle in which the element will be below the threshold if it is not used again.
  std::uint64_t DueOf(const History& history) const;
  bool Forget(WmeId wme);

  LongTerm& long_term_;
  AgentParts uses_;
  WmaSettings settings_;
  std::unordered_map<std::uint32_t, History> histories_;  ///< By WmeId.
  std::vector<std::uint32_t> used_;                       ///< Elements with uses in this cycle.
  static constexpr std::uint64_t kNever = ~std::uint64_t{0};
  std::uint64_t entered_ = kNever;                                     ///< The last cycle whose uses were added.
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> due_;  ///< By cycle: elements that may be forgotten.
  struct Answer {
    InstantiationId instantiation;
    std::vector<WmeId> grounds;
  };
  std::vector<Answer> answers_;  ///< Results whose elements do not exist yet.
  struct Grounds {
    PreferenceId preference;
    std::vector<WmeId> elements;  ///< References are held.
  };
  /// By WmeId, for elements without a history: the elements on which their o-supported preferences depend. Their
  /// matches may end before the history starts.
  std::unordered_map<std::uint32_t, std::vector<Grounds>> grounds_;
  std::vector<WmeId> open_, held_;
  std::vector<std::uint32_t> seen_;  ///< By WmeId: the last use that visited it.
  std::uint32_t pass_ = 0;
  std::uint64_t forgotten_ = 0;
};

}  // namespace soarbox::kernel
