// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "cli/print_stream.h"
#include "cli/run_times.h"
#include "cli/trace_settings.h"

namespace soarbox::kernel {
class Agent;
}

namespace soarbox::cli {

class PerceptPlayer;
class PerceptRecorder;
class RlUpdateLog;
class TracePrinter;
class SettingStore;

/// Settings such as `output agent-logs` and `output print-depth` for one agent.
struct OutputSettings {
  static constexpr int kLogChannels = 18;

  bool agent_writes = true;
  bool echo_commands = false;
  bool warnings = true;
  int print_depth = 1;
  std::vector<bool> log_channels = std::vector<bool>(kLogChannels, true);
};

/// The current subject of `explain`.
struct ExplainState {
  std::uint32_t rule = 0;    ///< Number of the learned rule; 0 if there is none.
  std::uint32_t firing = 0;  ///< Number of the firing that was explained last; 0 for the learned rule itself.
  bool elements = false;     ///< `explain wm-trace`: elements instead of tests.
};

/// A filter of `wm watch`: names as typed; `*` matches anything.
struct WmeFilter {
  std::string id, attribute, value;
  bool adds = true;
  bool removes = true;
};

/// The command line's data of one agent: its output, trace and watches, and the settings that the kernel does not use.
/// Must not outlive the agent. Belongs to the agent's thread.
class Session {
 public:
  explicit Session(kernel::Agent& agent, std::string name = "soar");
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  kernel::Agent& agent() { return agent_; }
  const std::string& name() const { return name_; }

  /// Output during runs that does not belong to a command. Set its sink to receive it.
  PrintStream& stream() { return stream_; }

  TraceSettings& trace() { return trace_; }
  OutputSettings& output() { return output_; }
  ExplainState& explain() { return explain_; }
  SettingStore& settings() { return *settings_; }
  /// `soar timers`, `stats`.
  RunTimes& times() { return times_; }
  std::vector<WmeFilter>& wme_filters() { return wme_filters_; }

  /// Subscribes to the events that the trace needs. Call it after changing trace() or the filters.
  void UpdateTrace();

  /// Sets the file for updates of learned values (`rl --set update-log-path`); an empty path stops the log. Returns
  /// false if the file cannot be written.
  bool SetReinforcementLog(const std::string& path);

  /// Names of rules whose firings are shown at all trace levels (`production watch`).
  std::vector<std::string>& watched_rules() { return watched_rules_; }

  /// `save percepts` and `load percepts`. At most one of them exists.
  std::unique_ptr<PerceptRecorder>& percept_recorder() { return percept_recorder_; }
  std::unique_ptr<PerceptPlayer>& percept_player() { return percept_player_; }

  /// `output log`: all texts and command lines are also written to a file.
  bool OpenLog(const std::string& path, bool append);
  void CloseLog();
  bool log_open() const;
  void Log(std::string_view text);

 private:
  struct LogFile;

  kernel::Agent& agent_;
  std::string name_;
  PrintStream stream_;
  TraceSettings trace_;
  OutputSettings output_;
  ExplainState explain_;
  RunTimes times_;
  std::unique_ptr<SettingStore> settings_;
  std::vector<WmeFilter> wme_filters_;
  std::vector<std::string> watched_rules_;
  std::unique_ptr<LogFile> log_;
  std::unique_ptr<PerceptRecorder> percept_recorder_;
  std::unique_ptr<PerceptPlayer> percept_player_;
  std::unique_ptr<TracePrinter> trace_printer_;
  std::unique_ptr<RlUpdateLog> rl_update_log_;
};

}  // namespace soarbox::cli
