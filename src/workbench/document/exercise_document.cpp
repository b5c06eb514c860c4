// SPDX-License-Identifier: BSD-2-Clause
// Exercise: the exercise of other simulations that the run takes part in (DIS).
#include <cmath>
#include <cstdio>
#include <utility>

#include "workbench/document/build.h"
#include "workbench/document/panels.h"

namespace soarbox::workbench::document {
namespace {

/// Time after which a silent entity is marked as uncertain, in s.
constexpr int kSilent_s = 6;

std::string Pdus(std::uint64_t count, double per_s) {
  char text[64];
  std::snprintf(text, sizeof text, "%llu PDUs, %.1f per second", static_cast<unsigned long long>(count), per_s);
  return text;
}

void AddFacts(const ExerciseContents& exercise, Nodes& nodes) {
  std::string dropped;
  for (const auto& [why, count] : exercise.dropped)
    dropped += (dropped.empty() ? "" : ", ") + std::to_string(count) + " " + why;
  nodes.push_back(Text(Spans{
      Quiet("Address: "),
      {exercise.address},
      exercise.is_of_this_machine ? Span{" (this machine only)"} : Span{" (other machines hear it)", Role::kWarn}}));
  nodes.push_back(Named("We are", exercise.as + (exercise.listens_only ? ", and only listen" : "") +
                                      (exercise.takes_orders ? ", and take orders" : "")));
  nodes.push_back(Named("Sent", Pdus(exercise.sent, exercise.sent_per_s)));
  if (exercise.not_sent > 0) nodes.push_back(Named("Not sent", std::to_string(exercise.not_sent), Role::kWarn));
  nodes.push_back(Named("Received", Pdus(exercise.received, exercise.received_per_s)));
  nodes.push_back(
      Named("Dropped", dropped.empty() ? "nothing" : dropped, dropped.empty() ? Role::kPlain : Role::kWarn));
}

void AddRow(const Contents& contents, const ExerciseContents::Entity& one, Table& table) {
  const bool has_body = !one.agent.empty();
  const std::string& name = has_body ? one.agent : !one.marking.empty() ? one.marking : one.id;
  TableRow& row =
      table.Add(one.id, {TextCell(name, has_body ? Role::kPlain : Role::kQuiet), TextCell(one.id, Role::kQuiet),
                         NumberCell(one.silent_s, one.silent_s == 0 ? "now" : std::to_string(one.silent_s) + " s ago",
                                    one.silent_s >= kSilent_s ? Role::kWarn : Role::kQuiet)});
  if (has_body) row.arguments = {one.agent};
  row.is_chosen = has_body && one.agent == contents.agent;
  row.sign = BodySign{one.team, one.body, true};
  row.hint =
      one.team + ", " + one.body + ", type " + one.type + (has_body ? "" : "; it has no body here: it is too far away");
}

}  // namespace

Nodes ExerciseDocument(const Contents& contents) {
  if (!contents.exercise && contents.moment.is_recording)
    return {Empty("A recording takes part in no exercise.",
                  "It contains what other simulations sent, which moves their bodies.")};
  if (!contents.exercise)
    return {Empty("This run takes part in no exercise of other simulations.",
                  "Begin it with --dis ADDRESS:PORT, or write [dis] into its scenario (docs/dis.md).")};
  const ExerciseContents& exercise = *contents.exercise;
  Nodes nodes{Heading("Exercise " + std::to_string(exercise.exercise))};
  if (exercise.is_frozen) nodes.push_back(Text("Frozen: the exercise's manager has paused the run.", Role::kWarn));
  AddFacts(exercise, nodes);
  const std::size_t listed = exercise.entities.size();
  nodes.push_back(Heading(Count(exercise.entity_count, "entity", "entities") + " of others"));
  if (listed < exercise.entity_count)
    nodes.push_back(Text("The first " + std::to_string(listed) + " of them:", Role::kQuiet));
  if (listed == 0) return nodes;
  Table table{"entities", {{"Name"}, {"Id"}, {"Heard", true}}};
  table.press = RowAction{{SelectRequest{}}, "agent", 1};
  for (const ExerciseContents::Entity& one : exercise.entities) AddRow(contents, one, table);
  nodes.push_back(std::move(table));
  return nodes;
}

}  // namespace soarbox::workbench::document
