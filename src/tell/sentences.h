// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>

namespace soarbox::tell {

/// What can be said of a mind. One sentence, or part of one, belongs to each: they stand in one table, from which
/// debugger, recordings and reports take their words, and docs/dev/answers.md lists them.
enum class Situation : std::uint8_t {
  // What one preference does.
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
  // Why one was not.
  kMutual,
  kWouldStillLose,
  kLosesWithoutThat,
  kLosesWithoutThese,
  kOneMoreDropped,
  kMoreDropped,
  kAnotherForced,
  kNoLongerProposed,
  // What comes next.
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
  // What an operator that is selected waits for.
  kApplied,
  kAppliedSilently,
  kNotFiredYet,
  kAnsweredOnly,
  kNoApplierMatches,
  kNothingBelow,
  kNoApplier,
  // What a rule waits for.
  kRuleWaits,
  kRuleWaitsFor,
  kRuleExcluded,
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
  // Rules that are not there.
  kNotParsed,
  kErrorIn,
  kMoreNotLoaded,
  kNoRules,
  // Commands and the end.
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
  // More of operators.
  kFiresAgain,
  kIsTied,
  kIsContradicted,
  kCouldWin,
  kNoChance,
  // Learning, and recordings of old.
  kLearnedFrom,
  kLearnedIn,
  kAsRecorded,
};

/// A row of the table. {slots} stand for facts.
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

/// The sentence with these facts. Each of its slots must be given.
std::string Say(Situation situation, std::initializer_list<Slot> slots = {});

/// "a", "a and b", "a, b and c".
std::string Listed(std::span<const std::string> parts);

/// docs/dev/answers.md.
std::string AnswersPage();

}  // namespace soarbox::tell
