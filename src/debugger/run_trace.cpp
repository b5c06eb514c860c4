// SPDX-License-Identifier: BSD-2-Clause
#include "debugger/run_trace.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <variant>

#include "debugger/facts_text.h"
#include "sim/input_text.h"
#include "wording/mind_words.h"

namespace soarbox::debugger {
namespace {

TraceKind TraceKindOf(const sim::RunEvent& event) {
  using Kind = sim::EventKind;
  switch (event.kind) {
    case Kind::kDiagnostic:
      return event.diagnostic.severity == Severity::kError ? TraceKind::kError : TraceKind::kEvent;
    case Kind::kAgentFailed:
    case Kind::kMindFailed:
    case Kind::kMindLost:
      return TraceKind::kError;
    case Kind::kCommand:
    case Kind::kOutcome:
      return TraceKind::kCommand;
    default:
      return TraceKind::kEvent;
  }
}

std::string LineOf(const sim::RunEvent& event) {
  const bool is_warning = event.kind == sim::EventKind::kDiagnostic && event.diagnostic.severity == Severity::kWarning;
  std::string text = (is_warning ? "warning" : std::string(sim::EventName(event.kind))) + ":";
  for (const std::string* more : {&event.news, &event.text, &event.parameters})
    if (!more->empty()) text += " " + *more;
  // The text of an outcome contains its reason.
  if (event.kind != sim::EventKind::kOutcome)
    for (const std::string& remark : sim::Remarks(event)) text += "; " + remark;
  if (event.diagnostic.message.empty()) return text;
  text += " ";
  if (!event.diagnostic.file.empty())
    text += event.diagnostic.file + ":" + std::to_string(event.diagnostic.line) + ": ";
  return text + event.diagnostic.message;
}

/// Adds the lines of one tick.
struct Writer {
  std::deque<TraceLine>& lines;
  std::uint64_t tick;
  double time_s;

  void Write(TraceKind kind, const std::string& agent, std::string text, int level = 0) {
    // A state in which nothing changes is reported in each decision. Such a line is added once per tick.
    if (kind == TraceKind::kDecision && !lines.empty() && lines.back().tick == tick && lines.back().agent == agent &&
        lines.back().kind == kind && lines.back().text == text)
      return;
    lines.push_back({tick, time_s, kind, level, agent, std::move(text)});
  }

  /// Adds percepts, decisions with their details in order, and commands.
  void WriteMind(const record::MindRecord& mind) {
    mind::Event event;
    for (std::size_t at = 0; mind.events.Next(at, event);) {
      if (const auto* percept = std::get_if<mind::PerceptChanged>(&event)) {
        Write(TraceKind::kPercept, mind.agent,
              wording::PerceptPath(percept->path, percept->attribute, percept->key) + " " +
                  wording::ValueText(percept->value));
      } else if (const auto* gone = std::get_if<mind::PerceptGone>(&event)) {
        Write(TraceKind::kPercept, mind.agent, "-" + wording::PerceptPath(gone->path, gone->attribute, gone->key));
      } else if (const auto* said = std::get_if<mind::CommandSaid>(&event)) {
        Write(TraceKind::kCommand, mind.agent, wording::CommandText(*said));
      } else if (mind::IsDetail(event)) {
        const bool is_element = std::holds_alternative<mind::ElementChanged>(event);
        Write(is_element ? TraceKind::kElement : TraceKind::kRule, mind.agent, wording::DetailLine(event));
      } else if (std::string line = wording::DecisionLine(event); !line.empty()) {
        // Changes of learned values are not decisions.
        const TraceKind kind = wording::IsOfReward(event) ? TraceKind::kRule : TraceKind::kDecision;
        Write(kind, mind.agent, std::move(line), wording::LevelOf(event));
      }
    }
  }

