// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "sml/client/link.h"
#include "sml/wire/message.h"

namespace sml {

struct AgentData;

/// Sends calls to a remote kernel and waits for the responses.
class RemoteCaller {
 public:
  virtual ~RemoteCaller() = default;
  /// The time limit for a response depends on the kind of call: a plain call, a run, or another command line.
  enum class Work : std::uint8_t { kCall, kRun, kLine };
  /// Returns none if the connection is lost or if the kernel does not respond in time.
  virtual std::optional<soarbox::wire::Message> Ask(soarbox::wire::Message& call, Work work = Work::kCall) = 0;
  /// Sends a call without waiting for its response.
  virtual void Tell(soarbox::wire::Message& call) = 0;
  virtual bool ChangeRegistration(const char* command, const std::string& agent, int event,
                                  const std::string& name) = 0;
};

/// The connection to an agent of a remote kernel.
class RemoteAgentLink final : public AgentLink, private MindLink {
 public:
  RemoteAgentLink(RemoteCaller& caller, std::string name) : caller_(caller), name_(std::move(name)) {}

  void CountApplyPhase() { ++apply_phases_; }

  std::string InputLinkName() override;
  InputHandle AddInput(const soarbox::server::InputWme& wme) override;
  InputHandle UpdateInput(InputHandle element, long long old_tag, const soarbox::server::InputWme& wme) override;
  void RemoveInput(InputHandle element, long long tag) override;
  void FlushInput() override;
  unsigned long long ApplyCount() override { return apply_phases_; }
  void WatchApplyPhases(bool on) override;
  std::string KernelName(std::string_view client_name) override;
  bool IsProductionLoaded(std::string_view name) override;
  int Phase() override { return RunStateOf("phase"); }
  int DecisionCount() override { return RunStateOf("decision"); }
  int RunState() override { return RunStateOf("runstate"); }
  bool OnRunList() override;
  int LastRunResult() override;
  void StopSelf() override;
  bool SendScene(std::string_view lines) override;
  std::string TakeRefusedScene() override;
  std::string QueryScene(std::string_view queries) override;
  void Register(int event) override;
  void Unregister(int event) override;
  MindLink& mind() override { return *this; }
  void ListInput(const std::function<void(const OutputWme&)>& visit) override;
  void ListOutput(const std::function<void(const OutputWme&)>& visit) override;

 private:
  std::optional<soarbox::mind::Decision> Decision(std::string_view state) override;
  bool NoteOrigins() override;
  soarbox::mind::OriginFacts Origin(std::uint64_t timetag, std::string_view command) override;

  soarbox::wire::Message Call(const char* command) const;
  std::string Text(soarbox::wire::Message& call);
  int RunStateOf(const char* what);
  soarbox::wire::Element& Batch();

  RemoteCaller& caller_;
  std::string name_;
  std::optional<soarbox::wire::Message> batch_;
  unsigned long long apply_phases_ = 0;
  bool watching_ = false;       ///< This library listens to apply phases.
  bool user_watching_ = false;  ///< The program listens to apply phases.
};

/// Reads the <wme> elements of a message.
void ReadWmes(const soarbox::wire::Element& parent, const std::function<void(const OutputWme&)>& visit);
/// Passes a message about output to the client's memory.
void ReceiveOutputMessage(AgentData& agent, const soarbox::wire::Element& command);

}  // namespace sml
