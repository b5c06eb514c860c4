// SPDX-License-Identifier: BSD-2-Clause
#include "sml/client/local_agent_link.h"

#include <algorithm>
#include <typeinfo>

#include "sml/client/agent_data.h"
#include "sml/server/decision_facts.h"
#include "sml/server/listing.h"
#include "sml/server/origin_facts.h"
#include "sml/server/scene_calls.h"

namespace sml {

namespace kernel = soarbox::kernel;
using soarbox::server::InputWme;

LocalAgentLink* LocalLinkOf(Agent& agent) {
  AgentLink* const link = AgentData::Of(agent).link.get();
  if (link == nullptr) return nullptr;
  const AgentLink& present = *link;
  return typeid(present) == typeid(LocalAgentLink) ? static_cast<LocalAgentLink*>(link) : nullptr;
}

std::string LocalAgentLink::InputLinkName() {
  return kernel::ToString(hosted_.agent().symbols(), std::as_const(hosted_).agent().InputLinkIdentifier());
}

std::optional<soarbox::mind::Decision> LocalAgentLink::Decision(std::string_view state) {
  return soarbox::server::DecisionNow(std::as_const(hosted_).agent(), state);
}

bool LocalAgentLink::NoteOrigins() {
  soarbox::server::NoteOrigins(hosted_);
  return true;
}

soarbox::mind::OriginFacts LocalAgentLink::Origin(std::uint64_t timetag, std::string_view command) {
  return command.empty() ? soarbox::server::OriginOfElement(hosted_, timetag)
                         : soarbox::server::OriginOfCommand(hosted_, command);
}

void LocalAgentLink::Note(const InputWme& wme) {
  // The texts may no longer exist at the end of the batch.
  const std::string id = wme.id.empty() ? soarbox::server::IdentifierName(wme.id_key) : std::string(wme.id);
  noted_texts_.push_back(id + '\0' + std::string(wme.attribute) + '\0' + std::string(wme.text));
  noted_.push_back(wme);
}

InputHandle LocalAgentLink::AddInput(const InputWme& wme) {
  const kernel::InputElement element = hosted_.input().Add(wme);
  if (hosted_.Listens(smlEVENT_XML_INPUT_RECEIVED)) Note(wme);
  return static_cast<InputHandle>(element);
}

InputHandle LocalAgentLink::UpdateInput(InputHandle element, long long old_tag, const InputWme& wme) {
  const kernel::InputElement updated = hosted_.input().Update(static_cast<kernel::InputElement>(element), wme);
  if (hosted_.Listens(smlEVENT_XML_INPUT_RECEIVED)) {
    NoteRemoval(old_tag);
    Note(wme);
  }
  return static_cast<InputHandle>(updated);
}

void LocalAgentLink::RemoveInput(InputHandle element, long long tag) {
  if (element == kNoInputHandle) {
    hosted_.input().RemoveByTag(tag);
  } else {
    hosted_.input().Remove(static_cast<kernel::InputElement>(element));
  }
  if (hosted_.Listens(smlEVENT_XML_INPUT_RECEIVED)) NoteRemoval(tag);
}

void LocalAgentLink::NoteRemoval(long long tag) {
  InputWme removal;
  removal.add = false;
  removal.tag = tag;
  Note(removal);
}

void LocalAgentLink::TellInput() {
  const soarbox::server::KernelHost::Stay stay(host_);
  std::vector<InputWme> wmes;
  std::vector<std::string> texts;
  wmes.swap(noted_);
  texts.swap(noted_texts_);
  for (std::size_t i = 0; i < wmes.size(); ++i) {
    const std::string_view text = texts[i];
    const std::size_t id_end = text.find('\0');
    const std::size_t attribute_end = text.find('\0', id_end + 1);
    wmes[i].id = text.substr(0, id_end);
    wmes[i].attribute = text.substr(id_end + 1, attribute_end - id_end - 1);
    wmes[i].text = text.substr(attribute_end + 1);
  }
  hosted_.FireXmlInput(wmes);
}

unsigned long long LocalAgentLink::ApplyCount() {
  const kernel::Agent& agent = hosted_.agent();
  const bool applied = agent.next_phase() == kernel::Phase::kOutput && !agent.in_middle_of_phase();
  return agent.counters().decision_cycles + (applied ? 1 : 0);
}

bool LocalAgentLink::IsProductionLoaded(std::string_view name) {
  return hosted_.agent().FindProduction(name) != kernel::ProductionId::kNone;
}

const OutputWme& LocalAgentLink::Describe(long long tag, kernel::Symbol id, kernel::Symbol attribute,
                                          kernel::Symbol value) {
  const kernel::SymbolTable& symbols = std::as_const(hosted_).agent().symbols();
  OutputWme& wme = described_;
  wme.text = {};
  wme.tag = tag;
  wme.id = IdentifierKey(symbols.Letter(id), symbols.Number(id));
  if (attribute.IsString()) {
    wme.attribute = symbols.Text(attribute);
  } else {
    attribute_.clear();
    kernel::AppendTo(attribute_, symbols, attribute, false);
    wme.attribute = attribute_;
  }
  if (value.IsIdentifier()) {
    wme.type = InputWme::Type::kId;
    wme.value_id = IdentifierKey(symbols.Letter(value), symbols.Number(value));
    wme.value_hint = value.bits();
  } else if (value.IsInteger()) {
    wme.type = InputWme::Type::kInt;
    wme.integer = symbols.IntegerValue(value);
  } else if (value.IsFloat()) {
    wme.type = InputWme::Type::kDouble;
    wme.real = symbols.FloatValue(value);
  } else {
    wme.type = InputWme::Type::kString;
    wme.text = symbols.Text(value);
  }
  return wme;
}

void LocalAgentLink::Deliver(AgentData& data, std::span<const kernel::OutputChange> changes) {
  data.memory.BeginOutput();
  if (!data.memory.OutputLink()) {
    const kernel::WmeInfo link = soarbox::server::OutputLinkWme(hosted_.agent());
    if (link.timetag != 0) {
      data.memory.ReceiveOutput(Describe(static_cast<long long>(link.timetag), link.id, link.attribute, link.value));
    }
  }
  // Additions first, as in messages. A child that arrives before its parent waits until the end.
  deferred_.clear();
  for (const kernel::OutputChange& change : changes) {
    if (change.added && !data.memory.AddOutput(Describe(change))) deferred_.push_back(&change);
  }
  for (const kernel::OutputChange& change : changes) {
    if (!change.added) data.memory.RemoveOutput(static_cast<long long>(change.timetag));
  }
  while (!deferred_.empty()) {
    const std::size_t left = std::erase_if(
        deferred_, [&](const kernel::OutputChange* change) { return data.memory.AddOutput(Describe(*change)); });
    if (left == 0) break;
  }
  data.OnOutputReceived(deferred_.empty());
}

bool LocalAgentLink::SendScene(std::string_view lines) {
  return soarbox::server::SendScene(hosted_, lines);
}

std::string LocalAgentLink::TakeRefusedScene() {
  return soarbox::server::TakeRefusedScene(hosted_);
}

std::string LocalAgentLink::QueryScene(std::string_view queries) {
  return soarbox::server::QueryScene(hosted_, queries);
}

void LocalAgentLink::ListInput(const std::function<void(const OutputWme&)>& visit) {
  for (const soarbox::server::InputListing& entry : soarbox::server::ListInput(hosted_)) {
    visit(Describe(entry.tag, entry.wme.id, entry.wme.attribute, entry.wme.value));
  }
}

void LocalAgentLink::ListOutput(const std::function<void(const OutputWme&)>& visit) {
  const kernel::WmeInfo link = soarbox::server::OutputLinkWme(hosted_.agent());
  if (link.timetag != 0) visit(Describe(static_cast<long long>(link.timetag), link.id, link.attribute, link.value));
  for (const kernel::OutputChange& wme : std::as_const(hosted_).agent().output().current()) {
    visit(Describe(static_cast<long long>(wme.timetag), wme.id, wme.attribute, wme.value));
  }
}

}  // namespace sml
