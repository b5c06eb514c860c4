// SPDX-License-Identifier: BSD-2-Clause
#include "sim/percept_link.h"

#include <algorithm>

#include "sml_Client.h"
#ifdef SOARBOX_OWN_KERNEL
#include "soarbox_DirectInput.h"
#endif

namespace soarbox::sim {
namespace {

using Kind = PerceptSlot::Kind;

template <typename T>
T* PointerOf(std::uint64_t handle) {
  return reinterpret_cast<T*>(static_cast<std::uintptr_t>(handle));
}

std::uint64_t HandleOf(const void* pointer) {
  return static_cast<std::uint64_t>(reinterpret_cast<std::uintptr_t>(pointer));
}

sml::WMElement* Create(sml::Agent& agent, sml::Identifier* parent, const PerceptSlot& slot) {
  const std::string attribute(slot.Attribute());
  switch (slot.kind) {
    case Kind::kInteger:
      return agent.CreateIntWME(parent, attribute.c_str(), slot.integer);
    case Kind::kFloat:
      return agent.CreateFloatWME(parent, attribute.c_str(), slot.number);
    case Kind::kText:
      return agent.CreateStringWME(parent, attribute.c_str(), std::string(slot.Text()).c_str());
    case Kind::kObject:
      return agent.CreateIdWME(parent, attribute.c_str());
  }
  return nullptr;
}

}  // namespace

#ifdef SOARBOX_OWN_KERNEL

/// An element of a slot is the kernel's handle, and above it the number of the percept in the order of addition.
struct PerceptLink::Direct {
  std::unique_ptr<DirectInput> input;

  static DirectInput::Element ElementOf(const PerceptSlot& slot) {
    return static_cast<DirectInput::Element>(static_cast<std::uint32_t>(slot.element));
  }
  static std::uint32_t NumberOf(const PerceptSlot& slot) { return static_cast<std::uint32_t>(slot.element >> 32); }
};

PerceptLink::PerceptLink(sml::Agent& agent, Way way) : agent_(agent) {
  if (way == Way::kClientApi) return;
  auto input = DirectInput::Open(agent, [this] {
    std::vector<PerceptSlot*> slots;
    for (PerceptSlots* top : tops_)
      for (PerceptSlot& slot : *top) slots.push_back(&slot);
    added_ = 0;
    WriteAgain(InputLink(), std::move(slots));
  });
  if (input != nullptr) direct_.reset(new Direct{std::move(input)});
}

bool PerceptLink::AddDirectly(std::uint64_t parent, PerceptSlot& slot) {
  DirectInput& input = *direct_->input;
  if (!input.IsUsable()) return false;
  const auto to = static_cast<DirectInput::Object>(static_cast<std::uint32_t>(parent));
  const std::string_view attribute = slot.Attribute();
  auto element = DirectInput::Element::kNone;
  switch (slot.kind) {
    case Kind::kInteger:
      element = input.Add(to, attribute, slot.integer);
      break;
    case Kind::kFloat:
      element = input.Add(to, attribute, slot.number);
      break;
    case Kind::kText:
      element = input.Add(to, attribute, slot.Text());
      break;
    case Kind::kObject: {
      auto object = DirectInput::Object::kNone;
      element = input.AddObject(to, attribute, object);
      slot.object.handle = static_cast<std::uint64_t>(object);
      break;
    }
  }
  slot.element = std::uint64_t{++added_} << 32 | static_cast<std::uint32_t>(element);
  return true;
}

/// Depth first, in the order in which the percepts of an object were first added.
void PerceptLink::WriteAgain(std::uint64_t parent, std::vector<PerceptSlot*> slots) {
  std::ranges::stable_sort(slots, {}, [](const PerceptSlot* slot) { return Direct::NumberOf(*slot); });
  for (PerceptSlot* slot : slots) {
    if (!AddDirectly(parent, *slot)) return;
    if (slot->kind != Kind::kObject) continue;
    std::vector<PerceptSlot*> below;
    for (PerceptSlot& one : *slot->object.below) below.push_back(&one);
    WriteAgain(slot->object.handle, std::move(below));
  }
}

#else

struct PerceptLink::Direct {};

PerceptLink::PerceptLink(sml::Agent& agent, Way) : agent_(agent) {}

#endif

void PerceptLink::EndDirect::operator()(Direct* direct) const {
  delete direct;
}

PerceptLink::~PerceptLink() = default;

void PerceptLink::Close() {
  is_closed_ = true;
  direct_.reset();
}

std::uint64_t PerceptLink::InputLink() {
  if (is_closed_) return 0;
#ifdef SOARBOX_OWN_KERNEL
  if (direct_ != nullptr) return static_cast<std::uint64_t>(DirectInput::Object::kInputLink);
#endif
  return HandleOf(agent_.GetInputLink());
}

bool PerceptLink::Add(std::uint64_t parent, PerceptSlot& slot) {
  if (is_closed_) return false;
#ifdef SOARBOX_OWN_KERNEL
  if (direct_ != nullptr) return AddDirectly(parent, slot);
#endif
  sml::WMElement* const made = Create(agent_, PointerOf<sml::Identifier>(parent), slot);
  slot.element = HandleOf(made);
  if (slot.kind == Kind::kObject) slot.object.handle = HandleOf(static_cast<sml::Identifier*>(made));
  return made != nullptr;
}

void PerceptLink::Change(const PerceptSlot& slot) {
  if (is_closed_) return;
#ifdef SOARBOX_OWN_KERNEL
  if (direct_ != nullptr) {
    DirectInput& input = *direct_->input;
    if (!input.IsUsable()) return;
    const DirectInput::Element element = Direct::ElementOf(slot);
    if (slot.kind == Kind::kFloat) return input.Update(element, slot.number);
    if (slot.kind == Kind::kInteger) return input.Update(element, slot.integer);
    return input.Update(element, slot.Text());
  }
#endif
  auto* const element = PointerOf<sml::WMElement>(slot.element);
  if (slot.kind == Kind::kFloat) {
    agent_.Update(static_cast<sml::FloatElement*>(element), slot.number);
  } else if (slot.kind == Kind::kInteger) {
    agent_.Update(static_cast<sml::IntElement*>(element), slot.integer);
  } else {
    agent_.Update(static_cast<sml::StringElement*>(element), std::string(slot.Text()).c_str());
  }
}

void PerceptLink::Remove(const PerceptSlot& slot) {
  if (is_closed_) return;
#ifdef SOARBOX_OWN_KERNEL
  if (direct_ != nullptr) {
    if (direct_->input->IsUsable()) direct_->input->Remove(Direct::ElementOf(slot));
    return;
  }
#endif
  agent_.DestroyWME(PointerOf<sml::WMElement>(slot.element));
}

}  // namespace soarbox::sim
