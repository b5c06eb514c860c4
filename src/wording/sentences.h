// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>

namespace soarbox::wording {

/// Everything that can be reported about a mind. Each situation has one sentence, or part of one, in a table. The
/// debugger, recordings and reports use it, and docs/dev/answers.md lists it.
enum class Situation : std::uint8_t {
  // The effect of one preference.
  kProposes,
  kRequires,
  kRejects,
  kProhibits,
  kMakesBest,
  kMakesWorst,
  kMakesBetter,
  kMakesWorse,
  kMakesIndifferent,
  kGivesValue,
  kMakesEqual,
  // Why an operator was selected.
  kWasSelected,
  kOnlyOneBy,
  kOnlyOne,
  kProposedBy,
  kForced,
  kByChance,
  kByChanceOfValue,
  kNewest,
  kOldest,
  // Why an operator was not selected.
  kMutual,
  kWouldStillLose,
  kLosesWithoutThat,
  kLosesWithoutThese,
  kOneMoreDropped,
  kMoreDropped,
  kAnotherForced,
  kNoLongerProposed,
  // What happens next.
  kSelectedUnspoken,
  kGoesNext,
  kHasChanged,
  kOneOfNext,
  kNext,
  kIsSelected,
  // Why nothing was selected.
  kTie,
  kTieAdvice,
  kTieIn,
  kTieAlike,
  kTieAllSigned,
  kTieBySeveral,
  kIsProposedBy,
  kConflict,
  kConflictIn,
  kConstraintFailureIn,
  kOneDropped,
  kAllDropped,
  kDroppedIn,
  kNoneProposed,
  kNoneProposedNow,
  kStackGrows,
  kNoProposer,
  kWriteProposer,
  // What a selected operator waits for.
  kApplied,
  kAppliedSilently,
  kOthersTestClock,
  kNotFiredYet,
  kAnsweredOnly,
  kNoApplierMatches,
  kNothingBelow,
  kNoApplier,
  // What a rule requires.
  kRuleWaits,
  kRuleWaitsFor,
  kRuleExcluded,
  kOfRule,
  kNeverFired,
  kNoneNow,
  kNoneNowMadeBy,
  kNoneNowMaybeBy,
  kWhenItApplies,
  kNoRuleMakes,
  kMakesOther,
  kNothingMakes,
  kNoneNowPercept,
  kWrongPlace,
  kOtherValue,
  kOneDoesNotFit,
  kNoneFits,
  kNoLinks,
  kElsewhere,
  kOnlyWords,
  kOneExists,
  kValueExists,
  kValuesExist,
  kNoOperatorSelected,
  kOtherOperator,
  kNoRuleProposes,
  kRuleProposes,
  kWaitForEachOther,
  kWaitForItself,
  kOnlyCreates,
  kUnwritten,
  // Rules that did not load or do not exist.
  kNotParsed,
  kErrorIn,
  kMoreNotLoaded,
  kNoRules,
  // Commands, and the end of a program.
  kSaidBy,
  kSaidByOneOf,
  kGivenThen,
  kGivenApplying,
  kMadeThen,
  kMadeApplying,
  kSelectedThen,
  kSelectedThenBecause,
  kSelectedWhenGiven,
  kSelectedWhenGivenBecause,
  kProposedThen,
  kWhichMatched,
  kMatchedMore,
  kAtTime,
  kAtDecision,
  kOperatorStays,
  kOperatorGone,
  kOriginUnknown,
  kNeverGiven,
  kOriginNotNoted,
  kDead,
  kDied,
  kHaltedBy,
  kHaltedByOneOf,
  kHalted,
  // More about operators.
  kFiresAgain,
  kIsTied,
  kIsContradicted,
  kCouldWin,
  kNoChance,
  // Learning, and recordings.
  kLearnedFrom,
  kLearnedIn,
  kAsRecorded,
};

/// A row of the table. A {slot} is replaced by a fact.
struct Sentence {
  Situation situation;
  std::string_view when;
  std::string_view text;
};

std::span<const Sentence> Sentences();

struct Slot {
  std::string_view name;
  std::string_view fact;
};

/// Returns the sentence with these facts. Each of its slots must be given.
std::string Say(Situation situation, std::initializer_list<Slot> slots = {});

/// "a", "a and b", "a, b and c".
std::string Listed(std::span<const std::string> parts);

/// Generates docs/dev/answers.md.
std::string AnswersPage();

}  // namespace soarbox::wording
