// SPDX-License-Identifier: BSD-2-Clause
#include "app/engine/engine_channel.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>

namespace soarbox::app {
namespace {

/// Above this, scenes are left out; above the second, whoever does not read is not there.
constexpr std::size_t kScenesWaitAbove = 256u << 10, kMostWaiting = 64u << 20;

}  // namespace

EngineChannel::EngineChannel(int socket) : socket_(socket) {
  fcntl(socket_, F_SETFL, O_NONBLOCK);
  fcntl(socket_, F_SETFD, FD_CLOEXEC);
}

EngineChannel::~EngineChannel() {
  close(socket_);
}

std::vector<std::string> EngineChannel::Receive(int most_ms) {
  std::vector<std::string> texts;
  if (!is_open_) return texts;
  pollfd there{socket_, static_cast<short>(waiting_.empty() ? POLLIN : POLLIN | POLLOUT), 0};
  if (poll(&there, 1, most_ms) <= 0) return texts;
  Flush();
  std::array<char, 65536> bytes;
  while (is_open_) {
    const ssize_t got = recv(socket_, bytes.data(), bytes.size(), 0);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) break;
    is_open_ = got > 0;
    if (is_open_) reader_.Add({bytes.data(), static_cast<std::size_t>(got)});
  }
  while (std::optional<serve::Frame> frame = reader_.Take())
    if (frame->kind == serve::FrameKind::kText) texts.push_back(std::move(frame->bytes));
  is_open_ = is_open_ && !reader_.is_broken();
  return texts;
}

bool EngineChannel::SendScene(std::string_view block, bool is_full) {
  Flush();
  if (waiting_.size() > kScenesWaitAbove) return false;
  Send(is_full ? serve::FrameKind::kFull : serve::FrameKind::kScene, block);
  return true;
}

void EngineChannel::Send(serve::FrameKind kind, std::string_view bytes) {
  if (!is_open_ || bytes.size() > serve::kMostFrameBytes) return;
  waiting_ += serve::WriteFrame(kind, bytes);
  Flush();
  is_open_ = is_open_ && waiting_.size() <= kMostWaiting;
}

void EngineChannel::Flush() {
  std::size_t sent = 0;
  while (is_open_ && sent < waiting_.size()) {
    const ssize_t put = send(socket_, waiting_.data() + sent, waiting_.size() - sent, MSG_NOSIGNAL);
    if (put < 0 && errno == EINTR) continue;
    if (put < 0) {
      is_open_ = errno == EAGAIN || errno == EWOULDBLOCK;
      break;
    }
    sent += static_cast<std::size_t>(put);
  }
  waiting_.erase(0, sent);
}

}  // namespace soarbox::app
