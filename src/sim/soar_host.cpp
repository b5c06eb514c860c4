// SPDX-License-Identifier: BSD-2-Clause
#include "sim/soar_host.h"

#include <algorithm>
#include <chrono>
#include <fstream>
#include <limits>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>

#include "diagnostics/problem.h"
#include "explain/clarify_errors.h"
#include "sim/vet_rules.h"
#include "sim/worker_pool.h"
#include "sml_Client.h"

namespace soarbox::sim {
namespace {

namespace fs = std::filesystem;

std::string AddressOf(const SoarSettings& settings) {
  return settings.remote_host + ":" + std::to_string(settings.remote_port);
}

/// Our client library can drop a kernel that does not answer; official Soar keeps waiting.
template <typename Kernel>
void SetAnswerLimit(Kernel& kernel, int milliseconds) {
  if constexpr (requires { kernel.SetAnswerLimit(milliseconds); }) kernel.SetAnswerLimit(milliseconds);
}

/// Our own kernel reports commands of debuggers, and accepts them only between two ticks, so that they are inputs of
/// the run.
template <typename Kernel>
void Overhear(Kernel& kernel, std::vector<CommandInput>& heard) {
  if constexpr (requires { kernel.HoldIncomingCommands(true); }) {
    kernel.OverhearCommands([&heard](char const* agent, char const* line) { heard.push_back({agent, line}); });
    kernel.HoldIncomingCommands(true);
  }
}

template <typename Kernel>
void Hold(Kernel& kernel, bool on) {
  if constexpr (requires { kernel.HoldIncomingCommands(on); }) kernel.HoldIncomingCommands(on);
}

/// Rule files may come from untrusted authors: our own kernel restricts their commands to the scenario's folders.
template <typename Kernel>
void PutUpFence(Kernel& kernel, const SoarSettings& settings) {
  if constexpr (requires { kernel.FenceFiles(std::vector<std::string>(), false); }) {
    std::vector<std::string> names;
    for (const std::filesystem::path& folder : settings.folders) names.push_back(folder.string());
    if (!names.empty() || settings.rules_only) kernel.FenceFiles(std::move(names), settings.rules_only);
  }
}

/// Percepts are sent to a kernel in another process as one message before each decision, not as one message per
/// element.
void WriteInTurns(::sml::Kernel& kernel) {
  kernel.SetAutoCommit(false);
}

/// A recording may also come from an untrusted author. Only our own kernel can restrict commands (PutUpFence). For
/// other kernels, returns null and executes nothing.
template <typename Kernel>
const char* ExecuteRecorded(Kernel& kernel, const char* line, const char* agent) {
  if constexpr (requires { kernel.ExecuteRecordedCommandLine(line, agent); })
    return kernel.ExecuteRecordedCommandLine(line, agent);
  return nullptr;
}

/// Warnings of our own kernel about loaded rules. Official Soar has no such warnings.
template <typename Agent>
const char* LoadWarnings(const Agent& agent) {
  if constexpr (requires { agent.GetLoadWarnings(); }) return agent.GetLoadWarnings();
  return "";
}

/// Finds the agents that other programs have created in the kernel since then.
template <typename Kernel>
void FindNewAgents(Kernel& kernel) {
  if constexpr (requires { kernel.UpdateAgentList(); }) kernel.UpdateAgentList();
}

/// An agent that another program created and runs. The host does not own it, and does not destroy it.
template <typename Kernel>
Result<SoarHost::Loaded> Attach(Kernel& kernel, const std::string& name) {
  FindNewAgents(kernel);
  SoarHost::Loaded loaded;
  loaded.agent = kernel.IsRemoteConnection() ? kernel.GetAgent(name.c_str()) : nullptr;
  if (loaded.agent == nullptr) return NewProblem("the kernel has no agent named " + name);
  return loaded;
}

/// Returns a kernel, never null. If the connection failed, its HadError() is true.
std::unique_ptr<::sml::Kernel> Connect(const SoarSettings& settings) {
  std::unique_ptr<::sml::Kernel> kernel(
      ::sml::Kernel::CreateRemoteConnection(true, settings.remote_host.c_str(), settings.remote_port));
  SetAnswerLimit(*kernel, settings.remote_limit_ms);
  return kernel;
}

void RemoveAgents(::sml::Kernel& kernel, const std::map<std::string, std::size_t>& agents) {
  for (const auto& [name, thread] : agents) {
    if (::sml::Agent* agent = kernel.GetAgent(name.c_str())) kernel.DestroyAgent(agent);
  }
}

std::string ErrorText(::sml::ClientErrors& source) {
  const char* text = source.GetLastErrorDescription();
  return text == nullptr ? "no reason given" : text;
}

/// Collects the output of an agent while its rules are loaded.
class PrintCollector {
 public:
  explicit PrintCollector(::sml::Agent& agent)
      : agent_(agent), callback_(agent.RegisterForPrintEvent(::sml::smlEVENT_PRINT, &PrintCollector::OnPrint, this)) {}
  ~PrintCollector() { agent_.UnregisterForPrintEvent(callback_); }
  PrintCollector(const PrintCollector&) = delete;
  PrintCollector& operator=(const PrintCollector&) = delete;

