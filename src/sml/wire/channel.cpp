// SPDX-License-Identifier: BSD-2-Clause
#include "sml/wire/channel.h"

#include <asio.hpp>

#ifdef __linux__
#include <netinet/tcp.h>
#endif

#include <algorithm>
#include <array>
#include <atomic>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>
#include <type_traits>
#include <vector>

#include "diagnostics/problem.h"
#include "sml/wire/framing.h"
#include "sml/wire/local_socket.h"

namespace soarbox::wire {

using asio::ip::tcp;
using LocalStream = asio::local::stream_protocol;
/// A connected socket of either kind.
using AnySocket = asio::generic::stream_protocol::socket;

struct IoThread::Contents {
  asio::io_context context;
  asio::executor_work_guard<asio::io_context::executor_type> work = asio::make_work_guard(context);
  std::thread thread;
};

IoThread::IoThread() : contents_(std::make_shared<Contents>()) {
  contents_->thread = std::thread([contents = contents_.get()] { contents->context.run(); });
}

IoThread::~IoThread() {
  contents_->work.reset();
  contents_->context.stop();
  if (contents_->thread.joinable()) contents_->thread.join();
}

namespace {

/// Droppable messages are collected for this time or up to this number of bytes.
constexpr std::chrono::milliseconds kGatherTime{1};
constexpr std::size_t kGathered = 64 * 1024;
/// Maximum length of a message to which parts are appended.
constexpr std::size_t kLongestJoined = 16 * 1024;
/// Maximum number of open messages.
constexpr std::size_t kMostOpen = 8;

/// Acknowledges received bytes immediately. Soar's own clients send a message in two parts, and their system delays the
/// second until the first is acknowledged. Otherwise this would take 40 ms, far longer than most calls.
void AcknowledgeNow([[maybe_unused]] AnySocket& socket) {
#ifdef TCP_QUICKACK
  const int on = 1;
  ::setsockopt(socket.native_handle(), IPPROTO_TCP, TCP_QUICKACK, &on, sizeof(on));
#endif
}

}  // namespace

// A connection --------------------------------------------------------------------------------------------------------

struct Channel::Socket : std::enable_shared_from_this<Channel::Socket> {
  Socket(AnySocket connected, const ChannelLimits& channel_limits)
      : socket(std::move(connected)), limits(channel_limits) {}

  void Start() {
    asio::error_code ignored;
    // (Fails for local sockets, which do not delay data.)
    socket.set_option(tcp::no_delay(true), ignored);
    socket.non_blocking(true, ignored);
    asio::post(socket.get_executor(), [self = shared_from_this()] {
      self->AwaitMessage();
      self->Read();
    });
  }

  /// A message must be completed within the time limit from now on; else the channel is closed.
  void AwaitMessage() {
    if (limits.patience.count() == 0 || shut) return;
    doubt.expires_after(limits.patience);
    doubt.async_wait([self = shared_from_this()](const asio::error_code& error) {
      if (!error) self->Shut();
    });
  }

  // Called on the thread for sockets.
  void Read() {
    socket.async_read_some(
        asio::buffer(piece),
        [self = shared_from_this()](const asio::error_code& error, std::size_t count) { self->OnRead(error, count); });
  }

  void OnRead(const asio::error_code& error, std::size_t count) {
    std::vector<std::string> messages;
    const bool readable = !error && reader.Feed({piece.data(), count}, messages);
    bool full = false;
    {
      const std::lock_guard lock(mutex);
      for (std::string& message : messages) {
        waiting_in += message.size();
        inbox.push_back(std::move(message));
      }
      full = waiting_in > limits.max_waiting_in;
      paused = full;
    }
    if (!readable) {
      Shut();
      return;
    }
    const bool has_begun = reader.pending() != 0;
    if (has_begun) AcknowledgeNow(socket);
    if (!messages.empty()) {
      silent = false;
      doubt.cancel();
    }
    if (has_begun && (!messages.empty() || !had_begun) && !silent) AwaitMessage();
    had_begun = has_begun;
    if (!messages.empty()) Notify();
    if (!full) Read();
  }

  void Write() {
    std::string bytes;
    {
      const std::lock_guard lock(mutex);
      if (outbox.empty()) CloseOpen();
      if (outbox.empty() || shut) {
        writing = false;
        return;
      }
      bytes.swap(outbox);
    }
    auto buffer = std::make_shared<std::string>(std::move(bytes));
    asio::async_write(socket, asio::buffer(*buffer),
                      [self = shared_from_this(), buffer](const asio::error_code& error, std::size_t) {
                        {
                          const std::lock_guard lock(self->mutex);
                          self->waiting_out -= buffer->size();
                        }
                        if (error) {
                          self->Shut();
                        } else {
                          self->Write();
                        }
                      });
  }

