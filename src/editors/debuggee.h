// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "diagnostics/result.h"
#include "explain/inspector.h"
#include "explain/why_node.h"
#include "script/script_debugger.h"
#include "sim/scenario.h"

namespace soarbox::editors {

/// The length of a step.
enum class Step : std::uint8_t {
  kTick,      ///< One tick of the world; a decision if there is no world.
  kDecision,  ///< Until the agent has made another decision; in a world, to the end of that tick.
  kPhase,     ///< One phase of the decision cycle; in a world a tick, because a world runs minds for complete ticks.
};

/// An event at which to stop, in addition to lines of rules: "operator seek", "element ^color red", "impasse tie",
/// "command move-to", "fire RULE", "match RULE". `kind` is a name of debugger::BreakKind, `what` its pattern. A kernel
/// without a world knows only the kinds fire, operator, element and impasse, and ignores the others.
struct StopWish {
  std::string kind, what;
};
/// Parses an event; nothing if there is no such kind, or for "operator" without a name.
std::optional<StopWish> ReadStopWish(const std::string& text);

/// Why a run stopped.
struct StopReason {
  enum class Kind : std::uint8_t { kMind, kScriptLine, kScriptStep, kScriptError };
  std::string text;
  Kind kind = Kind::kMind;
  std::string agent = {};  ///< kMind: the agent; empty if it is about none.
  std::string rule = {};   ///< kMind: the rule that fired; empty if something else is the reason.
};
using StopReasons = std::vector<StopReason>;

/// The Lua scripts of a world that is being debugged. A script can pause in the middle of a tick. Debuggee::Advance
/// then continues this tick, until its end or the next pause.
class ScriptDebuggee {
 public:
  virtual ~ScriptDebuggee() = default;
  /// Calls `look` with the debugger of the scripts. If a script is paused, `look` runs on the thread of that script. No
  /// script pauses during the call.
  virtual void With(const std::function<void(script::ScriptDebugger&)>& look) = 0;
  virtual bool IsPaused() const = 0;
  /// Continues until a script pauses again or the run ends. If a script is paused, makes a step in it; otherwise stops
  /// at the next line of the script of this owner. Returns the reasons for stopping.
  virtual StopReasons Advance(script::ScriptStep step, std::uint32_t owner) = 0;
  /// Passes Lua code to the script of an agent, or of the sandbox (0). It is executed in the next tick.
  virtual void Run(std::uint32_t owner, const std::string& text) = 0;
};

/// The minds that are being debugged, in a world or in a kernel alone.
class Debuggee {
 public:
  virtual ~Debuggee() = default;

  virtual std::vector<std::string> Agents() const = 0;
  /// Null if there is no such agent. Valid until the next step.
  virtual std::unique_ptr<explain::Inspector> Inspect(const std::string& agent) = 0;
  /// Makes a step. Returns the reasons to stop other than the end of the step; empty if there are none.
  virtual StopReasons Advance(Step step, const std::string& agent) = 0;
  /// Goes back by one tick. Fails if that is not possible.
  virtual Result<void> GoBack() = 0;
  /// Goes back to the beginning.
  virtual Result<void> Restart() = 0;
  virtual Result<std::string> Command(const std::string& agent, const std::string& line) = 0;
  /// Explains what the agent does; with a topic, why that is the case, or why not.
  virtual Result<explain::WhyNode> Why(const std::string& agent, const std::string& topic) = 0;
  /// Replaces the rules whose firing stops the run, and the events that stop it.
  virtual void SetStops(const std::vector<std::string>& rules, const std::vector<StopWish>& wishes) = 0;
  virtual bool HasEnded() const = 0;
  virtual bool CanGoBack() const = 0;
  /// "tick 12, 0.4 s", "decision 3".
  virtual std::string When() const = 0;
  /// Returns and removes the problems and printed texts since the last call. A text may have several lines.
  virtual std::vector<std::string> TakeNews() = 0;
  /// The Lua scripts of the world; null if there are none.
  virtual ScriptDebuggee* Scripts() { return nullptr; }
};

/// The arguments of a launch request.
struct LaunchRequest {
  std::string program;                ///< A scenario, a file of rules, a project of VisualSoar or a recording.
  bool world = true;                  ///< False: load the file of rules into a kernel without a world.
  std::optional<std::uint64_t> seed;  ///< Nothing: the scenario's own. A recording keeps its own.
  /// Simulated time after which a world ends. Nothing: that of the scenario or recording, or 60 s.
  std::optional<double> seconds;
};
/// Launches a world. A recording starts at its beginning, with its inputs.
Result<std::unique_ptr<Debuggee>> LaunchWorld(const LaunchRequest& request, const sim::DataFolders& data);
/// Launches a kernel in this process, with one agent that loads the program.
Result<std::unique_ptr<Debuggee>> LaunchKernel(const LaunchRequest& request);
/// Attaches to a kernel that listens at a port of this machine (`soarbox kernel`, `soarbox run --port`).
Result<std::unique_ptr<Debuggee>> AttachKernel(int port);

}  // namespace soarbox::editors
