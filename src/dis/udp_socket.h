// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "diagnostics/result.h"

namespace soarbox::dis {

/// Sends and receives the datagrams of an exercise.
///
/// 127.0.0.1 reaches all programs on this machine that listen on the port, but no other machine. A multicast group
/// (224.0.0.0 to 239.255.255.255) is sent through `interface`; with 127.0.0.1 it stays on this machine, too. Other
/// addresses are a host or a broadcast address. Never blocks. Not thread-safe.
class UdpSocket {
 public:
  static Result<std::unique_ptr<UdpSocket>> Open(const std::string& address, std::uint16_t port,
                                                 const std::string& interface);
  ~UdpSocket();
  UdpSocket(const UdpSocket&) = delete;
  UdpSocket& operator=(const UdpSocket&) = delete;

  /// Returns false if the operating system did not accept the datagram: no buffer space, or no route.
  bool Send(std::span<const std::byte> datagram);
  /// The next received datagram, valid until the next call; empty if there is none.
  std::span<const std::byte> Receive();
  /// Whether no other machine can receive from us or send to us.
  bool IsOfThisMachine() const;

 private:
  struct Impl;
  explicit UdpSocket(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace soarbox::dis