  /// Collects text and trace for a moment, because a system call for each part would cost more than the decision that
  /// it describes.
  void Gather() {
    timer.expires_after(kGatherTime);
    timer.async_wait([self = shared_from_this()](const asio::error_code&) {
      {
        const std::lock_guard lock(self->mutex);
        self->gathering = false;
        self->CloseOpen();
        if (self->writing || self->outbox.empty() || self->shut) return;
        self->writing = true;
      }
      self->Write();
    });
  }

  void Shut() {
    {
      const std::lock_guard lock(mutex);
      if (shut) return;
      shut = true;
      CloseOpen();
      if (!writing && !outbox.empty()) SendNow();
    }
    alarm.cancel();
    doubt.cancel();
    asio::error_code ignored;
    socket.shutdown(AnySocket::shutdown_both, ignored);
    socket.close(ignored);
    Notify();
  }

  void Notify() {
    std::function<void()> call;
    {
      const std::lock_guard lock(mutex);
      call = wake;
      arrived.notify_all();
    }
    if (call) call();
  }

  // Called on any thread.
  bool Send(const std::string& message, bool droppable) {
    const std::array<char, 4> header = FrameHeader(message.size());
    const std::size_t size = header.size() + message.size();
    std::unique_lock lock(mutex);
    if (shut) return false;
    if (droppable && waiting_out + size > limits.max_waiting_out / 2) {
      ++dropped;
      return false;
    }
    if (waiting_out + size > limits.max_waiting_out) {
      lock.unlock();
      asio::post(socket.get_executor(), [self = shared_from_this()] { self->Shut(); });
      return false;
    }
    CloseOpen();
    outbox.append(header.data(), header.size());
    outbox += message;
    waiting_out += size;
    return SendSoon(lock, droppable);
  }

  bool Join(std::uint64_t series, std::string_view part) {
    std::unique_lock lock(mutex);
    for (Open& message : open) {
      if (message.series != series) continue;
      if (message.bytes.size() + part.size() > kLongestJoined) return false;
      message.bytes += part;
      waiting_out += part.size();
      return true;
    }
    return false;
  }

  bool SendOpen(std::uint64_t series, std::string_view head, std::string_view part, std::string_view tail) {
    const std::size_t size = 4 + head.size() + part.size() + tail.size();
    std::unique_lock lock(mutex);
    if (shut) return false;
    if (waiting_out + size > limits.max_waiting_out / 2) {
      ++dropped;
      return false;
    }
    const bool again =
        std::any_of(open.begin(), open.end(), [&](const Open& message) { return message.series == series; });
    if (again || open.size() >= kMostOpen) CloseOpen();
    if (spare.empty()) spare.emplace_back();
    Open& message = open.emplace_back(std::move(spare.back()));
    spare.pop_back();
    message.series = series;
    message.bytes.assign(head).append(part);
    message.tail.assign(tail);
    waiting_out += size;
    return SendSoon(lock, true);
  }

  /// Ends the open messages and moves them to the outbox. The lock must be held.
  void CloseOpen() {
    for (Open& message : open) {
      const std::array<char, 4> header = FrameHeader(message.bytes.size() + message.tail.size());
      outbox.append(header.data(), header.size()).append(message.bytes).append(message.tail);
      spare.push_back(std::move(message));
    }
    open.clear();
  }

  /// Makes sure that the messages in the outbox are sent, immediately or after a moment. Also ends the open messages.
  bool SendSoon(std::unique_lock<std::mutex>& lock, bool may_wait) {
    // (The current write operation also sends the rest.)
    if (writing) return true;
    if (!may_wait || outbox.size() >= kGathered) {
      SendNow();
      if (!outbox.empty()) {
        writing = true;
        lock.unlock();
        asio::post(socket.get_executor(), [self = shared_from_this()] { self->Write(); });
        return true;
      }
    }
    if (gathering || (outbox.empty() && open.empty())) return true;
    gathering = true;
    lock.unlock();
    asio::post(socket.get_executor(), [self = shared_from_this()] { self->Gather(); });
    return true;
  }

  /// Sends as much as the system accepts immediately, without another thread. The lock must be held, and no write
  /// operation may be in progress.
  void SendNow() {
    asio::error_code error;
    const std::size_t sent = socket.send(asio::buffer(outbox), 0, error);
    if (error) return;
    outbox.erase(0, sent);
    waiting_out -= sent;
  }

