// SPDX-License-Identifier: BSD-2-Clause
#include <mutex>

#include "sml/client/agent_data.h"
#include "sml/client/hold.h"

namespace sml {

AgentData::AgentData(Agent& owner, Kernel& owner_kernel, std::string agent_name)
    : agent(owner), kernel(owner_kernel), name(std::move(agent_name)), memory(*this) {}

AgentLink* AgentData::Usable() {
  if (link && !kernel_data().shut_down) return link.get();
  SetError(kNoEmbeddedLink, link ? "The kernel has been shut down" : "The agent has been destroyed");
  return nullptr;
}

Agent::Agent(Kernel* kernel, char const* name) : data_(std::make_unique<AgentData>(*this, *kernel, name)) {}
Agent::~Agent() = default;

char const* Agent::GetAgentName() const {
  return data_->name.c_str();
}
Kernel* Agent::GetKernel() const {
  return &data_->kernel;
}
unsigned long long Agent::GetLife() const {
  return data_->memory.life();
}

// Input ---------------------------------------------------------------------------------------------------------------

Identifier* Agent::GetInputLink() {
  const Lock lock = Hold(*data_);
  return data_->memory.InputLink();
}

StringElement* Agent::CreateStringWME(Identifier* parent, char const* pAttribute, char const* pValue) {
  const Lock lock = Hold(*data_);
  return data_->memory.CreateString(parent, pAttribute, pValue);
}

IntElement* Agent::CreateIntWME(Identifier* parent, char const* pAttribute, long long value) {
  const Lock lock = Hold(*data_);
  return data_->memory.CreateInt(parent, pAttribute, value);
}

FloatElement* Agent::CreateFloatWME(Identifier* parent, char const* pAttribute, double value) {
  const Lock lock = Hold(*data_);
  return data_->memory.CreateFloat(parent, pAttribute, value);
}

Identifier* Agent::CreateIdWME(Identifier* parent, char const* pAttribute) {
  const Lock lock = Hold(*data_);
  return data_->memory.CreateId(parent, pAttribute);
}

Identifier* Agent::CreateSharedIdWME(Identifier* parent, char const* pAttribute, Identifier* pSharedValue) {
  const Lock lock = Hold(*data_);
  return data_->memory.CreateSharedId(parent, pAttribute, pSharedValue);
}

void Agent::Update(StringElement* pWME, char const* pValue) {
  const Lock lock = Hold(*data_);
  data_->memory.Update(pWME, pValue);
}

void Agent::Update(IntElement* pWME, long long value) {
  const Lock lock = Hold(*data_);
  data_->memory.Update(pWME, value);
}

void Agent::Update(FloatElement* pWME, double value) {
  const Lock lock = Hold(*data_);
  data_->memory.Update(pWME, value);
}

void Agent::SetBlinkIfNoChange(bool state) {
  data_->blink = state;
}
bool Agent::IsBlinkIfNoChange() {
  return data_->blink;
}

bool Agent::DestroyWME(WMElement* pWME) {
  const Lock lock = Hold(*data_);
  return data_->memory.Destroy(pWME);
}

bool Agent::Commit() {
  const Lock lock = Hold(*data_);
  return data_->memory.Commit();
}

bool Agent::IsCommitRequired() {
  return data_->memory.IsCommitRequired();
}

void Agent::Refresh() {
  const Lock lock = Hold(*data_);
  data_->RefreshInput();
}

bool Agent::SynchronizeInputLink() {
  const Lock lock = Hold(*data_);
  return data_->memory.SynchronizeInput();
}

char const* Agent::ConvertIdentifier(char const* pClientIdentifier) {
  if (!pClientIdentifier) return nullptr;
  const Lock lock = Hold(*data_);
  AgentLink* link = data_->Usable();
  const std::string name = link ? link->KernelName(pClientIdentifier) : std::string();
  if (name.empty()) return pClientIdentifier;
  data_->converted = name;
  return data_->converted.c_str();
}

// Output --------------------------------------------------------------------------------------------------------------

Identifier* Agent::GetOutputLink() {
  const Lock lock = Hold(*data_);
  data_->memory.EnableTracking(false);
  return data_->memory.OutputLink();
}

bool Agent::SynchronizeOutputLink() {
  const Lock lock = Hold(*data_);
  return data_->memory.SynchronizeOutput();
}

void Agent::SetOutputLinkChangeTracking(bool setting) {
  const Lock lock = Hold(*data_);
  if (setting) {
    data_->memory.EnableTracking(true);
  } else {
    data_->memory.DisableTracking();
  }
}

int Agent::GetNumberOutputLinkChanges() {
  const Lock lock = Hold(*data_);
  data_->memory.DropOldChanges();
  return data_->memory.changes().GetSize();
}

WMElement* Agent::GetOutputLinkChange(int index) {
  const Lock lock = Hold(*data_);
  data_->memory.DropOldChanges();
  WMDelta* delta = data_->memory.changes().GetDeltaWME(index);
  return delta ? delta->getWME() : nullptr;
}

bool Agent::IsOutputLinkChangeAdd(int index) {
  const Lock lock = Hold(*data_);
  data_->memory.DropOldChanges();
  WMDelta* delta = data_->memory.changes().GetDeltaWME(index);
  return delta && delta->getChangeType() == WMDelta::kAdded;
}

void Agent::ClearOutputLinkChanges() {
  const Lock lock = Hold(*data_);
  data_->memory.ClearChanges();
}

int Agent::GetNumberCommands() {
  const Lock lock = Hold(*data_);
  data_->memory.EnableTracking(false);
  return data_->memory.CountCommands();
}

bool Agent::Commands() {
  return GetNumberCommands() > 0;
}

Identifier* Agent::GetCommand(int index) {
  const Lock lock = Hold(*data_);
  data_->memory.EnableTracking(false);
  return data_->memory.Command(index);
}

WMDelta* OutputDeltaList::GetDeltaWME(int index) {
  return index < 0 || index >= GetSize() ? nullptr : &deltas_[static_cast<std::size_t>(index)];
}

TagWme* DeltaList::GetDelta(int index) {
  return index < 0 || index >= GetSize() ? nullptr : &changes_[static_cast<std::size_t>(index)];
}

// State ---------------------------------------------------------------------------------------------------------------

bool Agent::WasAgentOnRunList() {
  const Lock lock = Hold(*data_);
  AgentLink* link = data_->Usable();
  return link && link->OnRunList();
}

smlRunResult Agent::GetResultOfLastRun() {
  const Lock lock = Hold(*data_);
  AgentLink* link = data_->Usable();
  return link ? static_cast<smlRunResult>(link->LastRunResult()) : sml_RUN_ERROR;
}

smlPhase Agent::GetCurrentPhase() {
  const Lock lock = Hold(*data_);
  AgentLink* link = data_->Usable();
  return link ? static_cast<smlPhase>(link->Phase()) : sml_INPUT_PHASE;
}

int Agent::GetDecisionCycleCounter() {
  const Lock lock = Hold(*data_);
  AgentLink* link = data_->Usable();
  return link ? link->DecisionCount() : 0;
}

smlRunState Agent::GetRunState() {
  const Lock lock = Hold(*data_);
  AgentLink* link = data_->Usable();
  return link ? static_cast<smlRunState>(link->RunState()) : sml_RUNSTATE_STOPPED;
}

bool Agent::IsProductionLoaded(char const* pProductionName) {
  const Lock lock = Hold(*data_);
  AgentLink* link = data_->Usable();
  return link && pProductionName && link->IsProductionLoaded(pProductionName);
}

}  // namespace sml
