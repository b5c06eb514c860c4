// SPDX-License-Identifier: BSD-2-Clause
#include "debugger/timeline.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <variant>

#include "debugger/fields.h"
#include "wording/mind_words.h"

namespace soarbox::debugger {
namespace {

MarkKind KindOf(const sim::RunEvent& event) {
  using Kind = sim::EventKind;
  switch (event.kind) {
    case Kind::kCommand:
      return MarkKind::kCommand;
    case Kind::kOutcome:
      return MarkKind::kOutcome;
    case Kind::kNews:
      return std::holds_alternative<sim::Speech>(event.values) ? MarkKind::kMessage : MarkKind::kEvent;
    case Kind::kDiagnostic:
      return event.diagnostic.severity == Severity::kError ? MarkKind::kError : MarkKind::kEvent;
    case Kind::kAgentFailed:
    case Kind::kMindFailed:
      return MarkKind::kError;
    case Kind::kAnswer:
      return MarkKind::kEdit;
    default:
      return MarkKind::kEvent;
  }
}

std::string MarkText(const sim::RunEvent& event) {
  std::string text = event.news;
  for (const std::string* more : {&event.text, &event.parameters, &event.diagnostic.message})
    if (!more->empty()) text += (text.empty() ? "" : " ") + *more;
  return text;
}

/// Spans that overlap these ticks, including open ones, in the order in which they began.
std::vector<TimelineSpan> SpansWithin(const TimelineTrack& track, std::uint64_t first, std::uint64_t last) {
  std::vector<TimelineSpan> spans;
  ForSpansWithin(track, first, last, [&](const TimelineSpan& span) { spans.push_back(span); });
  std::ranges::stable_sort(spans, {}, [](const TimelineSpan& span) { return std::pair(span.first_tick, span.line); });
  return spans;
}

template <typename List>
void Bound(List& list, std::size_t most) {
  while (list.size() > most) list.pop_front();
}

}  // namespace

std::string_view NameOf(MarkKind kind) {
  constexpr std::string_view kNames[] = {"command", "outcome", "message", "event", "error", "edit", "learned"};
  return kNames[static_cast<std::size_t>(kind)];
}

void Timeline::Clear() {
  order_.clear();
  tracks_.clear();
  first_tick_ = last_tick_ = 0;
}

TimelineTrack& Timeline::Track(const std::string& agent) {
  const auto [at, is_new] = tracks_.try_emplace(agent);
  if (is_new) {
    at->second.agent = agent;
    order_.push_back(agent);
  }
  return at->second;
}

void Timeline::CutFrom(std::uint64_t tick) {
  for (auto& [agent, track] : tracks_) {
    std::erase_if(track.open, [tick](const TimelineSpan& span) { return span.first_tick >= tick; });
    for (const TimelineSpan& span : track.spans)
      if (span.first_tick < tick && span.last_tick >= tick) Open(track, span);
    std::erase_if(track.spans, [tick](const TimelineSpan& span) { return span.last_tick >= tick; });
    std::erase_if(track.marks, [tick](const TimelineMark& mark) { return mark.tick >= tick; });
    std::erase_if(track.firings, [tick](const auto& firing) { return firing.first >= tick; });
  }
}

void Timeline::Close(TimelineTrack& track, int level, std::uint64_t tick, bool state_too) {
  const auto goes = [&](const TimelineSpan& span) {
    return span.level > level || (span.level == level && (state_too || !span.is_state));
  };
  for (TimelineSpan& span : track.open) {
    if (!goes(span)) continue;
    track.spans.push_back(span);
    track.spans.back().open = false;
    track.spans.back().last_tick = tick;
  }
  std::erase_if(track.open, goes);
}

void Timeline::Open(TimelineTrack& track, TimelineSpan span) {
  span.open = true;
  track.open.push_back(std::move(span));
  std::ranges::stable_sort(track.open, {}, &TimelineSpan::line);
}

void Timeline::Read(TimelineTrack& track, const mind::Event& event, std::uint64_t tick) {
  TimelineSpan span;
  span.level = wording::LevelOf(event);
  span.first_tick = span.last_tick = tick;
  if (const auto* gone = std::get_if<mind::StateGone>(&event)) return Close(track, gone->level, tick, true);
  if (const auto* made = std::get_if<mind::StateMade>(&event)) {
    span.is_state = true;
    span.id = made->id;
    if (made->level > 1) span.text = wording::ImpasseText(made->reason, made->on_operator);
    // A state in which nothing changes is reported repeatedly. The report means that no operator is selected in it now.
    const auto is_same = [&](const TimelineSpan& open) {
      return open.is_state && open.level == span.level && open.id == span.id && open.text == span.text;
    };
    if (std::ranges::any_of(track.open, is_same)) return Close(track, span.level, tick, false);
    Close(track, span.level, tick, true);
  } else if (const auto* selected = std::get_if<mind::OperatorSelected>(&event)) {
    span.id = selected->id;
    span.text = selected->name;
    Close(track, span.level, tick, false);
  } else if (const auto* learned = std::get_if<mind::RuleLearned>(&event)) {
    track.marks.push_back({tick, MarkKind::kLearned, "learned " + std::string(learned->rule)});
    return;
  } else {
    // The mind's events contain each command. Add ignores the corresponding events of the world.
    if (const auto* said = std::get_if<mind::CommandSaid>(&event))
      track.marks.push_back({tick, MarkKind::kCommand, wording::CommandText(*said)});
    if (const auto* ended = std::get_if<mind::CommandEnded>(&event))
      track.marks.push_back({tick, MarkKind::kOutcome, wording::CommandText(*ended)});
    if (std::string line = wording::DecisionLine(event); !line.empty() && !wording::IsOfReward(event))
      track.marks.push_back({tick, MarkKind::kEvent, std::move(line)});
    return;
  }
  span.line = 2 * (span.level - 1) + (span.is_state ? 0 : 1);
  Open(track, std::move(span));
}

void Timeline::Add(const record::TickRecord& tick) {
  if (tracks_.empty() && last_tick_ == 0) first_tick_ = tick.tick;
  if (!tracks_.empty() && tick.tick <= last_tick_) CutFrom(tick.tick);
  first_tick_ = std::min(first_tick_, tick.tick);
  last_tick_ = tick.tick;
  if (tick.tick > 0 && tick.scene.time_s > 0) step_s_ = tick.scene.time_s / static_cast<double>(tick.tick);
  for (const world::AgentSnapshot& agent : tick.scene.agents) Track(agent.name);
  for (const record::MindRecord& mind : tick.minds) {
    TimelineTrack& track = Track(mind.agent);
    std::uint32_t fired = 0;
    mind::Event event;
    for (std::size_t at = 0; mind.events.Next(at, event);) {
      Read(track, event, tick.tick);
      const auto* firing = std::get_if<mind::RuleFired>(&event);
      fired += firing != nullptr && !firing->retracts ? 1 : 0;
    }
    if (fired > 0) track.firings.emplace_back(tick.tick, fired);
  }
  const auto has_mind = [&](const std::string& agent) {
    return std::ranges::any_of(tick.minds, [&](const record::MindRecord& mind) { return mind.agent == agent; });
  };
  for (const sim::RunEvent& event : tick.events) {
    const MarkKind kind = KindOf(event);
    if ((kind == MarkKind::kCommand || kind == MarkKind::kOutcome) && has_mind(event.agent)) continue;
    Track(event.agent).marks.push_back({tick.tick, kind, MarkText(event)});
  }
  const std::size_t most =
      std::clamp<std::size_t>(kMostOfAll / std::max<std::size_t>(1, tracks_.size()), 1, kMostPerTrack);
  for (auto& [agent, track] : tracks_) {
    for (TimelineSpan& span : track.open) span.last_tick = tick.tick;
    Bound(track.spans, most);
    Bound(track.marks, most);
    Bound(track.firings, most);
  }
}

const TimelineTrack* Timeline::Find(std::string_view agent) const {
  const auto at = tracks_.find(agent);
  return at == tracks_.end() ? nullptr : &at->second;
}

std::vector<const TimelineTrack*> Timeline::tracks() const {
  std::vector<const TimelineTrack*> list;
  for (const std::string& agent : order_) list.push_back(&tracks_.at(agent));
  return list;
}

void ForSpansWithin(const TimelineTrack& track, std::uint64_t first, std::uint64_t last,
                    const std::function<void(const TimelineSpan&)>& see) {
  for (auto span = std::ranges::lower_bound(track.spans, first, {}, &TimelineSpan::last_tick);
       span != track.spans.end(); ++span) {
    if (span->first_tick <= last) {
      see(*span);
    } else if (span->level == 1 && !span->is_state) {
      break;  // All spans below the previous operator had ended when this one began.
    }
  }
  for (const TimelineSpan& span : track.open)
    if (span.last_tick >= first && span.first_tick <= last) see(span);
}

std::vector<TimelineSpan> Timeline::At(std::string_view agent, std::uint64_t tick) const {
  std::vector<TimelineSpan> found;
  const TimelineTrack* track = Find(agent);
  if (track == nullptr) return found;
  // A span that ends in a tick is not present at the end of that tick.
  ForSpansWithin(*track, tick, tick, [&](const TimelineSpan& span) {
    if (span.open || tick < span.last_tick) found.push_back(span);
  });
  std::ranges::stable_sort(found, {}, &TimelineSpan::line);
  return found;
}

std::string ToText(const std::vector<TrackRow>& rows) {
  std::string text;
  for (const TrackRow& row : rows) {
    text += (row.agent.empty() ? "world" : row.agent) + "\n";
    for (const TimelineSpan& span : row.spans) {
      text += fmt::format("  {:>6} - {:<6} {}{} {}\n", span.first_tick, span.open ? "" : std::to_string(span.last_tick),
                          std::string(3 * static_cast<std::size_t>(span.level - 1), ' '),
                          span.is_state ? "==>S: " + span.id : "   O: " + span.id,
                          span.text.empty() ? "" : "(" + span.text + ")");
    }
    for (const TimelineMark& mark : row.marks)
      text += fmt::format("  {:>6}          {}: {}\n", mark.tick, NameOf(mark.kind), mark.text);
  }
  return text;
}

std::vector<TrackRow> TracksWithin(const Timeline& timeline, std::string_view agent, std::uint64_t first,
                                   std::uint64_t last) {
  std::vector<TrackRow> rows;
  for (const TimelineTrack* track : timeline.tracks()) {
    if (!agent.empty() && track->agent != agent) continue;
    TrackRow& row = rows.emplace_back(TrackRow{track->agent, SpansWithin(*track, first, last), {}});
    std::ranges::copy_if(track->marks, std::back_inserter(row.marks),
                         [&](const TimelineMark& mark) { return mark.tick >= first && mark.tick <= last; });
  }
  return rows;
}

}  // namespace soarbox::debugger
