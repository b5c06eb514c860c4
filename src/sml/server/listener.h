// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "diagnostics/result.h"

namespace soarbox::server {

class KernelHost;

struct ListenerOptions {
  int port = 12121;                   ///< -1: any free port.
  std::string address = "127.0.0.1";  ///< By default only this machine, because clients can execute commands.
  bool local = true;                  ///< Also listen at a file of this user (wire/local_socket.h).
  std::string secret;                 ///< Clients must present it first (wire/secret.h); empty: none is needed.
  /// Further clients are refused with a message. But if some clients have not sent anything yet, the oldest of these is
  /// disconnected instead.
  int max_clients = 128;
  int patience_ms = 30'000;  ///< wire::ChannelLimits::patience
  /// Maximum number of unsent bytes for a client that does not read. Above half of it, trace is dropped and counted;
  /// above it, the client is disconnected.
  std::size_t max_waiting_bytes = 16u << 20;
  /// Maximum time that the kernel waits for a client's answer to an event.
  int answer_timeout_ms = 2000;
};

/// Serves a kernel to clients over TCP and local sockets. A separate thread reads and writes; the thread that calls
/// Serve() while it holds the kernel executes the requests. A slow, silent or hostile client cannot stall the kernel
/// for longer than the time-out, and only once.
class Listener {
 public:
  /// Returns an error with the address and the port if it cannot listen.
  static Result<std::unique_ptr<Listener>> Open(KernelHost& host, const ListenerOptions& options);
  ~Listener();

  int port() const;
  /// Executes pending requests. The caller must hold the kernel. Returns true if there were any.
  bool Serve();
  /// The function is called on the reading thread when a request arrives.
  void SetWake(std::function<void()> wake);
  /// Disconnects all clients and stops listening. The caller must hold the kernel.
  void Close();

 private:
  struct State;
  explicit Listener(std::unique_ptr<State> state);

  std::unique_ptr<State> state_;
};

}  // namespace soarbox::server
