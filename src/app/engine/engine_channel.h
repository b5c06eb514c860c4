// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "serve/frames.h"

namespace soarbox::app {

/// An engine's end of the connection to the server that started it. It never waits for the server to read: text is
/// kept until it goes out, and what a scene looks like is left out while much is waiting. The real path of the place
/// holds its secret: pages see "/place" instead, in what they are sent and in the files that they name.
class EngineChannel {
 public:
  /// Owns the descriptor of a connected stream socket. Without sockets the other end is JavaScript
  /// (engine_channel_absent.cpp), and there is one channel at a time.
  explicit EngineChannel(int socket);
  ~EngineChannel();
  EngineChannel(const EngineChannel&) = delete;
  EngineChannel& operator=(const EngineChannel&) = delete;

  /// Waits at most so long for something to come, and sends what waits meanwhile. What has come, text only.
  std::vector<std::string> Receive(int most_ms);
  void Send(serve::FrameKind kind, std::string_view bytes);
  /// False: too much waits, and the block was left out.
  bool SendScene(std::string_view block, bool is_full);
  /// Whether the server is still there.
  bool is_open() const { return is_open_; }

 private:
  void Flush();
  std::string Hidden(std::string_view text) const;
  std::string Found(std::string text) const;

  std::string root_;  ///< Of the place; empty: nothing is hidden.
  int socket_;
  bool is_open_ = true;
  serve::FrameReader reader_;
  std::string waiting_;
};

}  // namespace soarbox::app