  const std::string& text() const { return text_; }

 private:
  static void OnPrint(::sml::smlPrintEventId, void* self, ::sml::Agent*, char const* message) {
    static_cast<PrintCollector*>(self)->text_ += message;
  }

  ::sml::Agent& agent_;
  int callback_;
  std::string text_;
};

}  // namespace

Result<std::unique_ptr<SoarHost>> SoarHost::Create(const SoarSettings& settings) {
  std::unique_ptr<::sml::Kernel> kernel;
  if (!settings.remote_host.empty()) {
    kernel = Connect(settings);
  } else {
    const int port = settings.port == 0 ? static_cast<int>(::sml::Kernel::kSuppressListener) : settings.port;
    kernel.reset(::sml::Kernel::CreateKernelInCurrentThread(true, port));
  }
  if (kernel->HadError()) {
    if (!settings.remote_host.empty()) {
      return NewProblem(
          "no Soar kernel answers at " + AddressOf(settings) + " (" + ErrorText(*kernel) + ")",
          "start one there, for example with: soarbox kernel --port " + std::to_string(settings.remote_port));
    }
    if (settings.port != 0) {
      return NewProblem(
          "port " + std::to_string(settings.port) + " cannot be opened for debuggers (" + ErrorText(*kernel) + ")",
          "another program uses it; choose another with --port N, or none with --port 0");
    }
    return NewProblem("the Soar kernel did not start: " + ErrorText(*kernel));
  }
  return std::unique_ptr<SoarHost>(new SoarHost(std::move(kernel), settings));
}

SoarHost::SoarHost(std::unique_ptr<::sml::Kernel> kernel, const SoarSettings& settings)
    : kernel_(std::move(kernel)), settings_(settings) {
  Overhear(*kernel_, heard_);
  PutUpFence(*kernel_, settings_);
  if (IsRemote()) WriteInTurns(*kernel_);
#ifdef SOARBOX_OWN_KERNEL
  // Official kernels share global data, so that several in one process crash.
  if (!IsRemote() && settings_.port == 0) MakeFurtherKernels();
#endif
}

void SoarHost::MakeFurtherKernels() {
  constexpr int kMostThreads = 64;
  const int wanted = settings_.threads != 0 ? settings_.threads : static_cast<int>(std::thread::hardware_concurrency());
  for (int thread = 1; thread < std::min(wanted, kMostThreads); ++thread) {
    std::unique_ptr<::sml::Kernel> kernel(
        ::sml::Kernel::CreateKernelInCurrentThread(true, static_cast<int>(::sml::Kernel::kSuppressListener)));
    if (kernel->HadError()) return;
    PutUpFence(*kernel, settings_);
    further_.push_back(std::move(kernel));
  }
}

SoarHost::~SoarHost() {
  // A remote kernel continues after this run, and the next run may use the same names.
  if (IsRemote() && IsConnected()) RemoveAgents(*kernel_, agents_);
  kernel_->Shutdown();
  for (const auto& kernel : further_) kernel->Shutdown();
}

Result<SoarHost::Loaded> SoarHost::CreateAgent(const std::string& name, const std::filesystem::path& rules,
                                               const char* first, bool beside_world) {
  if (rules.empty()) return Attach(*kernel_, name);
  const std::string file = rules.string();
  if (std::error_code error; fs::exists(rules, error) && !fs::is_regular_file(rules, error)) {
    Diagnostic problem = NewProblem("the rules of " + name + " are not a plain file", "name a file of rules");
    problem.file = file;
    return problem;
  }
  if (!std::ifstream(rules)) {
    Diagnostic problem =
        NewProblem("the rules of " + name + " cannot be read", "check the name, or add their folder with --path");
    problem.file = file;
    return problem;
  }
  if (IsRemote() && kernel_->GetAgent(name.c_str()) != nullptr) {
    return NewProblem("the kernel at " + AddressOf(settings_) + " already has an agent named " + name,
                      "another run may be using that kernel; give this one a kernel of its own");
  }
  Loaded loaded;
  loaded.thread = ThreadOf(agents_made_, threads());
  if (beside_world) {
    // With four threads: 1 2 3 0 1 2 3.
    const std::uint64_t turn = made_beside_world_++ % (2 * threads() - 1);
    loaded.thread = (turn + 1) % threads();
  }
  ::sml::Kernel& kernel = KernelOf(loaded.thread);
  loaded.agent = agents_.contains(name) ? nullptr : kernel.CreateAgent(name.c_str());
  if (loaded.agent == nullptr)
    return NewProblem("the kernel refuses an agent named " + name + ": " + ErrorText(kernel));
  agents_[name] = loaded.thread;
  loaded.agent->ExecuteCommandLine("watch 0");
  // Each agent has its own random stream, which depends on the run's seed and the order of creation.
  const std::uint64_t seed = (settings_.seed * 1000003u + ++agents_made_) & std::numeric_limits<std::int32_t>::max();
  loaded.agent->ExecuteCommandLine(("srand " + std::to_string(seed)).c_str());

  if (*first != '\0') loaded.agent->ExecuteCommandLine(first);

  std::error_code ignored;
  const std::filesystem::path absolute = std::filesystem::absolute(rules, ignored);
  PrintCollector printed(*loaded.agent);
  const bool ok = loaded.agent->LoadProductions(absolute.string().c_str(), false);
  const std::string reason = ok ? std::string() : ErrorText(*loaded.agent);
  loaded.problems = ParseDiagnostics(printed.text(), file);
  if (!ok) {
    std::vector<Diagnostic> more = ParseDiagnostics(reason, file);
    if (loaded.problems.empty()) loaded.problems = std::move(more);
  } else {
    for (Diagnostic& trap : ParseDiagnostics(LoadWarnings(*loaded.agent), file))
      loaded.problems.push_back(std::move(trap));
  }
  explain::ClarifyErrors(loaded.problems);
  for (Diagnostic& problem : loaded.problems) {
    if (problem.file == absolute.string()) problem.file = file;
  }
  loaded.agent->SetBlinkIfNoChange(true);
  return loaded;
}

void SoarHost::DestroyAgent(const std::string& name) {
  const auto found = agents_.find(name);
  if (found == agents_.end()) return;
  ::sml::Kernel& kernel = KernelOf(found->second);
  if (::sml::Agent* agent = kernel.GetAgent(name.c_str())) kernel.DestroyAgent(agent);
  agents_.erase(found);
}

void SoarHost::ServeClients() {
  Hold(*kernel_, false);
  while (kernel_->CheckForIncomingCommands()) {
  }
  Hold(*kernel_, true);
}

std::vector<CommandInput> SoarHost::TakeHeard() {
  return std::exchange(heard_, {});
}

Result<std::string> SoarHost::Execute(const std::string& agent, const std::string& line, bool recorded) {
  const auto found = agents_.find(agent);
  if (found == agents_.end()) {
    std::vector<std::string_view> names;
    for (const auto& [name, thread] : agents_) names.push_back(name);
    const std::string_view near = Suggest(agent, names);
    return NewProblem("there is no Soar agent '" + agent + "' for the command '" + line + "'",
                      near.empty() ? "" : "did you mean '" + std::string(near) + "'?");
  }
  // Text that does not parse must change nothing, but the kernel would first excise the old rule.
  for (Diagnostic& problem : VetTypedRules(line)) {
    if (problem.severity != Severity::kError) continue;
    problem.hint += std::string(problem.hint.empty() ? "" : "; ") + "nothing was changed";
    return std::move(problem);
  }
  ::sml::Kernel& kernel = KernelOf(found->second);
  if (::sml::Agent* named = kernel.GetAgent(agent.c_str())) named->Commit();
  const char* text = recorded ? ExecuteRecorded(kernel, line.c_str(), agent.c_str())
                              : kernel.ExecuteCommandLine(line.c_str(), agent.c_str());
  if (text == nullptr)
    return NewProblem("the command '" + line + "' comes from a recording, and this kernel cannot restrict it");
  std::string answer = text == nullptr ? "" : text;
  if (kernel.GetLastCommandLineResult()) return answer;
  // Soar adds these texts to every failure, even if no file is read. They do not help a user who typed a line.
  constexpr std::string_view kSourcing = "Error while sourcing file";
  constexpr std::string_view kDetails = "command failed (see return string for details)";
  for (const std::string_view tail : {kSourcing, kDetails}) {
    if (tail == kSourcing && line.starts_with("source")) continue;
    if (const std::size_t at = answer.rfind(tail); at != std::string::npos) answer.erase(at, tail.size());
  }
  answer.erase(answer.find_last_not_of(" \n") + 1);
  return NewProblem("the command '" + line + "' failed for " + agent + ": " + answer);
}

bool SoarHost::IsConnected() const {
  return !IsRemote() || !kernel_->IsConnectionClosed();
}

/// An attempt to connect to a kernel, on a separate thread, because an address that drops packets would block the world
/// for minutes. The thread shares ownership, so that the host can be destroyed without waiting for it.
class SoarHost::Attempt {
 public:
  static std::shared_ptr<Attempt> Start(const SoarSettings& settings) {
    auto attempt = std::make_shared<Attempt>();
    std::thread([attempt, settings] {
      std::unique_ptr<::sml::Kernel> kernel = Connect(settings);
      const std::lock_guard lock(attempt->mutex_);
      attempt->kernel_ = std::move(kernel);
    }).detach();
    return attempt;
  }

