// SPDX-License-Identifier: BSD-2-Clause
#include <mutex>

#include "sml/client/agent_data.h"
#include "sml/client/hold.h"
#include "sml/client/local_link.h"
#include "sml/client/remote_link.h"
#include "sml/client/sml_ClientAnalyzedXML.h"

namespace sml {

namespace {

/// Time limit in milliseconds for a kernel's first responses.
constexpr int kGreetingLimitMs = 10'000;

/// Maximum number of destroyed agents that still answer calls with errors; pointers to earlier ones are invalid.
constexpr std::size_t kGraves = 64;

}  // namespace

ConnectionInfo::ConnectionInfo(char const* pID, char const* pName, char const* pStatus, char const* pAgentStatus)
    : id_(pID ? pID : "unknown-id"),
      name_(pName ? pName : "unknown-name"),
      status_(pStatus ? pStatus : "unknown-status"),
      agent_status_(pAgentStatus ? pAgentStatus : "unknown-status") {}

Kernel::Kernel() : data_(std::make_unique<KernelData>(*this)) {}

Kernel::~Kernel() {
  Shutdown();
  data_->agents.clear();
  data_->graveyard.clear();
  data_->link.reset();
}

Kernel* Kernel::CreateKernelInCurrentThread(bool optimized, int portToListenOn) {
  auto* kernel = new Kernel;
  kernel->data_->direct = optimized;
  std::string error;
  kernel->data_->link = MakeLocalLink(*kernel->data_, false, portToListenOn, error);
  kernel->data_->next_tag = kernel->data_->link->InitialTimeTag();
  kernel->data_->next_name = -kernel->data_->next_tag;
  if (!error.empty()) kernel->SetDetailedError(kSocketError, error.c_str());
  return kernel;
}

Kernel* Kernel::CreateKernelInNewThread(int portToListenOn) {
  auto* kernel = new Kernel;
  std::string error;
  kernel->data_->link = MakeLocalLink(*kernel->data_, true, portToListenOn, error);
  kernel->data_->next_tag = kernel->data_->link->InitialTimeTag();
  kernel->data_->next_name = -kernel->data_->next_tag;
  if (!error.empty()) kernel->SetDetailedError(kSocketError, error.c_str());
  return kernel;
}

Kernel* Kernel::CreateRemoteConnection(bool, char const* pIPaddress, int port, bool ignoreOutput) {
  auto* kernel = new Kernel;
  kernel->data_->ignore_output = ignoreOutput;
  std::string error;
  kernel->data_->link = MakeRemoteLink(*kernel->data_, pIPaddress ? pIPaddress : "", port, error);
  if (!kernel->data_->link) {
    kernel->SetDetailedError(kConnectionFailed, error.c_str());
    return kernel;
  }
  kernel->data_->link->SetAnswerLimit(kGreetingLimitMs);
  kernel->data_->link->Register(smlEVENT_AFTER_AGENT_REINITIALIZED);
  kernel->data_->next_tag = kernel->data_->link->InitialTimeTag();
  kernel->data_->next_name = -kernel->data_->next_tag;
  if (kernel->data_->link->closed()) {
    const std::string refusal = kernel->data_->link->Refusal();
    kernel->SetDetailedError(kConnectionFailed, refusal.empty()
                                                    ? "The kernel accepted the connection, but does not answer"
                                                    : refusal.c_str());
    return kernel;
  }
  kernel->data_->link->SetAnswerLimit(0);
  if (kernel->data_->next_tag == 0) {
    kernel->SetDetailedError(kConnectionFailed,
                             "The kernel has no time tags for another client: it serves at most eight");
    return kernel;
  }
  kernel->UpdateAgentList();
  return kernel;
}

void Kernel::Shutdown() {
  if (data_->shut_down) return;
  // Without the lock, because the link waits for threads that may need it.
  if (data_->link) data_->link->Shutdown();
  data_->shut_down = true;
  while (!data_->agents.empty()) data_->Bury(std::string(data_->agents.begin()->first));
}

KernelLink* KernelData::Usable() {
  if (link && !shut_down && !link->closed()) return link.get();
  kernel.SetDetailedError(kConnectionFailed, shut_down ? "The kernel has been shut down"
                                             : link    ? "The connection to the kernel is lost"
                                                       : "There is no connection to a kernel");
  return nullptr;
}

char const* KernelData::Answer(std::string text) {
  buffer = std::move(text);
  return buffer.c_str();
}

int Kernel::GetListenerPort() {
  const Lock lock = Hold(*data_);
  KernelLink* link = data_->Usable();
  return link ? link->ListenerPort() : 0;
}

void Kernel::Together(std::function<void()> const& calls) {
  const Lock lock = Hold(*data_);
  calls();
}

void Kernel::SetAutoCommit(bool state) {
  const Lock lock = Hold(*data_);
  if (state) CommitAll();
  data_->auto_commit = state;
}
bool Kernel::IsAutoCommitEnabled() {
  return data_->auto_commit;
}
void Kernel::SetAnswerLimit(int milliseconds) {
  if (data_->link) data_->link->SetAnswerLimit(milliseconds);
}
void Kernel::OverhearCommands(std::function<void(char const* pAgentName, char const* pCommandLine)> listener) {
  if (data_->link) data_->link->OverhearCommands(std::move(listener));
}
void Kernel::FenceFiles(std::vector<std::string> folders, bool rules_only) {
  if (data_->link) data_->link->FenceFiles(std::move(folders), rules_only);
}
void Kernel::HoldIncomingCommands(bool state) {
  if (data_->link) data_->link->HoldIncoming(state);
}
bool Kernel::IsConnectionClosed() {
  return !data_->link || data_->shut_down || data_->link->closed();
}
bool Kernel::IsRemoteConnection() {
  return data_->link && data_->link->remote();
}
bool Kernel::IsDirectConnection() {
  return data_->direct;
}

void Kernel::SetTraceCommunications(bool state) {
  data_->trace_communications = state;
  if (data_->link) data_->link->SetTrace(state);
}
bool Kernel::IsTracingCommunications() {
  return data_->trace_communications;
}

// Agents --------------------------------------------------------------------------------------------------------------

Agent* Kernel::CreateAgent(char const* pAgentName) {
  const Lock lock = Hold(*data_);
  KernelLink* link = data_->Usable();
  if (!link) return nullptr;
  if (!pAgentName) {
    SetDetailedError(kNullArgument, "The agent's name is NULL");
    return nullptr;
  }
  if (data_->agents.count(pAgentName) != 0) {
    SetError(kAgentExists);
    return nullptr;
  }
  std::unique_ptr<Agent> agent(new Agent(this, pAgentName));
  std::string error;
  std::unique_ptr<AgentLink> agent_link = link->CreateAgent(*agent, pAgentName, error);
  if (!agent_link) {
    if (error.empty()) {
      SetError(kAgentExists);
    } else {
      SetDetailedError(kCreationFailed, error.c_str());
    }
    return nullptr;
  }
  // A remote kernel has reported the agent meanwhile, and its object was created then.
  if (Agent* told = GetAgent(pAgentName)) return told;
  Agent* created = agent.get();
  agent->data_->link = std::move(agent_link);
  data_->agents[pAgentName] = std::move(agent);
  if (!data_->ignore_output) created->data_->link->Register(smlEVENT_OUTPUT_PHASE_CALLBACK);
  ClearError();
  link->AnnounceAgent(pAgentName);
  return created;
}

/// The object for an agent that another client created; created if necessary.
Agent* KernelData::Adopt(const std::string& name) {
  const auto known = agents.find(name);
  if (known != agents.end()) return known->second.get();
  std::unique_ptr<Agent> agent(new Agent(&kernel, name.c_str()));
  std::unique_ptr<AgentLink> agent_link = link->FindAgent(*agent, name);
  if (!agent_link) return nullptr;
  Agent* adopted = agent.get();
  agent->data_->link = std::move(agent_link);
  agents[name] = std::move(agent);
  if (!ignore_output) adopted->data_->link->Register(smlEVENT_OUTPUT_PHASE_CALLBACK);
  return adopted;
}

void KernelData::Bury(const std::string& name) {
  const auto found = agents.find(name);
  if (found == agents.end()) return;
  found->second->data_->link.reset();
  graveyard.push_back(std::move(found->second));
  agents.erase(found);
  while (graveyard.size() > kGraves) graveyard.pop_front();
}

void Kernel::UpdateAgentList() {
  const Lock lock = Hold(*data_);
  KernelLink* link = data_->Usable();
  if (!link) return;
  const std::vector<std::string> names = link->AgentNames();
  for (const std::string& name : names) data_->Adopt(name);
  std::vector<std::string> gone;
  for (const auto& [name, agent] : data_->agents) {
    bool there = false;
    for (const std::string& known : names) there = there || known == name;
    if (!there) gone.push_back(name);
  }
  for (const std::string& name : gone) data_->Bury(name);
}

int Kernel::GetNumberAgents() {
  const Lock lock = Hold(*data_);
  return static_cast<int>(data_->agents.size());
}

Agent* Kernel::GetAgentByIndex(int index) {
  const Lock lock = Hold(*data_);
  if (index < 0 || index >= static_cast<int>(data_->agents.size())) return nullptr;
  return std::next(data_->agents.begin(), index)->second.get();
}

Agent* Kernel::GetAgent(char const* pAgentName) {
  const Lock lock = Hold(*data_);
  if (!pAgentName) return nullptr;
  const auto found = data_->agents.find(pAgentName);
  return found == data_->agents.end() ? nullptr : found->second.get();
}

bool Kernel::IsAgentValid(Agent* pAgent) {
  const Lock lock = Hold(*data_);
  for (const auto& entry : data_->agents) {
    if (entry.second.get() == pAgent) return true;
  }
  return false;
}

bool Kernel::DestroyAgent(Agent* pAgent) {
  const Lock lock = Hold(*data_);
  KernelLink* link = data_->Usable();
  if (!link) return false;
  if (!IsAgentValid(pAgent)) {
    SetDetailedError(kInvalidArgument,
                     "The agent to destroy does not belong to this kernel, or it has already been destroyed");
    return false;
  }
  const std::string name = pAgent->GetAgentName();
  std::string error;
  if (!link->DestroyAgent(name, error)) {
    SetDetailedError(kDetailedError, error.c_str());
    return false;
  }
  data_->Bury(name);
  ClearError();
  return true;
}

// Command lines and runs ----------------------------------------------------------------------------------------------

void Kernel::EnableFiltering(bool state) {
  data_->filtering = state;
}

char const* Kernel::ExecuteCommandLine(char const* pCommandLine, char const* pAgentName, bool echoResults,
                                       bool noFilter) {
  const Lock lock = Hold(*data_);
  KernelLink* link = data_->Usable();
  data_->last_line_ok = false;
  if (!link) return data_->Answer(GetLastErrorDescription());
  if (!pCommandLine) {
    SetDetailedError(kNullArgument, "The command line is NULL");
    return data_->Answer("");
  }
  Agent* agent = GetAgent(pAgentName);
  LineAnswer answer = link->Execute(pAgentName, agent ? agent->data_->link.get() : nullptr,
                                    {pCommandLine, echoResults, noFilter || !data_->filtering, false});
  data_->last_line_ok = answer.ok;
  if (answer.failed_to_ask) SetDetailedError(kFailedToGetResponse, answer.text.c_str());
  return data_->Answer(std::move(answer.text));
}

char const* Kernel::ExecuteRecordedCommandLine(char const* pCommandLine, char const* pAgentName) {
  const Lock lock = Hold(*data_);
  KernelLink* link = data_->Usable();
  data_->last_line_ok = false;
  if (!link) return data_->Answer(GetLastErrorDescription());
  if (link->remote()) return data_->Answer("A kernel in another process does not accept commands from recordings.");
  Agent* agent = GetAgent(pAgentName);
  LineRequest request{pCommandLine, false, true};
  request.recorded = true;
  LineAnswer answer = link->Execute(pAgentName, agent ? agent->data_->link.get() : nullptr, request);
  data_->last_line_ok = answer.ok;
  return data_->Answer(std::move(answer.text));
}

bool Kernel::ExecuteCommandLineXML(char const* pCommandLine, char const* pAgentName, ClientAnalyzedXML* pResponse) {
  const Lock lock = Hold(*data_);
  KernelLink* link = data_->Usable();
  data_->last_line_ok = false;
  if (!link) return false;
  if (!pCommandLine || !pResponse) {
    SetDetailedError(kNullArgument, "The command line or the object for the answer is NULL");
    return false;
  }
  Agent* agent = GetAgent(pAgentName);
  const LineAnswer answer = link->Execute(pAgentName, agent ? agent->data_->link.get() : nullptr,
                                          {pCommandLine, false, !data_->filtering, true});
  data_->last_line_ok = answer.ok;
  if (answer.failed_to_ask) SetDetailedError(kFailedToGetResponse, answer.text.c_str());
  pResponse->Attach(soarxml::ElementXML(answer.document));
  return answer.ok;
}

bool Kernel::GetLastCommandLineResult() {
  return data_->last_line_ok;
}

namespace {

char const* RunAll(Kernel& kernel, KernelData& data, const RunSpec& spec) {
  const Lock lock = Hold(data);
  KernelLink* link = data.Usable();
  if (!link) return data.Answer(kernel.GetLastErrorDescription());
  if (data.agents.empty()) return data.Answer("There are no agents to run");
  kernel.CommitAll();
  Agent& first = *data.agents.begin()->second;
  LineAnswer answer = link->Run(first.GetAgentName(), AgentData::Of(first).link.get(), spec, !data.direct);
  if (data.direct && answer.ok) return "DirectRun completed";
  data.last_line_ok = answer.ok;
  return data.Answer(std::move(answer.text));
}

}  // namespace

char const* Kernel::RunAllAgents(int numberSteps, smlRunStepSize stepSize, smlRunStepSize interleaveStepSize) {
  // An optimized kernel accepts steps that are smaller than the interleave step; the interleave step is used then.
  if (data_->direct && stepSize == sml_ELABORATION) stepSize = interleaveStepSize;
  return RunAll(*this, *data_, {false, false, numberSteps, stepSize, true, interleaveStepSize});
}

char const* Kernel::RunAllAgentsForever(smlRunStepSize interleaveStepSize) {
  return RunAll(*this, *data_, {false, true, 1, sml_DECIDE, true, interleaveStepSize});
}

char const* Kernel::RunAllTilOutput(smlRunStepSize interleaveStepSize) {
  return RunAll(*this, *data_, {false, false, 1, sml_UNTIL_OUTPUT, true, interleaveStepSize});
}

char const* Kernel::StopAllAgents() {
  // Without the lock, because another thread may hold it during the entire run.
  KernelLink* link = data_->link.get();
  if (!link || data_->shut_down) return "There are no agents to stop";
  link->StopAll();
  return "";
}

bool Kernel::IsSoarRunning() {
  return data_->link && !data_->shut_down && data_->link->IsRunning();
}

void Kernel::CommitAll() {
  const Lock lock = Hold(*data_);
  for (const auto& entry : data_->agents) entry.second->Commit();
}

bool Kernel::IsCommitRequired() {
  const Lock lock = Hold(*data_);
  for (const auto& entry : data_->agents) {
    if (entry.second->IsCommitRequired()) return true;
  }
  return false;
}

}  // namespace sml
