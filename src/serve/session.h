// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "diagnostics/result.h"
#include "serve/engine_process.h"
#include "serve/place_lock.h"
#include "serve/settings.h"

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
class Session {
 public:
  Session(boost::asio::io_context& io, const Settings& settings, Place place);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// Starts a run instead of the one there is: "lesson:01-a-rule", "scenario:scout", "recording:run-0001.soarrec".
  Result<void> Open(const std::string& what);
  void Join(Viewer& viewer);
  void Leave(Viewer& viewer);
  /// A message of a page.
  void Take(Viewer& viewer, std::string text);
  /// Ends a run that nobody has looked at for long, or that has lasted too long.
  void EndIfIdle();
  /// Ends the run; pages are told why.
  void End(const std::string& why);

  bool is_running() const { return engine_ != nullptr; }
  std::size_t viewers() const { return viewers_.size(); }
  const Place& place() const { return place_; }
  const std::string& what() const { return what_; }

 private:
  using Clock = std::chrono::steady_clock;
  void OnFrame(Frame frame);
  void OnEnd(const std::string& last_words, bool is_good);
  void Tell(const std::string& text, const std::string& key = {});
  void TellPresence();
  /// What somebody looks at who may not ask for anything else.
  Result<void> Watch(const Viewer& viewer, const std::string& text);
  void AwaitAnswer();
  void NoLongerBusy();

  boost::asio::io_context& io_;
  const Settings& settings_;
  Place place_;
  std::string what_;
  std::shared_ptr<EngineProcess> engine_;
  std::optional<PlaceLock> lock_;  ///< While there is an engine.
  std::vector<Viewer*> viewers_;
  std::map<const Viewer*, std::vector<std::string>> watched_;  ///< Panels that those who may only watch look at.
  Clock::time_point began_, looked_at_;

  // What is told to a page that comes later.
  Bytes hello_, watcher_hello_, flow_;
  std::map<std::string, Bytes> contents_;
  std::vector<std::pair<Bytes, bool>> blocks_;  ///< Since the newest full one.

  boost::asio::steady_timer busy_timer_;
  bool awaits_ = false, is_busy_ = false;
  std::shared_ptr<int> alive_ = std::make_shared<int>(0);  ///< For what comes back when it may be gone.
};

/// {"message": "error", ...}
std::string ErrorMessage(const Diagnostic& problem, const std::string& id = {});

}  // namespace soarbox::serve
