// SPDX-License-Identifier: BSD-2-Clause
#include "workbench/document/glossary.h"

#include <algorithm>
#include <iterator>

namespace soarbox::workbench::document {
namespace {

struct Term {
  std::string_view word, meaning;
};

constexpr Term kTerms[] = {
    // Words of the panels.
    {"goal stack",
     "The agent's states, the top state S1 first. When the agent cannot decide or does not know how to continue (an "
     "impasse), "
     "Soar makes a substate in which rules work that out. The substate goes away once the impasse is resolved."},
    {"state", "What the agent works on, with everything that it knows about it. S1 is always there."},
    {"operator",
     "Something that the agent may do next, in the world or in its mind. Rules propose operators, preferences compare "
     "them, "
     "and one is selected. Rules that test the selected operator then apply it."},
    {"preferences",
     "What rules say for and against each proposed operator. Unfold one to see which rules say it. The decision "
     "follows from "
     "preferences alone."},
    {"working memory",
     "Everything that the agent knows now, as elements (identifier ^attribute value). A value may be an identifier "
     "with "
     "elements of its own. What the agent has learned for good is in its rules."},
    {"time tag", "The number of an element. The newer the element, the higher the number."},
    {"input link", "Where the world writes what the agent perceives, before the agent decides."},
    {"output link", "Where rules write commands for the body. The world answers with ^status."},
    {"chance", "The probability with which this operator would be selected if the choice were made again."},
    {"value", "The sum of its numeric preferences. Reinforcement learning changes them."},
    {"fired", "How often the rule has found a new match and carried out its actions."},
    {"matches", "In how many ways all its conditions match now, each with different elements."},
    {"coverage", "Which rules fired in this run. For the others, the condition at which they stop."},
    {"decision time", "Real time that the mind used in the last tick. It differs from run to run."},
    // Phases.
    {"input", "Input: the percepts are written to the input link."},
    {"propose", "Propose: rules match, and propose operators and preferences for them."},
    {"decide", "Decide: the preferences are compared. Either an operator is selected, or there is an impasse."},
    {"apply", "Apply: rules apply the selected operator."},
    {"output", "Output: commands on the output link go to the body."},
    // Impasses.
    {"operator tie",
     "Impasse: several operators are proposed, and no preference says which is better. Add a rule that prefers one, or "
     "that makes them indifferent (=)."},
    {"operator conflict",
     "Impasse: preferences contradict each other. Each of two operators is better than the other."},
    {"operator constraint-failure", "Impasse: several operators are required, or one is both required and prohibited."},
    {"operator no-change",
     "Impasse: the operator is selected, but no rule changes anything because of it. Perhaps it takes time (a walk), "
     "or a rule that applies it is missing."},
    {"state no-change",
     "Impasse: no operator is proposed. A rule is missing, or one of its conditions does not match."},
    // Preferences.
    {"acceptable", "+ : it is proposed."},
    {"require", "! : it must be selected."},
    {"reject", "- : it is not a candidate while this preference lasts."},
    {"prohibit", "~ : it must not be selected."},
    {"best", "> : better than all others."},
    {"worst", "< : only if there is no other."},
    {"better", "> : better than the other one."},
    {"worse", "< : worse than the other one."},
    {"indifferent", "= : any of these will do; chance decides among them."},
    {"equal", "= : as good as the other one."},
    {"numeric", "= number : the higher the number, the likelier it is selected."},
    // Kinds of rules, and of support.
    {"user", "A rule that a person wrote."},
    {"default", "A rule that was loaded as general knowledge."},
    {"chunk", "A rule that the agent has learned: the result of a substate, so that it need not be worked out again."},
    {"justification", "A temporary rule for the result of a substate. It lasts as long as the result is supported."},
    {"template", "A rule that makes other rules, one for each combination of values that it matches."},
    {"i-support", "It stays as long as the rule that made it matches."},
    {"o-support", "It stays until a rule removes it: an operator made it."},
};

}  // namespace

std::string_view MeaningOf(std::string_view term) {
  const auto found = std::find_if(std::begin(kTerms), std::end(kTerms), [&](const Term& t) { return t.word == term; });
  return found == std::end(kTerms) ? std::string_view{} : found->meaning;
}

}  // namespace soarbox::workbench::document
