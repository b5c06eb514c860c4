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

/// A client's name such as "f12" as a number; 0 for other names.
std::int64_t ClientKey(std::string_view name) {
  constexpr std::size_t kMostDigits = 16;  // They fit below the letter.
  if (name.size() < 2 || name.size() > 1 + kMostDigits || name[1] < '1' || name[1] > '9') return 0;
  if (name[0] < 'a' || name[0] > 'z') return 0;
  std::uint64_t number = 0;
  for (const char digit : name.substr(1)) {
    if (digit < '0' || digit > '9') return 0;
    number = number * 10 + static_cast<std::uint64_t>(digit - '0');
  }
  return IdentifierKey(name[0], number);
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

const kernel::InputObject* AgentInput::FindNamed(std::string_view name) const {
  if (const std::int64_t key = ClientKey(name)) return objects_.Find(key);
  const auto found = odd_objects_.find(name);
  return found == odd_objects_.end() ? nullptr : &found->second;
}

kernel::InputObject AgentInput::Resolve(std::string_view name) {
  if (name.empty()) return kernel::InputObject::kNone;
  if (name == last_name_) return last_object_;
  if (const kernel::InputObject* found = FindNamed(name)) {
    last_name_ = name;
    return last_object_ = *found;
  }
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
    if (const std::int64_t key = ClientKey(wme.text)) {
      objects_.Set(key, object);
    } else {
      odd_objects_.emplace(std::string(wme.text), object);
    }
    last_name_ = wme.text;
    last_object_ = object;
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
  const kernel::InputObject* const found = FindNamed(client_name);
  if (found == nullptr) return {};
  const kernel::Symbol identifier = std::as_const(agent_).input().Identifier(*found);
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
  objects_.Clear();
  odd_objects_.clear();
  last_name_.clear();
}

void AgentInput::Tidy() {
  if (elements_.size() < tidy_elements_at_ && NamedObjects() < tidy_objects_at_) return;
  const kernel::InputLink& input = std::as_const(agent_).input();
  // Elements that wait for the next input phase are not in working memory either.
  if (input.HasPendingChanges()) return;
  elements_.RemoveIf(
      [&](std::int64_t, kernel::InputElement element) { return input.Wme(element) == kernel::WmeId::kNone; });
  last_name_.clear();
  const auto is_gone = [&](kernel::InputObject object) {
    const kernel::Symbol identifier = input.Identifier(object);
    return !identifier || !agent_.memory().identifier(identifier).live;
  };
  objects_.RemoveIf([&](std::int64_t, kernel::InputObject object) { return is_gone(object); });
  std::erase_if(odd_objects_, [&](const auto& entry) { return is_gone(entry.second); });
  tidy_elements_at_ = std::max<std::size_t>(256, 2 * elements_.size());
  tidy_objects_at_ = std::max<std::size_t>(64, 2 * NamedObjects());
}

}  // namespace soarbox::server
