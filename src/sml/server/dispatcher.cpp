// SPDX-License-Identifier: BSD-2-Clause
#include "sml/server/dispatcher.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <vector>

#include "sml/server/answers.h"
#include "sml/server/client_log.h"
#include "sml/server/decision_facts.h"
#include "sml/server/kernel_host.h"
#include "sml/server/listing.h"
#include "sml/server/origin_facts.h"
#include "sml/server/output_documents.h"
#include "sml/server/scene_calls.h"
#include "sml/wire/decision_element.h"
#include "sml/wire/message.h"
#include "sml/wire/origin_element.h"

namespace soarbox::server {

using namespace ::sml;

struct Dispatcher::Request {
  KernelHost& host;
  Connection& from;
  const wire::Element& command;
  std::string_view name;
  HostedAgent* agent = nullptr;
  wire::Message& response;

  const std::string* Arg(std::string_view param) const { return command.Arg(param); }
  void Raw(std::string_view text) { wire::AddRawResult(response, text); }
  void Raw(bool value) { wire::AddRawResult(response, value ? "true" : "false"); }
  void Raw(long long value) { wire::AddRawResult(response, std::to_string(value)); }
  void Fail(std::string_view text) { wire::AddError(response, text); }
  void Invalid(std::string_view detail) {
    Fail("Invalid arguments for command : " + std::string(name) + std::string(detail));
  }
};

namespace {

using Request = Dispatcher::Request;

bool IsTrue(const std::string* text) {
  return text && *text == "true";
}

long long ReadInt(const std::string* text) {
  return text ? std::strtoll(text->c_str(), nullptr, 10) : 0;
}

// Agents --------------------------------------------------------------------------------------------------------------

void CreateAgent(Request& request) {
  const std::string* name = request.Arg("name");
  if (!name) return request.Invalid("Agent name is missing");
  if (HostedAgent* created = request.host.CreateAgent(*name)) request.host.AnnounceAgent(*created);
}

void DestroyAgent(Request& request) {
  if (!request.agent) return request.Fail("The call destroy_agent failed to execute correctly.");
  request.host.DestroyAgent(*request.agent);
}

void GetAgentList(Request& request) {
  wire::Element& result = request.response.root.Add("result").Set("output", "structured");
  for (const HostedAgent* agent : request.host.agents()) result.Add("name").text = agent->name();
}

void GetRunState(Request& request) {
  const std::string* value = request.Arg("value");
  if (!value) return request.Invalid("Need to specify the type of information wanted.");
  if (*value == "phase") return request.Raw(static_cast<long long>(request.agent->agent().next_phase()));
  if (*value == "decision")
    return request.Raw(static_cast<long long>(request.agent->agent().counters().decision_phases));
  if (*value == "runstate") return request.Raw(static_cast<long long>(request.agent->run_state));
  request.Invalid("Didn't recognize the type of information requested in GetRunState().");
}

void IsProductionLoaded(Request& request) {
  const std::string* name = request.Arg("name");
  if (!name) return request.Invalid("Production name is missing");
  request.Raw(request.agent->agent().FindProduction(*name) != kernel::ProductionId::kNone);
}

void OnRunList(Request& request) {
  request.Raw(request.host.OnRunList(*request.agent));
}

void LastRunResult(Request& request) {
  request.Raw(static_cast<long long>(request.agent->last_result));
}

void ConvertIdentifier(Request& request) {
  const std::string* name = request.Arg("name");
  if (!name) return request.Invalid("Identifier is missing");
  request.Raw(request.agent->input().KernelName(*name));
}

// Input and output ----------------------------------------------------------------------------------------------------

void GetInputLink(Request& request) {
  const kernel::Agent& agent = request.agent->agent();
  request.Raw(kernel::ToString(agent.symbols(), agent.InputLinkIdentifier()));
}

void Input(Request& request) {
  std::vector<InputWme> wmes;
  for (const wire::Element& child : request.command.children) {
    if (child.tag == "wme") wmes.push_back(wire::ReadWme(child));
  }
  if (!wmes.empty()) request.from.takes_part = true;
  AgentInput& input = request.agent->input();
  for (const InputWme& wme : wmes) {
    if (wme.add) {
      input.AddByTag(wme);
    } else {
      input.RemoveByTag(wme.tag);
    }
  }
  if (!wmes.empty()) request.agent->FireXmlInput(wmes);
}

void GetAllInput(Request& request) {
  wire::Element& result = request.response.root.Add("result");
  for (const InputListing& entry : ListInput(*request.agent)) {
    result.children.push_back(
        AddedWme(request.agent->agent(), entry.tag, entry.wme.id, entry.wme.attribute, entry.wme.value));
  }
}

void GetAllOutput(Request& request) {
  wire::Element& command = request.response.root.Add("command").Set("name", "output");
  AddOutput(command, request.agent->agent(), std::as_const(*request.agent).agent().output().current(), true);
}

void TellDecision(Request& request) {
  const std::string* state = request.Arg("state");
  if (!state) return request.Invalid("State is missing");
  wire::AddDecision(request.response.root.Add("result"), DecisionNow(request.agent->agent(), *state));
}

void BeginOrigins(Request& request) {
  NoteOrigins(*request.agent);
}

void TellOrigin(Request& request) {
  const std::string* const command = request.Arg("command");
  const std::string* const timetag = request.Arg("timetag");
  if (!command && !timetag) return request.Invalid("Time tag or command is missing");
  const HostedAgent& agent = *request.agent;
  wire::AddOrigins(request.response.root.Add("result"),
                   command ? OriginOfCommand(agent, *command)
                           : OriginOfElement(agent, std::strtoull(timetag->c_str(), nullptr, 10)));
}

/// Sets a fence for the files that this client loads for the agent: the folders that may be read, one per line.
void FenceFiles(Request& request) {
  const std::string* text = request.Arg(wire::kFenceFolders);
  if (!text) return request.Invalid("Folders are missing");
  std::vector<std::filesystem::path> folders;
  for (std::size_t at = 0; at < text->size();) {
    const std::size_t end = std::min(text->find('\n', at), text->size());
    folders.emplace_back(text->substr(at, end - at));
    at = end + 1;
  }
  request.agent->fence = std::make_unique<const cli::Fence>(std::move(folders));
  request.Raw(true);
}

// Command lines and runs ----------------------------------------------------------------------------------------------

void CommandLine(Request& request) {
  const std::string* line = request.Arg("line");
  if (!line) return request.Invalid("Command line missing");
  const std::string* output = request.command.Attribute("output");
  const bool raw = output && *output == "raw";
  const cli::CommandResult result = request.host.Execute(request.agent, *line,
                                                         {IsTrue(request.Arg("echo")), !IsTrue(request.Arg("nofilter")),
                                                          &request.from, IsTrue(request.Arg(wire::kFenced))});
  AddLineResult(request.response, result, !raw);
}

void IsRunning(Request& request) {
  request.Raw(request.host.running(true));
}

void SetInterruptCheckRate(Request& request) {
  const std::string* value = request.Arg("value");
  if (!value) return request.Invalid("Value is missing");
  request.host.SetInterruptCheckRate(static_cast<int>(std::clamp(ReadInt(value), 1LL, 1'000'000'000LL)));
}

// Events --------------------------------------------------------------------------------------------------------------

void ChangeRegistration(Request& request, bool add) {
  const std::string* name = request.Arg("eventid");
  if (!name) return request.Invalid("Event id is missing");
  const int event = Events().ConvertToEvent(name->c_str());
  if (event == smlEVENT_INVALID_EVENT) return request.Fail("KernelSML doesn't know how to handle that event id");
  if (IsRhsEventID(event)) {
    const std::string* function = request.Arg("name");
    if (!function) return request.Invalid("Registering for rhs user function, but no function name was provided");
    if (add) {
      request.host.RegisterFunction(request.from, event, *function);
    } else {
      request.host.UnregisterFunction(request.from, event, *function);
    }
    return;
  }
  const bool of_agent = IsRunEventID(event) || IsProductionEventID(event) || IsPrintEventID(event) ||
                        IsXMLEventID(event) || IsWorkingMemoryEventID(event);
  if (of_agent && !request.agent) return request.Fail("No agent name for an event that is handled by an agent");
  HostedAgent* agent = of_agent ? request.agent : nullptr;
  if (add) {
    request.from.takes_part = request.from.takes_part || IsWorkingMemoryEventID(event);
    request.host.Register(request.from, agent, event);
  } else {
    request.host.Unregister(request.from, agent, event);
  }
}

void RegisterForEvent(Request& request) {
  ChangeRegistration(request, true);
}
void UnregisterForEvent(Request& request) {
  ChangeRegistration(request, false);
}

/// The event number of fire_event and suppress_event; 0 after an error.
int SystemEvent(Request& request, bool start_too) {
  const std::string* name = request.Arg("eventid");
  if (!name) {
    request.Invalid("Event id is missing");
    return 0;
  }
  const int event = Events().ConvertToEvent(name->c_str());
  if (event == smlEVENT_SYSTEM_STOP || (start_too && event == smlEVENT_SYSTEM_START)) return event;
  request.Fail("KernelSML doesn't know how to handle that event id");
  return 0;
}

void FireEvent(Request& request) {
  if (const int event = SystemEvent(request, true)) request.host.FireSystem(event);
}

void SuppressEvent(Request& request) {
  const std::string* value = request.Arg("value");
  if (!value) return request.Invalid("Value is missing");
  if (SystemEvent(request, false)) request.host.SuppressSystemStop(IsTrue(value));
}

// Connections ---------------------------------------------------------------------------------------------------------

void GetConnections(Request& request) {
  wire::Element& result = request.response.root.Add("result").Set("output", "structured");
  for (const Connection* connection : request.host.connections()) {
    const ConnectionInfo& info = connection->info;
    result.Add("connection")
        .Set("agent-status", info.agent_status)
        .Set("id", info.id)
        .Set("name", info.name)
        .Set("status", info.status);
  }
}

void SetConnectionInfo(Request& request) {
  const std::string* name = request.Arg("name");
  const std::string* status = request.Arg("status");
  const std::string* agent_status = request.Arg("agent-status");
  if (!name) return request.Invalid("Connection name is missing");
  if (!status) return request.Invalid("Connection status is missing");
  if (!agent_status) return request.Invalid("Agent status is missing");
  request.from.info.name = *name;
  request.from.info.status = *status;
  request.from.info.agent_status = *agent_status;
}

void InitialTimeTag(Request& request) {
  const long long tag = request.host.AssignTimeTags(request.from);
  if (tag == 0) return request.Fail("All ranges of time tags are taken: a kernel serves eight clients that make input");
  request.Raw(tag);
}

void SendClientMessage(Request& request) {
  const std::string* name = request.Arg("name");
  const std::string* message = request.Arg("message");
  if (!name || !message) return request.Invalid("Require a message type and a message and one is missing");
  request.Raw(request.host.CallFunction(request.agent, smlEVENT_CLIENT_MESSAGE, *name, *message)
                  .value_or("**NOBODY RESPONDED**"));
}

void Version(Request& request) {
  request.Raw(wire::kSmlVersion);
}
void GetListenerPort(Request& request) {
  request.Raw(static_cast<long long>(request.host.Port()));
}
void CheckForIncomingCommands(Request& request) {
  request.Raw(false);
}

void Shutdown(Request& request) {
  request.host.FireSystem(smlEVENT_BEFORE_SHUTDOWN);
  request.host.DestroyAllAgents();
}

void SvsInput(Request& request) {
  const std::string* line = request.Arg("line");
  if (!line) return request.Invalid("Command line missing");
  if (!SendScene(*request.agent, *line)) {
    request.Fail("The spatial visual system is off: enable it with the command svs --enable");
  }
}
void SvsOutput(Request& request) {
  request.Raw(TakeRefusedScene(*request.agent));
}
void SvsQuery(Request& request) {
  const std::string* line = request.Arg("line");
  if (!line) return request.Invalid("Command line missing");
  request.Raw(QueryScene(*request.agent, *line));
}

/// The log must have no gaps for programs that watch it, so nothing is left out.
void ReadLog(Request& request) {
  constexpr std::size_t kMostAtOnce = 512 * 1024;
  ClientLog* const log = request.host.log.get();
  if (log == nullptr) return request.Fail("this kernel keeps no log of what its clients do");
  // During a run, each decision is logged anyway. The contents of the log must not depend on whether it is read.
  if (!request.host.running())
    for (HostedAgent* const agent : request.host.agents()) log->Went(*agent);
  const std::string* const from = request.Arg(wire::kLogFrom);
  const std::uint64_t begin = from == nullptr ? 0 : std::strtoull(from->c_str(), nullptr, 10);
  const std::optional<std::string> text = log->Text(begin, kMostAtOnce);
  request.Raw(text ? EscapedForLog(*text) : wire::kLogEnded);
}

enum class NeedsAgent { kNo, kYes };

struct Entry {
  std::string_view name;
  NeedsAgent needs_agent;
  void (*handler)(Request& request);
};

constexpr std::array kEntries = {
    Entry{"check_for_incoming_commands", NeedsAgent::kNo, CheckForIncomingCommands},
    Entry{"cmdline", NeedsAgent::kNo, CommandLine},
    Entry{"convert_identifier", NeedsAgent::kYes, ConvertIdentifier},
    Entry{"create_agent", NeedsAgent::kNo, CreateAgent},
    Entry{"destroy_agent", NeedsAgent::kNo, DestroyAgent},
    Entry{wire::kFenceCall, NeedsAgent::kYes, FenceFiles},
    Entry{"fire_event", NeedsAgent::kNo, FireEvent},
    Entry{"get_agent_list", NeedsAgent::kNo, GetAgentList},
    Entry{"get_all_input", NeedsAgent::kYes, GetAllInput},
    Entry{"get_all_output", NeedsAgent::kYes, GetAllOutput},
    Entry{"get_connections", NeedsAgent::kNo, GetConnections},
    Entry{"get_input_link", NeedsAgent::kYes, GetInputLink},
    Entry{"get_listener_port", NeedsAgent::kNo, GetListenerPort},
    Entry{"get_run_state", NeedsAgent::kYes, GetRunState},
    Entry{"initial_time_tag", NeedsAgent::kNo, InitialTimeTag},
    Entry{"input", NeedsAgent::kYes, Input},
    Entry{"is_production_loaded", NeedsAgent::kYes, IsProductionLoaded},
    Entry{"is_running", NeedsAgent::kNo, IsRunning},
    Entry{"last_run_result", NeedsAgent::kYes, LastRunResult},
    Entry{"on_run_list", NeedsAgent::kYes, OnRunList},
    Entry{"register_for_event", NeedsAgent::kNo, RegisterForEvent},
    Entry{wire::kLogCall, NeedsAgent::kNo, ReadLog},
    Entry{"send_client_message", NeedsAgent::kNo, SendClientMessage},
    Entry{"set_connection_info", NeedsAgent::kNo, SetConnectionInfo},
    Entry{"set_interrupt_check_rate", NeedsAgent::kNo, SetInterruptCheckRate},
    Entry{"shutdown", NeedsAgent::kNo, Shutdown},
    Entry{wire::kDecisionCall, NeedsAgent::kYes, TellDecision},
    Entry{wire::kNoteOriginsCall, NeedsAgent::kYes, BeginOrigins},
    Entry{wire::kOriginCall, NeedsAgent::kYes, TellOrigin},
    Entry{"suppress_event", NeedsAgent::kNo, SuppressEvent},
    Entry{"svs_input", NeedsAgent::kYes, SvsInput},
    Entry{"svs_output", NeedsAgent::kYes, SvsOutput},
    Entry{"svs_query", NeedsAgent::kYes, SvsQuery},
    Entry{"unregister_for_event", NeedsAgent::kNo, UnregisterForEvent},
    Entry{"version", NeedsAgent::kNo, Version},
};

/// Whether the call changes what agents do, although it is not a command line.
bool GoesPastTheDoor(const Request& request) {
  if (request.name == "register_for_event") {
    const std::string* name = request.Arg("eventid");
    const int event = name ? Events().ConvertToEvent(name->c_str()) : smlEVENT_INVALID_EVENT;
    return event == smlEVENT_RHS_USER_FUNCTION || event == smlEVENT_FILTER;
  }
  constexpr std::array kCalls = {std::string_view("create_agent"), std::string_view("destroy_agent"),
                                 std::string_view("input"),        std::string_view("shutdown"),
                                 std::string_view("fire_event"),   std::string_view("suppress_event"),
                                 std::string_view("svs_input"),    std::string_view(wire::kFenceCall)};
  return std::find(kCalls.begin(), kCalls.end(), request.name) != kCalls.end();
}

}  // namespace

void Dispatcher::Handle(const wire::Message& call, wire::Message& response) {
  const wire::Element* command = call.Command();
  if (!command) return wire::AddError(response, "Incoming message did not contain a <command> tag");
  const std::string* name = command->Attribute("name");
  if (!name) return wire::AddError(response, "Incoming message did not contain a name attribute in the <command> tag");
  const auto entry =
      std::find_if(kEntries.begin(), kEntries.end(), [&](const Entry& known) { return known.name == *name; });
  if (entry == kEntries.end()) {
    return wire::AddError(response, "Command " + *name + " is not recognized by the kernel");
  }
  const KernelHost::Stay stay(host_);
  Request request{host_, from_, *command, *name, nullptr, response};
  if (host_.IsOverheard() && !from_.embedded() && GoesPastTheDoor(request)) {
    return wire::AddError(response, "The agents of this kernel live in a simulation, whose runs can be repeated: '" +
                                        *name +
                                        "' is refused there. Command lines are recorded and run; try 'wm add'.");
  }
  if (const std::string* agent = command->Arg("agent")) {
    request.agent = host_.Find(*agent);
    if (!request.agent) return wire::AddError(response, "Could not find an agent with name: " + *agent);
  }
  if (entry->needs_agent == NeedsAgent::kYes && !request.agent) {
    return wire::AddError(response, "The call " + *name + " failed to execute correctly.");
  }
  entry->handler(request);
}

}  // namespace soarbox::server
