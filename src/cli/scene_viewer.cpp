// SPDX-License-Identifier: BSD-2-Clause
#include "cli/scene_viewer.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <memory>

namespace soarbox::cli {
namespace {

class Socket {
 public:
  explicit Socket(int family) : descriptor_(::socket(family, SOCK_STREAM | SOCK_CLOEXEC, 0)) {}
  ~Socket() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  Socket(const Socket&) = delete;
  Socket& operator=(const Socket&) = delete;

  bool Connect(const sockaddr* address, socklen_t size) {
    const timeval patience{1, 0};
    return descriptor_ >= 0 && ::setsockopt(descriptor_, SOL_SOCKET, SO_SNDTIMEO, &patience, sizeof patience) == 0 &&
           ::connect(descriptor_, address, size) == 0;
  }
  bool Send(std::string_view text) {
    while (!text.empty()) {
      const ssize_t sent = ::send(descriptor_, text.data(), text.size(), MSG_NOSIGNAL);
      if (sent < 0 && errno == EINTR) continue;
      if (sent <= 0) return false;
      text.remove_prefix(static_cast<std::size_t>(sent));
    }
    return true;
  }

 private:
  int descriptor_;
};

}  // namespace

kernel::imagery::ViewerSink ConnectToViewer(const std::string& where, std::string& why) {
  std::shared_ptr<Socket> socket;
  bool connected = false;
  const bool is_port =
      !where.empty() && std::all_of(where.begin(), where.end(), [](char c) { return c >= '0' && c <= '9'; });
  if (is_port) {
    int port = 0;
    std::from_chars(where.data(), where.data() + where.size(), port);
    if (port < 1 || port > 65535) {
      why = "a port is a number from 1 to 65535, not " + where;
      return {};
    }
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socket = std::make_shared<Socket>(AF_INET);
    connected = socket->Connect(reinterpret_cast<const sockaddr*>(&address), sizeof address);
  } else {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    if (where.size() >= sizeof address.sun_path) {
      why = "the name of the socket is too long";
      return {};
    }
    std::copy(where.begin(), where.end(), address.sun_path);
    socket = std::make_shared<Socket>(AF_UNIX);
    connected = socket->Connect(reinterpret_cast<const sockaddr*>(&address), sizeof address);
  }
  if (!connected) {
    why = std::string(std::strerror(errno)) + ". Start the viewer first, and give the port that it listens on";
    return {};
  }
  return [socket](std::string_view line) { return socket->Send(line); };
}

}  // namespace soarbox::cli
