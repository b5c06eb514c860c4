// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "diagnostics/result.h"
#include "serve/activity.h"
#include "serve/engine_process.h"
#include "serve/page_message.h"
#include "serve/place_lock.h"
#include "serve/server_settings.h"
#include "serve/work.h"

namespace soarbox::serve {

/// Data that are sent to several pages share memory.
using Bytes = std::shared_ptr<const std::string>;

/// A page that shows a run, as its session sees it. Its functions never block.
class Viewer {
 public:
  virtual ~Viewer() = default;
  /// A message replaces a waiting message with the same `key`; an empty key replaces none.
  virtual void SendText(Bytes text, const std::string& key) = 0;
  virtual void SendScene(Bytes block, bool is_full) = 0;
  /// Whether it may send all requests. If not, it may only select the panels that it shows.
  virtual bool MayAsk() const = 0;
};

/// One run of one place: its engine, the pages that show it, and the messages for pages that connect later. A place has
/// at most one process: `Open` ends the present one, and starts the next one after it has ended.
class Session : public std::enable_shared_from_this<Session> {
 public:
  /// Whether this session may start a process now; fails with the reason if it may not.
  using MayStart = std::function<Result<void>(const Session&)>;
  Session(boost::asio::io_context& io, Work& work, const Settings& settings, Place place, MayStart may_start);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// Opens a run instead of the present one: "lesson:01-a-rule", "scenario:scout", "recording:run-0001.soarrec". If it
  /// is called again before the run has started, only the last call counts. If the run cannot be opened, `refuse` is
  /// called with the reason, and the present run continues.
  void Open(const std::string& what, std::function<void(const Diagnostic&)> refuse);
  /// `tab` identifies a tab of a browser, so that a reconnecting page is recognized; may be empty.
  void Join(Viewer& viewer, const std::string& tab);
  void Leave(Viewer& viewer);
  /// Requests a full block of the scene for all pages.
  void AskForScene();
  /// Processes a message of a page.
  void Take(Viewer& viewer, std::string text);
  /// Sets the message that each page of the run's owner gets when it joins, and again after Greet; empty: none.
  void SetGreeting(std::function<std::string()> greeting) { greeting_ = std::move(greeting); }
  void Greet();
  /// What the user does, according to the contents that were sent last.
  Activity::Standing Standing();
  /// Ends a run that no page has shown for a long time, or that has lasted too long.
  void EndIfIdle();
  /// Ends the run and sends the reason to its pages.
  void End(const std::string& why);

  /// Whether there is a process, or one is being ended or started.
  bool is_running() const { return engine_ != nullptr || phase_ == Phase::kEnding || phase_ == Phase::kStarting; }
  /// Address of the first page.
  const std::string& address() const { return address_; }
  void set_address(const std::string& address) { address_ = address; }
  std::size_t viewers() const { return viewers_.size(); }
  const Place& place() const { return place_; }
  const std::string& what() const { return what_; }

 private:
  using Clock = std::chrono::steady_clock;
  /// Progress of opening a run.
  enum class Phase : std::uint8_t {
    kRest,      ///< No run is being opened.
    kAsking,    ///< Checks whether the run exists.
    kEnding,    ///< Waits until the previous run has ended.
    kStarting,  ///< Starts the process.
  };
  struct Wanted {
    std::string what;
    std::function<void(const Diagnostic&)> refuse;
  };
  /// Starts the next phase for wanted_.
  void Advance();
  void EndForNext(const std::string& what, const std::vector<std::string>& words);
  void StartLater(const std::string& what, const std::vector<std::string>& words);
  void StartNext(const std::string& what, const std::vector<std::string>& words);
  void OnStarted(const std::string& what, const EngineProcess::Spawned& spawned);
  void Forget();
  void OnFrame(Frame frame);
  void OnEnd(EngineProcess::Ending ending);
  void Tell(const std::string& text, const std::string& key = {});
  void TellPresence();
  /// Handles a message of a page that may only select panels.
  Result<void> Watch(const Viewer& viewer, const PageMessage& message);
  /// Lets only this page edit texts, and reports that to all pages.
  void HandTextsTo(const Viewer* viewer);
  void AwaitAnswer();
  void NoLongerBusy();
  /// Checks twice per second whether the engine is alive.
  void ListenForLife();

  boost::asio::io_context& io_;
  Work& work_;
  const Settings& settings_;
  Place place_;
  MayStart may_start_;
  std::string what_, address_;
  std::shared_ptr<EngineProcess> engine_;
  Phase phase_ = Phase::kRest;
  std::optional<Wanted> wanted_;
  std::optional<PlaceLock> lock_;  ///< Held while there is an engine.
  std::vector<Viewer*> viewers_;
  std::map<const Viewer*, std::vector<std::string>> watched_;  ///< Panels that pages without further rights show.
  const Viewer* editor_ = nullptr;                             ///< The page that may edit texts.
  std::map<const Viewer*, std::string> tabs_;
  Clock::time_point began_, looked_at_;  ///< When the run was started; when a page joined or left last.

  std::function<std::string()> greeting_;
  Activity activity_;
  std::string reason_;           ///< The error because of which the engine ends, if it sent one.
  std::array<Bytes, 3> looked_;  ///< The contents that activity_ was updated with.

  // Messages for pages that connect later.
  Bytes hello_, watcher_hello_, flow_;
  std::map<std::string, Bytes> contents_;
  std::vector<std::pair<Bytes, bool>> blocks_;  ///< Since the newest full block.

  boost::asio::steady_timer busy_timer_, life_timer_, start_timer_;
  /// awaits_: since the last request, the engine has sent nothing. is_busy_: pages were told that the engine is busy.
  bool awaits_ = false, is_busy_ = false;
  int silent_checks_ = 0;                                  ///< Number of consecutive checks without a message from the
                                                           ///< engine.
  std::shared_ptr<int> alive_ = std::make_shared<int>(0);  ///< Callbacks hold a weak pointer to it, to detect that the
                                                           ///< session was destroyed.
};

/// {"message": "error", ...}
std::string ErrorMessage(const Diagnostic& problem, const std::string& id = {});

}  // namespace soarbox::serve
