// SPDX-License-Identifier: BSD-2-Clause
#include <mutex>

#include "sml/client/agent_data.h"
#include "sml/client/hold.h"
#include "sml/client/kernel_data.h"

namespace sml {

bool Kernel::GetAllConnectionInfo() {
  const Lock lock = Hold(*data_);
  KernelLink* link = data_->Usable();
  if (!link) return false;
  std::vector<ConnectionInfo> fetched;
  for (const soarbox::server::ConnectionInfo& info : link->Connections()) {
    fetched.emplace_back(info.id.c_str(), info.name.c_str(), info.status.c_str(), info.agent_status.c_str());
  }
  data_->connections_changed = fetched.size() != data_->connections.size();
  for (std::size_t i = 0; i < fetched.size() && !data_->connections_changed; ++i) {
    ConnectionInfo const& before = data_->connections[i];
    ConnectionInfo const& now = fetched[i];
    data_->connections_changed = std::string(before.GetID()) != now.GetID() ||
                                 std::string(before.GetName()) != now.GetName() ||
                                 std::string(before.GetConnectionStatus()) != now.GetConnectionStatus() ||
                                 std::string(before.GetAgentStatus()) != now.GetAgentStatus();
  }
  data_->connections = std::move(fetched);
  return true;
}

bool Kernel::HasConnectionInfoChanged() {
  return data_->connections_changed;
}

int Kernel::GetNumberConnections() {
  return static_cast<int>(data_->connections.size());
}

ConnectionInfo const* Kernel::GetConnectionInfo(int index) {
  if (index < 0 || index >= GetNumberConnections()) return nullptr;
  return &data_->connections[static_cast<std::size_t>(index)];
}

char const* Kernel::GetConnectionStatus(char const* pConnectionName) {
  for (ConnectionInfo const& info : data_->connections) {
    if (pConnectionName && std::string(info.GetName()) == pConnectionName) return info.GetConnectionStatus();
  }
  return nullptr;
}

char const* Kernel::GetAgentStatus(char const* pConnectionName) {
  for (ConnectionInfo const& info : data_->connections) {
    if (pConnectionName && std::string(info.GetName()) == pConnectionName) return info.GetAgentStatus();
  }
  return nullptr;
}

bool Kernel::SetConnectionInfo(char const* pName, char const* pConnectionStatus, char const* pAgentStatus) {
  const Lock lock = Hold(*data_);
  KernelLink* link = data_->Usable();
  if (!link || !pName || !pConnectionStatus || !pAgentStatus) return false;
  return link->SetConnectionInfo(pName, pConnectionStatus, pAgentStatus);
}

bool Kernel::FireStartSystemEvent() {
  const Lock lock = Hold(*data_);
  KernelLink* link = data_->Usable();
  return link && link->FireSystem(smlEVENT_SYSTEM_START);
}

bool Kernel::FireStopSystemEvent() {
  const Lock lock = Hold(*data_);
  KernelLink* link = data_->Usable();
  return link && link->FireSystem(smlEVENT_SYSTEM_STOP);
}

bool Kernel::SuppressSystemStop(bool state) {
  const Lock lock = Hold(*data_);
  KernelLink* link = data_->Usable();
  return link && link->SuppressSystemStop(state);
}

bool Kernel::CheckForIncomingCommands() {
  return data_->link && !data_->shut_down && data_->link->CheckForIncoming();
}

bool Kernel::CheckForIncomingEvents() {
  return CheckForIncomingCommands();
}

bool Kernel::StartEventThread() {
  return data_->link && !data_->shut_down && data_->link->StartEventThread();
}

bool Kernel::StopEventThread() {
  return data_->link && !data_->shut_down && data_->link->StopEventThread();
}

bool Kernel::SetInterruptCheckRate(int newRate) {
  const Lock lock = Hold(*data_);
  KernelLink* link = data_->Usable();
  return link && link->SetInterruptCheckRate(newRate);
}

std::string Kernel::GetSoarKernelVersion() {
  const Lock lock = Hold(*data_);
  KernelLink* link = data_->Usable();
  return link ? link->Version() : std::string();
}

std::string Kernel::LoadExternalLibrary(char const* pLibraryCommand) {
  const Lock lock = Hold(*data_);
  KernelLink* link = data_->Usable();
  if (!link || !pLibraryCommand) return "No kernel to load a library into.";
  return link->LoadLibrary(pLibraryCommand);
}

Connection* Kernel::GetConnection() const {
  return nullptr;
}

}  // namespace sml
