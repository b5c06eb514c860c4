// SPDX-License-Identifier: BSD-2-Clause
#include "sim/soar_host.h"

#include <chrono>
#include <fstream>
#include <limits>
#include <mutex>
#include <system_error>
#include <thread>

#include "sml_Client.h"

namespace soarbox::sim {
namespace {

Diagnostic Problem(std::string message, std::string hint = {}) {
  Diagnostic diagnostic;
  diagnostic.message = std::move(message);
  diagnostic.hint = std::move(hint);
  return diagnostic;
}

std::string AddressOf(const SoarSettings& settings) {
  return settings.remote_host + ":" + std::to_string(settings.remote_port);
}

/// Our client library can give up a kernel that does not answer; an official Soar in its place waits on.
template <typename Kernel>
void SetAnswerLimit(Kernel& kernel, int milliseconds) {
  if constexpr (requires { kernel.SetAnswerLimit(milliseconds); }) kernel.SetAnswerLimit(milliseconds);
}

/// Never null; asks for HadError().
std::unique_ptr<::sml::Kernel> Connect(const SoarSettings& settings) {
  std::unique_ptr<::sml::Kernel> kernel(
      ::sml::Kernel::CreateRemoteConnection(true, settings.remote_host.c_str(), settings.remote_port));
  SetAnswerLimit(*kernel, settings.remote_limit_ms);
  return kernel;
}

void RemoveAgents(::sml::Kernel& kernel, const std::set<std::string>& names) {
  for (const std::string& name : names) {
    if (::sml::Agent* agent = kernel.GetAgent(name.c_str())) kernel.DestroyAgent(agent);
  }
}

std::string ErrorText(::sml::ClientErrors& source) {
  const char* text = source.GetLastErrorDescription();
  return text == nullptr ? "no reason given" : text;
}

/// Collects what an agent prints while its rules are loaded.
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
      return Problem(
          "no Soar kernel answers at " + AddressOf(settings) + " (" + ErrorText(*kernel) + ")",
          "start one there, for example with: soarbox kernel --port " + std::to_string(settings.remote_port));
    }
    if (settings.port != 0) {
      return Problem(
          "port " + std::to_string(settings.port) + " cannot be opened for debuggers (" + ErrorText(*kernel) + ")",
          "another program holds it; choose another with --port N, or none with --port 0");
    }
    return Problem("the Soar kernel did not start: " + ErrorText(*kernel));
  }
  return std::unique_ptr<SoarHost>(new SoarHost(std::move(kernel), settings));
}

SoarHost::SoarHost(std::unique_ptr<::sml::Kernel> kernel, const SoarSettings& settings)
    : kernel_(std::move(kernel)), settings_(settings) {}

SoarHost::~SoarHost() {
  // A kernel elsewhere goes on after this run; the next one may want the same names.
  if (IsRemote() && IsConnected()) RemoveAgents(*kernel_, agents_);
  kernel_->Shutdown();
}

Result<SoarHost::Loaded> SoarHost::CreateAgent(const std::string& name, const std::filesystem::path& rules) {
  const std::string file = rules.string();
  if (!std::ifstream(rules)) {
    Diagnostic problem =
        Problem("the rules of " + name + " cannot be read", "check the name, or add their folder with --path");
    problem.file = file;
    return problem;
  }
  if (IsRemote() && kernel_->GetAgent(name.c_str()) != nullptr) {
    return Problem("the kernel at " + AddressOf(settings_) + " already has an agent named " + name,
                   "another run may be using that kernel; give this one a kernel of its own");
  }
  Loaded loaded;
  loaded.agent = kernel_->CreateAgent(name.c_str());
  if (loaded.agent == nullptr) return Problem("the kernel refuses an agent named " + name + ": " + ErrorText(*kernel_));
  agents_.insert(name);
  loaded.agent->ExecuteCommandLine("watch 0");
  // Each agent draws from a stream of its own, given by the run's seed and its place in the order of creation.
  const std::uint64_t seed = (settings_.seed * 1000003u + ++agents_made_) & std::numeric_limits<std::int32_t>::max();
  loaded.agent->ExecuteCommandLine(("srand " + std::to_string(seed)).c_str());

  std::error_code ignored;
  const std::filesystem::path absolute = std::filesystem::absolute(rules, ignored);
  PrintCollector printed(*loaded.agent);
  const bool ok = loaded.agent->LoadProductions(absolute.string().c_str(), false);
  loaded.problems = ParseDiagnostics(printed.text(), file);
  if (!ok) {
    std::vector<Diagnostic> more = ParseDiagnostics(ErrorText(*loaded.agent), file);
    if (loaded.problems.empty()) loaded.problems = std::move(more);
  }
  for (Diagnostic& problem : loaded.problems) {
    if (problem.file == absolute.string()) problem.file = file;
  }
  loaded.agent->SetBlinkIfNoChange(true);
  return loaded;
}

void SoarHost::ServeClients() {
  while (kernel_->CheckForIncomingCommands()) {
  }
}

bool SoarHost::IsConnected() const {
  return !IsRemote() || !kernel_->IsConnectionClosed();
}

/// One call for a kernel, on a thread of its own: an address that swallows packets would hold up the world for minutes.
/// The thread shares this, so that a host that ends meanwhile need not wait for it.
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

  /// The kernel once the call has ended, with its error if nobody answered; null before.
  std::unique_ptr<::sml::Kernel> Take() {
    const std::lock_guard lock(mutex_);
    return std::move(kernel_);
  }
  bool IsOld() const { return std::chrono::steady_clock::now() - begun_ >= std::chrono::seconds(1); }

  bool ended = false;  ///< Its outcome has been taken; the next attempt is due when this one is old.

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
  attempt_.reset();
  // If it is the same kernel, and only the connection broke, the agents of before are still there.
  RemoveAgents(*kernel_, agents_);
  agents_.clear();
  agents_made_ = 0;
  return true;
}

}  // namespace soarbox::sim
