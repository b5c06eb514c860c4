// SPDX-License-Identifier: BSD-2-Clause
#include "sml/client/remote_agent_link.h"

#include <cstdlib>

#include "sml/client/agent_data.h"

namespace sml {

using soarbox::server::InputWme;
using soarbox::wire::Element;
using soarbox::wire::Message;

void ReadWmes(const Element& parent, const std::function<void(const OutputWme&)>& visit) {
  for (const Element& element : parent.children) {
    if (element.tag != "wme") continue;
    const auto text = [&](const char* name) -> std::string_view {
      const std::string* value = element.Attribute(name);
      return value ? std::string_view(*value) : std::string_view();
    };
    const std::string* tag = element.Attribute("tag");
    OutputWme wme;
    wme.add = text("action") != "remove";
    wme.tag = tag ? std::atoll(tag->c_str()) : 0;
    wme.id = IdentifierKey(text("id"));
    wme.attribute = text("attr");
    wme.text = text("value");
    const std::string_view type = text("valtype");
    if (type == "int") {
      wme.type = InputWme::Type::kInt;
      wme.integer = std::atoll(std::string(wme.text).c_str());
    } else if (type == "double") {
      wme.type = InputWme::Type::kDouble;
      wme.real = std::strtod(std::string(wme.text).c_str(), nullptr);
    } else if (type == "id") {
      wme.type = InputWme::Type::kId;
      wme.value_id = IdentifierKey(wme.text);
    }
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
  Element& element = Batch().Add("wme");
  element.Set("action", "add").Set("attr", std::string(wme.attribute)).Set("id", std::string(wme.id));
  element.Set("tag", std::to_string(wme.tag));
  switch (wme.type) {
    case InputWme::Type::kString:
      element.Set("value", std::string(wme.text));
      break;
    case InputWme::Type::kId:
      element.Set("valtype", "id").Set("value", std::string(wme.text));
      break;
    case InputWme::Type::kInt:
      element.Set("valtype", "int").Set("value", std::to_string(wme.integer));
      break;
    case InputWme::Type::kDouble:
      element.Set("valtype", "double").Set("value", soarbox::wire::ShortDouble(wme.real));
      break;
  }
  return kNoInputHandle;
}

void RemoteAgentLink::RemoveInput(InputHandle, long long tag) {
  Batch().Add("wme").Set("action", "remove").Set("tag", std::to_string(tag));
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
  // Without waiting: another thread may be waiting for the end of the run.
  caller_.Tell(call);
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
