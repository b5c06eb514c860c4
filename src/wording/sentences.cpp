// SPDX-License-Identifier: BSD-2-Clause
#include "wording/sentences.h"

#include <array>
#include <cassert>
#include <cstddef>

namespace soarbox::wording {
namespace {

using enum Situation;

// In the order of Situation.
constexpr std::array kSentences = {
    Sentence{kProposes, "acceptable preference", "{maker} proposes {op}"},
    Sentence{kRequires, "require preference", "{maker} requires {op}"},
    Sentence{kRejects, "reject preference", "{maker} rejects {op}"},
    Sentence{kProhibits, "prohibit preference", "{maker} prohibits {op}"},
    Sentence{kMakesBest, "best preference", "{maker} makes {op} best"},
    Sentence{kMakesWorst, "worst preference", "{maker} makes {op} worst"},
    Sentence{kMakesBetter, "better or worse preference, of the upper one", "{maker} makes {op} better than {other}"},
    Sentence{kMakesWorse, "better or worse preference, of the lower one", "{maker} makes {op} worse than {other}"},
    Sentence{kMakesIndifferent, "indifferent preference", "{maker} makes {op} indifferent"},
    Sentence{kGivesValue, "numeric preference", "{maker} gives {op} the value {value}"},
    Sentence{kMakesEqual, "binary indifferent preference", "{maker} makes {op} indifferent to {other}"},

    Sentence{kWasSelected, "an operator is selected by the present preferences", "{op} was selected: {why}."},
    Sentence{kOnlyOneBy, "sole candidate", "the only operator proposed, by {maker}"},
    Sentence{kOnlyOne, "sole candidate, its proposal unknown", "the only operator proposed"},
    Sentence{kProposedBy, "which rule proposed the operator, in a recording", "proposed by {maker}"},
    Sentence{kForced, "`decide select` selected it", "the command decide select had selected it"},
    Sentence{kByChance, "choice among indifferent operators",
             "chosen by chance, with a probability of {chance} %, among {count} indifferent operators"},
    Sentence{kByChanceOfValue, "choice by numeric preferences",
             "chosen by chance, with a probability of {chance} % (its value is {value}), among {count} indifferent "
             "operators"},
    Sentence{kNewest, "choice of the first (`indifferent-selection --first`)",
             "the first of {count} indifferent operators"},
    Sentence{kOldest, "choice of the last (`indifferent-selection --last`)",
             "the last of {count} indifferent operators"},

    Sentence{kMutual, "two dominate each other",
             "{op} and {other} are each better than the other ({makers}), so both were dropped"},
    Sentence{kWouldStillLose, "an operator that would lose without its reason, in a list",
             "(without that {op} would still lose)"},
    Sentence{kLosesWithoutThat, "an operator that would lose without its reason", "without that it would still lose"},
    Sentence{kLosesWithoutThese, "an operator that would lose without all of its reasons",
             "without these it would still lose"},
    Sentence{kOneMoreDropped, "one candidate more than a sentence names", "1 more was dropped"},
    Sentence{kMoreDropped, "more candidates than a sentence names", "{count} more were dropped"},
    Sentence{kAnotherForced, "`decide select` selected another one",
             "the command decide select had selected another one"},
    Sentence{kNoLongerProposed, "a selected operator has lost its proposal", "it is no longer proposed"},

    Sentence{kSelectedUnspoken, "a selected operator without preferences",
             "{op} is selected, but it has no preferences any more."},
    Sentence{kGoesNext, "a selected operator that would not be selected again",
             "{op} is selected, but now {why}, so the next decision will drop it."},
    Sentence{kHasChanged, "preferences changed since the decision",
             "{op} is selected, and preferences have changed since then. With the present preferences: {why}."},
    Sentence{kOneOfNext, "no operator is selected yet, several could be",
             "one of {count} indifferent operators would be selected at the next decision."},
    Sentence{kNext, "no operator is selected yet, one would be", "{op} would be selected at the next decision: {why}."},
    Sentence{kIsSelected, "a selected operator, for an unknown reason", "{op} is selected."},

    Sentence{kTie, "operator tie", "no preference decides among {operators}"},
    Sentence{kTieAdvice, "operator tie: what to do",
             "if it does not matter which, add = where they are proposed: (<s> ^operator <o> + =); if one is better, a "
             "rule that says so: (<s> ^operator <better> > <other>)"},
    Sentence{kTieIn, "operator tie, in a report", "operator tie in {state}: {why}"},
    Sentence{kTieAlike, "operator tie among operators of one name", "{count} {name} operators"},
    Sentence{kTieAllSigned, "operator tie among operators with the same preference",
             ": each of them has the preference {sign}"},
    Sentence{kTieBySeveral, "operator tie because an attribute that rules make has several values",
             ": they differ in ^{attribute}, because ^{source} has several values, {values}, made by rule {rule}"},
    Sentence{kIsProposedBy, "which rule proposes an operator of a tie", "{op} is proposed by rule {rule}"},
    Sentence{kConflict, "operator conflict", "each of {operators} is worse than another one"},
    Sentence{kConflictIn, "operator conflict, in a report", "operator conflict in {state}: {why}"},
    Sentence{kConstraintFailureIn, "constraint failure, in a report", "constraint failure in {state}: {why}"},
    Sentence{kOneDropped, "the only candidate was dropped", "the only operator proposed was dropped: {why}"},
    Sentence{kAllDropped, "all candidates were dropped", "every operator proposed was dropped: {why}"},
    Sentence{kDroppedIn, "all candidates were dropped, in a report", "no operator is selected in {state}: {why}"},
    Sentence{kNoneProposed, "state no-change", "no operator is proposed in {state}"},
    Sentence{kNoneProposedNow, "no operator is proposed any more", "no operator is proposed in {state} any more"},
    Sentence{
        kStackGrows, "impasse loop",
        "no operator is proposed in {state}; the goal stack grows without progress: {first} to {last} are all state "
        "no-changes"},
    Sentence{kNoProposer, "no rule proposes anything", "no rule proposes an operator: {advice}"},
    Sentence{kWriteProposer, "no rule proposes anything, and all rules loaded", "write one with (<s> ^operator <o> +)"},

    Sentence{
        kApplied, "applied, stays selected",
        "operator {op} has been applied (rule {rule}) and stays selected: its proposal still lasts, and an operator "
        "is applied once; let the proposal test that something is left to do, and let this rule change what the "
        "proposal tests"},
    Sentence{
        kAppliedSilently, "applied without a command, stays selected",
        "operator {op} has been applied (rule {rule}), which gave no command, and stays selected: its proposal still "
        "lasts, and an operator is applied once; let the proposal test that something is left to do, and let this rule "
        "change what the proposal tests"},
    Sentence{kOthersTestClock, "an operator that stays selected, in a world with turns",
             "; rule {rule} tests ^clock, which is new at each turn, so its operator is proposed again each time"},
    Sentence{kNotFiredYet, "a rule that applies it matches and has not fired",
             "operator {op} is selected in {state}, and rule {rule}, which applies it, matches but has not fired"},
    Sentence{kAnsweredOnly, "operator no-change, the rule that answers to it changes nothing",
             "operator {op} stays selected in {state}: rule {rule} has fired for it, but neither changes what its "
             "proposal tests nor gives a command"},
    Sentence{kNoApplierMatches, "operator no-change, rules that apply it do not match",
             "operator {op} is selected in {state} and no rule that applies it matches"},
    Sentence{kNothingBelow, "operator no-change, worked on in a substate",
             "operator {op} is selected in {state}, and in the state below it no operator is proposed"},
    Sentence{kNoApplier, "operator no-change, no rule applies it",
             "operator {op} is selected in {state} and no rule applies it: {advice}"},

    Sentence{kRuleWaits, "a rule stops at a condition", "requires {condition}, but {found}"},
    Sentence{kRuleWaitsFor, "a rule stops at a condition that is only known as printed", "requires {condition}"},
    Sentence{kRuleExcluded, "a rule stops at a negated condition", "requires no {condition}, but {found}"},
    Sentence{kOfRule, "which rule stops at a condition", "rule {rule} {waits}"},
    Sentence{kNeverFired, "a rule that never fired in a run", "rule {rule} never fired: it {waits}"},
    Sentence{kNoneNow, "what a rule tests is not there", "there is none now"},
    Sentence{kNoneNowMadeBy, "another rule makes what a rule tests",
             "there is none now; rule {maker} makes it{applying}"},
    Sentence{kNoneNowMaybeBy, "another rule makes it with a value that is not known beforehand",
             "there is none now; rule {maker} may make it{applying}"},
    Sentence{kWhenItApplies, "the rule that makes it applies operators", " when it applies {operators}"},
    Sentence{kNoRuleMakes, "no rule makes the value that is asked for", "there is none now, and no rule makes it"},
    Sentence{kMakesOther, "a rule makes another value", "; rule {maker} makes ^{attribute} {value}"},
    Sentence{kNothingMakes, "misspelt attribute", "no percept and no rule makes it"},
    Sentence{kNoneNowPercept, "percept missing", "there is none now ({meaning})"},
    Sentence{kWrongPlace, "a percept of this name is elsewhere", "no percept is there: it is {places}"},
    Sentence{kOtherValue, "another value is there", "it is {values}"},
    Sentence{kOneDoesNotFit, "an object that earlier conditions exclude",
             "the one that is there does not fit the conditions before it"},
    Sentence{kNoneFits, "objects that earlier conditions exclude",
             "none of the {count} that are there fits the conditions before it"},
    Sentence{kNoLinks, "the links of a substate", "{state} is a substate, which has none: test ^superstate.io"},
    Sentence{kElsewhere, "the value is there, but of something else",
             "the one that has it does not fit the rule's other conditions"},
    Sentence{kOnlyWords, "a word that a percept never has", "; it is never {value}, only {words}"},
    Sentence{kOneExists, "a negated condition is met", "there is one"},
    Sentence{kValueExists, "a negated condition is met by one value", "^{attribute} {values} exists"},
    Sentence{kValuesExist, "a negated condition is met by several values", "^{attribute} {values} exist"},
    Sentence{kNoOperatorSelected, "a rule waits for an operator, and none is selected",
             "no operator is selected in {state}"},
    Sentence{kOtherOperator, "a rule waits for another operator", "the operator selected in {state} is {op}"},
    Sentence{kNoRuleProposes, "no rule proposes the operator that a rule waits for", "; no rule proposes {name}"},
    Sentence{kRuleProposes, "a rule proposes the operator that a rule waits for", "; rule {rule} proposes {name}"},
    Sentence{kWaitForEachOther, "circular wait", "{attributes} wait for each other: {makers}"},
    Sentence{kWaitForItself, "a rule waits for what only it makes", "^{attribute} waits for itself: {makers}"},
    Sentence{kOnlyCreates, "which rule makes what, in a circular wait",
             "only rule {rule} creates ^{attribute}, and it tests ^{tested}"},
    Sentence{kUnwritten, "a rule tests what nothing writes",
             "rule {rule} tests ^{attribute}, which no percept and no rule makes"},

    Sentence{kNotParsed, "parse failure", "rule {rule} in {place} failed to parse: {problem}"},
    Sentence{kErrorIn, "an error in a file of rules that names no rule", "error in {place}: {problem}"},
    Sentence{kMoreNotLoaded, "more errors than a sentence names", "{count} more did not load"},
    Sentence{kNoRules, "an agent without rules", "it has no rules"},

    Sentence{kSaidBy, "which rule gave a command", "given by rule {rule}"},
    Sentence{kSaidByOneOf, "several rules that have fired could have given a command",
             "given by one of the rules {rules}"},
    Sentence{kGivenThen, "which rule gave a command, noted when it fired", "given by rule {rule}{when}{matched}"},
    Sentence{kGivenApplying, "which rule gave a command when it applied an operator, noted when it fired",
             "given by rule {rule}{when}, which applied operator {op}"},
    Sentence{kMadeThen, "which rule made an element, noted when it fired", "made by rule {rule}{when}{matched}"},
    Sentence{kMadeApplying, "which rule made an element when it applied an operator, noted when it fired",
             "made by rule {rule}{when}, which applied operator {op}"},
    Sentence{kSelectedThen, "an operator was selected when a rule applied it", "operator {op} was selected{when}"},
    Sentence{kSelectedThenBecause, "an operator was selected when a rule applied it, with the reason at that time",
             "operator {op} was selected{when}: {why}"},
    Sentence{kSelectedWhenGiven, "an operator was selected when a command was given, in a recording",
             "when it was given, operator {op} was selected"},
    Sentence{kSelectedWhenGivenBecause,
             "an operator was selected when a command was given, with the reason, in a recording",
             "when it was given, operator {op} was selected: {why}"},
    Sentence{kProposedThen, "who proposed an operator that was selected then", "proposed by rule {rule}{matched}"},
    Sentence{kWhichMatched, "before the elements that a rule matched then", ", which matched"},
    Sentence{kMatchedMore, "a rule matched more than a list shows", "and {count} more"},
    Sentence{kAtTime, "when something was made", " at {time} s (decision {decision})"},
    Sentence{kAtDecision, "when something was made, without a world", " in decision {decision}"},
    Sentence{kOperatorStays, "why a command is still there", "operator {op} is still selected"},
    Sentence{kOperatorGone, "why a command is still there: it has o-support",
             "operator {op} is not selected any more; the command stays until it is finished or removed"},
    Sentence{kOriginUnknown, "an official kernel does not report origins",
             "which rule gave it, and for which operator, is not known: this kernel does not report it"},
    Sentence{kNeverGiven, "a command that a mind has not given in the run", "command {command} was never given"},
    Sentence{kOriginNotNoted, "nobody asked the kernel to note origins when the command was given",
             "which rule gave it, and for which operator, was not noted"},
    Sentence{kDead, "an agent is dead, and nothing reported how it died", "is dead"},
    Sentence{kDied, "an agent is dead", "died at {time} s: {how}"},
    Sentence{kHaltedBy, "the program halted itself", "rule {rule} calls (halt)"},
    Sentence{kHaltedByOneOf, "the program halted itself, several rules have called it",
             "one of the rules {rules} calls (halt)"},
    Sentence{kHalted, "the program has halted", "its program has halted"},

    Sentence{
        kFiresAgain, "elaboration loop",
        "operator {op} is selected in {state}, and rule {rule}, which applies it, has fired {count} times and matches "
        "again: each firing makes it match again, until max-elaborations ends the phase"},
    Sentence{kIsTied, "one of the operators of a tie", "tied with the others that are left"},
    Sentence{kIsContradicted, "one of the operators of a constraint failure",
             "its require and prohibit preferences contradict each other, or another operator is required, too"},
    Sentence{kCouldWin, "one of several indifferent operators", "could win"},
    Sentence{kNoChance, "one of several indifferent operators whose value gives it no chance",
             "left, but its value gives it no chance"},

    Sentence{kLearnedFrom, "what a rule was learned from", "from {rule} in {state} ({impasse})"},
    Sentence{kLearnedIn, "what a rule was learned from, the firing unknown", "from a firing in {state} ({impasse})"},
    Sentence{kAsRecorded, "a reason in a recording of an earlier format", "as recorded: {reason}"},
};

constexpr bool IsInOrder() {
  for (std::size_t i = 0; i < kSentences.size(); ++i)
    if (static_cast<std::size_t>(kSentences[i].situation) != i) return false;
  return kSentences.size() == static_cast<std::size_t>(kAsRecorded) + 1;
}
static_assert(IsInOrder());

}  // namespace

std::span<const Sentence> Sentences() {
  return kSentences;
}

std::string Say(Situation situation, std::initializer_list<Slot> slots) {
  std::string_view rest = kSentences[static_cast<std::size_t>(situation)].text;
  std::string said;
  for (std::size_t open = rest.find('{'); open != std::string_view::npos; open = rest.find('{')) {
    const std::size_t close = rest.find('}', open);
    const std::string_view name = rest.substr(open + 1, close - open - 1);
    said += rest.substr(0, open);
    rest.remove_prefix(close + 1);
    [[maybe_unused]] bool is_given = false;
    for (const Slot& slot : slots) {
      if (slot.name != name) continue;
      said += slot.fact;
      is_given = true;
    }
    assert(is_given);
  }
  return said += rest;
}

std::string Listed(std::span<const std::string> parts) {
  std::string text;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (i > 0) text += i + 1 == parts.size() ? " and " : ", ";
    text += parts[i];
  }
  return text;
}

std::string AnswersPage() {
  std::string page =
      "# Answers\n\n"
      "This page lists the sentences, and parts of sentences, with which Soarbox describes a mind. `soarbox why`, "
      "`soarbox\n"
      "inspect`, the panels, reports about idle agents, and recordings take their text from this table\n"
      "(`src/wording/sentences.cpp`). Values replace the words between { and }. A test compares this page with the "
      "table.\n\n"
      "| situation | sentence |\n"
      "| --- | --- |\n";
  for (const Sentence& sentence : kSentences)
    page += "| " + std::string(sentence.when) + " | `" + std::string(sentence.text) + "` |\n";
  return page +
         "\nIf a kernel does not report a fact, the answer says `not available there`. If a recording does not hold "
         "it, "
         "the\n"
         "answer says `not recorded`.\n";
}

}  // namespace soarbox::wording
