// SPDX-License-Identifier: BSD-2-Clause
#include "sml/server/listener.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <mutex>
#include <vector>

#include "sml/server/kernel_host.h"
#include "sml/server/remote_connection.h"
#include "sml/wire/channel.h"
#include "sml/wire/local_socket.h"
#include "sml/wire/message.h"
#include "sml/wire/secret.h"

namespace soarbox::server {

struct Listener::State {
  State(KernelHost& kernel_host, const ListenerOptions& listener_options)
      : host(kernel_host), options(listener_options) {}

  void Accepted(std::unique_ptr<wire::Channel> channel) {
    std::unique_ptr<wire::Channel> dropped;  // Destroyed after the lock is released.
    {
      const std::lock_guard lock(mutex);
      // Serve checks the limit of clients; this check only protects the memory.
      if (static_cast<int>(arrived.size()) >= options.max_clients) {
        const auto silent = std::ranges::find_if(arrived, [](const auto& each) { return each->silent(); });
        if (silent == arrived.end()) return;
        dropped = std::move(*silent);
        arrived.erase(silent);
      }
      channel->SetWake([this] { Wake(); });
      arrived.push_back(std::move(channel));
    }
    Wake();
  }

  /// Returns false if there is no room; the new client was informed.
  bool MakeRoom(wire::Channel& channel) {
    const auto is_there = [](const std::unique_ptr<RemoteConnection>& each) { return !each->closed(); };
    const auto count = std::count_if(connections.begin(), connections.end(), is_there);
    if (count < options.max_clients) return true;
    // They are in order of arrival.
    const auto silent = std::find_if(connections.begin(), connections.end(),
                                     [&](const auto& each) { return is_there(each) && each->silent(); });
    if (silent != connections.end()) {
      (*silent)->Close();
      return true;
    }
    wire::Message notice;
    notice.type = wire::DocType::kNotify;
    wire::AddError(notice, "This kernel serves " + std::to_string(options.max_clients) +
                               " clients already: close one of them, then connect again");
    channel.Send(wire::ToDocument(notice));
    return false;
  }

  void Admit(std::unique_ptr<wire::Channel> channel) {
    auto connection = std::make_unique<RemoteConnection>(host, std::move(channel),
                                                         std::chrono::milliseconds(options.answer_timeout_ms));
    connection->info.id = "id_" + std::to_string(next_id++);
    host.AddConnection(*connection);
    connections.push_back(std::move(connection));
    host.FireSystem(::sml::smlEVENT_AFTER_CONNECTION);
  }

  /// Admits clients that present the secret, and disconnects those that send anything else. Returns true if a message
  /// came.
  bool AskForSecrets() {
    bool any = false;
    std::vector<std::unique_ptr<wire::Channel>> waiting;
    waiting.swap(guests);  // Admit may call this function again.
    for (std::unique_ptr<wire::Channel>& channel : waiting) {
      std::string document;
      if (!channel->Pop(document)) {
        if (!channel->closed()) guests.push_back(std::move(channel));
        continue;
      }
      any = true;
      if (HasSecret(*channel, document)) Admit(std::move(channel));
    }
    // Silent clients are disconnected to make room, the oldest first.
    const std::size_t most = static_cast<std::size_t>(options.max_clients);
    if (guests.size() > most) guests.erase(guests.begin(), guests.end() - static_cast<std::ptrdiff_t>(most));
    return any;
  }

  /// Whether the first message of a client presents the secret. Sends the response to the client.
  bool HasSecret(wire::Channel& channel, const std::string& document) {
    const Result<wire::Message> message = wire::ReadMessage(document);
    if (!message) return false;
    const std::string* const shown = wire::ShownSecret(*message);
    const bool is_right = shown != nullptr && wire::IsSameSecret(*shown, options.secret);
    wire::Message response = wire::MakeResponse(message->id);
    if (is_right) {
      wire::AddRawResult(response, "true");
    } else {
      const std::string text = shown != nullptr
                                   ? std::string("This kernel does not accept this secret: compare ") +
                                         wire::kSecretVariable + " with what the kernel was started with"
                                   : std::string(
                                         "This kernel requires a secret: start this program with the environment "
                                         "variable ") +
                                         wire::kSecretVariable + " or " + wire::kSecretFileVariable;
      wire::Message notice;
      notice.type = wire::DocType::kNotify;
      wire::AddError(notice, text);
      channel.Send(wire::ToDocument(notice));
      wire::AddError(response, text);
    }
    channel.Send(wire::ToDocument(response));
    return is_right;
  }

