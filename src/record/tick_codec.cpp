// SPDX-License-Identifier: BSD-2-Clause
#include "record/tick_codec.h"

#include <algorithm>

#include "record/scene_codec.h"

namespace soarbox::record {
namespace {

template <typename Writer>
void WriteTexts(Writer& out, const std::vector<std::string>& texts) {
  out.Number(texts.size());
  for (const std::string& text : texts) out.Text(text);
}

void ReadTexts(ByteReader& in, std::vector<std::string>& texts) {
  texts.resize(in.CountOf(sizeof(std::string)));
  for (std::string& text : texts) text = in.Text();
}

void WriteDiagnostic(BufferedWriter& out, const Diagnostic& diagnostic) {
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

void WriteEvent(BufferedWriter& out, const sim::RunEvent& event) {
  out.Byte(static_cast<std::uint8_t>(event.kind));
  out.Text(event.agent);
  for (const std::string* text : {&event.text, &event.news, &event.parameters}) out.Text(*text);
  out.Number(event.reasons.size());
  for (const explain::Reason& reason : event.reasons) {
    out.Byte(static_cast<std::uint8_t>(reason.kind));
    out.Text(reason.text);
    out.Text(reason.rule);
  }
  out.Byte(static_cast<std::uint8_t>(event.values.index()));
  if (const auto* speech = std::get_if<sim::Speech>(&event.values)) {
    for (const std::string* text : {&speech->to, &speech->about, &speech->text}) out.Text(*text);
  } else if (const auto* check = std::get_if<sim::CheckReport>(&event.values)) {
    for (const std::string* text : {&check->expected, &check->was, &check->agent}) out.Text(*text);
    out.Byte(check->is_marker ? 1 : 0);
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
  const std::uint8_t values = in.Byte();
  if (values == 1) {
    auto& speech = event.values.emplace<sim::Speech>();
    for (std::string* text : {&speech.to, &speech.about, &speech.text}) *text = in.Text();
  } else if (values == 2) {
    auto& check = event.values.emplace<sim::CheckReport>();
    for (std::string* text : {&check.expected, &check.was, &check.agent}) *text = in.Text();
    check.is_marker = in.Byte() != 0;
  } else if (values != 0) {
    return in.Fail();
  }
  event.tick = in.Number();
  event.time_s = in.Double();
  if (HasDiagnostic(event.kind)) ReadDiagnostic(in, event.diagnostic);
  event.has_perceived = in.Byte() != 0;
  for (float* value : {&event.perceived, &event.position.x, &event.position.y, &event.position.z}) *value = in.Float();
}

}  // namespace

const MindRecord* FindMind(const TickRecord& record, std::string_view agent) {
  const auto at = std::find_if(record.minds.begin(), record.minds.end(),
                               [&](const MindRecord& mind) { return mind.agent == agent; });
  return at == record.minds.end() ? nullptr : &*at;
}

void WriteTick(BufferedWriter& out, const TickRecord& before, const TickRecord& now, MindsEncoder& minds) {
  out.Number(now.tick);
  out.Fixed64(now.state_hash);
  WriteTexts(out, now.inputs);
  WriteScene(out, before.scene, now.scene);
  out.Number(now.events.size());
  for (const sim::RunEvent& event : now.events) WriteEvent(out, event);
  minds.Write(out, now.minds);
}

void ReadTick(ByteReader& in, TickRecord& record, MindsDecoder& minds) {
  record.tick = in.Number();
  record.state_hash = in.Fixed64();
  ReadTexts(in, record.inputs);
  ReadScene(in, record.scene);
  record.scene.tick = record.tick;
  // An event uses at least 15 bytes.
  record.events.assign(in.CountOf(sizeof(sim::RunEvent), 15), {});
  for (sim::RunEvent& event : record.events) ReadEvent(in, event);
  minds.Read(in, record.minds);
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
