// SPDX-License-Identifier: BSD-2-Clause
#include "sml/server/remote_connection.h"

#include "sml/server/answers.h"
#include "sml/server/dispatcher.h"
#include "sml/server/hosted_agent.h"
#include "sml/server/output_documents.h"
#include "sml/wire/xml_writer.h"

namespace soarbox::server {

using namespace ::sml;

namespace {

/// The approximate time that a debugger needs to update all its windows.
constexpr std::chrono::milliseconds kRoundPause{500};

std::string EventName(int event) {
  return Events().ConvertToString(event);
}

wire::Message EventCall() {
  return wire::MakeCall("event");
}

wire::Element& Command(wire::Message& message) {
  return message.root.children.front();
}

}  // namespace

bool RemoteConnection::IsIdleAnswer(std::string_view document) const {
  const std::string_view root = document.substr(0, document.find('>'));
  if (root.find(" doctype=\"response\"") == std::string_view::npos) return false;
  constexpr std::string_view kAck = " ack=\"";
  const std::size_t found = root.find(kAck);
  if (found == std::string_view::npos) return true;
  const std::string_view rest = root.substr(found + kAck.size());
  const std::string_view ack = rest.substr(0, rest.find('"'));
  return ack != awaited_id_ && ack != notice_id_ && !open_events_.Has(ack);
}

RemoteConnection::RemoteConnection(KernelHost& host, std::unique_ptr<wire::Channel> channel,
                                   std::chrono::milliseconds answer_timeout)
    : host_(host), channel_(std::move(channel)), timeout_(answer_timeout) {}

RemoteConnection::~RemoteConnection() = default;

bool RemoteConnection::Serve() {
  bool any = false;
  // Read before the messages, so that all messages before the end are served.
  const bool closed = channel_->closed();
  std::string document;
  while (channel_->Pop(document)) {
    any = true;
    if (IsIdleAnswer(document)) continue;
    if (const Result<wire::Message> message = wire::ReadMessage(document)) Handle(message.value());
  }
  if (serving_ == 0) SendNotice();
  gone_ = gone_ || closed;
  return any;
}

void RemoteConnection::Handle(const wire::Message& message) {
  switch (message.type) {
    case wire::DocType::kNotify:
      return;
    case wire::DocType::kResponse:
      if (message.ack.empty()) return;
      if (message.ack == awaited_id_) {
        slow_ = false;
        answer_ = message;
      }
      Answered(message.ack);
      return;
    case wire::DocType::kCall:
      break;
  }
  wire::Message response = wire::MakeResponse(message.id);
  response.id = NextId();
  ++serving_;
  Dispatcher(host_, *this).Handle(message, response);
  --serving_;
  const std::string document = wire::ToDocument(response);
  if (serving_ == 0) open_events_.Called(document);
  channel_->Send(document);
  if (serving_ == 0) SendNotice();
}

void RemoteConnection::Answered(const std::string& id) {
  if (const std::string again = open_events_.Answered(id); !again.empty()) channel_->Send(again);
  if (id == notice_id_) notice_id_.clear();
  if (serving_ == 0) SendNotice();
}

wire::Message RemoteConnection::NoticeCall(const Notice& notice) {
  wire::Message call = EventCall();
  wire::Element& command = Command(call);
  if (!notice.agent.empty()) command.AddArg("agent", notice.agent);
  command.AddArg("eventid", EventName(notice.event));
  if (!notice.parameter.empty()) command.AddArg(std::string(notice.parameter), std::to_string(notice.value));
  return call;
}

void RemoteConnection::Announce(Notice notice) {
  std::erase_if(notices_, [&](const Notice& old) { return old.event == notice.event && old.agent == notice.agent; });
  if (!slow_ && (takes_part || serving_ > 0)) {
    wire::Message call = NoticeCall(notice);
    Call(call, Wait::kForAnswer);
    return;
  }
  notices_.push_back(std::move(notice));
  SendNotice();
}

bool RemoteConnection::BeginRound() {
  if (notices_.empty()) return false;
  const auto now = std::chrono::steady_clock::now();
  if (now < next_round_) {
    if (!alarm_set_) channel_->WakeAfter(std::chrono::ceil<std::chrono::milliseconds>(next_round_ - now));
    alarm_set_ = true;
    return false;
  }
  alarm_set_ = false;
  next_round_ = now + kRoundPause;
  round_.swap(notices_);
  return true;
}

void RemoteConnection::SendNotice() {
  if (slow_ || !notice_id_.empty()) return;
  // Frequent events must not delay events of other kinds. So the kind that happened last is sent last.
  if (round_.empty() && !BeginRound()) return;
  wire::Message call = NoticeCall(round_.front());
  round_.erase(round_.begin());
  call.id = notice_id_ = NextId();
  open_events_.Sent(call.id);
  channel_->Send(wire::ToDocument(call));
}

std::optional<wire::Message> RemoteConnection::Call(wire::Message& call, Wait wait, bool droppable) {
  call.id = NextId();
  if (!channel_->Send(wire::ToDocument(call), droppable)) return std::nullopt;
  if (wait == Wait::kNo) return std::nullopt;
  const std::string id = call.id;
  awaited_id_ = id;
  answer_.reset();
  if (serving_ == 0) open_events_.Sent(id);
  if (slow_) return std::nullopt;
  const auto end = std::chrono::steady_clock::now() + timeout_;
  std::string document;
  while (true) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - std::chrono::steady_clock::now());
    if (left.count() <= 0 || !channel_->Wait(document, left)) break;
    const Result<wire::Message> message = wire::ReadMessage(document);
    if (!message) continue;
    // A nested event waits for its own answer; afterwards the outer answer is awaited again.
    const std::string awaited = awaited_id_;
    if (message.value().type == wire::DocType::kResponse && message.value().ack == id) {
      Answered(id);
      return message.value();
    }
    Handle(message.value());
    awaited_id_ = awaited;
  }
  slow_ = !channel_->closed();
  return std::nullopt;
}

