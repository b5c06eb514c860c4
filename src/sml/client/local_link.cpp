// SPDX-License-Identifier: BSD-2-Clause
#include "sml/client/local_link.h"

#include <condition_variable>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <thread>

#include "cli/result_node.h"
#include "cli/run_text.h"
#include "sml/client/agent_data.h"
#include "sml/client/library.h"
#include "sml/client/local_agent_link.h"
#include "sml/server/answers.h"
#include "sml/server/kernel_host.h"
#include "sml/server/listener.h"
#include "sml/wire/channel.h"
#include "sml/wire/message.h"
#include "sml/wire/secret.h"
#include "sml/wire/xml_reader.h"
#include "soarbox_ClientLog.h"

namespace sml {

using soarbox::kernel::RunUnit;
using soarbox::server::HostedAgent;
using soarbox::server::InputWme;
using soarbox::server::KernelHost;

namespace {

RunUnit UnitOf(smlRunStepSize step) {
  switch (step) {
    case sml_PHASE:
      return RunUnit::kPhase;
    case sml_ELABORATION:
      return RunUnit::kElaboration;
    case sml_DECIDE:
      return RunUnit::kDecision;
    case sml_UNTIL_OUTPUT:
      return RunUnit::kOutput;
  }
  return RunUnit::kDecision;
}

/// The rank of a unit, from the smallest to the largest.
int SizeOf(smlRunStepSize step) {
  switch (step) {
    case sml_ELABORATION:
      return 0;
    case sml_PHASE:
      return 1;
    case sml_DECIDE:
      return 2;
    case sml_UNTIL_OUTPUT:
      return 3;
  }
  return 3;
}

/// The client of a kernel for the program that contains it.
class LocalLink final : public KernelLink, public soarbox::server::Connection {
 public:
  LocalLink(KernelData& kernel, bool own_thread, int port, std::string& error) : kernel_(kernel) {
    const std::lock_guard lock(host_.mutex());
    info.id = "id_0";
    host_.AddConnection(*this);
    host_.Register(*this, nullptr, smlEVENT_BEFORE_AGENT_DESTROYED);
    host_.Register(*this, nullptr, smlEVENT_AFTER_AGENT_REINITIALIZED);
    RecordIfAsked();
    if (port != Kernel::kSuppressListener) Listen(own_thread, port, error);
  }

  ~LocalLink() override { Shutdown(); }

  std::recursive_mutex& mutex() override { return host_.mutex(); }
  bool remote() const override { return false; }
  bool closed() const override { return closed_; }
  bool embedded() const override { return true; }

  void Shutdown() override {
    if (closed_) return;
    {
      const std::lock_guard lock(host_.mutex());
      host_.FireSystem(smlEVENT_BEFORE_SHUTDOWN);
      host_.DestroyAllAgents();
      if (listener_) listener_->Close();
      closed_ = true;
    }
    StopServing();
    listener_.reset();
    host_.SetPort(0);
  }

  void OverhearCommands(std::function<void(char const*, char const*)> listener) override {
    const std::lock_guard lock(host_.mutex());
    host_.Overhear(std::move(listener));
  }
  void HoldIncoming(bool on) override { host_.HoldPump(on); }

  /// Records what clients do. Returns an error message or an empty text.
  std::string Record(const std::string& file) {
    const std::lock_guard lock(host_.mutex());
    const soarbox::Result<void> kept = soarbox::server::KeepLog(host_, file, soarbox::wire::kSmlVersion);
    if (kept) return {};
    const soarbox::Diagnostic& problem = kept.error();
    return problem.file + ": " + problem.message + "; " + problem.hint;
  }

  void FenceFiles(std::vector<std::string> folders, bool rules_only) override {
    const std::lock_guard lock(host_.mutex());
    host_.SetFence({folders.begin(), folders.end()}, rules_only);
  }

  int ListenerPort() override { return host_.Port(); }
  long long InitialTimeTag() override { return host_.AssignTimeTags(*this); }
  std::string Version() override { return std::string(soarbox::wire::kSmlVersion); }

