// SPDX-License-Identifier: BSD-2-Clause
#include <mutex>

#include "cli/tokens.h"
#include "sml/client/agent_data.h"
#include "sml/client/hold.h"
#include "sml/client/sml_ClientAnalyzedXML.h"

namespace sml {

namespace {

/// A file name without the quotes or braces around it.
std::string_view Unwrapped(std::string_view name) {
  if (name.size() < 2) return name;
  const bool quoted = name.front() == '"' && name.back() == '"';
  const bool braced = name.front() == '{' && name.back() == '}';
  return quoted || braced ? name.substr(1, name.size() - 2) : name;
}

}  // namespace

bool Agent::LoadProductions(char const* pFilename, bool echoResults) {
  const Lock lock = Hold(*data_);
  if (!pFilename) {
    SetDetailedError(kNullArgument, "The name of the file to load is NULL");
    return false;
  }
  AgentLink* link = data_->Usable();
  if (!link) return false;
  const std::string line = "source " + soarbox::cli::QuoteWord(Unwrapped(pFilename));
  KernelData& kernel = data_->kernel_data();
  LineAnswer answer = kernel.link->Execute(GetAgentName(), link, {line, echoResults, !kernel.filtering, false, true});
  kernel.last_line_ok = answer.ok;
  data_->load_warnings.clear();
  if (answer.ok) {
    ClearError();
    data_->load_warnings = std::move(answer.details);
  } else {
    SetDetailedError(kDetailedError, answer.details.empty() ? answer.text.c_str() : answer.details.c_str());
  }
  kernel.Answer(std::move(answer.text));
  return kernel.last_line_ok;
}

char const* Agent::GetLoadWarnings() const {
  return data_->load_warnings.c_str();
}

char const* Agent::InitSoar() {
  const Lock lock = Hold(*data_);
  if (data_->memory.IsCommitRequired()) data_->memory.Commit();
  return ExecuteCommandLine("init-soar");
}

char const* AgentData::Run(const RunSpec& spec) {
  const Lock lock = Hold(*this);
  KernelData& data = kernel_data();
  if (!Usable()) return data.Answer("The agent has been destroyed");
  if (memory.IsCommitRequired()) return data.Answer("Need to commit changes before calling a run method");
  LineAnswer answer = data.link->Run(name.c_str(), link.get(), spec, !data.direct);
  if (data.direct && answer.ok) return "DirectRun completed";
  data.last_line_ok = answer.ok;
  return data.Answer(std::move(answer.text));
}

char const* Agent::RunSelf(int numberSteps, smlRunStepSize stepSize) {
  RunSpec spec;
  spec.count = numberSteps;
  spec.step = stepSize;
  return data_->Run(spec);
}

char const* Agent::RunSelfForever() {
  RunSpec spec;
  spec.forever = true;
  return data_->Run(spec);
}

char const* Agent::RunSelfTilOutput() {
  RunSpec spec;
  spec.step = sml_UNTIL_OUTPUT;
  return data_->Run(spec);
}

char const* Agent::StopSelf() {
  // Without the lock, because another thread may hold it during the entire run.
  if (AgentLink* link = data_->Usable()) link->StopSelf();
  return "";
}

char const* Agent::ExecuteCommandLine(char const* pCommandLine, bool echoResults, bool noFilter) {
  return data_->kernel.ExecuteCommandLine(pCommandLine, GetAgentName(), echoResults, noFilter);
}

bool Agent::ExecuteCommandLineXML(char const* pCommandLine, ClientAnalyzedXML* pResponse) {
  return data_->kernel.ExecuteCommandLineXML(pCommandLine, GetAgentName(), pResponse);
}

bool Agent::GetLastCommandLineResult() {
  return data_->kernel.GetLastCommandLineResult();
}

void Agent::SendSVSInput(std::string const& txt) {
  const Lock lock = Hold(*data_);
  AgentLink* const link = data_->Usable();
  if (!link) return;
  if (link->SendScene(txt)) {
    ClearError();
  } else {
    SetDetailedError(kDetailedError, "The spatial visual system is off: enable it with the command svs --enable");
  }
}

std::string Agent::GetSVSOutput() {
  const Lock lock = Hold(*data_);
  AgentLink* const link = data_->Usable();
  return link ? link->TakeRefusedScene() : std::string();
}

std::string Agent::SVSQuery(std::string const& q) {
  const Lock lock = Hold(*data_);
  AgentLink* const link = data_->Usable();
  return link ? link->QueryScene(q) : std::string();
}

}  // namespace sml
