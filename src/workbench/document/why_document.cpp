// SPDX-License-Identifier: BSD-2-Clause
// Why: a question about the selected agent, and its answer as a tree of reasons.
#include "workbench/document/build.h"
#include "workbench/document/panels.h"

namespace soarbox::workbench::document {

Nodes WhyDocument(const Contents& contents) {
  if (contents.agent.empty())
    return {Empty("No agent is selected.", "Click one: this panel then explains why it does what it does.")};
  Line ask;
  ask.nodes.push_back(Button{"Why this?", Action{WhyRequest{}}, "Why does the agent do what it does now?"});
  Form form = LineForm("not", WhyRequest{WhyRequest::About::kNot, {}},
                       {Field::Kind::kLine, "what", "What to ask about", "Why not ... a rule, operator or command"},
                       "Why not?");
  form.hint = "Why is it not chosen, or why does it not happen?";
  ask.nodes.push_back(std::move(form));
  Nodes nodes{std::move(ask)};
  if (contents.why.question.empty()) {
    nodes.push_back(
        Empty(contents.not_available.empty() ? "Ask why the agent does what it does." : contents.not_available));
    return nodes;
  }
  nodes.push_back(Paragraph{Paragraph::Style::kTitle, {Span{contents.why.question, Role::kStrong}}});
  NoteRecorded(contents, nodes);
  if (contents.why.answer)
    nodes.push_back(ReasonTree(contents, *contents.why.answer, 4));
  else
    nodes.push_back(Empty(contents.not_available.empty() ? "There is no answer: what you ask about does not exist now."
                                                         : contents.not_available));
  return nodes;
}

}  // namespace soarbox::workbench::document