std::string RemoteConnection::DroppedNote() const {
  const unsigned long long count = channel_->dropped() - told_dropped_;
  if (count == 0) return {};
  return "\n--- " + std::to_string(count) +
         " messages of trace were dropped here: the client did not read them in time ---\n";
}

template <typename Note>
void RemoteConnection::SendTrace(HostedAgent& agent, int event, std::string_view piece, std::string_view opening,
                                 std::string_view closing, Note note) {
  const std::uint64_t series = agent.number() * smlEVENT_LAST + static_cast<std::uint64_t>(event);
  const unsigned long long before = channel_->dropped();
  if (before == told_dropped_ && channel_->Join(series, piece)) return;
  head_ = "<sml doctype=\"call\" id=\"";
  head_ += NextId();
  head_ += "\" smlversion=\"";
  head_ += wire::kSmlVersion;
  head_ += "\"><command name=\"event\"><arg param=\"agent\">";
  wire::AppendEscaped(head_, agent.name());
  head_ += "</arg><arg param=\"eventid\">";
  head_ += Events().ConvertToString(event);
  head_ += "</arg>";
  head_ += opening;
  if (const std::string told = DroppedNote(); !told.empty()) note(head_, told);
  channel_->SendOpen(series, head_, piece, closing);
  if (channel_->dropped() == before) told_dropped_ = before;
}

void RemoteConnection::OnSystemEvent(int event) {
  Announce({event, {}, {}, 0});
}

void RemoteConnection::OnUpdateEvent(int event, int run_flags) {
  Announce({event, {}, "value", run_flags});
}

void RemoteConnection::OnAgentEvent(HostedAgent& agent, int event) {
  if (event == smlEVENT_BEFORE_AGENT_DESTROYED) {
    const auto of_agent = [&](const Notice& notice) { return notice.agent == agent.name(); };
    std::erase_if(notices_, of_agent);
    std::erase_if(round_, of_agent);
  }
  wire::Message call = EventCall();
  Command(call).AddArg("name", agent.name()).AddArg("eventid", EventName(event));
  Call(call, Wait::kForAnswer);
}

void RemoteConnection::OnRunEvent(HostedAgent& agent, int event, int phase) {
  Announce({event, agent.name(), "phase", phase});
}

void RemoteConnection::OnProductionEvent(HostedAgent& agent, int event, std::string_view name) {
  wire::Message call = EventCall();
  Command(call).AddArg("agent", agent.name()).AddArg("eventid", EventName(event)).AddArg("name", std::string(name));
  Call(call, Wait::kNo, true);
}

void RemoteConnection::OnPrint(HostedAgent& agent, const std::string& text) {
  piece_.clear();
  wire::AppendEscaped(piece_, text);
  SendTrace(agent, smlEVENT_PRINT, piece_, "<arg param=\"message\">", "</arg></command></sml>",
            [](std::string& out, std::string_view note) { wire::AppendEscaped(out, note); });
}

void RemoteConnection::OnEcho(HostedAgent& agent, const std::string& text, bool self) {
  wire::Message call = EventCall();
  Command(call)
      .AddArg("agent", agent.name())
      .AddArg("eventid", EventName(smlEVENT_ECHO))
      .AddArg("message", text)
      .AddArg("self", self ? "true" : "false");
  Call(call, Wait::kNo, true);
}

void RemoteConnection::OnXmlTrace(HostedAgent& agent, std::string_view pieces) {
  SendTrace(agent, smlEVENT_XML_TRACE_OUTPUT, pieces, "</command><trace>", "</trace></sml>",
            [](std::string& out, std::string_view note) {
              wire::XmlPen(out).Begin("message").Set("string", note).End("message");
            });
}

void RemoteConnection::OnXmlInput(HostedAgent& agent, std::span<const InputWme> wmes) {
  wire::Message call = EventCall();
  Command(call) = InputReceivedCommand(agent, wmes);
  Call(call, Wait::kNo, true);
}

void RemoteConnection::OnOutput(HostedAgent& agent, std::span<const kernel::OutputChange> changes) {
  wire::Message call = wire::MakeCall("output");
  Command(call).AddArg("agent", agent.name());
  const bool first = told_output_.insert(agent.name()).second && !changes.empty();
  AddOutput(Command(call), agent.agent(), changes, first);
  Call(call, Wait::kForAnswer);
}

void RemoteConnection::OnOutputInit(HostedAgent& agent) {
  wire::Message call = wire::MakeCall("output_init");
  Command(call).AddArg("agent", agent.name());
  Call(call, Wait::kForAnswer);
}

std::optional<std::string> RemoteConnection::OnFunction(HostedAgent* agent, int event, std::string_view name,
                                                        std::string_view argument) {
  wire::Message call = EventCall();
  Command(call)
      .AddArg("name", agent ? agent->name() : std::string())
      .AddArg("eventid", EventName(event))
      .AddArg("function", std::string(name))
      .AddArg("value", std::string(argument));
  const auto answer = Call(call, Wait::kForAnswer);
  if (!answer) return std::nullopt;
  const wire::Element* result = answer->ResultTag();
  return result ? result->text : std::string();
}

}  // namespace soarbox::server
