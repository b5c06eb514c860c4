// SPDX-License-Identifier: BSD-2-Clause
#include "sml/server/hosted_agent.h"

#include <algorithm>

#include "kernel/longterm/long_term.h"
#include "sml/server/event_relay.h"
#include "sml/server/xml_trace.h"

namespace soarbox::server {

namespace {

/// Printed text is sent when it reaches this size, even if it is not flushed.
constexpr std::size_t kPrintChunk = 64 * 1024;

/// Number of agents created by this program.
std::atomic<std::uint64_t> agents_made{0};

}  // namespace

HostedAgent::HostedAgent(std::string name)
    : name_(std::move(name)),
      number_(++agents_made),
      agent_(name_),
      session_(*this, agent_, name_),
      input_(agent_),
      relay_(std::make_unique<EventRelay>(*this)),
      tracer_(std::make_unique<XmlTracer>(*this)) {
  origins = std::make_unique<kernel::Origins>(agent_.long_term().parts());
  session_.UpdateTrace();
}

HostedAgent::~HostedAgent() = default;

void HostedAgent::Register(Connection& connection, int event) {
  auto found = std::find_if(listeners_.begin(), listeners_.end(),
                            [&](const Listener& listener) { return listener.connection == &connection; });
  if (found == listeners_.end()) {
    // The program that contains the kernel receives everything first.
    found = listeners_.insert(connection.embedded() ? listeners_.begin() : listeners_.end(), Listener{&connection, {}});
  }
  if (found->events.Has(event)) return;
  found->events.Add(event);
  if (!listened_.Has(event)) registered_at_[static_cast<std::size_t>(event)] = ++registrations_;
  UpdateListened();
}

void HostedAgent::Unregister(Connection& connection, int event) {
  for (Listener& listener : listeners_) {
    if (listener.connection == &connection) listener.events.Remove(event);
  }
  UpdateListened();
}

void HostedAgent::Forget(Connection& connection) {
  std::erase_if(listeners_, [&](const Listener& listener) { return listener.connection == &connection; });
  UpdateListened();
}

void HostedAgent::UpdateListened() {
  const bool printed_before = listened_.Has(::sml::smlEVENT_PRINT);
  listened_.Clear();
  for (const Listener& listener : listeners_) listened_.Add(listener.events);
  phase_listeners_ = listened_.HasAnyOf(::sml::smlEVENT_BEFORE_PHASE_EXECUTED, ::sml::smlEVENT_AFTER_DECISION_CYCLE);
  relay_->Update(listened_);
  tracer_->SetOn(listened_.Has(::sml::smlEVENT_XML_TRACE_OUTPUT));
  const bool prints = listened_.Has(::sml::smlEVENT_PRINT);
  if (prints == printed_before) return;
  if (prints) {
    session_.stream().SetSink([this](std::string_view text) {
      printed_ += text;
      if (printed_.size() >= kPrintChunk) SendPrint();
    });
  } else {
    session_.stream().SetSink({});
    printed_.clear();
  }
}

template <typename Call>
void HostedAgent::Tell(int event, Call call) {
  if (!listened_.Has(event)) return;
  // In Soar 9.6.3, the line of a decision is written after the events at the end of its phase.
  const bool within_phase = event < ::sml::smlEVENT_BEFORE_PHASE_EXECUTED ||
                            event == ::sml::smlEVENT_AFTER_DECIDE_PHASE ||
                            event == ::sml::smlEVENT_AFTER_PHASE_EXECUTED || ::sml::IsProductionEventID(event);
  if (!within_phase) FlushPrint();
  // Handlers may register and unregister, so the list may change during the loop. They may also destroy the agent; its
  // clients must not receive events for it then.
  for (std::size_t i = 0; i < listeners_.size() && !doomed; ++i) {
    if (listeners_[i].events.Has(event)) call(*listeners_[i].connection);
  }
}

void HostedAgent::TellRun(int event, int phase) {
  Tell(event, [&](Connection& connection) { connection.OnRunEvent(*this, event, phase); });
}

void HostedAgent::FirePhase(int specific, int general, int phase) {
  if (registered_at_[static_cast<std::size_t>(general)] > registered_at_[static_cast<std::size_t>(specific)]) {
    std::swap(specific, general);
  }
  FireRun(specific, phase);
  FireRun(general, phase);
}

void HostedAgent::FireProduction(int event, std::string_view name) {
  Tell(event, [&](Connection& connection) { connection.OnProductionEvent(*this, event, name); });
}

void HostedAgent::FireOutput(std::span<const kernel::OutputChange> changes) {
  Tell(::sml::smlEVENT_OUTPUT_PHASE_CALLBACK, [&](Connection& connection) { connection.OnOutput(*this, changes); });
}

void HostedAgent::FireOutputInit() {
  Tell(::sml::smlEVENT_OUTPUT_PHASE_CALLBACK, [&](Connection& connection) { connection.OnOutputInit(*this); });
}

void HostedAgent::FireXmlInput(std::span<const InputWme> wmes) {
  Tell(::sml::smlEVENT_XML_INPUT_RECEIVED, [&](Connection& connection) { connection.OnXmlInput(*this, wmes); });
}

void HostedAgent::FireEcho(const Connection* from, const std::string& text) {
  Tell(::sml::smlEVENT_ECHO, [&](Connection& connection) { connection.OnEcho(*this, text, &connection == from); });
}

void HostedAgent::SendPrint() {
  std::string text;
  text.swap(printed_);
  for (std::size_t i = 0; i < listeners_.size() && !doomed; ++i) {
    if (listeners_[i].events.Has(::sml::smlEVENT_PRINT)) listeners_[i].connection->OnPrint(*this, text);
  }
  // Keeps the allocated memory for the next text, unless a handler printed meanwhile.
  if (printed_.empty()) {
    text.clear();
    printed_.swap(text);
  }
}

void HostedAgent::PrepareRun() {
  if (Listens(::sml::smlEVENT_XML_TRACE_OUTPUT)) tracer_->Refresh();
}

void HostedAgent::FlushXmlTrace() {
  if (!Listens(::sml::smlEVENT_XML_TRACE_OUTPUT)) return;
  std::string pieces = std::move(trace_pieces_);
  if (tracer_->Take(pieces)) {
    Tell(::sml::smlEVENT_XML_TRACE_OUTPUT, [&](Connection& connection) { connection.OnXmlTrace(*this, pieces); });
  }
  // Keeps the allocated memory for the next parts.
  trace_pieces_ = std::move(pieces);
}

void HostedAgent::DeliverOutput() {
  const kernel::OutputLink& output = agent_.output();
  if (output.generation() == output_generation_) return;
  output_generation_ = output.generation();
  FireOutput(output.changes());
}

}  // namespace soarbox::server
