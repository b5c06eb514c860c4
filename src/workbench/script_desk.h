// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "debugger/line_stops.h"
#include "workbench/contents.h"
#include "workbench/desk_common.h"
#include "workbench/file_desk.h"
#include "workbench/requests.h"

namespace soarbox::workbench {

/// The lines at which scripts of the run stop, and the script that is stopped in the middle of a tick.
///
/// While a script is stopped, the program around the desk serves the user inside the tick. Scripts stop only in ticks
/// for which Prepare was called.
class ScriptDesk {
 public:
  ScriptDesk(const DeskCommon& common, FileDesk& files) : common_(common), files_(files) {}

  /// What serves the user, with Desk::Serve, while a script is stopped: it returns when is_stopped() is false or the
  /// user is gone. Without it, scripts cannot stop.
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
  /// False if somebody else observes the scripts, for example a profiler.
  bool CanStop() const;
  /// A script has stopped.
  void Wait();
  /// The name that the run uses for a file: of the file with this path, or with this name if it is no path.
  std::string FileOf(const std::string& file);
  /// Whether this is the name of a script of the run. Scripts choose the names of the chunks that they load, so a name
  /// may be that of any file.
  bool IsOfRun(const std::string& file);

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
  std::map<std::string, std::string> names_;  ///< Answers of FileOf.
};

}  // namespace soarbox::workbench
