// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/result.h"
#include "kernel/io/input_link.h"
#include "sml/wire/input_wme.h"

namespace soarbox::server {

using wire::InputWme;
class HostedAgent;

/// The position of an agent in its run: the completed output phases, and the phase that comes next.
struct RunPosition {
  std::uint64_t cycles = 0;
  int phase = 0;
  std::uint64_t elaborations = 0;  ///< In the middle of a phase: all elaborations so far; 0: between phases.
  friend auto operator<=>(const RunPosition&, const RunPosition&) = default;
};
RunPosition PositionOf(const HostedAgent& hosted);

/// The log of everything that clients do to the agents of a kernel. It suffices to run the agents again without the
/// clients. Each act is one line, whose parts are separated by tabs; `\t`, `\n`, `\r` and `\\` are escapes.
///
///     soarbox-client 1 BUILD      the first line
///     agent NAME                  an agent was created;  gone NAME: it was destroyed
///     function NAME               clients implement this right-hand-side function from now on
///     file PATH CONTENT           a command read this file
///     line AGENT TEXT             a command line; `source` names its file by its absolute path
///     add AGENT HANDLE TAG ID ATTRIBUTE TYPE VALUE    an element of input
///     set AGENT HANDLE TAG TYPE VALUE                 the element has another value
///     remove AGENT HANDLE;  drop AGENT TAG            the element was removed
///     scene AGENT TEXT            lines for the scene of the top state
///     answer AGENT FUNCTION ARGUMENT VALUE            what a client returned for a function that a rule called
///     go AGENT CYCLES PHASE ELABORATIONS FIRINGS MS   the agent ran to this position (RunPosition). FIRINGS is the
///                                 number of rule firings so far, or - if unknown. MS is the time since the log began,
///                                 for readers: ticks of recordings do not contain it (record/client_ticks.h).
///
/// Each act follows the `go` of the position at which it happened. An act in the middle of a phase is moved to the end
/// of the phase: input and commands reach the agent no earlier. Answers precede the `go` that needs them.
///
/// Owned by KernelHost and used on the thread that holds the kernel. If the file can no longer be written, the log
/// reports this once on the standard error and ends.
class ClientLog {
 public:
  /// Creates the file, replacing an old one. `build` identifies the program. Without a name, creates a temporary file
  /// of at most kMostUnnamed bytes that no other program can open; its contents can be read by Text().
  static Result<std::unique_ptr<ClientLog>> Create(const std::string& file, std::string_view build);
  static constexpr std::uint64_t kMostUnnamed = std::uint64_t{256} << 20;
  ~ClientLog();
  ClientLog(const ClientLog&) = delete;
  ClientLog& operator=(const ClientLog&) = delete;

  void AgentMade(std::string_view agent);
  void AgentGone(HostedAgent& hosted);
  void FunctionMade(std::string_view name);
  void FileRead(std::string_view path, std::string_view content);
  void Line(HostedAgent& hosted, std::string_view line);
  void Added(HostedAgent& hosted, kernel::InputElement element, const InputWme& wme);
  void Changed(HostedAgent& hosted, kernel::InputElement element, const InputWme& wme);
  void Removed(HostedAgent& hosted, kernel::InputElement element);
  void Dropped(HostedAgent& hosted, long long tag);
  void Scene(HostedAgent& hosted, std::string_view lines);
  void Answered(HostedAgent& hosted, std::string_view function, std::string_view argument, std::string_view value);
  /// The agent has run: writes its new position.
  void Went(HostedAgent& hosted);
  /// Flushes the written lines to the operating system, so that they survive if the program is killed.
  void Flush();

  /// Returns at most `most` bytes of the log from this byte on. Returns none if no more bytes follow and the log has
  /// ended, because it could not be written or became too long.
  std::optional<std::string> Text(std::uint64_t from, std::size_t most);

 private:
  struct Seen {
    RunPosition at;                    ///< The position of the last `go`.
    RunPosition deferred_at;           ///< The end of the phase in which the waiting acts happened.
    std::vector<std::string> waiting;  ///< The lines of acts in the middle of a phase.
  };

  ClientLog(std::FILE* file, bool is_named);
  void Act(HostedAgent& hosted, std::string line);
  void WriteGo(const std::string& agent, const RunPosition& at, const std::string& firings);
  /// Writes the acts of a phase that has ended.
  void Settle(const std::string& agent, Seen& seen, const RunPosition& now);
  void Write(const std::string& line);
  void End(const char* reason);

  std::FILE* file_;  ///< Null once the log has ended.
  int readable_;     ///< Another descriptor of the file; -1: none.
  bool is_named_;
  std::uint64_t written_ = 0;
  std::map<std::uint64_t, Seen> seen_;  ///< By the agent's number.
  std::int64_t began_ms_;
};

/// Splits a line of the log into its parts and removes the escapes.
std::vector<std::string> PartsOfLogLine(std::string_view line);
/// A part in the escaped form that the log contains.
std::string EscapedForLog(std::string_view text);

}  // namespace soarbox::server
