// SPDX-License-Identifier: BSD-2-Clause
#include "record/tick_codec.h"

#include <algorithm>

#include "record/legacy_minds.h"
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
  for (const std::string* text : {&diagnostic.file, &diagnostic.message, &diagnostic.excerpt, &diagnostic.hint})
    out.Text(*text);
  for (const int number : {diagnostic.line, diagnostic.column, diagnostic.excerpt_length, diagnostic.more})
    out.Number(static_cast<std::uint64_t>(std::max(number, 0)));
}

void ReadDiagnostic(ByteReader& in, Diagnostic& diagnostic) {
  const std::uint8_t severity = in.Byte();
  if (severity > static_cast<std::uint8_t>(Severity::kError)) return in.Fail();
  diagnostic.severity = static_cast<Severity>(severity);
  for (std::string* text : {&diagnostic.file, &diagnostic.message, &diagnostic.excerpt, &diagnostic.hint})
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
  WriteTexts(out, event.reasons);
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
  ReadTexts(in, event.reasons);
  event.tick = in.Number();
  event.time_s = in.Double();
  if (HasDiagnostic(event.kind)) ReadDiagnostic(in, event.diagnostic);
  event.has_perceived = in.Byte() != 0;
  for (float* value : {&event.perceived, &event.position.x, &event.position.y, &event.position.z}) *value = in.Float();
}

void WriteMind(ByteWriter& out, const MindRecord& mind) {
  out.Text(mind.agent);
  out.Byte(mind.from_words ? 1 : 0);
  out.Text(mind.events.bytes());
}

void ReadMind(ByteReader& in, MindRecord& mind) {
  mind.agent = in.Text();
  mind.from_words = in.Byte() != 0;
  const std::string_view events = in.Text();
  in.Charge(events.size());
  if (in.failed()) return;
  mind.events = mind::EventLog(events);
  if (!mind.events.IsSound()) in.Fail();
}

/// Formats 2 to 4 hold words.
void ReadMindInWords(ByteReader& in, MindRecord& mind) {
  mind.agent = in.Text();
  mind.from_words = true;
  tell::MindWords words;
  for (auto* texts :
       {&words.percepts, &words.decisions, &words.details, &words.commands, &words.reasons, &words.command_rules})
    ReadTexts(in, *texts);
  if (!in.failed()) mind.events = ReadWords(words);
}

}  // namespace

const MindRecord* FindMind(const TickRecord& record, std::string_view agent) {
  const auto at = std::find_if(record.minds.begin(), record.minds.end(),
                               [&](const MindRecord& mind) { return mind.agent == agent; });
  return at == record.minds.end() ? nullptr : &*at;
}

void WriteTick(ByteWriter& out, const world::SceneSnapshot& before, const TickRecord& now) {
  out.Number(now.tick);
  out.Fixed64(now.state_hash);
  WriteTexts(out, now.inputs);
  WriteScene(out, before, now.scene);
  out.Number(now.events.size());
  for (const sim::RunEvent& event : now.events) WriteEvent(out, event);
  out.Number(now.minds.size());
  for (const MindRecord& mind : now.minds) WriteMind(out, mind);
}

void ReadTick(ByteReader& in, TickRecord& record, std::uint16_t version) {
  record.tick = in.Number();
  record.state_hash = in.Fixed64();
  ReadTexts(in, record.inputs);
  ReadScene(in, record.scene, version);
  record.scene.tick = record.tick;
  // An event takes 15 bytes at least, a mind 3.
  record.events.assign(in.CountOf(sizeof(sim::RunEvent), 15), {});
  for (sim::RunEvent& event : record.events) ReadEvent(in, event);
  record.minds.assign(in.CountOf(sizeof(MindRecord), 3), {});
  constexpr std::uint16_t kLastInWords = 4;
  for (MindRecord& mind : record.minds) version <= kLastInWords ? ReadMindInWords(in, mind) : ReadMind(in, mind);
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
