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
  /// Bytes that may wait for the other side to read them. Messages that may be dropped are, above half of it; beyond it
  /// the channel is closed.
  std::size_t max_waiting_out = 16u << 20;
  /// Bytes that may wait to be taken here; above it nothing more is read from the other side.
  std::size_t max_waiting_in = 128u << 20;
  /// How long the other side may take for its first whole message, and for each that it has begun; then the channel is
  /// closed. 0: as long as it likes.
  std::chrono::milliseconds patience{0};
};

/// A thread that moves the bytes of sockets. Channels and acceptors live on it; destroy them first.
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

/// One connection: messages in both directions, framed. All functions may be called from any thread; none blocks but
/// Wait.
class Channel {
 public:
  struct Socket;

  Channel(std::shared_ptr<Socket> socket);
  ~Channel();

  /// Sends a message, or queues it. `droppable`: it may be left out if the other side does not keep up, and may wait
  /// for a millisecond, so that many go together; the order of messages stays. False if it was left out or the channel
  /// is closed.
  bool Send(const std::string& message, bool droppable = false);
  /// Adds to a message of this series that SendOpen left open. False if there is none any more: begin one.
  bool Join(std::uint64_t series, std::string_view part);
  /// Sends `head`, `part` and `tail` as a message that may be left out. For a moment, and unless another message goes
  /// first, further parts can join: many small pieces of text or trace then cost as much as one.
  bool SendOpen(std::uint64_t series, std::string_view head, std::string_view part, std::string_view tail);
  /// Takes a message that has come; false if there is none.
  bool Pop(std::string& message);
  /// Waits for a message; false if the time is over, or the channel closed and empty.
  bool Wait(std::string& message, std::chrono::milliseconds timeout);
  /// No more messages can come or go; those that came can still be taken.
  bool closed() const;
  void Close();
  std::uint64_t dropped() const;
  /// No whole message has come yet.
  bool silent() const;
  /// Calls the function given to SetWake after this time, even if no message has come.
  void WakeAfter(std::chrono::milliseconds delay);
  /// Called (from the thread that moves bytes) when a message has come or the channel was closed.
  void SetWake(std::function<void()> wake);

 private:
  std::shared_ptr<Socket> socket_;
};

/// Whether this build has sockets; without them, each of the functions below returns an error.
bool HasSockets();

/// Connects. The error names address and port.
Result<std::unique_ptr<Channel>> Connect(IoThread& thread, const std::string& address, int port,
                                         const ChannelLimits& limits = {});

/// Connects to a socket of this machine, given by its file.
Result<std::unique_ptr<Channel>> ConnectLocal(IoThread& thread, const std::string& path,
                                              const ChannelLimits& limits = {});

/// Listens on a port, or at a file of this machine, and hands out channels.
class Acceptor {
 public:
  struct Contents;

  /// `port` -1: any free one. The error names address and port.
  static Result<std::unique_ptr<Acceptor>> Open(IoThread& thread, const std::string& address, int port,
                                                const ChannelLimits& limits,
                                                std::function<void(std::unique_ptr<Channel>)> accepted);
  /// Listens at a file; it goes when the acceptor does.
  static Result<std::unique_ptr<Acceptor>> OpenLocal(IoThread& thread, const std::string& path,
                                                     const ChannelLimits& limits,
                                                     std::function<void(std::unique_ptr<Channel>)> accepted);
  explicit Acceptor(std::shared_ptr<Contents> contents);
  ~Acceptor();
  /// 0 for one that listens at a file.
  int port() const;

 private:
  std::shared_ptr<Contents> contents_;
};

}  // namespace soarbox::wire