  /// Adds the results of commands, which come from events of the world.
  void WriteOutcomes(const record::MindRecord& mind) {
    mind.events.ForEachOf<mind::CommandEnded>(
        [&](const mind::CommandEnded& ended) { Write(TraceKind::kCommand, mind.agent, wording::CommandText(ended)); });
  }
};

}  // namespace

std::string_view NameOf(TraceKind kind) {
  constexpr std::string_view kNames[] = {"error", "decision", "command", "event",
                                         "input", "percept",  "rule",    "element"};
  return kNames[static_cast<std::size_t>(kind)];
}

void Trace::Add(const record::TickRecord& tick) {
  while (!lines_.empty() && lines_.back().tick >= tick.tick) {
    lines_.pop_back();
    revision_ = NewRevision();
  }
  Writer writer{lines_, tick.tick, tick.scene.time_s};
  for (const std::string& input : tick.inputs) writer.Write(TraceKind::kInput, "", sim::ShownInput(input));
  for (const record::MindRecord& mind : tick.minds) writer.WriteMind(mind);
  for (const sim::RunEvent& event : tick.events) {
    // Commands were already added with their minds.
    if (TraceKindOf(event) == TraceKind::kCommand && !tick.minds.empty()) continue;
    writer.Write(TraceKindOf(event), event.agent, LineOf(event));
  }
  for (const record::MindRecord& mind : tick.minds) writer.WriteOutcomes(mind);
  while (lines_.size() > most_) {
    lines_.pop_front();
    ++forgotten_;
  }
}

namespace {

/// A word of a filter that selects a kind of line: "rule:", "op:", "command:", or an attribute.
struct Asked {
  TraceKind kind;
  std::string_view part;
};
std::optional<Asked> ReadAsked(std::string_view word) {
  constexpr std::pair<std::string_view, TraceKind> kHeads[] = {
      {"rule:", TraceKind::kRule}, {"op:", TraceKind::kDecision}, {"command:", TraceKind::kCommand}};
  for (const auto& [head, kind] : kHeads)
    if (word.starts_with(head)) return Asked{kind, word.substr(head.size())};
  if (word.size() > 1 && word.starts_with('^')) return Asked{TraceKind::kElement, word};
  return std::nullopt;
}

/// Attributes occur in elements, in percepts ("self.speed 3") and in the text of commands.
bool HasAttribute(const TraceLine& line, std::string_view attribute) {
  if (line.kind == TraceKind::kElement || line.kind == TraceKind::kRule) return Passes(attribute, line.text);
  return line.kind == TraceKind::kPercept && Passes(attribute.substr(1), line.text);
}

}  // namespace

bool TraceFilter::Lets(const TraceLine& line) const {
  if (!agent.empty() && line.agent != agent) return false;
  std::string plain;
  bool asks_kind = false, has_kind = false;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    const std::string_view word = std::string_view(text).substr(begin, end - begin);
    begin = end + 1;
    if (const auto asked = ReadAsked(word)) {
      asks_kind = true;
      const bool is_attribute = word.starts_with('^');
      has_kind |= is_attribute ? HasAttribute(line, word) : line.kind == asked->kind && Passes(asked->part, line.text);
    } else if (!word.empty()) {
      plain.append(plain.empty() ? "" : " ").append(word);
    }
  }
  // A filter for a kind of line shows it regardless of the level of detail.
  if (asks_kind ? !has_kind : line.kind > most) return false;
  return plain.empty() || Passes(plain, line.agent + " " + line.text);
}

std::vector<const TraceLine*> Trace::Find(const TraceFilter& filter) const {
  std::vector<const TraceLine*> found;
  for (const TraceLine& line : lines_)
    if (filter.Lets(line)) found.push_back(&line);
  return found;
}

const std::deque<const TraceLine*>& TraceSearch::Find(const Trace& trace, const TraceFilter& filter) {
  const std::uint64_t first = trace.forgotten(), end = first + trace.lines().size();
  if (revision_ != trace.revision() || !(filter_ == filter)) {
    filter_ = filter;
    revision_ = trace.revision();
    next_ = first;
    found_.clear();
    numbers_.clear();
  }
  while (!numbers_.empty() && numbers_.front() < first) {
    numbers_.pop_front();
    found_.pop_front();
  }
  for (next_ = std::max(next_, first); next_ < end; ++next_) {
    const TraceLine& line = trace.lines()[static_cast<std::size_t>(next_ - first)];
    if (!filter.Lets(line)) continue;
    found_.push_back(&line);
    numbers_.push_back(next_);
  }
  return found_;
}

std::string ToText(const std::vector<const TraceLine*>& lines) {
  std::string text;
  for (const TraceLine* line : lines) {
    const std::size_t indent = line->level > 1 ? 3 * static_cast<std::size_t>(line->level - 1) : 0;
    text += fmt::format("{:>6}  {:<9}{:<10}{}{}\n", line->tick, NameOf(line->kind),
                        line->agent.empty() ? "world" : line->agent, std::string(indent, ' '), line->text);
  }
  return text;
}

}  // namespace soarbox::debugger
