// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <sys/types.h>

#include <array>
#include <boost/asio/io_context.hpp>
#include <boost/asio/local/stream_protocol.hpp>
#include <boost/asio/steady_timer.hpp>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "diagnostics/result.h"
#include "serve/frames.h"
#include "serve/server_settings.h"

namespace soarbox::serve {

/// The process of one world. It is started without a shell, with its own home, environment, limits and process group.
/// When its connection is closed, it should end by itself; after 3 s it is killed.
class EngineProcess : public std::enable_shared_from_this<EngineProcess> {
 public:
  /// How a process ended. If it sent a reason, that explains more.
  enum class Ending : std::uint8_t {
    kGood,     ///< By itself, with the status 0 or 1.
    kRefused,  ///< By itself: it could not begin or go on, or its memory was exhausted.
    kCrashed,
  };
  struct Hooks {
    std::function<void(Frame)> on_frame;
    std::function<void(Ending ending)> on_end;  ///< Called after it has ended.
  };
  /// A process without a listener. The caller must pass it to Adopt or Discard.
  struct Spawned {
    pid_t pid = 0;
    int socket = -1;
  };
  /// Starts the process. May take milliseconds. Can be called on any thread.
  static Result<Spawned> Spawn(const std::vector<std::string>& words, const Place& place, const Limits& limits);
  /// Listens to a process, on the thread of `io`.
  static std::shared_ptr<EngineProcess> Adopt(boost::asio::io_context& io, const Spawned& spawned, Hooks hooks);
  ~EngineProcess();
  EngineProcess(const EngineProcess&) = delete;
  EngineProcess& operator=(const EngineProcess&) = delete;

  /// Sends a message to the process. Considers the process as hung if more than 16 MiB wait to be read.
  void Send(std::string text);
  /// Asks the process to end, and kills it after 3 s. Hooks are not called any more; `on_gone` is called when it has
  /// ended.
  void End(std::function<void()> on_gone = {});
  /// Kills the process at once. Hooks are called as usual.
  void Kill();

 private:
  explicit EngineProcess(boost::asio::io_context& io);
  void Read();
  void Write();
  void AwaitEnd();

  pid_t pid_ = 0;
  boost::asio::local::stream_protocol::socket socket_;
  boost::asio::steady_timer timer_;
  Hooks hooks_;
  FrameReader reader_;
  std::array<char, 65536> bytes_{};
  std::deque<std::string> waiting_;
  std::size_t waiting_bytes_ = 0;
  bool is_closed_ = false;
  int waits_ = 0;
};

}  // namespace soarbox::serve
