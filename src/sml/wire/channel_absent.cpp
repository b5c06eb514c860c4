// SPDX-License-Identifier: BSD-2-Clause
// The implementation for platforms without sockets (WebAssembly): all functions return errors.
#include "diagnostics/problem.h"
#include "sml/wire/channel.h"

namespace soarbox::wire {
namespace {

Diagnostic NoSockets() {
  return NewProblem("this build has no sockets", "use the native soarbox for connections to other programs");
}

}  // namespace

struct IoThread::Contents {};
struct Channel::Socket {};
struct Acceptor::Contents {};

IoThread::IoThread() = default;
IoThread::~IoThread() = default;

Channel::Channel(std::shared_ptr<Socket> socket) : socket_(std::move(socket)) {}
Channel::~Channel() = default;
bool Channel::Send(const std::string&, bool) {
  return false;
}
bool Channel::Join(std::uint64_t, std::string_view) {
  return false;
}
bool Channel::SendOpen(std::uint64_t, std::string_view, std::string_view, std::string_view) {
  return false;
}
bool Channel::Pop(std::string&) {
  return false;
}
bool Channel::Wait(std::string&, std::chrono::milliseconds) {
  return false;
}
bool Channel::closed() const {
  return true;
}
void Channel::Close() {}
std::uint64_t Channel::dropped() const {
  return 0;
}
bool Channel::silent() const {
  return true;
}
void Channel::WakeAfter(std::chrono::milliseconds) {}
void Channel::SetWake(std::function<void()>) {}

bool HasSockets() {
  return false;
}

Result<std::unique_ptr<Channel>> Connect(IoThread&, const std::string&, int, const ChannelLimits&) {
  return NoSockets();
}
Result<std::unique_ptr<Channel>> ConnectLocal(IoThread&, const std::string&, const ChannelLimits&) {
  return NoSockets();
}

Result<std::unique_ptr<Acceptor>> Acceptor::Open(IoThread&, const std::string&, int, const ChannelLimits&,
                                                 std::function<void(std::unique_ptr<Channel>)>) {
  return NoSockets();
}
Result<std::unique_ptr<Acceptor>> Acceptor::OpenLocal(IoThread&, const std::string&, const ChannelLimits&,
                                                      std::function<void(std::unique_ptr<Channel>)>) {
  return NoSockets();
}
Acceptor::Acceptor(std::shared_ptr<Contents> contents) : contents_(std::move(contents)) {}
Acceptor::~Acceptor() = default;
int Acceptor::port() const {
  return 0;
}

}  // namespace soarbox::wire
