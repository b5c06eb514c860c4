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

/// How far a step goes.
enum class Step : std::uint8_t {
  kTick,      ///< Of the world; a decision where there is none.
  kDecision,  ///< Until the agent has decided once more; in a world, up to the end of that tick.
  kPhase,     ///< Of the decision cycle; a tick in a world, which runs minds as far as they go.
};

/// What the user waits for besides the rules' lines: "operator seek", "element ^color red", "impasse tie",
/// "command move-to", "fire RULE", "match RULE".
struct StopWish {
  std::string kind, what;
};
/// Reads one; nothing if there is no such kind.
std::optional<StopWish> ReadStopWish(const std::string& text);

/// The scripts in Lua of a world that is being debugged. A script pauses in the middle of a tick; then
/// Debuggee::Advance goes on to the end of this tick.
class ScriptDebuggee {
 public:
  virtual ~ScriptDebuggee() = default;
  /// Calls `look` with the debugger of the scripts, on the thread that they run on. Nothing pauses meanwhile.
  virtual void With(const std::function<void(script::ScriptDebugger&)>& look) = 0;
  virtual bool IsPaused() const = 0;
  /// Goes on until a script pauses again or the run ends: by a step of the script that is paused, else up to the next
  /// line that the script of this owner executes. Returns why it stopped.
  virtual std::vector<std::string> Advance(script::ScriptStep step, std::uint32_t owner) = 0;
  /// Hands a text of Lua to the script of an agent, or of the sandbox (0); it runs in the next tick.
  virtual void Run(std::uint32_t owner, const std::string& text) = 0;
};

/// Minds that are being debugged, in a world or in a kernel alone.
class Debuggee {
 public:
  virtual ~Debuggee() = default;

  virtual std::vector<std::string> Agents() const = 0;
  /// Null if there is no such agent. Valid until the next step.
  virtual std::unique_ptr<explain::Inspector> Inspect(const std::string& agent) = 0;
  /// Returns why it should stop there besides the step's own end; empty: for nothing.
  virtual std::vector<std::string> Advance(Step step, const std::string& agent) = 0;
  /// One tick back. Fails where time has only one direction.
  virtual Result<void> GoBack() = 0;
  /// Goes back to the beginning.
  virtual Result<void> Restart() = 0;
  virtual Result<std::string> Command(const std::string& agent, const std::string& line) = 0;
  /// Why the agent does what it does; with a topic: why that happens, or does not.
  virtual Result<explain::WhyNode> Why(const std::string& agent, const std::string& topic) = 0;
  /// Rules whose firing stops it, and what else does.
  virtual void SetStops(const std::vector<std::string>& rules, const std::vector<StopWish>& wishes) = 0;
  virtual bool HasEnded() const = 0;
  virtual bool CanGoBack() const = 0;
  /// "tick 12, 0.4 s", "decision 3".
  virtual std::string When() const = 0;
  /// Problems and events since the last call, as lines.
  virtual std::vector<std::string> TakeNews() = 0;
  /// The world's scripts in Lua; null: there are none.
  virtual ScriptDebuggee* Scripts() { return nullptr; }
};

/// What a client asked for.
struct LaunchRequest {
  std::string program;  ///< A scenario, a file of rules, a project of VisualSoar or a recording.
  bool world = true;    ///< False: the file of rules in a kernel without a world.
  std::optional<std::uint64_t> seed;
  std::optional<double> seconds;  ///< After which a world ends.
};
/// In a world: of a recording at its first tick, with its inputs.
Result<std::unique_ptr<Debuggee>> LaunchWorld(const LaunchRequest& request, const sim::DataFolders& data);
/// In a kernel of this process.
Result<std::unique_ptr<Debuggee>> LaunchKernel(const LaunchRequest& request);
/// In a kernel that listens at a port of this machine (`soarbox kernel`, `soarbox run --port`).
Result<std::unique_ptr<Debuggee>> AttachKernel(int port);

}  // namespace soarbox::editors
