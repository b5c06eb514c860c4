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
  std::string address = "127.0.0.1";  ///< Only this machine, unless told otherwise: there is a command shell behind it.
  bool local = true;                  ///< Listen at a file of this user's too (wire/local_socket.h).
  std::string secret;                 ///< What clients must show first (wire/secret.h); empty: nothing.
  /// Whoever comes when there are so many is told so and sent away, unless one has said nothing yet: the oldest of
  /// those makes room.
  int max_clients = 128;
  int patience_ms = 30'000;  ///< wire::ChannelLimits::patience
  /// Bytes that may wait for a client that does not read. Trace above half of it is dropped and counted; a client that
  /// exceeds it is disconnected.
  std::size_t max_waiting_bytes = 16u << 20;
  /// How long the kernel waits for a client's answer to an event before it goes on without.
  int answer_timeout_ms = 2000;
};

/// Serves a kernel to clients over TCP and local sockets. A thread of its own reads and writes; what clients ask for is
/// carried out by
/// whoever calls Serve() while it holds the kernel. A client that is slow, silent or hostile never stalls the kernel
/// for longer than the time-out, and only once.
class Listener {
 public:
  /// An error that names the address and the port if it cannot be listened on.
  static Result<std::unique_ptr<Listener>> Open(KernelHost& host, const ListenerOptions& options);
  ~Listener();

  int port() const;
  /// Carries out what is waiting. The caller holds the kernel. True if there was anything.
  bool Serve();
  /// Called from the reading thread when something is waiting.
  void SetWake(std::function<void()> wake);
  /// Disconnects all and stops listening. The caller holds the kernel.
  void Close();

 private:
  struct State;
  explicit Listener(std::unique_ptr<State> state);

  std::unique_ptr<State> state_;
};

}  // namespace soarbox::server