  std::unique_ptr<AgentLink> CreateAgent(Agent& agent, const std::string& name, std::string&) override {
    HostedAgent* hosted = host_.CreateAgent(name);
    if (!hosted) return nullptr;
    hosted->embedded_peer = &agent;
    return std::make_unique<LocalAgentLink>(host_, *this, *hosted);
  }
  void AnnounceAgent(const std::string& name) override {
    if (HostedAgent* hosted = host_.Find(name)) host_.AnnounceAgent(*hosted);
  }
  std::unique_ptr<AgentLink> FindAgent(Agent& agent, const std::string& name) override {
    HostedAgent* hosted = host_.Find(name);
    if (!hosted) return nullptr;
    hosted->embedded_peer = &agent;
    return std::make_unique<LocalAgentLink>(host_, *this, *hosted);
  }
  bool DestroyAgent(const std::string& name, std::string& error) override {
    HostedAgent* hosted = host_.Find(name);
    if (!hosted) {
      error = "Could not find an agent with name: " + name;
      return false;
    }
    host_.DestroyAgent(*hosted);
    return true;
  }
  std::vector<std::string> AgentNames() override {
    std::vector<std::string> names;
    for (const HostedAgent* hosted : host_.agents()) names.push_back(hosted->name());
    return names;
  }

  LineAnswer Execute(const char* agent, AgentLink* link, const LineRequest& request) override {
    HostedAgent* hosted = link ? &static_cast<LocalAgentLink*>(link)->hosted() : nullptr;
    if (!hosted && agent && *agent) hosted = host_.Find(agent);
    if (!hosted && agent && *agent) return Unknown(agent, request.structured);
    const soarbox::cli::CommandResult result =
        host_.Execute(hosted, request.line, {request.echo, !request.no_filter, this, request.fenced, request.recorded});
    return Answer(result, request.structured);
  }

  LineAnswer Run(const char* agent, AgentLink* link, const RunSpec& spec, bool want_text) override {
    LineAnswer answer;
    if (host_.HasFilters()) {
      const std::string line = RunLine(spec);
      answer = Execute(agent, link, {line, false, false, false});
      return answer;
    }
    answer.ok = false;
    if (host_.running()) {
      answer.text = "Soar is already running";
      return answer;
    }
    if (!spec.forever && (spec.count < 0 || (spec.count == 0 && spec.step != sml_DECIDE))) {
      answer.text = "Count must be positive.";
      return answer;
    }
    if (spec.interleave_given && !spec.forever && SizeOf(spec.interleave) > SizeOf(spec.step)) {
      answer.text = "Run type and interleave setting incompatible.";
      return answer;
    }
    soarbox::cli::RunRequest request;
    request.unit = spec.forever ? RunUnit::kForever : UnitOf(spec.step);
    request.count = static_cast<std::uint64_t>(spec.forever ? 1 : spec.count);
    request.interleave = UnitOf(spec.interleave);
    request.self_only = spec.self;
    const soarbox::server::KernelHost::Stay stay(host_);
    HostedAgent& hosted = static_cast<LocalAgentLink*>(link)->hosted();
    answer.ok = true;
    const auto before = soarbox::cli::RunCounts::Of(hosted.agent());
    const soarbox::kernel::RunResult result = host_.RunAgents(hosted, request, spec.interleave_given);
    if (!want_text && result.reason != soarbox::kernel::StopReason::kHalted) return answer;
    // A handler may have destroyed the agent meanwhile.
    if (hosted.doomed) return answer;
    answer.text = soarbox::cli::RunText(hosted.agent(), before, result);
    answer.ok = !hosted.agent().out_of_memory();
    return answer;
  }

  void StopAll() override { host_.StopAll(); }
  bool IsRunning() override { return host_.running(true); }

