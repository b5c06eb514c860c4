// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <span>
#include <string>
#include <vector>

#include "sml/client/link.h"
#include "sml/server/kernel_host.h"

namespace sml {

struct AgentData;

/// The direct connection to an agent of a kernel in this process, without documents. Only elements are copied.
class LocalAgentLink final : public AgentLink, private MindLink {
 public:
  LocalAgentLink(soarbox::server::KernelHost& host, soarbox::server::Connection& connection,
                 soarbox::server::HostedAgent& hosted)
      : host_(host), connection_(connection), hosted_(hosted) {}
  ~LocalAgentLink() override { hosted_.Forget(connection_); }

  soarbox::server::HostedAgent& hosted() { return hosted_; }
  soarbox::server::KernelHost& host() { return host_; }
  /// Passes a change of the output to the client's memory.
  void Deliver(AgentData& data, std::span<const soarbox::kernel::OutputChange> changes);

  std::string InputLinkName() override;
  InputHandle AddInput(const soarbox::server::InputWme& wme) override;
  InputHandle UpdateInput(InputHandle element, long long old_tag, const soarbox::server::InputWme& wme) override;
  void RemoveInput(InputHandle element, long long tag) override;
  void FlushInput() override {
    if (!noted_.empty()) TellInput();
  }
  unsigned long long ApplyCount() override;
  void WatchApplyPhases(bool) override {}
  std::string KernelName(std::string_view client_name) override { return hosted_.input().KernelName(client_name); }
  bool IsProductionLoaded(std::string_view name) override;
  int Phase() override { return static_cast<int>(hosted_.agent().next_phase()); }
  int DecisionCount() override { return static_cast<int>(hosted_.agent().counters().decision_phases); }
  int RunState() override { return hosted_.run_state; }
  bool OnRunList() override { return host_.OnRunList(hosted_); }
  int LastRunResult() override { return hosted_.last_result; }
  void StopSelf() override { hosted_.RequestStop(); }
  bool SendScene(std::string_view lines) override;
  std::string TakeRefusedScene() override;
  std::string QueryScene(std::string_view queries) override;
  void Register(int event) override { host_.Register(connection_, &hosted_, event); }
  void Unregister(int event) override { host_.Unregister(connection_, &hosted_, event); }
  MindLink& mind() override { return *this; }
  void ListInput(const std::function<void(const OutputWme&)>& visit) override;
  void ListOutput(const std::function<void(const OutputWme&)>& visit) override;

 private:
  std::optional<soarbox::mind::Decision> Decision(std::string_view state) override;
  bool NoteOrigins() override;
  soarbox::mind::OriginFacts Origin(std::uint64_t timetag, std::string_view command) override;

  /// Valid until the next call. Of the value fields, only that of the value's type is valid.
  const OutputWme& Describe(long long tag, soarbox::kernel::Symbol id, soarbox::kernel::Symbol attribute,
                            soarbox::kernel::Symbol value);
  const OutputWme& Describe(const soarbox::kernel::OutputChange& change) {
    return Describe(static_cast<long long>(change.timetag), change.id, change.attribute, change.value);
  }
  void Note(const soarbox::server::InputWme& wme);
  void NoteRemoval(long long tag);
  void TellInput();

  soarbox::server::KernelHost& host_;
  soarbox::server::Connection& connection_;
  soarbox::server::HostedAgent& hosted_;
  OutputWme described_;                                         ///< The last result of Describe.
  std::string attribute_;                                       ///< Storage for a text while it is passed on.
  std::vector<const soarbox::kernel::OutputChange*> deferred_;  ///< Output whose parent has not arrived yet.
  std::vector<soarbox::server::InputWme> noted_;                ///< For xml-input-received.
  std::vector<std::string> noted_texts_;
};

/// The link of an agent whose kernel is in this process; null for others and for destroyed agents.
LocalAgentLink* LocalLinkOf(Agent& agent);

}  // namespace sml
