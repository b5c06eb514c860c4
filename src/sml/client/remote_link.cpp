// SPDX-License-Identifier: BSD-2-Clause
#include "sml/client/remote_link.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <mutex>
#include <system_error>
#include <thread>

#include "sml/client/agent_data.h"
#include "sml/client/library.h"
#include "sml/client/remote_agent_link.h"
#include "sml/wire/channel.h"
#include "sml/wire/local_socket.h"
#include "sml/wire/message.h"
#include "sml/wire/secret.h"

namespace sml {

using soarbox::wire::Channel;
using soarbox::wire::DocType;
using soarbox::wire::Element;
using soarbox::wire::MakeCall;
using soarbox::wire::Message;

namespace {

using Milliseconds = std::chrono::milliseconds;

/// Maximum time until a kernel responds to a call if the program sets no limit. In that case, command lines have no
/// limit.
constexpr Milliseconds kPatience{60'000};
/// Command lines that are not runs may load files; their limit is multiplied by this factor.
constexpr int kLineFactor = 5;
/// Maximum time until a kernel accepts a secret.
constexpr int kSecretLimitMs = 10'000;

/// A program's client of a remote kernel. Between calls a thread delivers events; during a call, the calling thread
/// does.
class RemoteLink final : public KernelLink, public LogLink, public RemoteCaller {
 public:
  explicit RemoteLink(KernelData& kernel) : kernel_(kernel) {}
  ~RemoteLink() override { Shutdown(); }

  bool Connect(const std::string& address, int port, std::string& error) {
    // Without an address, connects to a kernel of this user: by the socket file for the port, or else by the port.
    const std::string path = address.empty() ? soarbox::wire::LocalSocketPath(port) : std::string();
    soarbox::Result<std::unique_ptr<Channel>> connected = soarbox::Diagnostic();
    if (!path.empty()) connected = soarbox::wire::ConnectLocal(io_, path);
    if (!connected) connected = soarbox::wire::Connect(io_, address.empty() ? "127.0.0.1" : address, port);
    if (!connected) {
      error = connected.error().message;
      if (!connected.error().hint.empty()) error += " (" + connected.error().hint + ")";
      return false;
    }
    channel_ = std::move(connected.value());
    channel_->SetWake([this] { WakeEvents(); });
    StartEventThread();
    return true;
  }

  /// Presents the secret in the environment, if there is one. A kernel that requires none does not know the call; one
  /// that refuses reports the reason (Refusal).
  bool ShowSecret(std::string& error) {
    const soarbox::Result<std::string> secret = soarbox::wire::SecretOfEnvironment();
    if (!secret) {
      error = secret.error().file + ": " + secret.error().message;
      return false;
    }
    if (!secret->empty()) {
      SetAnswerLimit(kSecretLimitMs);
      Message call = soarbox::wire::SecretCall(*secret);
      Ask(call);
      SetAnswerLimit(0);
    }
    return true;
  }

  std::recursive_mutex& mutex() override { return mutex_; }
  bool remote() const override { return true; }
  bool closed() const override { return lost_ || channel_->closed(); }

  std::string Refusal() override {
    const std::lock_guard lock(mutex_);
    std::string document;
    while (refusal_.empty() && channel_->Pop(document)) Read(document);
    return refusal_;
  }

  void Shutdown() override {
    StopEventThread();
    if (channel_) {
      channel_->SetWake({});
      channel_->Close();
    }
  }

  // Calls
  // ---------------------------------------------------------------------------------------------------------------

  void SetAnswerLimit(int milliseconds) override { limit_ms_ = std::max(0, milliseconds); }

  std::optional<Message> Ask(Message& call, Work work = Work::kCall) override {
    // The thread that delivers events must not consume the response.
    const std::lock_guard lock(mutex_);
    call.id = NextId();
    if (!SendDocument(call)) return std::nullopt;
    waiting_.push_back(call.id);
    std::optional<Message> answer = AwaitAnswer(call.id, LimitOf(work));
    std::erase(waiting_, call.id);
    early_.erase(call.id);
    return answer;
  }

  /// None: no limit.
  std::optional<Milliseconds> LimitOf(Work work) const {
    const Milliseconds limit{limit_ms_.load()};
    if (limit.count() == 0) return work == Work::kCall ? std::optional(kPatience) : std::nullopt;
    return work == Work::kLine ? limit * kLineFactor : limit;
  }

  /// Serves the kernel's calls until the response arrives, or until the kernel has sent nothing for too long. A handler
  /// that calls the kernel may receive the response to an outer call first. That response is stored for the outer call.
  std::optional<Message> AwaitAnswer(const std::string& id, std::optional<Milliseconds> limit) {
    std::string document;
    while (true) {
      const auto kept = early_.find(id);
      if (kept != early_.end()) return std::move(kept->second);
      if (!channel_->Wait(document, limit.value_or(kPatience))) {
        if (closed()) return std::nullopt;
        if (!limit) continue;
        // If a limit is set, the connection counts as lost, so that later calls do not wait again.
        if (limit_ms_ != 0) GiveUp();
        return std::nullopt;
      }
      std::optional<Message> message = Read(document);
      if (!message) continue;
      if (message->type == DocType::kResponse) {
        if (message->ack == id) return message;
        if (std::find(waiting_.begin(), waiting_.end(), message->ack) != waiting_.end())
          early_[message->ack] = std::move(*message);
      } else if (message->type == DocType::kCall) {
        HandleCall(*message);
      }
    }
  }
  void GiveUp() {
    lost_ = true;
    channel_->Close();
  }
  void Tell(Message& call) override {
    call.id = NextId();
    SendDocument(call);
  }
  bool Done(Message& call) {
    const std::optional<Message> response = Ask(call);
    return response && !response->ErrorTag();
  }
  std::string Text(Message& call) {
    const std::optional<Message> response = Ask(call);
    if (!response || response->ErrorTag()) return {};
    const Element* result = response->ResultTag();
    return result ? result->text : std::string();
  }

  int ListenerPort() override {
    Message call = MakeCall("get_listener_port");
    return std::atoi(Text(call).c_str());
  }
  long long InitialTimeTag() override {
    Message call = MakeCall("initial_time_tag");
    return std::atoll(Text(call).c_str());
  }
  std::string Version() override {
    Message call = MakeCall("version");
    return Text(call);
  }

  std::unique_ptr<AgentLink> CreateAgent(Agent& agent, const std::string& name, std::string& error) override {
    Message call = MakeCall("create_agent");
    Command(call).AddArg("name", name);
    const std::optional<Message> response = Ask(call);
    if (!response) {
      error = "The kernel did not answer";
      return nullptr;
    }
    if (const Element* failure = response->ErrorTag()) {
      error = failure->text;
      return nullptr;
    }
    if (!fence_folders_.empty()) PutUpFence(name);
    return FindAgent(agent, name);
  }
  void FenceFiles(std::vector<std::string> folders, bool) override {
    fence_folders_.clear();
    for (const std::string& folder : folders) {
      std::error_code error;
      const std::filesystem::path absolute = std::filesystem::absolute(folder, error);
      if (!error) fence_folders_ += absolute.string() + "\n";
    }
  }
  /// Soar's own kernels do not support fences; they execute all commands in files.
  void PutUpFence(const std::string& name) {
    Message call = MakeCall(soarbox::wire::kFenceCall);
    Command(call).AddArg("agent", name).AddArg(soarbox::wire::kFenceFolders, fence_folders_);
    Done(call);
  }
  void AnnounceAgent(const std::string&) override {}
  std::optional<std::string> ReadLog(std::uint64_t from) override {
    Message call = MakeCall(soarbox::wire::kLogCall);
    Command(call).AddArg(soarbox::wire::kLogFrom, std::to_string(from));
    const std::optional<Message> response = Ask(call);
    const Element* const result = response ? response->ResultTag() : nullptr;
    if (result == nullptr || response->ErrorTag() != nullptr) return std::nullopt;
    return result->text;
  }
  std::unique_ptr<AgentLink> FindAgent(Agent&, const std::string& name) override {
    return std::make_unique<RemoteAgentLink>(*this, name);
  }
  bool DestroyAgent(const std::string& name, std::string& error) override {
    Message call = MakeCall("destroy_agent");
    Command(call).AddArg("agent", name);
    const std::optional<Message> response = Ask(call);
    if (response && !response->ErrorTag()) return true;
    error = response ? response->ErrorTag()->text : "The kernel did not answer";
    return false;
  }
  std::vector<std::string> AgentNames() override {
    Message call = MakeCall("get_agent_list");
    std::vector<std::string> names;
    const std::optional<Message> response = Ask(call);
    const Element* result = response ? response->ResultTag() : nullptr;
    if (!result) return names;
    for (const Element& child : result->children) {
      if (child.tag == "name") names.push_back(child.text);
    }
    return names;
  }

  LineAnswer Execute(const char* agent, AgentLink*, const LineRequest& request) override {
    return ExecuteLine(agent, request, Work::kLine);
  }
  LineAnswer ExecuteLine(const char* agent, const LineRequest& request, Work work) {
    Message call = MakeCall("cmdline");
    Element& command = Command(call);
    if (!request.structured) command.Set("output", "raw");
    if (agent) command.AddArg("agent", agent);
    command.AddArg("line", std::string(request.line))
        .AddArg("echo", request.echo ? "true" : "false")
        .AddArg("nofilter", request.no_filter ? "true" : "false");
    if (request.fenced && !fence_folders_.empty()) command.AddArg(soarbox::wire::kFenced, "true");
    const std::optional<Message> response = Ask(call, work);
    LineAnswer answer;
    if (!response) {
      answer.ok = false;
      answer.failed_to_ask = true;
      answer.text = "The connection to the kernel is lost";
      return answer;
    }
    const Element* error = response->ErrorTag();
    const Element* result = response->ResultTag();
    answer.ok = !error;
    answer.text = error ? error->text : result ? result->text : std::string();
    if (request.structured) answer.document = std::make_shared<const Element>(response->root);
    return answer;
  }
  LineAnswer Run(const char* agent, AgentLink*, const RunSpec& spec, bool) override {
    const std::string line = RunLine(spec);
    return ExecuteLine(agent, {line, false, false, false}, Work::kRun);
  }

  void StopAll() override {
    Message call = MakeCall("cmdline");
    Element& command = Command(call).Set("output", "raw");
    {
      const std::unique_lock lock(mutex_, std::try_to_lock);
      if (lock && !kernel_.agents.empty()) command.AddArg("agent", kernel_.agents.begin()->first);
      command.AddArg("line", "stop-soar").AddArg("echo", "false").AddArg("nofilter", "false");
      if (lock) {
        Ask(call);
        return;
      }
    }
    // Another thread waits for the end of a run and will discard this response.
    Tell(call);
  }
  bool IsRunning() override {
    const std::unique_lock lock(mutex_, std::try_to_lock);
    if (!lock) return true;
    Message call = MakeCall("is_running");
    return Text(call) == "true";
  }

  void Register(int event) override { ChangeRegistration("register_for_event", {}, event, {}); }
  void Unregister(int event) override { ChangeRegistration("unregister_for_event", {}, event, {}); }
  void RegisterFunction(int event, const std::string& name) override {
    ChangeRegistration("register_for_event", {}, event, name);
  }
  void UnregisterFunction(int event, const std::string& name) override {
    ChangeRegistration("unregister_for_event", {}, event, name);
  }
  bool ChangeRegistration(const char* command, const std::string& agent, int event, const std::string& name) override {
    Message call = MakeCall(command);
    if (!agent.empty()) Command(call).AddArg("agent", agent);
    Command(call).AddArg("eventid", Events().ConvertToString(event));
    if (!name.empty()) Command(call).AddArg("name", name);
    return Done(call);
  }

  std::optional<std::string> SendClientMessage(Agent* agent, const std::string& client,
                                               const std::string& message) override {
    Message call = MakeCall("send_client_message");
    if (agent) Command(call).AddArg("agent", agent->GetAgentName());
    Command(call).AddArg("name", client).AddArg("message", message);
    const std::optional<Message> response = Ask(call);
    const Element* result = response && !response->ErrorTag() ? response->ResultTag() : nullptr;
    return result ? std::optional(result->text) : std::nullopt;
  }
  bool FireSystem(int event) override {
    Message call = MakeCall("fire_event");
    Command(call).AddArg("eventid", Events().ConvertToString(event));
    return Done(call);
  }
  bool SuppressSystemStop(bool on) override {
    Message call = MakeCall("suppress_event");
    Command(call).AddArg("eventid", "system-stop").AddArg("value", on ? "true" : "false");
    return Done(call);
  }
  bool SetInterruptCheckRate(int rate) override {
    Message call = MakeCall("set_interrupt_check_rate");
    Command(call).AddArg("value", std::to_string(rate));
    return Done(call);
  }
  std::vector<soarbox::server::ConnectionInfo> Connections() override {
    Message call = MakeCall("get_connections");
    std::vector<soarbox::server::ConnectionInfo> infos;
    const std::optional<Message> response = Ask(call);
    const Element* result = response ? response->ResultTag() : nullptr;
    if (!result) return infos;
    for (const Element& child : result->children) {
      const auto read = [&](const char* attribute) {
        const std::string* value = child.Attribute(attribute);
        return value ? *value : std::string();
      };
      infos.push_back({read("id"), read("name"), read("status"), read("agent-status")});
    }
    return infos;
  }
  bool SetConnectionInfo(const std::string& name, const std::string& status, const std::string& agent_status) override {
    Message call = MakeCall("set_connection_info");
    Command(call).AddArg("name", name).AddArg("status", status).AddArg("agent-status", agent_status);
    return Done(call);
  }
  std::string LoadLibrary(const std::string& command) override { return LoadSmlLibrary(kernel_.kernel, command); }

  // Events
  // --------------------------------------------------------------------------------------------------------------

  bool CheckForIncoming() override {
    const std::lock_guard lock(mutex_);
    bool any = false;
    std::string document;
    while (channel_->Pop(document)) {
      std::optional<Message> message = Read(document);
      if (!message || message->type != DocType::kCall) continue;
      HandleCall(*message);
      any = true;
    }
    return any;
  }

  bool StartEventThread() override {
    if (events_.joinable()) return true;
    stopping_ = false;
    events_ = std::thread([this] { DeliverEvents(); });
    return true;
  }
  bool StopEventThread() override {
    if (!events_.joinable()) return true;
    {
      const std::lock_guard lock(wake_mutex_);
      stopping_ = true;
      wake_.notify_all();
    }
    if (events_.get_id() == std::this_thread::get_id()) {
      events_.detach();
    } else {
      events_.join();
    }
    return true;
  }
  void SetTrace(bool on) override { trace_ = on; }

 private:
  static Element& Command(Message& message) { return message.root.children.front(); }
  std::string NextId() { return std::to_string(next_id_++); }

  bool SendDocument(const Message& message) {
    const std::string document = ToDocument(message);
    if (trace_) std::printf("sent: %s\n", document.c_str());
    return !lost_ && channel_->Send(document);
  }

  std::optional<Message> Read(const std::string& document) {
    if (trace_) std::printf("received: %s\n", document.c_str());
    soarbox::Result<Message> message = soarbox::wire::ReadMessage(document);
    if (!message) return std::nullopt;
    if (message->type == DocType::kNotify && message->ErrorTag() != nullptr) refusal_ = message->ErrorTag()->text;
    return std::move(message.value());
  }

  void WakeEvents() {
    const std::lock_guard lock(wake_mutex_);
    awake_ = true;
    wake_.notify_all();
  }

  void DeliverEvents() {
    while (true) {
      {
        std::unique_lock lock(wake_mutex_);
        wake_.wait(lock, [this] { return awake_ || stopping_; });
        awake_ = false;
        if (stopping_) return;
      }
      // A current call delivers events itself; then this thread finds nothing.
      CheckForIncoming();
    }
  }

  void HandleCall(const Message& call) {
    Message response = soarbox::wire::MakeResponse(call.id);
    response.id = NextId();
    const Element* command = call.Command();
    const std::string* name = command ? command->Attribute("name") : nullptr;
    if (!name) {
      soarbox::wire::AddError(response, "Incoming message did not contain a <command> tag");
    } else if (*name == "event") {
      HandleEvent(call, *command, response);
    } else if (*name == "output") {
      if (AgentData* agent = Find(command->Arg("agent"))) ReceiveOutputMessage(*agent, *command);
    } else if (*name == "output_init") {
      if (AgentData* agent = Find(command->Arg("agent"))) agent->memory.InvalidateOutput();
    } else {
      soarbox::wire::AddError(response, "Command " + *name + " is not recognized by the client");
    }
    SendDocument(response);
  }

  AgentData* Find(const std::string* name) {
    if (!name) return nullptr;
    const auto found = kernel_.agents.find(*name);
    return found == kernel_.agents.end() ? nullptr : &AgentData::Of(*found->second);
  }

  void HandleEvent(const Message& call, const Element& command, Message& response) {
    const auto text = [&](const char* arg) {
      const std::string* value = command.Arg(arg);
      return value ? *value : std::string();
    };
    const int event = Events().ConvertToEvent(text("eventid").c_str());
    if (IsSystemEventID(event)) return kernel_.OnSystem(event);
    if (IsUpdateEventID(event)) return kernel_.OnUpdate(event, std::atoi(text("value").c_str()));
    if (IsAgentEventID(event)) return kernel_.OnAgent(text("name"), event);
    if (IsStringEventID(event)) {
      if (const auto answer = kernel_.OnString(event, text("value"))) soarbox::wire::AddRawResult(response, *answer);
      return;
    }
    if (IsRhsEventID(event)) {
      const std::string name = text("name");
      AgentData* agent = Find(&name);
      const auto answer = kernel_.OnFunction(agent ? &agent->agent : nullptr, event, text("function"), text("value"));
      if (answer) soarbox::wire::AddRawResult(response, *answer);
      return;
    }
    AgentData* agent = Find(command.Arg("agent"));
    if (!agent || !agent->link) return;
    if (IsRunEventID(event)) {
      auto& link = static_cast<RemoteAgentLink&>(*agent->link);
      if (event == smlEVENT_AFTER_APPLY_PHASE) link.CountApplyPhase();
      agent->OnRun(event, std::atoi(text("phase").c_str()));
    } else if (IsProductionEventID(event)) {
      agent->OnProduction(event, text("name"));
    } else if (IsPrintEventID(event)) {
      agent->OnPrint(event, text("message"), text("self") == "true");
    } else if (event == smlEVENT_XML_TRACE_OUTPUT) {
      if (const Element* trace = call.root.Child("trace")) agent->OnXml(event, std::make_shared<const Element>(*trace));
    } else if (event == smlEVENT_XML_INPUT_RECEIVED) {
      agent->OnXml(event, std::make_shared<const Element>(call.root));
    }
  }

  KernelData& kernel_;
  // Must outlive io_, whose thread may still be in WakeEvents when Shutdown returns.
  std::mutex wake_mutex_;
  std::condition_variable wake_;
  bool awake_ = false;
  bool stopping_ = false;
  soarbox::wire::IoThread io_;
  std::unique_ptr<Channel> channel_;
  std::atomic<int> limit_ms_{0};  ///< For responses; 0: kPatience.
  std::string refusal_;
  std::atomic<bool> lost_{false};  ///< The kernel did not respond within the limit.
  std::recursive_mutex mutex_;
  std::atomic<std::uint64_t> next_id_{0};
  std::atomic<bool> trace_{false};
  std::vector<std::string> waiting_;      ///< Calls whose responses are awaited, the outermost first.
  std::string fence_folders_;             ///< Folders for files of agents created here, one per line; empty: no fence.
  std::map<std::string, Message> early_;  ///< Responses to outer calls that arrived during inner ones.
  std::thread events_;
};

}  // namespace

std::unique_ptr<KernelLink> MakeRemoteLink(KernelData& kernel, const std::string& address, int port,
                                           std::string& error) {
  auto link = std::make_unique<RemoteLink>(kernel);
  if (!link->Connect(address, port, error) || !link->ShowSecret(error)) return nullptr;
  return link;
}

}  // namespace sml
