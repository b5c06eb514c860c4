// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "diagnostics/result.h"

namespace soarbox::wire {

struct ChannelLimits {
  /// Maximum number of bytes that wait to be sent. Above half of it, droppable messages are dropped; above it, the
  /// channel is closed.
  std::size_t max_waiting_out = 16u << 20;
  /// Maximum number of received bytes that wait to be processed. Above it, nothing more is read from the socket.
  std::size_t max_waiting_in = 128u << 20;
  /// Maximum time for the peer's first complete message, and for completing each message that it has begun. If it is
  /// exceeded, the channel is closed. 0: no limit.
  std::chrono::milliseconds patience{0};
};

/// The thread that reads from and writes to sockets. Channels and acceptors use it; destroy them first.
class IoThread {
 public:
  IoThread();
  ~IoThread();
  IoThread(const IoThread&) = delete;
  IoThread& operator=(const IoThread&) = delete;

  struct Contents;
  Contents& contents() { return *contents_; }

 private:
  std::shared_ptr<Contents> contents_;
};

/// One connection: framed messages in both directions. All functions are callable from any thread. Only Wait blocks.
class Channel {
 public:
  struct Socket;

  Channel(std::shared_ptr<Socket> socket);
  ~Channel();

  /// Sends a message, or queues it. A `droppable` message may be dropped if the peer does not keep up. It may be
  /// delayed by a millisecond, so that several are sent together. The order of messages is preserved. Returns false if
  /// it was dropped or if the channel is closed.
  bool Send(const std::string& message, bool droppable = false);
  /// Appends to the message of this series that SendOpen started. Returns false if it has been sent or would become too
  /// long: then start a new one.
  bool Join(std::uint64_t series, std::string_view part);
  /// Starts a droppable message of `head`, `part` and `tail`. For a moment, until another message is sent, further
  /// parts can be appended with Join: many small parts of text or trace then cost as much as one.
  bool SendOpen(std::uint64_t series, std::string_view head, std::string_view part, std::string_view tail);
  /// Removes and returns the next received message in `message`. Returns false if there is none.
  bool Pop(std::string& message);
  /// Waits for a message. Returns false after the timeout, or if the channel is closed and empty.
  bool Wait(std::string& message, std::chrono::milliseconds timeout);
  /// No more messages can be sent or received; received ones can still be read.
  bool closed() const;
  void Close();
  std::uint64_t dropped() const;
  /// No complete message has been received yet.
  bool silent() const;
  /// Calls the function of SetWake after this delay, even if no message has arrived.
  void WakeAfter(std::chrono::milliseconds delay);
  /// The function is called, on the thread for sockets, when a message arrives or the channel is closed.
  void SetWake(std::function<void()> wake);

 private:
  std::shared_ptr<Socket> socket_;
};

/// Whether this build supports sockets. If not, each of the functions below returns an error.
bool HasSockets();

/// Connects to a server. Errors contain address and port.
Result<std::unique_ptr<Channel>> Connect(IoThread& thread, const std::string& address, int port,
                                         const ChannelLimits& limits = {});

/// Connects to a local socket, given by its file.
Result<std::unique_ptr<Channel>> ConnectLocal(IoThread& thread, const std::string& path,
                                              const ChannelLimits& limits = {});

/// Listens on a port or at the file of a local socket, and accepts channels.
class Acceptor {
 public:
  struct Contents;

  /// With `port` -1, any free port. Errors contain address and port.
  static Result<std::unique_ptr<Acceptor>> Open(IoThread& thread, const std::string& address, int port,
                                                const ChannelLimits& limits,
                                                std::function<void(std::unique_ptr<Channel>)> accepted);
  /// Listens at a file, which is removed with the acceptor.
  static Result<std::unique_ptr<Acceptor>> OpenLocal(IoThread& thread, const std::string& path,
                                                     const ChannelLimits& limits,
                                                     std::function<void(std::unique_ptr<Channel>)> accepted);
  explicit Acceptor(std::shared_ptr<Contents> contents);
  ~Acceptor();
  /// Returns 0 if it listens at a file.
  int port() const;

 private:
  std::shared_ptr<Contents> contents_;
};

}  // namespace soarbox::wire
