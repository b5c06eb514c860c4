// SPDX-License-Identifier: BSD-2-Clause
#include "app/engine/engine_channel.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <filesystem>

namespace soarbox::app {
namespace {

/// Limits of the bytes that wait to be sent. Above the first, scenes are left out; above the second, the connection is
/// considered closed.
constexpr std::size_t kScenesWaitAbove = 256u << 10, kMostWaiting = 64u << 20;

std::string Replaced(std::string text, std::string_view what, std::string_view with) {
  if (what.empty()) return text;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + with.size()))
    text.replace(at, what.size(), with);
  return text;
}

}  // namespace

EngineChannel::EngineChannel(int socket) : socket_(socket) {
  std::error_code error;
  if (const char* place = std::getenv("SOARBOX_PLACE"))
    root_ = std::filesystem::weakly_canonical(place, error).string();
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
    if (frame->kind == serve::FrameKind::kText) texts.push_back(Found(std::move(frame->bytes)));
  is_open_ = is_open_ && !reader_.is_broken();
  return texts;
}

bool EngineChannel::SendScene(std::string_view block, bool is_full) {
  Flush();
  if (waiting_.size() > kScenesWaitAbove) return false;
  Send(is_full ? serve::FrameKind::kFull : serve::FrameKind::kScene, block);
  return true;
}

std::string EngineChannel::Hidden(std::string_view text) const {
  return Replaced(std::string(text), root_, serve::kShownRoot);
}

std::string EngineChannel::Found(std::string text) const {
  if (root_.empty()) return text;
  // Replaces it only at the beginning of a JSON string, as a path or as the address of a file, and not within texts
  // that the user types.
  const std::string shown(serve::kShownRoot);
  text = Replaced(std::move(text), "\"" + shown + "/", "\"" + root_ + "/");
  return Replaced(std::move(text), "\"file://" + shown + "/", "\"file://" + root_ + "/");
}

void EngineChannel::Send(serve::FrameKind kind, std::string_view bytes) {
  const bool is_scene = kind == serve::FrameKind::kScene || kind == serve::FrameKind::kFull;
  const std::string hidden = is_scene ? std::string() : Hidden(bytes);
  if (!is_scene) bytes = hidden;
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
