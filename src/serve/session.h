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
#include "serve/settings.h"
#include "serve/work.h"

namespace soarbox::serve {

/// What is sent to several pages is kept once.
using Bytes = std::shared_ptr<const std::string>;

/// A page that looks at a run, as its session sees it. It never makes the session wait.
class Viewer {
 public:
  virtual ~Viewer() = default;
  /// `key`: a message of the same key that still waits is replaced; empty: none is.
  virtual void SendText(Bytes text, const std::string& key) = 0;
  virtual void SendScene(Bytes block, bool is_full) = 0;
  /// Whether it may ask for anything; if not, it may only say which panels it looks at.
  virtual bool MayAsk() const = 0;
};

/// One run of one place: its engine, the pages that look at it, and what a page that comes later has to be told.
/// A place has one process at most: `Open` ends the one there is, and the next one starts when that is gone.
class Session : public std::enable_shared_from_this<Session> {
 public:
  /// Whether this session may start a process now; the error says why not.
  using MayStart = std::function<Result<void>(const Session&)>;
  Session(boost::asio::io_context& io, Work& work, const Settings& settings, Place place, MayStart may_start);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// Starts a run instead of the one there is: "lesson:01-a-rule", "scenario:scout", "recording:run-0001.soarrec".
  /// If it is called again before that run has begun, only the last call counts. `refuse` is called with the reason if
  /// it cannot be opened; the run that there was then goes on.
  void Open(const std::string& what, std::function<void(const Diagnostic&)> refuse);
  /// `tab` distinguishes the tabs of a browser, so that one that connects again is not taken for another; may be empty.
  void Join(Viewer& viewer, const std::string& tab);
  void Leave(Viewer& viewer);
  /// A message of a page.
  void Take(Viewer& viewer, std::string text);
  /// What each page of the person whose run it is gets when it joins, and again after Greet; empty: nothing.
  void SetGreeting(std::function<std::string()> greeting) { greeting_ = std::move(greeting); }
  void Greet();
  /// What the person does, as far as the contents that were sent last say it.
  Activity::Standing Standing();
  /// Ends a run that nobody has looked at for long, or that has lasted too long.
  void EndIfIdle();
  /// Ends the run; pages are told why.
  void End(const std::string& why);

  /// Whether it has a process, or is about to.
  bool is_running() const { return engine_ != nullptr || phase_ == Phase::kEnding || phase_ == Phase::kStarting; }
  /// Address of the page that came first.
  const std::string& address() const { return address_; }
  void set_address(const std::string& address) { address_ = address; }
  std::size_t viewers() const { return viewers_.size(); }
  const Place& place() const { return place_; }
  const std::string& what() const { return what_; }

 private:
  using Clock = std::chrono::steady_clock;
  /// What is done for a run that was asked for.
  enum class Phase : std::uint8_t {
    kRest,      ///< Nothing.
    kAsking,    ///< Looks whether there is such a thing.
    kEnding,    ///< Waits for the end of the run before.
    kStarting,  ///< Starts the process.
  };
  struct Wanted {
    std::string what;
    std::function<void(const Diagnostic&)> refuse;
  };
  /// Begins the next phase for what is wanted.
  void Advance();
  void EndForNext(const std::string& what, const std::vector<std::string>& words);
  void StartLater(const std::string& what, const std::vector<std::string>& words);
  void StartNext(const std::string& what, const std::vector<std::string>& words);
  void OnStarted(const std::string& what, const EngineProcess::Spawned& spawned);
  void Forget();
  void OnFrame(Frame frame);
  void OnEnd(const std::string& last_words, bool is_good);
  void Tell(const std::string& text, const std::string& key = {});
  void TellPresence();
  /// What somebody looks at who may not ask for anything else.
  Result<void> Watch(const Viewer& viewer, const PageMessage& message);
  /// Lets this page alone edit texts, and tells all.
  void HandTextsTo(const Viewer* viewer);
  void AwaitAnswer();
  void NoLongerBusy();
  /// Looks twice a second whether the engine still lives.
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
  std::optional<PlaceLock> lock_;  ///< While there is an engine.
  std::vector<Viewer*> viewers_;
  std::map<const Viewer*, std::vector<std::string>> watched_;  ///< Panels that those who may only watch look at.
  const Viewer* editor_ = nullptr;                             ///< The page that may edit texts.
  std::map<const Viewer*, std::string> tabs_;
  Clock::time_point began_, looked_at_;

  std::function<std::string()> greeting_;
  Activity activity_;
  std::array<Bytes, 3> looked_;  ///< The contents that activity_ has seen.

  // What is told to a page that comes later.
  Bytes hello_, watcher_hello_, flow_;
  std::map<std::string, Bytes> contents_;
  std::vector<std::pair<Bytes, bool>> blocks_;  ///< Since the newest full one.

  boost::asio::steady_timer busy_timer_, life_timer_, start_timer_;
  bool awaits_ = false, is_busy_ = false;
  int silent_checks_ = 0;                                  ///< In a row, in which the engine had sent nothing.
  std::shared_ptr<int> alive_ = std::make_shared<int>(0);  ///< For what comes back when it may be gone.
};

/// {"message": "error", ...}
std::string ErrorMessage(const Diagnostic& problem, const std::string& id = {});

}  // namespace soarbox::serve
