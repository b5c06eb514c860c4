// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "diagnostics/result.h"
#include "script/script_debugger.h"

namespace soarbox::debugger {

/// A line of a script at which scripts stop. Two stops at one line are equal, whatever their conditions are.
struct LineStop {
  std::string file;
  int line = 0;
  std::string condition = {};  ///< An expression of Lua that must be true; empty: always.
  friend bool operator==(const LineStop& a, const LineStop& b) { return a.line == b.line && a.file == b.file; }
  friend bool operator<(const LineStop& a, const LineStop& b) {
    return a.file != b.file ? a.file < b.file : a.line < b.line;
  }
};

/// A variable of a stopped script, with the fields that are unfolded.
struct ScriptRow {
  std::string key;  ///< Path from its group: "locals/self/memory".
  std::string name, value, type;
  bool folds = false, is_open = false;
  std::vector<ScriptRow> below = {};
};

/// A watched expression of a stopped script.
struct ScriptWatch {
  std::string what;
  ScriptRow value;
  std::string fault = {};  ///< Why it has no value; empty if it has one.
};

/// What a stopped script shows.
struct StoppedScript {
  std::string script;                      ///< The name of the agent that it belongs to; "sandbox".
  std::string reason;                      ///< "breakpoint", "step" or "error".
  std::string error;                       ///< The message of the error, or why the condition of the stop has no value.
  std::vector<script::ScriptFrame> calls;  ///< Innermost first.
  std::size_t call = 0;                    ///< The call that the variables belong to.
  std::vector<ScriptRow> locals, upvalues, globals;
  std::vector<ScriptWatch> watches;
};

/// The lines at which the scripts of a run stop, and the script that is stopped.
///
/// A script stops in the middle of a tick: it calls `wait`, and continues when `wait` returns. Meanwhile nothing else
/// of the simulation advances. A stop does not count for the limits of scripts, because these count instructions. Stops
/// never change what a run does. Used by the run's thread.
class LineStops {
 public:
  explicit LineStops(std::function<void()> wait) : wait_(std::move(wait)) { debugger_.SetEnabled(false); }

  /// It must observe the scripts of the run (sim::ObserveScripts).
  script::ScriptObserver& observer() { return debugger_; }
  /// Whether scripts stop. Initially they do not.
  void SetEnabled(bool enabled) { debugger_.SetEnabled(enabled); }

  /// Sets a stop at this line of a file with this text, or at the next line that a function executes. Returns the line.
  /// Fails if there is none. Lines outside of functions are executed only when a script is loaded. The condition
  /// replaces that of a stop at the same line. It may only call functions that change nothing. If it has no value, the
  /// script stops, and the stop says why.
  Result<int> Set(const std::string& file, std::string_view text, int line, const std::string& condition = {});
  void Clear(const std::string& file, int line);
  /// Sets stops that Set has accepted before.
  void Bring(const std::set<LineStop>& stops);
  const std::set<LineStop>& list() const { return stops_; }
  void SetAtErrors(bool stops) { debugger_.SetStopAtErrors(at_errors_ = stops); }
  bool at_errors() const { return at_errors_; }

  bool is_stopped() const { return is_stopped_; }
  /// Lets the stopped script continue.
  void GoOn(script::ScriptStep step);
  /// Lets the stopped script continue. Scripts do not stop again until SetEnabled(true).
  void Leave();
  /// The file and line of the innermost call of the stopped script that is in a file; empty and 0 if there is none.
  LineStop Place();
  /// What the stopped script shows. `call`: the call whose variables are shown; `open`: keys of unfolded rows.
  StoppedScript Look(std::size_t call, const std::set<std::string>& open, const std::vector<std::string>& watches);

 private:
  void Stop();
  void Apply(const std::string& file);
  ScriptRow RowOf(const script::ScriptVariable& variable, const std::string& parent, const std::set<std::string>& open,
                  int depth);
  std::vector<ScriptRow> RowsOf(const std::vector<script::ScriptVariable>& variables, const std::string& parent,
                                const std::set<std::string>& open, int depth = 0);

  std::function<void()> wait_;
  script::ScriptDebugger debugger_{[this] { Stop(); }};
  std::set<LineStop> stops_;
  bool at_errors_ = false, is_stopped_ = false;
};

}  // namespace soarbox::debugger
