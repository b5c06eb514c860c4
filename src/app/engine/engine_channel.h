// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "serve/frames.h"

namespace soarbox::app {

/// An engine's end of the connection to the server that started it. It never blocks on sending: text is queued, and
/// scenes are left out while much data is queued. The real path of a user's place contains its secret. Pages see
/// "/place" instead, both in messages to them and in file names that they send.
class EngineChannel {
 public:
  /// Owns the descriptor of a connected stream socket. Without sockets, the other end is JavaScript
  /// (engine_channel_absent.cpp), and there is one channel at a time.
  explicit EngineChannel(int socket);
  ~EngineChannel();
  EngineChannel(const EngineChannel&) = delete;
  EngineChannel& operator=(const EngineChannel&) = delete;

  /// Waits at most `most_ms` for data, or until queued data can be sent. Returns the received text frames.
  std::vector<std::string> Receive(int most_ms);
  void Send(serve::FrameKind kind, std::string_view bytes);
  /// Returns false if too much data is queued, and the block was left out.
  bool SendScene(std::string_view block, bool is_full);
  /// Whether the server is still connected.
  bool is_open() const { return is_open_; }

 private:
  void Flush();
  std::string Hidden(std::string_view text) const;
  std::string Found(std::string text) const;

  std::string root_;  ///< Real path of the place; empty: no paths are hidden.
  int socket_;
  bool is_open_ = true;
  serve::FrameReader reader_;
  std::string waiting_;
};

}  // namespace soarbox::app
