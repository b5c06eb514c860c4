// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "editors/debuggee.h"
#include "editors/json_type.h"
#include "language/workspace.h"
#include "script/script_debugger.h"
#include "sim/scenario.h"

namespace soarbox::editors {

/// The Debug Adapter Protocol for Soar agents and scripts in Lua, without its framing: it converts messages to answers.
///
/// Agents are threads, the states of a goal stack are frames, and states, operators and the objects below them are
/// variables. The script of the sandbox and the script of each agent are threads as well, whose frames are calls
/// (dap_scripts.cpp).
///
/// In a thread of an agent, `next` advances the world by a tick, `stepIn` by a decision, and `stepOut` until the agent
/// leaves its substate. With the granularity "instruction", each of them makes steps of a phase. `stepBack` goes back
/// by a tick, `reverseContinue` to the beginning. Breakpoints are set on lines of rules and of scripts, or as function
/// breakpoints on events (StopWish). The console accepts Soar commands and `why`, for a script Lua.
///
/// All requests are answered, including invalid ones. Only `disconnect` ends the server.
class DapServer {
 public:
  /// `data`: the folders of scenarios; null: scenarios are refused.
  explicit DapServer(const sim::DataFolders* data) : data_(data) {}

  /// Processes one message. Returns the answer and the events in the order in which they must be sent.
  std::vector<Json> Handle(const std::string& message);
  /// Continues the run by a tick and returns the events. Call it repeatedly while is_running() and no message waits.
  std::vector<Json> Advance();
  bool is_running() const { return running_; }
  bool is_over() const { return over_; }

 private:
  Json Request(const std::string& command, const Json& arguments);
  Json Launch(const Json& arguments);
  Json Attach(const Json& arguments);
  Json SetBreakpoints(const Json& arguments);
  Json SetFunctionBreakpoints(const Json& arguments);
  Json Threads(const Json& arguments);
  Json StackTrace(const Json& arguments);
  Json Scopes(const Json& arguments);
  Json Variables(const Json& arguments);
  Json Evaluate(const Json& arguments);
  Json Completions(const Json& arguments);
  Json StepBy(const std::string& command, const Json& arguments);

  // Conditions of breakpoints, and log points (dap_marks.cpp).
  /// What is wrong with the condition of a breakpoint in a rule; empty: nothing.
  static std::string FaultOfCondition(const std::string& condition);
  /// Prints the line of a log point, which is in line `at` of the file.
  void Log(const std::string& line, const std::filesystem::path& file, std::size_t at);
  /// Prints the log points among these reasons to stop. False: none of the others is a reason, so the run goes on.
  bool StopsFor(const StopReasons& reasons);
  bool StopsFor(const StopReason& reason);
  bool StopsInScript(std::uint32_t owner);

  // Requests about scripts.
  Json SetScriptBreakpoints(const std::filesystem::path& file, const Json& arguments);
  Json SetErrorStops(const Json& arguments);
  void AddScriptThreads(Json& list);
  Json ScriptStack(std::uint32_t owner);
  Json ScriptScopes(std::size_t frame_number);
  Json ScriptVariables(int held_number);
  Json EvaluateInScript(std::uint32_t owner, std::size_t level, const std::string& expression, bool in_console);
  Json StepScript(const std::string& command, std::uint32_t owner);
  Json VariablesAsJson(const std::vector<script::ScriptVariable>& variables);
  ScriptDebuggee& Lua();
  /// The owner of the script that is paused in the middle of a tick.
  std::optional<std::uint32_t> PausedScript();
  /// The owner of the script of this thread; nothing for threads of agents.
  std::optional<std::uint32_t> ScriptOf(const Json& arguments);

  void Begin(std::unique_ptr<Debuggee> debuggee);
  void Event(const std::string& name, Json body);
  void TellNews();
  void Stop(const std::string& reason, const std::string& text = {});
  void EndIfOver();
  void UpdateStops();
  std::string AgentOf(const Json& arguments);
  std::string AgentOfFrame(const Json& arguments, std::string* state = nullptr);
  /// Creates a reference to variables: to an identifier of an agent, or to a tree of reasons.
  int Reference(std::string agent, std::string id);
  int Reference(explain::WhyNode why);
  Json ElementsOf(const std::string& agent, const std::string& id);
  Json Tree(const explain::WhyNode& why);
  Debuggee& Minds();

  const sim::DataFolders* data_;
  std::unique_ptr<Debuggee> debuggee_;
  language::Workspace workspace_;
  std::vector<Json> out_, after_;  ///< Messages to send; events in after_ are sent after the answer.
  int sequence_ = 0;
  bool running_ = false, over_ = false, stop_on_entry_ = true, configured_ = false, ended_ = false;
  std::string stepping_;  ///< The agent of the last step or breakpoint.
  struct Frame {
    std::string agent, state, operator_id;
    std::optional<std::uint32_t> script = {};  ///< Owner of the script; `level` then counts calls, the innermost is 0.
    std::size_t level = 0;
  };
  std::vector<Frame> frames_;  ///< The frame with the id n is frames_[n - 1].
  struct Held {
    std::string agent, id;
    explain::WhyNode why;
    enum class Kind : std::uint8_t { kElements, kWhy, kLocals, kUpvalues, kGlobals, kFields } kind = Kind::kElements;
    std::uint32_t script = 0;
    int number = 0;  ///< The level of a call; for kFields, a reference of the debugger of scripts.
  };
  std::vector<Held> held_;  ///< Objects that can be unfolded. That with the reference n is held_[n - 1].
  struct Mark {
    std::filesystem::path file;
    std::string rule;
    std::size_t line = 0;
    /// `condition`: empty if there is none. `log`: the line that a log point prints; empty for a breakpoint, which
    /// stops the run.
    std::string condition, log;
  };
  std::map<std::string, std::vector<Mark>> marks_;  ///< Breakpoints by file.
  std::vector<StopWish> wishes_;
  std::map<std::string, std::vector<script::ScriptBreakpoint>> script_marks_;  ///< By file.
  std::map<std::pair<std::string, int>, std::string> script_logs_;             ///< By file and line.
  bool stop_at_errors_ = false;
  std::string stopped_at_;  ///< The rule of the breakpoint at which it stopped.
};

/// Serves on two file descriptors until the client disconnects or closes its end. Returns the exit code of the process.
int ServeDap(int in, int out, const sim::DataFolders* data);

}  // namespace soarbox::editors