  /// Removes and returns a message. The lock must be held.
  bool Take(std::string& message) {
    if (inbox.empty()) return false;
    message = std::move(inbox.front());
    inbox.pop_front();
    waiting_in -= message.size();
    if (paused && waiting_in <= limits.max_waiting_in / 2) {
      paused = false;
      asio::post(socket.get_executor(), [self = shared_from_this()] { self->Read(); });
    }
    return true;
  }

  AnySocket socket;
  asio::steady_timer timer{socket.get_executor()}, alarm{socket.get_executor()}, doubt{socket.get_executor()};
  const ChannelLimits limits;
  FrameReader reader;
  std::array<char, 64 * 1024> piece{};
  bool had_begun = false;  ///< A part of a message had been received.
  std::atomic<bool> silent{true};

  mutable std::mutex mutex;
  std::condition_variable arrived;
  std::deque<std::string> inbox;
  std::string outbox;
  /// A message to which further parts may be appended.
  struct Open {
    std::uint64_t series = 0;
    std::string bytes, tail;
  };
  std::vector<Open> open, spare;
  std::size_t waiting_in = 0, waiting_out = 0;
  bool writing = false, gathering = false, paused = false, shut = false;
  std::atomic<std::uint64_t> dropped{0};
  std::function<void()> wake;
};

Channel::Channel(std::shared_ptr<Socket> socket) : socket_(std::move(socket)) {
  socket_->Start();
}

Channel::~Channel() {
  SetWake({});
  Close();
}

bool Channel::Send(const std::string& message, bool droppable) {
  return socket_->Send(message, droppable);
}

bool Channel::Join(std::uint64_t series, std::string_view part) {
  return socket_->Join(series, part);
}

bool Channel::SendOpen(std::uint64_t series, std::string_view head, std::string_view part, std::string_view tail) {
  return socket_->SendOpen(series, head, part, tail);
}

bool Channel::Pop(std::string& message) {
  const std::lock_guard lock(socket_->mutex);
  return socket_->Take(message);
}

bool Channel::Wait(std::string& message, std::chrono::milliseconds timeout) {
  std::unique_lock lock(socket_->mutex);
  socket_->arrived.wait_for(lock, timeout, [this] { return !socket_->inbox.empty() || socket_->shut; });
  return socket_->Take(message);
}

bool Channel::closed() const {
  const std::lock_guard lock(socket_->mutex);
  return socket_->shut;
}

void Channel::Close() {
  asio::post(socket_->socket.get_executor(), [socket = socket_] { socket->Shut(); });
}

std::uint64_t Channel::dropped() const {
  return socket_->dropped.load(std::memory_order_relaxed);
}

void Channel::WakeAfter(std::chrono::milliseconds delay) {
  asio::post(socket_->socket.get_executor(), [socket = socket_, delay] {
    socket->alarm.expires_after(delay);
    socket->alarm.async_wait([socket](const asio::error_code& error) {
      if (!error) socket->Notify();
    });
  });
}

bool Channel::silent() const {
  return socket_->silent;
}

void Channel::SetWake(std::function<void()> wake) {
  const std::lock_guard lock(socket_->mutex);
  socket_->wake = std::move(wake);
}

// Connecting and listening --------------------------------------------------------------------------------------------

namespace {

Diagnostic Failure(const std::string& what, const std::string& place, const asio::error_code& error, std::string hint) {
  return NewProblem(what + " " + place + ": " + error.message(), std::move(hint));
}

std::string Place(const std::string& address, int port) {
  return address + ":" + std::to_string(port);
}

}  // namespace

bool HasSockets() {
  return true;
}

Result<std::unique_ptr<Channel>> Connect(IoThread& thread, const std::string& address, int port,
                                         const ChannelLimits& limits) {
  asio::error_code error;
  tcp::resolver resolver(thread.contents().context);
  const auto found = resolver.resolve(address, std::to_string(port), error);
  if (error) return Failure("cannot find", Place(address, port), error, {});
  tcp::socket socket(thread.contents().context);
  asio::connect(socket, found, error);
  if (error) {
    return Failure("cannot connect to", Place(address, port), error, "is there a kernel that listens on this port?");
  }
  return std::make_unique<Channel>(std::make_shared<Channel::Socket>(AnySocket(std::move(socket)), limits));
}

Result<std::unique_ptr<Channel>> ConnectLocal(IoThread& thread, const std::string& path, const ChannelLimits& limits) {
  asio::error_code error;
  LocalStream::socket socket(thread.contents().context);
  socket.connect(LocalStream::endpoint(path), error);
  if (error) return Failure("cannot connect to", path, error, {});
  return std::make_unique<Channel>(std::make_shared<Channel::Socket>(AnySocket(std::move(socket)), limits));
}

struct Acceptor::Contents {
  virtual ~Contents() = default;
  /// Called on the thread for sockets.
  virtual void Close() = 0;

