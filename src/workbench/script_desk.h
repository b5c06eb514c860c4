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

#include "debugger/line_stops.h"
#include "workbench/contents.h"
#include "workbench/desk_common.h"
#include "workbench/file_desk.h"
#include "workbench/pace.h"
#include "workbench/requests.h"

namespace soarbox::workbench {

/// The lines at which scripts of the run stop, and the script that is stopped in the middle of a tick.
///
/// While a script is stopped, the tick does not end: the function of SetWait serves the user inside it. Scripts stop
/// only in ticks for which Prepare was called.
class ScriptDesk {
 public:
  ScriptDesk(const DeskCommon& common, FileDesk& files) : common_(common), files_(files) {}

  /// Sets the function that is called when a script stops. It calls Desk::Serve until is_stopped() is false, or the
  /// user is gone. Without this function, scripts cannot stop.
  void SetWait(std::function<void()> wait);
  /// Observes the scripts of the present simulation.
  void Observe();

  /// The state that is passed on to the next run.
  struct Belongings {
    std::set<debugger::LineStop> stops;
    bool at_errors = false;
    std::vector<std::string> watches;
  };
  Belongings Take() { return {stops_.list(), stops_.at_errors(), watches_}; }
  void Bring(const Belongings& belongings);

  /// Lets scripts stop in the next tick.
  void Prepare() { stops_.SetEnabled(CanStop()); }
  /// Scripts do not stop until Prepare.
  void Rest() { stops_.SetEnabled(false); }
  bool is_stopped() const { return stops_.is_stopped(); }
  /// Whether the user is served inside a tick: a script is stopped, or is about to continue.
  bool is_in_tick() const { return is_in_tick_; }
  /// Why the request cannot be carried out while a script is stopped; empty if it can.
  std::string Refusal(const Request& request);
  /// Lets the stopped script continue.
  void GoOn(ScriptGoRequest::How how = ScriptGoRequest::How::kOn);
  /// Lets the stopped script continue; no script stops in the rest of this tick.
  void Leave() { stops_.Leave(); }
  /// Executes a command of the run while a script is stopped. Returns false if it must be executed after this tick.
  bool ObeyInTick(Flow flow, Pace& pace);
  /// Returns true once after each stop.
  bool TakeNews() { return std::exchange(has_news_, false); }

  void Obey(const LineStopRequest& request);
  void Obey(const ErrorStopRequest& request) { stops_.SetAtErrors(request.is_on); }
  void Obey(const ScriptCallRequest& request);
  void Obey(const ScriptValueRequest& request);
  void Obey(const ScriptWatchRequest& request);
  /// `is_visible`: the panel Script is.
  void Fill(Contents& contents, bool is_visible);

 private:
  /// False for a recording, without a function of SetWait, and while another observer observes the scripts, for example
  /// a profiler.
  bool CanStop() const;
  /// Called when a script stops: calls the function of SetWait.
  void Wait();
  /// The names that the run uses for its files, without those of rules.
  std::set<std::string> FilesOfRun() const;

  const DeskCommon& common_;
  FileDesk& files_;
  std::function<void()> wait_;
  debugger::LineStops stops_{[this] { Wait(); }};
  std::set<std::string> open_;  ///< Keys of unfolded variables.
  std::vector<std::string> watches_;
  std::size_t call_ = 0;
  std::uint64_t count_ = 0;   ///< Number of stops.
  debugger::LineStop place_;  ///< Of the present stop.
  bool has_news_ = false, is_in_tick_ = false;
};

}  // namespace soarbox::workbench
