// SPDX-License-Identifier: BSD-2-Clause
#include "sml/server/agent_input.h"

#include <algorithm>
#include <charconv>
#include <cstdint>

#include "sml/server/client_log.h"

namespace soarbox::server {

namespace {

/// The number in a kernel's name such as "F12"; 0 for other texts.
std::uint64_t NumberOf(std::string_view name) {
  if (name.size() < 2 || name[0] < 'A' || name[0] > 'Z') return 0;
  std::uint64_t number = 0;
  const auto [stop, error] = std::from_chars(name.data() + 1, name.data() + name.size(), number);
  return error == std::errc() && stop == name.data() + name.size() ? number : 0;
}

/// The live identifier with a kernel's name, or the none symbol.
kernel::Symbol FindIdentifier(const kernel::SymbolTable& symbols, std::string_view name) {
  const std::uint64_t number = NumberOf(name);
  return number == 0 ? kernel::Symbol() : symbols.FindIdentifier(name[0], number);
}

}  // namespace

kernel::InputObject AgentInput::Resolve(const InputWme& wme) {
  if (wme.id_hint != 0) {
    // The handle may have been reused for another identifier.
    const kernel::Symbol symbol = kernel::Symbol::FromBits(wme.id_hint);
    const kernel::SymbolTable& symbols = std::as_const(agent_).symbols();
    if (symbol.IsIdentifier() && std::as_const(agent_).memory().identifier(symbol).live &&
        IdentifierKey(symbols.Letter(symbol), symbols.Number(symbol)) == wme.id_key) {
      return agent_.input().ObjectFor(symbol);
    }
  }
  return wme.id.empty() ? Resolve(IdentifierName(wme.id_key)) : Resolve(wme.id);
}

kernel::InputObject AgentInput::Resolve(std::string_view name) {
  if (name.empty()) return kernel::InputObject::kNone;
  if (const auto found = objects_.find(name); found != objects_.end()) return found->second;
  const kernel::Symbol identifier = FindIdentifier(agent_.symbols(), name);
  if (!identifier) return kernel::InputObject::kNone;
  if (identifier == agent_.InputLinkIdentifier()) return kernel::InputObject::kInputLink;
  return agent_.input().ObjectFor(identifier);
}

kernel::InputValue AgentInput::Value(const InputWme& wme) {
  switch (wme.type) {
    case InputWme::Type::kInt:
      return std::int64_t{wme.integer};
    case InputWme::Type::kDouble:
      return wme.real;
    case InputWme::Type::kString:
      return wme.text;
    case InputWme::Type::kId:
      break;
  }
  kernel::InputObject object = Resolve(wme.text);
  if (object == kernel::InputObject::kNone && !wme.text.empty()) {
    object = agent_.input().NewObject();
    objects_.emplace(std::string(wme.text), object);
  }
  return object;
}

kernel::InputElement AgentInput::Add(const InputWme& wme) {
  const kernel::InputElement element = AddUnlogged(wme);
  if (log_ != nullptr) log_->Added(*hosted_, element, wme);
  return element;
}

kernel::InputElement AgentInput::AddUnlogged(const InputWme& wme) {
  if (wme.attribute.empty() || wme.tag == 0) return kernel::InputElement::kNone;
  const kernel::InputObject parent = Resolve(wme);
  if (parent == kernel::InputObject::kNone) return kernel::InputElement::kNone;
  return agent_.input().Add(parent, wme.attribute, Value(wme), wme.tag);
}

kernel::InputElement AgentInput::Update(kernel::InputElement element, const InputWme& wme) {
  if (element == kernel::InputElement::kNone) return Add(wme);
  agent_.input().Update(element, Value(wme), wme.tag);
  if (log_ != nullptr) log_->Changed(*hosted_, element, wme);
  return element;
}

void AgentInput::Remove(kernel::InputElement element) {
  if (log_ != nullptr) log_->Removed(*hosted_, element);
  agent_.input().Remove(element);
}

void AgentInput::AddByTag(const InputWme& wme) {
  const kernel::InputElement element = Add(wme);
  if (element != kernel::InputElement::kNone) elements_.Set(wme.tag, element);
}

void AgentInput::RemoveByTag(long long tag) {
  if (const std::optional<kernel::InputElement> element = elements_.Take(tag)) {
    Remove(*element);
    return;
  }
  if (tag <= 0) {
    kernel::InputElement found = kernel::InputElement::kNone;
    agent_.input().ForEachTagged([&](kernel::InputElement element, kernel::WmeId, std::int64_t other) {
      if (other == tag) found = element;
    });
    if (found != kernel::InputElement::kNone) Remove(found);
    return;
  }
  // A client that synchronized its input with the kernel identifies elements by the kernel's tags.
  if (log_ != nullptr) log_->Dropped(*hosted_, tag);
  const kernel::WmeId wme = agent_.memory().FindByTimetag(static_cast<std::uint64_t>(tag));
  if (wme != kernel::WmeId::kNone && agent_.memory().record(wme).kind == kernel::WmeKind::kInput) {
    static_cast<void>(agent_.RemoveWme(wme));
  }
}

std::string AgentInput::KernelName(std::string_view client_name) const {
  const auto found = objects_.find(client_name);
  if (found == objects_.end()) return {};
  const kernel::Symbol identifier = std::as_const(agent_).input().Identifier(found->second);
  return identifier ? kernel::ToString(agent_.symbols(), identifier) : std::string();
}

std::vector<std::pair<kernel::WmeId, long long>> AgentInput::ClientTags() const {
  std::vector<std::pair<kernel::WmeId, long long>> tags;
  std::as_const(agent_).input().ForEachTagged([&](kernel::InputElement, kernel::WmeId wme, std::int64_t tag) {
    if (wme != kernel::WmeId::kNone) tags.emplace_back(wme, tag);
  });
  std::sort(tags.begin(), tags.end());
  return tags;
}

void AgentInput::Clear() {
  elements_.Clear();
  objects_.clear();
}

void AgentInput::Tidy() {
  if (elements_.size() < tidy_elements_at_ && objects_.size() < tidy_objects_at_) return;
  const kernel::InputLink& input = std::as_const(agent_).input();
  // Elements that wait for the next input phase are not in working memory either.
  if (input.HasPendingChanges()) return;
  elements_.RemoveIf(
      [&](std::int64_t, kernel::InputElement element) { return input.Wme(element) == kernel::WmeId::kNone; });
  const auto is_gone = [&](const auto& named) {
    const kernel::Symbol identifier = input.Identifier(named.second);
    return !identifier || !agent_.memory().identifier(identifier).live;
  };
  std::erase_if(objects_, is_gone);
  tidy_elements_at_ = std::max<std::size_t>(256, 2 * elements_.size());
  tidy_objects_at_ = std::max<std::size_t>(64, 2 * objects_.size());
}

}  // namespace soarbox::server
