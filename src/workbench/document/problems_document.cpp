// SPDX-License-Identifier: BSD-2-Clause
// Problems: errors and warnings in full, the cause first.
#include <algorithm>
#include <filesystem>
#include <utility>

#include "workbench/document/build.h"
#include "workbench/document/panels.h"

namespace soarbox::workbench::document {
namespace {

Span SeverityOf(const Diagnostic& what) {
  switch (what.severity) {
    case Severity::kError:
      return {"error", Role::kBad};
    case Severity::kWarning:
      return {"warning", Role::kWarn};
    case Severity::kNote:
      break;
  }
  return Quiet("note");
}

/// "walker.soar:14:12"
std::string PlaceOf(const Diagnostic& what) {
  std::string place = std::filesystem::path(what.file).filename().string();
  for (const int number : {what.line, what.column})
    if (number > 0) place.append(1, ':').append(std::to_string(number));
  return place;
}

/// The line, with a mark below the wrong part.
std::string Marked(const Diagnostic& what) {
  if (what.column <= 0) return what.excerpt;
  return what.excerpt + "\n" + std::string(static_cast<std::size_t>(what.column - 1), ' ') +
         std::string(static_cast<std::size_t>(std::max(1, what.excerpt_length)), '^');
}

Section SectionOf(const Contents& contents, const ProblemRow& problem, std::size_t number) {
  const Diagnostic& what = problem.diagnostic;
  Section section{std::to_string(number), {SeverityOf(what), {"  "}, Time(problem.tick)}, {}};
  if (!problem.agent.empty()) section.title.insert(section.title.end(), {Span{"  "}, AgentLink(problem.agent)});
  section.nodes.push_back(Text(what.message));
  if (!what.excerpt.empty()) section.nodes.push_back(Code{Marked(what)});
  if (!what.hint.empty()) section.nodes.push_back(Text(what.hint, Role::kGood));
  if (what.more > 0)
    section.nodes.push_back(
        Text("the same in " + Count(static_cast<std::uint64_t>(what.more), "further place", "further places"),
             Role::kQuiet));
  if (!what.file.empty()) section.nodes.push_back(Text({FileLink(contents, what.file, what.line, PlaceOf(what))}));
  return section;
}

}  // namespace

Nodes ProblemsDocument(const Contents& contents) {
  if (contents.problems.empty())
    return {Empty("No problems.", "Errors and warnings of rules, scripts and commands appear here in full.")};
  Nodes all, own;
  std::size_t number = 0;
  for (const ProblemRow& problem : contents.problems) {  // The cause first.
    all.emplace_back(SectionOf(contents, problem, ++number));
    if (!contents.agent.empty() && problem.agent == contents.agent) own.push_back(all.back());
  }
  Nodes nodes{Button{"Clear", Action{ClearProblemsRequest{}}, "Empty this list"}};
  if (own.empty() || own.size() == all.size()) {
    nodes.insert(nodes.end(), all.begin(), all.end());
  } else {
    nodes.emplace_back(Tabs{"whose",
                            {{"All", "The problems of all agents", std::move(all)},
                             {contents.agent, "Only the problems of the selected agent", std::move(own)}}});
  }
  return nodes;
}

}  // namespace soarbox::workbench::document
