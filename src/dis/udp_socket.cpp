// SPDX-License-Identifier: BSD-2-Clause
#include "dis/udp_socket.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <optional>
#include <utility>
#include <vector>

namespace soarbox::dis {
namespace {

constexpr int kRoomOfSystem_bytes = 4 << 20;
constexpr std::uint32_t kLoopbackNet = 0x7F000000, kLoopbackBroadcast = 0x7FFFFFFF;

bool IsLoopback(std::uint32_t host) {
  return (host & 0xFF000000) == kLoopbackNet;
}
bool IsMulticast(std::uint32_t host) {
  return (host & 0xF0000000) == 0xE0000000;
}

sockaddr_in Address(std::uint32_t host, std::uint16_t port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(host);
  address.sin_port = htons(port);
  return address;
}

/// In host byte order; nothing if it is not a numeric IPv4 address.
std::optional<std::uint32_t> ParseHost(const std::string& text) {
  in_addr parsed{};
  if (inet_pton(AF_INET, text.c_str(), &parsed) != 1) return std::nullopt;
  return ntohl(parsed.s_addr);
}

template <class Value>
bool Set(int socket, int level, int option, const Value& value) {
  return setsockopt(socket, level, option, &value, sizeof value) == 0;
}

}  // namespace

struct UdpSocket::Impl {
  ~Impl() {
    for (const int socket : sockets) close(socket);
  }

  /// Opens a socket that receives datagrams for this address; the first one also sends.
  bool Listen(std::uint32_t host, std::uint16_t port) {
    const int made = socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
    if (made < 0) return false;
    sockets.push_back(made);
    const int yes = 1;
    // Several programs of this machine may take part in one exercise.
    Set(made, SOL_SOCKET, SO_REUSEADDR, yes);
    Set(made, SOL_SOCKET, SO_BROADCAST, yes);
    Set(made, SOL_SOCKET, SO_RCVBUF, kRoomOfSystem_bytes);
    const sockaddr_in here = Address(host, port);
    return bind(made, reinterpret_cast<const sockaddr*>(&here), sizeof here) == 0;
  }

  std::vector<int> sockets;
  sockaddr_in to{};
  bool is_of_this_machine = false;
  std::size_t next = 0;  ///< The socket that is read first.
  std::array<std::byte, 65536> room;
};

UdpSocket::UdpSocket(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
UdpSocket::~UdpSocket() = default;

Result<std::unique_ptr<UdpSocket>> UdpSocket::Open(const std::string& address, std::uint16_t port,
                                                   const std::string& interface) {
  Diagnostic problem;
  const std::optional<std::uint32_t> host = ParseHost(address), over = ParseHost(interface);
  if (!host || !over) {
    problem.message = "'" + (host ? interface : address) + "' is not an IPv4 address";
    problem.hint = "write it in numbers, such as 127.0.0.1 (this machine) or 239.1.2.3 (a multicast group)";
    return problem;
  }
  auto impl = std::make_unique<Impl>();
  bool good = false;
  if (IsLoopback(*host)) {
    // A broadcast reaches all listeners of this machine; a datagram to 127.0.0.1 reaches only one.
    impl->is_of_this_machine = true;
    impl->to = Address(kLoopbackBroadcast, port);
    good = impl->Listen(kLoopbackBroadcast, port);
    if (good) impl->Listen(*host, port);
  } else if (IsMulticast(*host)) {
    impl->is_of_this_machine = IsLoopback(*over);
    impl->to = Address(*host, port);
    good = impl->Listen(*host, port);
    ip_mreq group{};
    group.imr_multiaddr.s_addr = htonl(*host);
    group.imr_interface.s_addr = htonl(*over);
    good = good && Set(impl->sockets.front(), IPPROTO_IP, IP_ADD_MEMBERSHIP, group) &&
           Set(impl->sockets.front(), IPPROTO_IP, IP_MULTICAST_IF, group.imr_interface);
  } else {
    impl->to = Address(*host, port);
    good = impl->Listen(INADDR_ANY, port);
  }
  if (!good) {
    problem.message =
        "the DIS port " + std::to_string(port) + " of " + address + " cannot be opened: " + strerror(errno);
    problem.hint = "another program may keep the port to itself, or this machine has no such network";
    return problem;
  }
  return std::unique_ptr<UdpSocket>(new UdpSocket(std::move(impl)));
}

bool UdpSocket::Send(std::span<const std::byte> datagram) {
  return sendto(impl_->sockets.front(), datagram.data(), datagram.size(), 0,
                reinterpret_cast<const sockaddr*>(&impl_->to), sizeof impl_->to) >= 0;
}

std::span<const std::byte> UdpSocket::Receive() {
  for (std::size_t tried = 0; tried < impl_->sockets.size();) {
    sockaddr_in from{};
    socklen_t size = sizeof from;
    const ssize_t read = recvfrom(impl_->sockets[impl_->next], impl_->room.data(), impl_->room.size(), 0,
                                  reinterpret_cast<sockaddr*>(&from), &size);
    if (read < 0) {
      impl_->next = (impl_->next + 1) % impl_->sockets.size();
      ++tried;
      continue;
    }
    if (impl_->is_of_this_machine && !IsLoopback(ntohl(from.sin_addr.s_addr))) continue;
    if (read > 0) return {impl_->room.data(), static_cast<std::size_t>(read)};
  }
  return {};
}

bool UdpSocket::IsOfThisMachine() const {
  return impl_->is_of_this_machine;
}

}  // namespace soarbox::dis
