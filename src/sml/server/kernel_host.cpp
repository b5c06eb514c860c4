// SPDX-License-Identifier: BSD-2-Clause
#include "sml/server/kernel_host.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "cli/tokens.h"
#include "diagnostics/problem.h"

namespace soarbox::server {

using namespace ::sml;

KernelHost::KernelHost() : run_(*this), interpreter_(this) {}

KernelHost::~KernelHost() {
  order_.clear();
  by_name_.clear();
}

HostedAgent* KernelHost::CreateAgent(const std::string& name) {
  if (Find(name)) return nullptr;
  auto created = std::make_unique<HostedAgent>(name);
  HostedAgent* hosted = created.get();
  by_name_.emplace(name, std::move(created));
  const auto before = [](const HostedAgent* known, const std::string& wanted) { return known->name() < wanted; };
  order_.insert(std::lower_bound(order_.begin(), order_.end(), name, before), hosted);
  InstallFunctions(*hosted);
  if (log) {
    log->AgentMade(name);
    hosted->log = log.get();
    hosted->input().SetLog(log.get(), *hosted);
  }
  SourceSettings(*hosted);
  return hosted;
}

Result<void> KeepLog(KernelHost& host, const std::string& file, std::string_view build) {
  if (host.log) return ProblemIn(file, "this kernel is being recorded already", "a kernel has one recording");
  if (!host.agents().empty())
    return ProblemIn(file, "this kernel has agents already", "record before you create the first agent");
  Result<std::unique_ptr<ClientLog>> log = ClientLog::Create(file, build);
  if (!log) return log.error();
  host.log = std::move(*log);
  for (const KernelHost::Function& function : host.functions_)
    if (function.event == smlEVENT_RHS_USER_FUNCTION) host.log->FunctionMade(function.name);
  host.interpreter().on_file_read = [&host](const std::filesystem::path& path, std::string_view content) {
    host.log->FileRead(path.string(), content);
  };
  return {};
}

void KernelHost::SourceSettings(HostedAgent& hosted) {
  std::error_code ignored;
  const char* home = std::getenv("SOAR_HOME");
  std::vector<std::filesystem::path> folders{interpreter_.directory()};
  if (home) folders.emplace_back(home);
  for (const std::filesystem::path& folder : folders) {
    const std::filesystem::path file = folder / "settings.soar";
    if (!std::filesystem::exists(file, ignored)) continue;
    // If a fence protects from untrusted files, settings in the working directory may be untrusted; $SOAR_HOME belongs
    // to the user.
    const bool is_own = home != nullptr && folder == home;
    if (fence_ && !is_own && !fence_->MayRead(file)) continue;
    const cli::Interpreter::Fenced fenced(interpreter_, is_own ? nullptr : fence_.get());
    interpreter_.Execute(hosted.session(), "source " + cli::QuoteWord(file.string()));
    return;
  }
}

void KernelHost::InstallFunctions(HostedAgent& hosted) {
  hosted.agent().SetUserFunctions(
      [this, &hosted](kernel::Agent& agent, std::string_view name,
                      std::span<const kernel::Symbol> arguments) -> Result<kernel::Symbol> {
        std::string argument;
        for (const kernel::Symbol symbol : arguments) kernel::AppendTo(argument, agent.symbols(), symbol, false);
        const auto answer = CallFunction(&hosted, smlEVENT_RHS_USER_FUNCTION, name, argument);
        if (answer) return agent.mutable_symbols().String(*answer);
        return agent.mutable_symbols().String("Error: Nobody was registered to implement rhs function " +
                                              std::string(name));
      },
      [this](std::string_view name) {
        if (player && player->Knows(name)) return true;
        return std::ranges::any_of(functions_, [&](const auto& function) {
          return function.event == smlEVENT_RHS_USER_FUNCTION && function.name == name;
        });
      });
  hosted.agent().SetCommandRunner([this, &hosted](kernel::Agent&, std::string_view line) {
    LineOptions options;
    options.fenced = true;
    const cli::CommandResult result = Execute(&hosted, line, options);
    // The output of a command ends with a line end; its error message does not.
    return !result.ok && result.text.ends_with('\n') ? result.text.substr(0, result.text.size() - 1) : result.text;
  });
}

void KernelHost::DestroyAgent(HostedAgent& hosted) {
  const Stay stay(*this);
  FireAgent(hosted, smlEVENT_BEFORE_AGENT_DESTROYED);
  const auto found = by_name_.find(hosted.name());
  if (found == by_name_.end() || found->second.get() != &hosted) return;
  if (log) log->AgentGone(hosted);
  std::erase(order_, &hosted);
  if (last_addressed_ == &hosted) last_addressed_ = nullptr;
  hosted.doomed = true;
  hosted.RequestStop();
  doomed_.push_back(std::move(found->second));
  by_name_.erase(found);
}

void KernelHost::DestroyAllAgents() {
  const Stay stay(*this);
  while (!order_.empty()) DestroyAgent(*order_.front());
}

void KernelHost::BuryDoomed() {
  std::vector<std::unique_ptr<HostedAgent>> gone;
  gone.swap(doomed_);
}

HostedAgent* KernelHost::Find(std::string_view name) {
  const auto found = by_name_.find(name);
  return found == by_name_.end() ? nullptr : found->second.get();
}

HostedAgent* KernelHost::Addressed(HostedAgent* hosted) {
  if (!hosted) hosted = last_addressed_;
  if (!hosted && !order_.empty()) hosted = order_.front();
  if (hosted) {
    last_addressed_ = hosted;
    return hosted;
  }
  if (!nobody_) nobody_ = std::make_unique<HostedAgent>("");
  return nobody_.get();
}

kernel::RunResult KernelHost::RunAgents(HostedAgent& addressed, const cli::RunRequest& request, bool interleave_given) {
  if (player && player->is_in_line()) return {};
  const Stay stay(*this);
  return run_.Run(addressed, request, interleave_given);
}

kernel::RunResult KernelHost::Run(cli::Session& session, const cli::RunRequest& request) {
  return RunAgents(static_cast<HostedSession&>(session).hosted(), request, request.interleave_given);
}

void KernelHost::Stop(cli::Session& session, bool self_only) {
  if (!self_only) {
    StopAll();
    return;
  }
  static_cast<HostedSession&>(session).hosted().RequestStop();
}

void KernelHost::Reinitialize(cli::Session& session) {
  Initialize(static_cast<HostedSession&>(session).hosted());
}

bool KernelHost::IsRunning(cli::Session& session) const {
  return running() || session.agent().running();
}

void KernelHost::Initialize(HostedAgent& hosted) {
  FireAgent(hosted, smlEVENT_BEFORE_AGENT_REINITIALIZED);
  if (hosted.Listens(smlEVENT_OUTPUT_PHASE_CALLBACK)) {
    std::vector<kernel::OutputChange> removals(hosted.agent().output().current().begin(),
                                               hosted.agent().output().current().end());
    for (kernel::OutputChange& change : removals) change.added = false;
    hosted.FireOutput(removals);
    hosted.FireOutputInit();
  }
  hosted.input().Clear();
  hosted.agent().InitSoar();
  hosted.FlushPrint();
  hosted.FireOutput({});
  hosted.run_state = sml_RUNSTATE_STOPPED;
  hosted.last_run = 0;
  FireAgent(hosted, smlEVENT_AFTER_AGENT_REINITIALIZED);
  hosted.FlushXmlTrace();
}

void KernelHost::ServePump() {
  pump_requested_.store(false, std::memory_order_release);
  if (pump_) pump_();
}

}  // namespace soarbox::server
