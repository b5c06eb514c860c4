// SPDX-License-Identifier: BSD-2-Clause
#include "record/tick_codec.h"

#include <algorithm>
#include <utility>

#include "record/event_delta.h"
#include "record/scene_codec.h"

namespace soarbox::record {
namespace {

void WriteTexts(ByteWriter& out, const std::vector<std::string>& texts) {
  out.Number(texts.size());
  for (const std::string& text : texts) out.Text(text);
}

void ReadTexts(ByteReader& in, std::vector<std::string>& texts) {
  texts.resize(in.CountOf(sizeof(std::string)));
  for (std::string& text : texts) text = in.Text();
}

void WriteDiagnostic(ByteWriter& out, const Diagnostic& diagnostic) {
  out.Byte(static_cast<std::uint8_t>(diagnostic.severity));
  out.Byte(static_cast<std::uint8_t>(diagnostic.topic));
  for (const std::string* text : {&diagnostic.file, &diagnostic.message, &diagnostic.excerpt, &diagnostic.hint,
                                  &diagnostic.rule, &diagnostic.meant})
    out.Text(*text);
  for (const int number : {diagnostic.line, diagnostic.column, diagnostic.excerpt_length, diagnostic.more})
    out.Number(static_cast<std::uint64_t>(std::max(number, 0)));
}

void ReadDiagnostic(ByteReader& in, Diagnostic& diagnostic) {
  const std::uint8_t severity = in.Byte();
  if (severity > static_cast<std::uint8_t>(Severity::kError)) return in.Fail();
  diagnostic.severity = static_cast<Severity>(severity);
  const std::uint8_t topic = in.Byte();
  if (topic > static_cast<std::uint8_t>(kLastTopic)) return in.Fail();
  diagnostic.topic = static_cast<Topic>(topic);
  for (std::string* text : {&diagnostic.file, &diagnostic.message, &diagnostic.excerpt, &diagnostic.hint,
                            &diagnostic.rule, &diagnostic.meant})
    *text = in.Text();
  for (int* number : {&diagnostic.line, &diagnostic.column, &diagnostic.excerpt_length, &diagnostic.more})
    *number = static_cast<int>(std::min<std::uint64_t>(in.Number(), 0x7fffffff));
}

bool HasDiagnostic(sim::EventKind kind) {
  return kind == sim::EventKind::kDiagnostic || kind == sim::EventKind::kAgentFailed ||
         kind == sim::EventKind::kMindFailed;
}

void WriteEvent(ByteWriter& out, const sim::RunEvent& event) {
  out.Byte(static_cast<std::uint8_t>(event.kind));
  out.Text(event.agent);
  for (const std::string* text : {&event.text, &event.news, &event.parameters}) out.Text(*text);
  out.Number(event.reasons.size());
  for (const explain::Reason& reason : event.reasons) {
    out.Byte(static_cast<std::uint8_t>(reason.kind));
    out.Text(reason.text);
    out.Text(reason.rule);
  }
  out.Number(event.tick);
  out.Double(event.time_s);
  if (HasDiagnostic(event.kind)) WriteDiagnostic(out, event.diagnostic);
  out.Byte(event.has_perceived ? 1 : 0);
  for (const float value : {event.perceived, event.position.x, event.position.y, event.position.z}) out.Float(value);
}

void ReadEvent(ByteReader& in, sim::RunEvent& event) {
  const std::uint8_t kind = in.Byte();
  if (kind > static_cast<std::uint8_t>(sim::kLastEventKind)) return in.Fail();
  event.kind = static_cast<sim::EventKind>(kind);
  event.agent = in.Text();
  for (std::string* text : {&event.text, &event.news, &event.parameters}) *text = in.Text();
  event.reasons.resize(in.CountOf(sizeof(explain::Reason)));
  for (explain::Reason& reason : event.reasons) {
    const std::uint8_t what = in.Byte();
    if (what > static_cast<std::uint8_t>(explain::Reason::kLastKind)) return in.Fail();
    reason.kind = static_cast<explain::Reason::Kind>(what);
    reason.text = in.Text();
    reason.rule = in.Text();
  }
  event.tick = in.Number();
  event.time_s = in.Double();
  if (HasDiagnostic(event.kind)) ReadDiagnostic(in, event.diagnostic);
  event.has_perceived = in.Byte() != 0;
  for (float* value : {&event.perceived, &event.position.x, &event.position.y, &event.position.z}) *value = in.Float();
}

/// Writes minds as their differences from the tick before, in which they usually have the same order. For each mind: 1
/// plus the number of earlier minds to skip, or 0 and the agent's name for one that is not in the tick before. Then its
/// events.
void WriteMinds(ByteWriter& out, const std::vector<MindRecord>& before, const std::vector<MindRecord>& now) {
  constexpr std::size_t kMostPassed = 200;
  out.Number(now.size());
  std::size_t next = 0;
  for (const MindRecord& mind : now) {
    const std::size_t end = std::min(before.size(), next + kMostPassed);
    std::size_t at = next;
    while (at < end && before[at].agent != mind.agent) ++at;
    const bool was_there = at < end;
    out.Number(was_there ? at - next + 1 : 0);
    if (!was_there) out.Text(mind.agent);
    WriteEventDelta(out, was_there ? before[at].events.bytes() : std::string_view(), mind.events.bytes());
    if (was_there) next = at + 1;
  }
}

void ReadMinds(ByteReader& in, std::vector<MindRecord>& minds) {
  const std::vector<MindRecord> before = std::exchange(minds, {});
  minds.resize(in.CountOf(sizeof(MindRecord), 2));
  std::size_t next = 0;
  for (MindRecord& mind : minds) {
    std::string_view events_before;
    if (const std::uint64_t passed = in.Number(); passed == 0) {
      mind.agent = in.Text();
    } else {
      if (passed > before.size() - next) return in.Fail();
      next += static_cast<std::size_t>(passed);
      mind.agent = before[next - 1].agent;
      in.Charge(mind.agent.size());
      events_before = before[next - 1].events.bytes();
    }
    mind.events = mind::EventLog(ReadEventDelta(in, events_before));
    if (in.failed()) return;
    if (!mind.events.IsSound()) return in.Fail();
  }
}

}  // namespace

const MindRecord* FindMind(const TickRecord& record, std::string_view agent) {
  const auto at = std::find_if(record.minds.begin(), record.minds.end(),
                               [&](const MindRecord& mind) { return mind.agent == agent; });
  return at == record.minds.end() ? nullptr : &*at;
}

void WriteTick(ByteWriter& out, const TickRecord& before, const TickRecord& now) {
  out.Number(now.tick);
  out.Fixed64(now.state_hash);
  WriteTexts(out, now.inputs);
  WriteScene(out, before.scene, now.scene);
  out.Number(now.events.size());
  for (const sim::RunEvent& event : now.events) WriteEvent(out, event);
  WriteMinds(out, before.minds, now.minds);
}

void ReadTick(ByteReader& in, TickRecord& record) {
  record.tick = in.Number();
  record.state_hash = in.Fixed64();
  ReadTexts(in, record.inputs);
  ReadScene(in, record.scene);
  record.scene.tick = record.tick;
  // An event uses at least 15 bytes, a mind 3.
  record.events.assign(in.CountOf(sizeof(sim::RunEvent), 15), {});
  for (sim::RunEvent& event : record.events) ReadEvent(in, event);
  ReadMinds(in, record.minds);
}

void WriteInputs(ByteWriter& out, std::uint64_t tick, const std::vector<std::string>& inputs) {
  out.Number(tick);
  WriteTexts(out, inputs);
}

void ReadInputs(ByteReader& in, std::uint64_t& tick, std::vector<std::string>& inputs) {
  tick = in.Number();
  ReadTexts(in, inputs);
}

}  // namespace soarbox::record
