// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/panels/terms.h"

#include <algorithm>
#include <iterator>

#include "viewer/panels/widgets.h"

namespace soarbox::viewer {
namespace {

struct Term {
  std::string_view word, meaning;
};

constexpr Term kTerms[] = {
    // Words of the panels.
    {"goal stack",
     "What the agent is busy with, from the top down. S1 is its life as a whole. Where it cannot decide or does not "
     "know "
     "how to go on (an impasse), Soar makes a state below in which that is thought about; it goes as soon as the "
     "matter "
     "is settled."},
    {"state", "A situation that the agent thinks about, with all that it knows of it. S1 is always there."},
    {"operator",
     "Something that the agent may do next, in the world or in its thoughts. Rules propose operators, preferences "
     "weigh "
     "them, and one is selected; rules that see it selected then apply it."},
    {"preferences",
     "What rules say for and against each proposed operator. Unfold one to see who says it; the decision follows from "
     "them alone."},
    {"working memory",
     "All that the agent knows now, as elements (identifier ^attribute value). A value may be an identifier with "
     "elements "
     "of its own. What it has learned for good stands in its rules."},
    {"time tag", "The number of an element: the higher, the later it came."},
    {"input link", "Where the world writes what the agent perceives, before it decides."},
    {"output link", "Where rules write commands for the body. The world answers with ^status."},
    {"chance", "How often exploration would choose this one, were it to choose again."},
    {"value", "The sum of its numeric preferences; reinforcement learning changes them."},
    {"fired", "How often the rule has matched something new and done what stands behind its arrow."},
    {"matches", "How often all its conditions hold now, each time with other elements."},
    {"coverage", "Which rules took part in the run; for those that did not, the condition at which they stop."},
    {"decision time", "Real time that the mind took in the last tick; it differs from run to run."},
    // Phases.
    {"input", "Input: what the body perceives is written to the input link."},
    {"propose", "Propose: rules look at the situation and propose operators and preferences for them."},
    {"decide", "Decide: the preferences are weighed, and an operator is selected; or there is an impasse."},
    {"apply", "Apply: rules carry out the operator that was selected."},
    {"output", "Output: commands on the output link go to the body."},
    // Impasses.
    {"operator tie",
     "Impasse: several operators are proposed, and no preference says which is better. Add a rule that prefers one, or "
     "makes them indifferent (=)."},
    {"operator conflict", "Impasse: preferences contradict each other; each of two operators is said to be better."},
    {"operator constraint-failure",
     "Impasse: several operators are required, or one is required and prohibited at once."},
    {"operator no-change",
     "Impasse: the operator is selected, but no rule changes anything because of it. It may take its time (a walk), or "
     "a "
     "rule that applies it is missing."},
    {"state no-change", "Impasse: no operator is proposed. A rule is missing, or a condition of one does not hold."},
    // Preferences.
    {"acceptable", "+ : it is proposed."},
    {"require", "! : it must be selected."},
    {"reject", "- : it is no candidate as long as this holds."},
    {"prohibit", "~ : it must not be selected."},
    {"best", "> : better than all others."},
    {"worst", "< : only if nothing else is there."},
    {"better", "> : better than the other one."},
    {"worse", "< : worse than the other one."},
    {"indifferent", "= : any will do; chance decides among such."},
    {"equal", "= : as good as the other one."},
    {"numeric", "= number : how much speaks for it; exploration weighs these."},
    // Kinds of rules, and of support.
    {"user", "A rule that somebody has written."},
    {"default", "A rule that was loaded as general knowledge."},
    {"chunk", "A rule that the agent has learned: what it found out in a substate, so that it need not think again."},
    {"justification", "A rule that stands for what was found out in a substate, for as long as that holds."},
    {"template", "A rule that makes other rules, one for each combination of values that it meets."},
    {"i-support", "It stays as long as the rule that made it matches."},
    {"o-support", "It stays until something takes it away: an operator made it."},
};

}  // namespace

std::string_view MeaningOf(std::string_view term) {
  const auto found = std::find_if(std::begin(kTerms), std::end(kTerms), [&](const Term& t) { return t.word == term; });
  return found == std::end(kTerms) ? std::string_view{} : found->meaning;
}

void TermTooltip(std::string_view term) {
  Tooltip(MeaningOf(term));
}

}  // namespace soarbox::viewer
