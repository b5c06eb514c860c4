// SPDX-License-Identifier: BSD-2-Clause
#include "sml/client/remote_agent_link.h"

#include <cstdlib>

#include "sml/client/agent_data.h"
#include "sml/wire/decision_element.h"
#include "sml/wire/origin_element.h"

namespace sml {

using soarbox::server::InputWme;
using soarbox::wire::Element;
using soarbox::wire::Message;

void ReadWmes(const Element& parent, const std::function<void(const OutputWme&)>& visit) {
  for (const Element& element : parent.children) {
    if (element.tag != "wme") continue;
    const InputWme read = soarbox::wire::ReadWme(element);
    OutputWme wme;
    wme.add = read.add;
    wme.tag = read.tag;
    wme.id = IdentifierKey(read.id);
    wme.attribute = read.attribute;
    wme.type = read.type;
    wme.text = read.text;
    wme.integer = read.integer;
    wme.real = read.real;
    if (read.type == InputWme::Type::kId) wme.value_id = IdentifierKey(read.text);
    visit(wme);
  }
}

void ReceiveOutputMessage(AgentData& agent, const Element& command) {
  if (!agent.link) return;
  agent.memory.BeginOutput();
  ReadWmes(command, [&](const OutputWme& wme) { agent.memory.ReceiveOutput(wme); });
  agent.OnOutputReceived(agent.memory.EndOutput());
}

Message RemoteAgentLink::Call(const char* command) const {
  Message call = soarbox::wire::MakeCall(command);
  call.root.children.front().AddArg("agent", name_);
  return call;
}

std::string RemoteAgentLink::Text(Message& call) {
  const std::optional<Message> response = caller_.Ask(call);
  if (!response || response->ErrorTag()) return {};
  const Element* result = response->ResultTag();
  return result ? result->text : std::string();
}

std::string RemoteAgentLink::InputLinkName() {
  Message call = Call("get_input_link");
  return Text(call);
}

Element& RemoteAgentLink::Batch() {
  if (!batch_) batch_ = Call("input");
  return batch_->root.children.front();
}

InputHandle RemoteAgentLink::AddInput(const InputWme& wme) {
  soarbox::wire::AddWme(Batch(), wme);
  return kNoInputHandle;
}

void RemoteAgentLink::RemoveInput(InputHandle, long long tag) {
  InputWme removed;
  removed.add = false;
  removed.tag = tag;
  soarbox::wire::AddWme(Batch(), removed);
}

InputHandle RemoteAgentLink::UpdateInput(InputHandle element, long long old_tag, const InputWme& wme) {
  RemoveInput(element, old_tag);
  return AddInput(wme);
}

void RemoteAgentLink::FlushInput() {
  if (!batch_) return;
  Message call = std::move(*batch_);
  batch_.reset();
  caller_.Ask(call);
}

void RemoteAgentLink::WatchApplyPhases(bool on) {
  if (on == watching_) return;
  watching_ = on;
  if (user_watching_) return;
  caller_.ChangeRegistration(on ? "register_for_event" : "unregister_for_event", name_, smlEVENT_AFTER_APPLY_PHASE, {});
}

void RemoteAgentLink::Register(int event) {
  if (event == smlEVENT_AFTER_APPLY_PHASE) {
    user_watching_ = true;
    if (watching_) return;
  }
  caller_.ChangeRegistration("register_for_event", name_, event, {});
}

void RemoteAgentLink::Unregister(int event) {
  if (event == smlEVENT_AFTER_APPLY_PHASE) {
    user_watching_ = false;
    if (watching_) return;
  }
  caller_.ChangeRegistration("unregister_for_event", name_, event, {});
}

std::string RemoteAgentLink::KernelName(std::string_view client_name) {
  Message call = Call("convert_identifier");
  call.root.children.front().AddArg("name", std::string(client_name));
  return Text(call);
}

bool RemoteAgentLink::IsProductionLoaded(std::string_view name) {
  Message call = Call("is_production_loaded");
  call.root.children.front().AddArg("name", std::string(name));
  return Text(call) == "true";
}

int RemoteAgentLink::RunStateOf(const char* what) {
  Message call = Call("get_run_state");
  call.root.children.front().AddArg("value", what);
  return std::atoi(Text(call).c_str());
}

bool RemoteAgentLink::OnRunList() {
  Message call = Call("on_run_list");
  return Text(call) == "true";
}

int RemoteAgentLink::LastRunResult() {
  Message call = Call("last_run_result");
  return std::atoi(Text(call).c_str());
}

void RemoteAgentLink::StopSelf() {
  Message call = Call("cmdline");
  call.root.children.front()
      .Set("output", "raw")
      .AddArg("line", "stop-soar --self")
      .AddArg("echo", "false")
      .AddArg("nofilter", "false");
  // Without waiting, because another thread may be waiting for the end of the run.
  caller_.Tell(call);
}

std::optional<soarbox::mind::Decision> RemoteAgentLink::Decision(std::string_view state) {
  Message call = Call(soarbox::wire::kDecisionCall);
  call.root.children.front().AddArg("state", std::string(state));
  const std::optional<Message> response = caller_.Ask(call);
  if (!response || response->ErrorTag() || !response->ResultTag()) return std::nullopt;
  return soarbox::wire::ReadDecision(*response->ResultTag());
}

bool RemoteAgentLink::NoteOrigins() {
  Message call = Call(soarbox::wire::kNoteOriginsCall);
  const std::optional<Message> response = caller_.Ask(call);
  return response && !response->ErrorTag();
}

soarbox::mind::OriginFacts RemoteAgentLink::Origin(std::uint64_t timetag, std::string_view command) {
  Message call = Call(soarbox::wire::kOriginCall);
  if (command.empty()) {
    call.root.children.front().AddArg("timetag", std::to_string(timetag));
  } else {
    call.root.children.front().AddArg("command", std::string(command));
  }
  const std::optional<Message> response = caller_.Ask(call);
  if (!response || response->ErrorTag() || !response->ResultTag()) return {};
  return soarbox::wire::ReadOrigins(*response->ResultTag());
}

bool RemoteAgentLink::SendScene(std::string_view lines) {
  Message call = Call("svs_input");
  call.root.children.front().AddArg("line", std::string(lines));
  const std::optional<Message> response = caller_.Ask(call);
  return response && !response->ErrorTag();
}

std::string RemoteAgentLink::TakeRefusedScene() {
  Message call = Call("svs_output");
  return Text(call);
}

std::string RemoteAgentLink::QueryScene(std::string_view queries) {
  Message call = Call("svs_query");
  call.root.children.front().AddArg("line", std::string(queries));
  return Text(call);
}

void RemoteAgentLink::ListInput(const std::function<void(const OutputWme&)>& visit) {
  Message call = Call("get_all_input");
  const std::optional<Message> response = caller_.Ask(call);
  if (response && response->ResultTag()) ReadWmes(*response->ResultTag(), visit);
}

void RemoteAgentLink::ListOutput(const std::function<void(const OutputWme&)>& visit) {
  Message call = Call("get_all_output");
  const std::optional<Message> response = caller_.Ask(call);
  if (response && response->Command()) ReadWmes(*response->Command(), visit);
}

}  // namespace sml