  void Register(int event) override { host_.Register(*this, nullptr, event); }
  void Unregister(int event) override { host_.Unregister(*this, nullptr, event); }
  void RegisterFunction(int event, const std::string& name) override { host_.RegisterFunction(*this, event, name); }
  void UnregisterFunction(int event, const std::string& name) override { host_.UnregisterFunction(*this, event, name); }
  std::optional<std::string> SendClientMessage(Agent* agent, const std::string& client,
                                               const std::string& message) override {
    HostedAgent* hosted = agent ? host_.Find(agent->GetAgentName()) : nullptr;
    return host_.CallFunction(hosted, smlEVENT_CLIENT_MESSAGE, client, message);
  }
  bool FireSystem(int event) override {
    host_.FireSystem(event);
    return true;
  }
  bool SuppressSystemStop(bool on) override {
    host_.SuppressSystemStop(on);
    return true;
  }
  bool SetInterruptCheckRate(int rate) override {
    host_.SetInterruptCheckRate(rate);
    return rate > 0;
  }
  std::vector<soarbox::server::ConnectionInfo> Connections() override {
    std::vector<soarbox::server::ConnectionInfo> infos;
    for (const Connection* connection : host_.connections()) infos.push_back(connection->info);
    return infos;
  }
  bool SetConnectionInfo(const std::string& name, const std::string& status, const std::string& agent_status) override {
    info.name = name;
    info.status = status;
    info.agent_status = agent_status;
    return true;
  }
  std::string LoadLibrary(const std::string& command) override { return LoadSmlLibrary(kernel_.kernel, command); }

  bool CheckForIncoming() override {
    const std::lock_guard lock(host_.mutex());
    return listener_ && !closed_ && listener_->Serve();
  }
  bool StartEventThread() override { return true; }
  bool StopEventThread() override { return true; }
  void SetTrace(bool) override {}

  // Events of the kernel.
  void OnSystemEvent(int event) override { kernel_.OnSystem(event); }
  void OnUpdateEvent(int event, int run_flags) override { kernel_.OnUpdate(event, run_flags); }
  void OnAgentEvent(HostedAgent& agent, int event) override {
    const std::string name = agent.name();
    kernel_.OnAgent(name, event);
  }
  void OnRunEvent(HostedAgent& agent, int event, int phase) override { Data(agent).OnRun(event, phase); }
  void OnProductionEvent(HostedAgent& agent, int event, std::string_view name) override {
    Data(agent).OnProduction(event, name);
  }
  void OnPrint(HostedAgent& agent, const std::string& text) override {
    if (Peer(agent)) Data(agent).OnPrint(smlEVENT_PRINT, text, false);
  }
  void OnEcho(HostedAgent& agent, const std::string& text, bool self) override {
    Data(agent).OnPrint(smlEVENT_ECHO, text, self);
  }
  void OnXmlTrace(HostedAgent& agent, std::string_view pieces) override {
    auto trace = soarbox::wire::ReadXml("<trace>" + std::string(pieces) + "</trace>");
    if (!trace) return;
    auto shared = std::make_shared<soarbox::wire::Element>(std::move(trace.value()));
    Data(agent).OnXml(smlEVENT_XML_TRACE_OUTPUT, shared);
  }
  void OnXmlInput(HostedAgent& agent, std::span<const InputWme> wmes) override {
    Data(agent).OnXml(smlEVENT_XML_INPUT_RECEIVED, soarbox::server::InputReceivedDocument(agent, wmes));
  }
  void OnOutput(HostedAgent& agent, std::span<const soarbox::kernel::OutputChange> changes) override {
    Agent* peer = Peer(agent);
    if (!peer || !AgentData::Of(*peer).link) return;
    static_cast<LocalAgentLink&>(*AgentData::Of(*peer).link).Deliver(AgentData::Of(*peer), changes);
  }
  void OnOutputInit(HostedAgent& agent) override { Data(agent).memory.InvalidateOutput(); }
  std::optional<std::string> OnFunction(HostedAgent* agent, int event, std::string_view name,
                                        std::string_view argument) override {
    return kernel_.OnFunction(agent ? Peer(*agent) : nullptr, event, name, argument);
  }

 private:
  static Agent* Peer(HostedAgent& agent) { return static_cast<Agent*>(agent.embedded_peer); }
  static AgentData& Data(HostedAgent& agent) { return AgentData::Of(*Peer(agent)); }

  static LineAnswer Unknown(const char* agent, bool structured) {
    soarbox::cli::CommandResult result;
    result.ok = false;
    result.text = std::string("Could not find an agent with name: ") + agent;
    return Answer(result, structured);
  }