  /// The kernel after the attempt has ended, with its error if it failed; null before.
  std::unique_ptr<::sml::Kernel> Take() {
    const std::lock_guard lock(mutex_);
    return std::move(kernel_);
  }
  bool IsOld() const { return std::chrono::steady_clock::now() - begun_ >= std::chrono::seconds(1); }

  bool ended = false;  ///< The result was taken. The next attempt is made after some time.

 private:
  const std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now();
  std::mutex mutex_;
  std::unique_ptr<::sml::Kernel> kernel_;
};

bool SoarHost::Reconnect() {
  if (attempt_ == nullptr || (attempt_->ended && attempt_->IsOld())) attempt_ = Attempt::Start(settings_);
  std::unique_ptr<::sml::Kernel> answered = attempt_->Take();
  if (answered == nullptr) return false;
  attempt_->ended = true;
  if (answered->HadError() || answered->IsConnectionClosed()) return false;
  kernel_->Shutdown();
  kernel_ = std::move(answered);
  PutUpFence(*kernel_, settings_);
  WriteInTurns(*kernel_);
  attempt_.reset();
  // If it is the same kernel and only the connection was lost, the old agents still exist.
  RemoveAgents(*kernel_, agents_);
  agents_.clear();
  agents_made_ = made_beside_world_ = 0;
  return true;
}

}  // namespace soarbox::sim
