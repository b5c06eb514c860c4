// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "debugger/agents.h"
#include "debugger/fields.h"
#include "debugger/io_rows.h"
#include "debugger/learning.h"
#include "debugger/memory.h"
#include "debugger/messages.h"
#include "debugger/operators.h"
#include "debugger/plots.h"
#include "debugger/recall.h"
#include "debugger/rules.h"
#include "debugger/run_trace.h"
#include "debugger/shown.h"
#include "debugger/stack_rows.h"

namespace soarbox::debugger {

/// The fields of the views of `soarbox inspect` in JSON (json_fields.h). No reference lists them, so they have no
/// descriptions.

void Fields(auto& visit, const explain::ElementFact& element) {
  visit("timetag", element.timetag);
  visit("id", element.id);
  visit("attribute", element.attribute);
  visit("value", element.value);
  visit.Known("acceptable", element.acceptable);
  visit.Known("object", element.is_object);
}
inline constexpr std::string_view kMakerKinds[] = {"rule", "input", "architecture"};
void Fields(auto& visit, const explain::MakerFact& maker) {
  const bool is_rule = maker.kind == explain::MakerFact::Kind::kRule;
  visit("kind", maker.kind, kMakerKinds, "");
  visit.If(is_rule, "rule", maker.rule);
  visit.If(is_rule, "support", maker.o_supported ? "o" : "i");
  visit.If(is_rule, "level", maker.level);
  visit.If(is_rule, "elements", maker.elements);
}
void Fields(auto& visit, const explain::TesterFact& tester) {
  visit("rule", tester.rule);
  visit("condition", tester.condition + 1);
  visit("negated", tester.negated);
  visit("matches", tester.matches);
}

void Fields(auto& visit, const AgentRow& row) {
  visit("name", row.name);
  visit("kind", row.kind);
  visit("team", row.team);
  visit("script", row.script);
  visit("mind", row.has_mind);
  visit("alive", row.alive);
  visit("failed", row.failed);
  visit("health", row.health);
  visit("state", StateText(row));
  visit("operator", ToText(row.op));
  visit("last_operator", ToText(row.last_op));
  visit("command", row.command);
  visit("decisions", row.decisions);
  visit("errors", row.errors);
  visit.If(row.errors != 0, "error", row.error);
  visit.If(row.errors != 0, "file", row.error_file);
  visit.If(row.errors != 0, "line", row.error_line);
}

void Fields(auto& visit, const StackLevel& level) {
  visit("level", level.level);
  visit("state", level.state);
  visit("impasse", level.impasse);
  visit("operator", level.operator_id);
  visit("name", level.operator_name);
}
void Fields(auto& visit, const StackView& view) {
  visit.Known("note", view.note);
  visit("decisions", view.decisions);
  visit("phase", view.phase);
  visit("halted", view.halted);
  visit.Known("breakdown", view.breakdown);
  visit("elaborations", view.elaborations);
  visit("firings", view.firings);
  visit("elements", view.elements);
  visit("rules", view.rules);
  visit("states", view.levels);
}

inline constexpr std::string_view kChanges[] = {"", "added", "removed"};
void Fields(auto& visit, const MemoryRow& row) {
  Fields(visit, row.element);
  visit.Known("about", row.about);
  visit.Known("change", kChanges[static_cast<std::size_t>(row.change)]);
  visit.Known("elements", row.below);
}
void Fields(auto& visit, const MemoryObject& object) {
  visit("id", object.id);
  visit("about", object.about);
  visit("exists", object.exists);
  visit.Known("note", object.note);
  visit("elements", object.rows);
}
void Fields(auto& visit, const ElementStory& story) {
  Fields(visit, story.element);
  visit.Known("note", story.note);
  visit("made_by", story.makers);
  visit("tested_by", story.testers);
}

void Fields(auto& visit, const CommandRow& command) {
  visit("command", command.name);
  visit.Known("id", command.id);
  visit("timetag", command.timetag);
  visit("parameters", ParameterText(command));
  visit("status", command.status);
  visit.Known("reason", command.reason);
  visit.If(command.progress >= 0, "progress", command.progress);
}
void Fields(auto& visit, const IoView& view) {
  visit("input", view.input);
  visit("output", view.output);
  visit("commands", view.commands);
}

void Fields(auto& visit, const DroppedBy& dropped) {
  visit("stage", dropped.stage);
  visit("rules", dropped.rules);
  visit.Known("decisive", dropped.is_decisive);
}
void Fields(auto& visit, const explain::PreferenceFact& preference) {
  visit("type", preference.type);
  visit("sign", preference.sign);
  visit.Known("referent", preference.referent);
  visit("maker", preference.maker);
}
void Fields(auto& visit, const OperatorRow& row) {
  visit("id", row.id);
  visit("name", row.name);
  visit.Known("about", row.about);
  visit("selected", row.selected);
  visit("verdict", row.verdict);
  visit.Known("dropped", row.dropped);
  visit.Known("value", row.value);
  visit.Known("probability", row.probability);
  visit("preferences", row.preferences);
}
void Fields(auto& visit, const OperatorsView& view) {
  visit("state", view.state);
  visit("selected", view.selected);
  visit("impasse", view.impasse);
  visit("why", view.sentence);
  visit.Known("note", view.note);
  visit("operators", view.rows);
}

void Fields(auto& visit, const explain::RuleFact& rule) {
  visit("name", rule.name);
  visit("type", rule.type);
  visit.Known("file", rule.file);
  visit.Known("line", rule.line);
  visit.Known("documentation", rule.documentation);
  visit("firings", rule.firings);
  visit("matches", rule.matches);
  visit.Known("break", rule.breaks);
}
void Fields(auto& visit, const explain::ConditionFact& condition) {
  visit("text", condition.text);
  visit("negated", condition.negated);
  visit("partial_matches", condition.partial_matches);
}
inline Json TokensToJson(const std::vector<Token>& tokens, const std::string& source) {
  Json list = Json::array();
  for (const Token& token : tokens)
    list.push_back(Json{{"kind", NameOf(token.kind)}, {"text", source.substr(token.begin, token.length)}});
  return list;
}
void Fields(auto& visit, const RuleView& view) {
  const explain::MatchFacts& match = view.match.facts;
  Fields(visit, view.rule);
  visit("source", view.source);
  visit("tokens", TokensToJson(view.tokens, view.source));
  visit("match", view.match.sentence);
  visit("complete", match.complete);
  visit.If(match.failing.has_value(), "failing", match.failing.value_or(0) + 1);
  visit("conditions", match.conditions);
  visit("matches_now", match.matches);
  visit("seen", match.seen);
}
void Fields(auto& visit, const Coverage::Row& row) {
  visit("rule", row.rule);
  visit("firings", row.firings);
  visit("matched", row.matched);
  visit.Known("first_tick", row.first);
  visit.Known("last_tick", row.last);
  visit.If(!row.matched, "held", row.furthest);
  visit.If(!row.matched, "conditions", row.conditions);
  visit.If(!row.matched, "stops_at", row.stops_at);
}

void Fields(auto& visit, const explain::NumberFact& number) {
  visit("rule", number.rule);
  visit("when", number.when);
  visit("value", number.value);
  visit("current", number.current);
  visit("future", number.future);
  visit("updates", number.updates);
}
void Fields(auto& visit, const LearnedRuleRow& rule) {
  visit("rule", rule.name);
  visit("firings", rule.firings);
  visit.Known("tick", rule.tick);
  visit.Known("source", rule.source);
  visit.Known("purpose", rule.purpose);
  visit.Known("excised", rule.is_gone);
}
void Fields(auto& visit, const LearningView& view) {
  visit("by_reward", view.by_reward);
  visit("last_reward", view.last_reward);
  visit("total_reward", view.total_reward);
  visit("numbers", view.numbers);
  visit("rules", view.rules);
  visit.Known("note", view.note);
}
void Fields(auto& visit, const LearnedRuleView& view) {
  visit("rule", view.name);
  visit("why", view.why);
  visit("fired", view.fired);
  visit.Known("note", view.fired_note);
}
void Fields(auto& visit, const RewardEpisode& episode) {
  visit("first_tick", episode.first_tick);
  visit("last_tick", episode.last_tick);
  visit("reward", episode.reward);
}

void Fields(auto& visit, const explain::KnownObjectFact& object) {
  visit("number", object.number);
  visit("activation", object.activation);
  visit("uses", object.uses);
  visit("text", object.text);
}
void Fields(auto& visit, const LongTermView& view) {
  visit("semantic", view.facts.semantic);
  visit("episodic", view.facts.episodic);
  visit("objects", view.facts.objects);
  visit("augmentations", view.facts.augmentations);
  visit("episodes", view.facts.episodes);
  visit("known", view.facts.known);
  visit.Known("note", view.note);
}
void Fields(auto& visit, const RememberedThing& thing) {
  visit("name", thing.name);
  visit("kind", thing.kind);
  visit("x", thing.x);
  visit("z", thing.z);
}
void Fields(auto& visit, const EpisodeView& view) {
  visit("episode", view.number);
  visit.Known("time", view.time_s);
  visit("elements", view.lines);
  visit("things", view.things);
}
inline constexpr std::string_view kMemories[] = {"semantic", "episodic"};
void Fields(auto& visit, const Recall& recall) {
  visit("tick", recall.tick);
  visit("level", recall.level);
  visit("memory", recall.is_episode, kMemories, "");
  visit("number", recall.number);
  visit("question", recall.question);
  visit("answer", recall.answer);
  visit("reason", recall.reason);
}

void Fields(auto& visit, const MessageRow& row) {
  visit("tick", row.tick);
  visit("time_s", row.time_s);
  visit("from", row.from);
  visit("to", row.to);
  visit("about", row.about);
  visit("text", row.text);
}
void Fields(auto& visit, const TraceLine& line) {
  visit("tick", line.tick);
  visit("time_s", line.time_s);
  visit("kind", NameOf(line.kind));
  visit.Known("level", line.level);
  visit("agent", line.agent);
  visit("text", line.text);
}
inline Json ToJson(const PlotPoint& point) {
  return Json::array({point.tick, point.value});
}
void Fields(auto& visit, const PlotSeries& series) {
  visit("agent", series.agent);
  visit("what", series.what);
  visit("minimum", series.minimum);
  visit("maximum", series.maximum);
  visit("points", series.points);
}

}  // namespace soarbox::debugger