  static LineAnswer Answer(const soarbox::cli::CommandResult& result, bool structured) {
    LineAnswer answer;
    answer.ok = result.ok;
    answer.text = result.text;
    answer.details = result.ok ? soarbox::server::Warnings(result) : soarbox::server::ErrorDetails(result);
    if (structured) answer.document = soarbox::server::StructuredDocument(result);
    return answer;
  }

  /// Records the clients if the environment names a file, for programs that cannot be changed. A second kernel of the
  /// program gets a separate file.
  void RecordIfAsked() {
    const char* const named = std::getenv("SOARBOX_RECORD");
    if (named == nullptr || *named == '\0') return;
    static std::atomic<int> kernels{0};
    const int number = ++kernels;
    std::filesystem::path file(named);
    if (number > 1)
      file.replace_filename(file.stem().string() + "-" + std::to_string(number) + file.extension().string());
    if (const std::string problem = Record(file.string()); !problem.empty())
      std::fprintf(stderr, "soarbox: SOARBOX_RECORD: %s\n", problem.c_str());
  }

  void Listen(bool own_thread, int port, std::string& error) {
    // "Any port" allows a kernel without a listener, so a build without sockets continues. For a specific port this is
    // an error.
    if (port == Kernel::kUseAnyPort && !soarbox::wire::HasSockets()) return;
    soarbox::server::ListenerOptions options;
    options.port = port;
    const soarbox::Result<std::string> secret = soarbox::wire::SecretOfEnvironment();
    if (!secret) {
      error = secret.error().file + ": " + secret.error().message;
      return;
    }
    options.secret = *secret;
    auto opened = soarbox::server::Listener::Open(host_, options);
    if (!opened) {
      error = opened.error().message;
      if (!opened.error().hint.empty()) error += " (" + opened.error().hint + ")";
      return;
    }
    listener_ = std::move(opened.value());
    host_.SetPort(listener_->port());
    host_.SetPump([this] { listener_->Serve(); });
    if (!own_thread) {
      listener_->SetWake([this] { host_.RequestPump(); });
      return;
    }
    listener_->SetWake([this] {
      host_.RequestPump();
      const std::lock_guard lock(wake_mutex_);
      awake_ = true;
      wake_.notify_one();
    });
    server_ = std::thread([this] { ServeForEver(); });
  }

  void ServeForEver() {
    while (true) {
      {
        std::unique_lock lock(wake_mutex_);
        wake_.wait(lock, [this] { return awake_; });
        awake_ = false;
        if (stopping_) return;
      }
      const std::lock_guard lock(host_.mutex());
      if (!closed_) host_.Pump();
    }
  }

  void StopServing() {
    if (!server_.joinable()) return;
    {
      const std::lock_guard lock(wake_mutex_);
      stopping_ = true;
      awake_ = true;
      wake_.notify_one();
    }
    if (server_.get_id() == std::this_thread::get_id()) {
      server_.detach();
    } else {
      server_.join();
    }
  }

  KernelData& kernel_;
  KernelHost host_;
  std::unique_ptr<soarbox::server::Listener> listener_;
  std::thread server_;
  std::mutex wake_mutex_;
  std::condition_variable wake_;
  bool awake_ = false;
  bool stopping_ = false;
  std::atomic<bool> closed_{false};
};

}  // namespace

std::unique_ptr<KernelLink> MakeLocalLink(KernelData& kernel, bool own_thread, int port, std::string& error) {
  return std::make_unique<LocalLink>(kernel, own_thread, port, error);
}

}  // namespace sml

namespace soarbox {

std::string RecordClients(sml::Kernel& kernel, const std::string& file) {
  sml::KernelLink* const link = sml::KernelData::Of(kernel).link.get();
  if (link == nullptr) return "the kernel no longer exists";
  auto* const local = dynamic_cast<sml::LocalLink*>(link);
  if (local != nullptr) return local->Record(file);
  return file + ": the kernel is in another process; record where it runs: soarbox kernel --record FILE";
}

}  // namespace soarbox