  void Wake() {
    std::function<void()> call;
    {
      const std::lock_guard lock(mutex);
      call = wake;
    }
    if (call) call();
  }

  KernelHost& host;
  const ListenerOptions options;
  std::mutex mutex;
  std::function<void()> wake;
  std::vector<std::unique_ptr<wire::Channel>> arrived;  ///< Not yet clients of the kernel.

  // Used only by the thread that holds the kernel.
  std::vector<std::unique_ptr<RemoteConnection>> connections;
  std::vector<std::unique_ptr<wire::Channel>> guests;  ///< Clients that have not presented the secret yet.
  bool serving = false;
  unsigned long long next_id = 1;

  wire::IoThread thread;
  std::unique_ptr<wire::Acceptor> acceptor, local_acceptor;
};

Listener::Listener(std::unique_ptr<State> state) : state_(std::move(state)) {}

Listener::~Listener() {
  Close();
}

Result<std::unique_ptr<Listener>> Listener::Open(KernelHost& host, const ListenerOptions& options) {
  auto state = std::make_unique<State>(host, options);
  wire::ChannelLimits limits;
  limits.max_waiting_out = options.max_waiting_bytes;
  limits.patience = std::chrono::milliseconds(options.patience_ms);
  auto opened = wire::Acceptor::Open(
      state->thread, options.address, options.port, limits,
      [raw = state.get()](std::unique_ptr<wire::Channel> channel) { raw->Accepted(std::move(channel)); });
  if (!opened) return opened.error();
  state->acceptor = std::move(opened.value());
  // Programs of the same user first look for the socket file; without it they use the port.
  const std::string path = wire::LocalSocketPath(options.port == -1 ? getpid() : options.port);
  if (!path.empty() && options.local) {
    auto local = wire::Acceptor::OpenLocal(
        state->thread, path, limits,
        [raw = state.get()](std::unique_ptr<wire::Channel> channel) { raw->Accepted(std::move(channel)); });
    if (local) state->local_acceptor = std::move(local.value());
  }
  return std::unique_ptr<Listener>(new Listener(std::move(state)));
}

int Listener::port() const {
  return state_->acceptor ? state_->acceptor->port() : 0;
}

void Listener::SetWake(std::function<void()> wake) {
  const std::lock_guard lock(state_->mutex);
  state_->wake = std::move(wake);
}

bool Listener::Serve() {
  State& state = *state_;
  // An executing call may enter this function again (a run that pumps): the outer call continues with the list.
  std::vector<std::unique_ptr<wire::Channel>> arrived;
  {
    const std::lock_guard lock(state.mutex);
    arrived.swap(state.arrived);
  }
  for (std::unique_ptr<wire::Channel>& channel : arrived) {
    if (!state.MakeRoom(*channel)) continue;
    if (state.options.secret.empty()) {
      state.Admit(std::move(channel));
    } else {
      state.guests.push_back(std::move(channel));
    }
  }
  const bool outermost = !state.serving;
  state.serving = true;
  bool any = !arrived.empty();
  if (!state.guests.empty()) any = state.AskForSecrets() || any;
  for (std::size_t i = 0; i < state.connections.size(); ++i) any = state.connections[i]->Serve() || any;
  if (!outermost) return any;
  state.serving = false;
  // Clients are destroyed only here, when none of their calls is being executed. During a run they are never destroyed,
  // because an event may be on its way to them.
  if (state.host.running()) return any;
  std::erase_if(state.connections, [&](const std::unique_ptr<RemoteConnection>& connection) {
    if (!connection->gone()) return false;
    state.host.RemoveConnection(*connection);
    return true;
  });
  return any;
}

void Listener::Close() {
  State& state = *state_;
  SetWake({});
  state.acceptor.reset();
  state.local_acceptor.reset();
  for (const std::unique_ptr<RemoteConnection>& connection : state.connections)
    state.host.RemoveConnection(*connection);
  state.connections.clear();
  state.guests.clear();
  const std::lock_guard lock(state.mutex);
  state.arrived.clear();
}

}  // namespace soarbox::server