  asio::io_context* context = nullptr;
  ChannelLimits limits;
  std::function<void(std::unique_ptr<Channel>)> accepted;
  int port = 0;
  std::unique_ptr<LocalSocketFile> file;  ///< For local sockets.
};

namespace {

template <typename Protocol>
struct AcceptorOf final : Acceptor::Contents, std::enable_shared_from_this<AcceptorOf<Protocol>> {
  // NOLINTNEXTLINE(performance-unnecessary-value-param): it is moved.
  AcceptorOf(IoThread& thread, const ChannelLimits& channel_limits, std::function<void(std::unique_ptr<Channel>)> call)
      : acceptor(thread.contents().context) {
    context = &thread.contents().context;
    limits = channel_limits;
    accepted = std::move(call);
  }

  asio::error_code Listen(const typename Protocol::endpoint& endpoint) {
    asio::error_code error;
    acceptor.open(endpoint.protocol(), error);
    if (!error && std::is_same_v<Protocol, tcp>) acceptor.set_option(tcp::acceptor::reuse_address(true), error);
    if (!error) acceptor.bind(endpoint, error);
    if (!error) acceptor.listen(asio::socket_base::max_listen_connections, error);
    return error;
  }

  void Start() {
    asio::post(*context, [self = this->shared_from_this()] { self->Accept(); });
  }

  void Accept() {
    acceptor.async_accept([self = this->shared_from_this()](const asio::error_code& error,
                                                            typename Protocol::socket socket) {
      if (error == asio::error::operation_aborted || !self->acceptor.is_open()) return;
      if (!error) {
        self->accepted(
            std::make_unique<Channel>(std::make_shared<Channel::Socket>(AnySocket(std::move(socket)), self->limits)));
      }
      self->Accept();
    });
  }

  void Close() override {
    asio::error_code ignored;
    acceptor.close(ignored);
  }

  typename Protocol::acceptor acceptor;
};

}  // namespace

Result<std::unique_ptr<Acceptor>> Acceptor::Open(IoThread& thread, const std::string& address, int port,
                                                 const ChannelLimits& limits,
                                                 std::function<void(std::unique_ptr<Channel>)> accepted) {
  asio::error_code error;
  const auto ip = asio::ip::make_address(address, error);
  if (error) {
    return Failure("cannot listen on", Place(address, port), error, "give an address in numbers, such as 127.0.0.1");
  }
  if (port < -1 || port > 65535) {
    return Failure("cannot listen on", Place(address, port), asio::error::invalid_argument, "ports go from 1 to 65535");
  }
  const auto contents = std::make_shared<AcceptorOf<tcp>>(thread, limits, std::move(accepted));
  error = contents->Listen(tcp::endpoint(ip, static_cast<unsigned short>(port == -1 ? 0 : port)));
  if (error) {
    return Failure("cannot listen on", Place(address, port), error,
                   "another kernel may have this port; choose another one, or -1 for any");
  }
  contents->port = contents->acceptor.local_endpoint(error).port();
  contents->Start();
  return std::make_unique<Acceptor>(contents);
}

Result<std::unique_ptr<Acceptor>> Acceptor::OpenLocal(IoThread& thread, const std::string& path,
                                                      const ChannelLimits& limits,
                                                      std::function<void(std::unique_ptr<Channel>)> accepted) {
  if (!LocalSocketFile::Prepare(path)) {
    return Failure("cannot listen at", path, asio::error::access_denied,
                   "the folder must be this user's alone (mode 0700)");
  }
  const auto contents = std::make_shared<AcceptorOf<LocalStream>>(thread, limits, std::move(accepted));
  if (const asio::error_code error = contents->Listen(LocalStream::endpoint(path))) {
    return Failure("cannot listen at", path, error, {});
  }
  contents->file = std::make_unique<LocalSocketFile>(path);
  contents->Start();
  return std::make_unique<Acceptor>(contents);
}

Acceptor::Acceptor(std::shared_ptr<Contents> contents) : contents_(std::move(contents)) {}

Acceptor::~Acceptor() {
  contents_->file.reset();
  asio::post(*contents_->context, [contents = contents_] { contents->Close(); });
}

int Acceptor::port() const {
  return contents_->port;
}

}  // namespace soarbox::wire
