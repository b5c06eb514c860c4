// SPDX-License-Identifier: BSD-2-Clause
// Futures: after going back, the old and the new future side by side, and where they differ.
#include <utility>

#include "workbench/document/build.h"
#include "workbench/document/curves.h"
#include "workbench/document/panels.h"

namespace soarbox::workbench::document {
namespace {

using record::Comparison;
using record::Difference;

bool IsSame(const std::optional<Difference>& a, const std::optional<Difference>& b) {
  return a && b && a->tick == b->tick && a->agent == b->agent && a->element == b->element;
}

void AddDifference(const Difference& difference, Nodes& nodes) {
  nodes.push_back(Text(Spans{Time(difference.tick), {" " + difference.agent + "  " + difference.element}}));
  const auto shown = [](const std::string& what) { return what.empty() ? std::string("nothing") : what; };
  nodes.push_back(Named("before", shown(difference.recorded), Role::kWarn));
  nodes.push_back(Named("now", shown(difference.now), Role::kName));
}

void AddCourse(const Contents& contents, const Comparison& found, Nodes& nodes) {
  if (found.course.size() < 2) return;
  const double step_s = contents.moment.step_s;
  Plot apart{"apart", "How far apart", {{"mean distance (m)"}, {"greatest distance (m)"}}};
  Plot health{"health", "Health of all", {{"health before"}, {"health now"}}};
  Table table{"course", {{"Time"}, {"Apart (m)", true}, {"Furthest"}, {"Alive before", true}, {"Alive now", true}}};
  constexpr std::size_t kMostRows = 60;
  const std::size_t step = (found.course.size() + kMostRows - 1) / kMostRows;
  for (std::size_t i = 0; i < found.course.size(); ++i) {
    const Comparison::Moment& at = found.course[i];
    const double tick = at.time_s / step_s;
    apart.curves[0].points.emplace_back(tick, at.mean_distance_m);
    apart.curves[1].points.emplace_back(tick, at.greatest_distance_m);
    health.curves[0].points.emplace_back(tick, at.health_a);
    health.curves[1].points.emplace_back(tick, at.health_b);
    if (i % step != 0) continue;
    table.Add(std::to_string(i),
              {TimeCell(static_cast<std::uint64_t>(tick + 0.5)),
               NumberCell(at.mean_distance_m, Rounded(at.mean_distance_m)), TextCell(at.farthest),
               CountCell(static_cast<std::uint64_t>(at.alive_a)), CountCell(static_cast<std::uint64_t>(at.alive_b))});
  }
  for (Plot* const plot : {&apart, &health})
    for (Curve& curve : plot->curves) curve.points = Thinned(std::move(curve.points));
  nodes.push_back(std::move(apart));
  nodes.push_back(std::move(health));
  nodes.push_back(Section{"course", {{"In numbers"}}, {std::move(table)}, false});
}

}  // namespace

Nodes FuturesDocument(const Contents& contents) {
  if (contents.moment.is_recording)
    return {Empty("A recording has one future.",
                  "soarbox resume FILE --at SECONDS continues from a moment of it, soarbox compare shows where two "
                  "recordings differ first.")};
  if (!contents.futures)
    return {Empty("There is only one future so far.",
                  "Go back to an earlier moment, change a rule if you like, and go on from there. What happened before "
                  "stays as ghosts in the scene, and this panel shows where the two differ first.")};
  const FuturesContents& futures = *contents.futures;
  const Comparison& found = futures.comparison;
  Nodes nodes;
  // First the result: which agent decided differently, and why.
  if (found.decision) {
    nodes.push_back(Heading("First other decision or command"));
    AddDifference(*found.decision, nodes);
    for (const std::string& percept : found.percepts) nodes.push_back(Text("perceived " + percept, Role::kObject));
  } else {
    nodes.push_back(Text(found.difference ? "So far everybody decides as before." : "So far both futures are the same.",
                         Role::kGood));
  }
  nodes.push_back(
      Text(Spans{Quiet("The run went back to "), Time(futures.branch_tick),
                 Quiet(std::string(" and went on from there. ") +
                       (futures.old_is_known ? "Ghosts show where everybody was at this time before."
                                             : "Before, the run did not come this far: there are no ghosts."))}));
  // The first difference is usually the edit that created this future.
  if (found.difference && !IsSame(found.difference, found.decision)) {
    const Difference& first = *found.difference;
    Section section{"first",
                    {{"What differed first: " + first.agent + (first.agent.empty() ? "" : " ") + first.element}},
                    {},
                    false};
    AddDifference(first, section.nodes);
    nodes.push_back(std::move(section));
  }
  AddCourse(contents, found, nodes);
  return nodes;
}

}  // namespace soarbox::workbench::document
