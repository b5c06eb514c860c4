// SPDX-License-Identifier: BSD-2-Clause
#include <utility>

#include "kernel/agent.h"
#include "sml/client/agent_data.h"
#include "sml/client/local_agent_link.h"
#include "soarbox_DirectInput.h"

namespace soarbox {
namespace {

kernel::InputLink& LinkOf(sml::AgentData& data) {
  return static_cast<sml::LocalAgentLink&>(*data.link).hosted().agent().input();
}

std::string_view UpToZero(std::string_view text) {
  return text.substr(0, text.find('\0'));
}

kernel::InputObject KernelObject(DirectInput::Object object) {
  static_assert(static_cast<std::uint32_t>(DirectInput::Object::kInputLink) ==
                static_cast<std::uint32_t>(kernel::InputObject::kInputLink));
  static_assert(static_cast<std::uint32_t>(DirectInput::Object::kNone) ==
                static_cast<std::uint32_t>(kernel::InputObject::kNone));
  return static_cast<kernel::InputObject>(object);
}

kernel::InputElement KernelElement(DirectInput::Element element) {
  return static_cast<kernel::InputElement>(element);
}

DirectInput::Element AddTo(sml::AgentData& data, DirectInput::Object parent, std::string_view attribute,
                           const kernel::InputValue& value) {
  attribute = UpToZero(attribute);
  if (attribute.empty()) return DirectInput::Element::kNone;
  return static_cast<DirectInput::Element>(LinkOf(data).Add(KernelObject(parent), attribute, value));
}

}  // namespace

std::unique_ptr<DirectInput> DirectInput::Open(sml::Agent& agent, std::function<void()> write_again) {
  sml::AgentData& data = sml::AgentData::Of(agent);
  auto* const link = sml::LocalLinkOf(agent);
  if (link == nullptr || link->host().Port() != 0 || link->hosted().log != nullptr || data.write_direct_input)
    return nullptr;
  data.write_direct_input = std::move(write_again);
  return std::unique_ptr<DirectInput>(new DirectInput(data));
}

DirectInput::~DirectInput() {
  data_.write_direct_input = nullptr;
}

bool DirectInput::IsUsable() const {
  return data_.link != nullptr && !data_.kernel_data().shut_down;
}

DirectInput::Element DirectInput::Add(Object parent, std::string_view attribute, std::string_view value) {
  return AddTo(data_, parent, attribute, UpToZero(value));
}

DirectInput::Element DirectInput::Add(Object parent, std::string_view attribute, std::int64_t value) {
  return AddTo(data_, parent, attribute, value);
}

DirectInput::Element DirectInput::Add(Object parent, std::string_view attribute, double value) {
  return AddTo(data_, parent, attribute, value);
}

DirectInput::Element DirectInput::AddObject(Object parent, std::string_view attribute, Object& object) {
  object = Object::kNone;
  if (parent == Object::kNone || attribute.empty() || attribute.front() == '\0') return Element::kNone;
  const kernel::InputObject made = LinkOf(data_).NewObject();
  object = static_cast<Object>(made);
  return AddTo(data_, parent, attribute, made);
}

void DirectInput::Update(Element element, std::string_view value) {
  LinkOf(data_).Update(KernelElement(element), UpToZero(value));
}

void DirectInput::Update(Element element, std::int64_t value) {
  LinkOf(data_).Update(KernelElement(element), value);
}

void DirectInput::Update(Element element, double value) {
  LinkOf(data_).Update(KernelElement(element), value);
}

void DirectInput::Remove(Element element) {
  LinkOf(data_).Remove(KernelElement(element));
}

}  // namespace soarbox
