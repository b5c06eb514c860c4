// SPDX-License-Identifier: BSD-2-Clause
#include "sml/server/client_log.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <initializer_list>
#include <utility>

#include "diagnostics/problem.h"
#include "sml/server/hosted_agent.h"
#include "sml/wire/message.h"

namespace soarbox::server {

namespace {

constexpr int kPhases = 5;

std::int64_t Now_ms() {
  using namespace std::chrono;
  return duration_cast<milliseconds>(steady_clock::now().time_since_epoch()).count();
}

std::string LineOf(std::string_view kind, std::initializer_list<std::string_view> parts) {
  std::string line(kind);
  for (const std::string_view part : parts) line.append("\t").append(EscapedForLog(part));
  return line + '\n';
}

std::string HandleText(kernel::InputElement element) {
  return std::to_string(static_cast<std::uint32_t>(element));
}

std::string_view InputTypeName(InputWme::Type type) {
  switch (type) {
    case InputWme::Type::kString:
      return "string";
    case InputWme::Type::kInt:
      return "int";
    case InputWme::Type::kDouble:
      return "double";
    case InputWme::Type::kId:
      return "id";
  }
  return "string";
}

std::string ValueText(const InputWme& wme) {
  switch (wme.type) {
    case InputWme::Type::kInt:
      return std::to_string(wme.integer);
    case InputWme::Type::kDouble:
      return wire::ShortDouble(wme.real);
    case InputWme::Type::kString:
    case InputWme::Type::kId:
      break;
  }
  return std::string(wme.text);
}

/// The position at which current acts take effect: the end of the running phase, or else the current position.
RunPosition EffectivePosition(const HostedAgent& hosted) {
  RunPosition at = PositionOf(hosted);
  if (!hosted.agent().running()) return at;
  at.elaborations = 0;
  at.phase = (at.phase + 1) % kPhases;
  if (at.phase == 0) ++at.cycles;
  return at;
}

}  // namespace

RunPosition PositionOf(const HostedAgent& hosted) {
  const kernel::Agent& agent = hosted.agent();
  return {agent.counters().decision_cycles, static_cast<int>(agent.next_phase()),
          agent.in_middle_of_phase() ? agent.counters().elaborations : 0};
}

std::string EscapedForLog(std::string_view text) {
  std::string escaped;
  escaped.reserve(text.size());
  for (const char c : text) {
    const char* const code = c == '\\' ? "\\\\" : c == '\t' ? "\\t" : c == '\n' ? "\\n" : c == '\r' ? "\\r" : nullptr;
    if (code != nullptr) {
      escaped += code;
    } else {
      escaped += c;
    }
  }
  return escaped;
}

std::vector<std::string> PartsOfLogLine(std::string_view line) {
  std::vector<std::string> parts(1);
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (c == '\t') {
      parts.emplace_back();
    } else if (c == '\\' && i + 1 < line.size()) {
      const char code = line[++i];
      parts.back() += code == 't' ? '\t' : code == 'n' ? '\n' : code == 'r' ? '\r' : code;
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

Result<std::unique_ptr<ClientLog>> ClientLog::Create(const std::string& file, std::string_view build) {
  std::FILE* const opened = file.empty() ? std::tmpfile() : std::fopen(file.c_str(), "w+be");
  if (opened == nullptr)
    return ProblemIn(file, std::string("the recording cannot be written: ") + std::strerror(errno),
                     "name a file in a folder that you may write");
  std::unique_ptr<ClientLog> log(new ClientLog(opened, !file.empty()));
  log->Write(LineOf("soarbox-client", {"1", build}));
  log->Flush();
  return log;
}

ClientLog::ClientLog(std::FILE* file, bool is_named)
    : file_(file), readable_(dup(fileno(file))), is_named_(is_named), began_ms_(Now_ms()) {}

ClientLog::~ClientLog() {
  for (auto& [number, seen] : seen_)
    for (const std::string& line : seen.waiting) Write(line);
  if (file_ != nullptr) std::fclose(file_);
  if (readable_ >= 0) close(readable_);
}

void ClientLog::End(const char* reason) {
  std::fprintf(stderr, "soarbox: %s ends here: %s\n", is_named_ ? "the recording" : "the log for soarbox watch",
               reason);
  std::fclose(std::exchange(file_, nullptr));
}

void ClientLog::Write(const std::string& line) {
  if (file_ == nullptr) return;
  if (!is_named_ && written_ + line.size() > kMostUnnamed) return End("it has reached 256 MB");
  if (std::fwrite(line.data(), 1, line.size(), file_) != line.size()) return End(std::strerror(errno));
  written_ += line.size();
}

void ClientLog::Flush() {
  if (file_ != nullptr && std::fflush(file_) != 0) End(std::strerror(errno));
}

std::optional<std::string> ClientLog::Text(std::uint64_t from, std::size_t most) {
  Flush();
  if (from >= written_ || readable_ < 0) return file_ == nullptr ? std::nullopt : std::optional<std::string>("");
  std::string text(std::min<std::uint64_t>(most, written_ - from), '\0');
  const ssize_t got = pread(readable_, text.data(), text.size(), static_cast<off_t>(from));
  text.resize(got < 0 ? 0 : static_cast<std::size_t>(got));
  return text;
}

void ClientLog::WriteGo(const std::string& agent, const RunPosition& at, const std::string& firings) {
  Write(LineOf("go", {agent, std::to_string(at.cycles), std::to_string(at.phase), std::to_string(at.elaborations),
                      firings, std::to_string(Now_ms() - began_ms_)}));
}

void ClientLog::Settle(const std::string& agent, Seen& seen, const RunPosition& now) {
  if (seen.waiting.empty() || now == seen.deferred_at) return;
  WriteGo(agent, seen.deferred_at, "-");
  for (const std::string& line : std::exchange(seen.waiting, {})) Write(line);
  seen.at = seen.deferred_at;
}

void ClientLog::Act(HostedAgent& hosted, std::string line) {
  Seen& seen = seen_[hosted.number()];
  const RunPosition at = EffectivePosition(hosted);
  if (hosted.agent().running()) {
    Settle(hosted.name(), seen, at);
    seen.deferred_at = at;
    seen.waiting.push_back(std::move(line));
    return;
  }
  Went(hosted);
  Write(line);
}

void ClientLog::Went(HostedAgent& hosted) {
  Seen& seen = seen_[hosted.number()];
  const RunPosition now = PositionOf(hosted);
  if (!seen.waiting.empty()) {
    seen.deferred_at = std::min(seen.deferred_at, now);
    WriteGo(hosted.name(), seen.deferred_at, "-");
    for (const std::string& line : std::exchange(seen.waiting, {})) Write(line);
    seen.at = seen.deferred_at;
  }
  if (now == seen.at) return;
  WriteGo(hosted.name(), now, std::to_string(hosted.agent().counters().firings));
  seen.at = now;
}

void ClientLog::AgentMade(std::string_view agent) {
  Write(LineOf("agent", {agent}));
}

void ClientLog::AgentGone(HostedAgent& hosted) {
  if (!hosted.agent().running()) Went(hosted);
  Write(LineOf("gone", {hosted.name()}));
  seen_.erase(hosted.number());
  Flush();
}

void ClientLog::FunctionMade(std::string_view name) {
  Write(LineOf("function", {name}));
}

void ClientLog::FileRead(std::string_view path, std::string_view content) {
  Write(LineOf("file", {path, content}));
}

void ClientLog::Line(HostedAgent& hosted, std::string_view line) {
  Act(hosted, LineOf("line", {hosted.name(), line}));
}

void ClientLog::Added(HostedAgent& hosted, kernel::InputElement element, const InputWme& wme) {
  const std::string id = wme.id.empty() ? IdentifierName(wme.id_key) : std::string(wme.id);
  Act(hosted, LineOf("add", {hosted.name(), HandleText(element), std::to_string(wme.tag), id, wme.attribute,
                             InputTypeName(wme.type), ValueText(wme)}));
}

void ClientLog::Changed(HostedAgent& hosted, kernel::InputElement element, const InputWme& wme) {
  Act(hosted, LineOf("set", {hosted.name(), HandleText(element), std::to_string(wme.tag), InputTypeName(wme.type),
                             ValueText(wme)}));
}

void ClientLog::Removed(HostedAgent& hosted, kernel::InputElement element) {
  Act(hosted, LineOf("remove", {hosted.name(), HandleText(element)}));
}

void ClientLog::Dropped(HostedAgent& hosted, long long tag) {
  Act(hosted, LineOf("drop", {hosted.name(), std::to_string(tag)}));
}

void ClientLog::Scene(HostedAgent& hosted, std::string_view lines) {
  Act(hosted, LineOf("scene", {hosted.name(), lines}));
}

void ClientLog::Answered(HostedAgent& hosted, std::string_view function, std::string_view argument,
                         std::string_view value) {
  Write(LineOf("answer", {hosted.name(), function, argument, value}));
}

}  // namespace soarbox::server
