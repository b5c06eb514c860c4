// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <cstdint>

#include "sml/server/kernel_host.h"

namespace soarbox::server {

using namespace ::sml;

namespace {

constexpr long long kTagRange = 1LL << 27;
constexpr int kTagRanges = 8;

}  // namespace

void KernelHost::AddConnection(Connection& connection) {
  connections_.insert(connection.embedded() ? connections_.begin() : connections_.end(), &connection);
}

void KernelHost::RemoveConnection(Connection& connection) {
  std::erase(connections_, &connection);
  std::erase_if(functions_, [&](const Function& function) { return function.connection == &connection; });
  for (HostedAgent* hosted : order_) hosted->Forget(connection);
  for (const auto& hosted : doomed_) hosted->Forget(connection);
  listened_.Clear();
  for (const Connection* other : connections_) listened_.Add(other->kernel_events);
}

long long KernelHost::AssignTimeTags(Connection& connection) {
  if (connection.initial_time_tag != 0) return connection.initial_time_tag;
  for (int range = 0; range < kTagRanges; ++range) {
    const long long tag = -1 - range * kTagRange;
    // The highest range is reserved for the program that contains the kernel.
    if (range == 0 && !connection.embedded()) continue;
    const bool taken = std::any_of(connections_.begin(), connections_.end(),
                                   [&](const Connection* other) { return other->initial_time_tag == tag; });
    if (taken) continue;
    connection.initial_time_tag = tag;
    return tag;
  }
  return 0;
}

void KernelHost::Register(Connection& connection, HostedAgent* hosted, int event) {
  if (hosted) {
    hosted->Register(connection, event);
    return;
  }
  connection.kernel_events.Add(event);
  listened_.Add(connection.kernel_events);
}

void KernelHost::Unregister(Connection& connection, HostedAgent* hosted, int event) {
  if (hosted) {
    hosted->Unregister(connection, event);
    return;
  }
  connection.kernel_events.Remove(event);
  listened_.Clear();
  for (const Connection* other : connections_) listened_.Add(other->kernel_events);
}

void KernelHost::RegisterFunction(Connection& connection, int event, const std::string& name) {
  const auto same = [&](const Function& function) {
    return function.event == event && function.name == name && function.connection == &connection;
  };
  if (std::any_of(functions_.begin(), functions_.end(), same)) return;
  if (log && event == smlEVENT_RHS_USER_FUNCTION) log->FunctionMade(name);
  functions_.insert(connection.embedded() ? functions_.begin() : functions_.end(), Function{event, name, &connection});
}

void KernelHost::UnregisterFunction(Connection& connection, int event, const std::string& name) {
  std::erase_if(functions_, [&](const Function& function) {
    return function.event == event && function.name == name && function.connection == &connection;
  });
}

void KernelHost::FlushPrints() {
  const Stay stay(*this);
  // Handlers may create and destroy agents, so the list may change during the loop.
  for (std::size_t i = 0; i < order_.size(); ++i) order_[i]->FlushPrint();
}

void KernelHost::TellSystem(int event) {
  FlushPrints();
  for (std::size_t i = 0; i < connections_.size(); ++i) {
    if (connections_[i]->kernel_events.Has(event)) connections_[i]->OnSystemEvent(event);
  }
}

void KernelHost::FireUpdate(int event, int run_flags) {
  if (!listened_.Has(event)) return;
  FlushPrints();
  for (std::size_t i = 0; i < connections_.size(); ++i) {
    if (connections_[i]->kernel_events.Has(event)) connections_[i]->OnUpdateEvent(event, run_flags);
  }
}

void KernelHost::FireAgent(HostedAgent& hosted, int event) {
  if (!listened_.Has(event) || hosted.doomed) return;
  const Stay stay(*this);
  hosted.FlushPrint();
  for (std::size_t i = 0; i < connections_.size(); ++i) {
    if (connections_[i]->kernel_events.Has(event)) connections_[i]->OnAgentEvent(hosted, event);
  }
}

std::optional<std::string> KernelHost::CallFunction(HostedAgent* hosted, int event, std::string_view name,
                                                    std::string_view argument) {
  const bool is_of_rules = event == smlEVENT_RHS_USER_FUNCTION && hosted;
  if (is_of_rules && player) {
    if (auto answer = player->Answer(hosted, name, argument)) return answer;
  }
  for (std::size_t i = 0; i < functions_.size() && !(hosted && hosted->doomed); ++i) {
    if (functions_[i].event != event || functions_[i].name != name) continue;
    Connection* connection = functions_[i].connection;
    auto answer = connection->OnFunction(hosted, event, name, argument);
    if (!answer) continue;
    if (is_of_rules && log && !hosted->doomed) log->Answered(*hosted, name, argument, *answer);
    return answer;
  }
  return std::nullopt;
}

}  // namespace soarbox::server
