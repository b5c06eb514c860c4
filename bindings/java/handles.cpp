// SPDX-License-Identifier: BSD-2-Clause
#include "handles.h"

#include <mutex>
#include <unordered_map>

namespace soarbox::java {

namespace {

constexpr int kKindBits = 3;

struct Table {
  std::mutex mutex;
  std::unordered_map<jlong, Slot> slots;
  jlong last = 0;
};

/// Never destroyed, because Java threads may still run while the process ends.
Table& TheTable() {
  static auto* table = new Table;
  return *table;
}

}  // namespace

jlong Add(Slot slot, ElementKind kind) {
  Table& table = TheTable();
  const std::lock_guard lock(table.mutex);
  const jlong number = (++table.last << kKindBits) | kind;
  table.slots.emplace(number, std::move(slot));
  return number;
}

bool Find(jlong number, Slot& slot) {
  Table& table = TheTable();
  const std::lock_guard lock(table.mutex);
  const auto found = table.slots.find(number);
  if (found == table.slots.end()) return false;
  slot = found->second;
  return true;
}

void Release(jlong number) {
  Table& table = TheTable();
  Slot released;  // Destroyed without the lock, because deleting a kernel calls handlers.
  const std::lock_guard lock(table.mutex);
  const auto found = table.slots.find(number);
  if (found == table.slots.end()) return;
  released = std::move(found->second);
  table.slots.erase(found);
}

jlong& LastGiven() {
  thread_local jlong given = 0;
  return given;
}

jlong Give(sml::Kernel* kernel, bindings::Life life) {
  return kernel ? Add({kernel, std::move(life), {}}) : 0;
}

jlong Give(sml::Agent* agent, bindings::Life life) {
  return agent ? Add({agent, std::move(life), {}}) : 0;
}

jlong Give(sml::WMElement* element, bindings::Life life) {
  if (!element) return 0;
  if (sml::Identifier* identifier = element->ConvertToIdentifier()) {
    return Add({identifier, std::move(life), {}}, kIdentifierKind);
  }
  if (sml::StringElement* text = element->ConvertToStringElement()) {
    return Add({text, std::move(life), {}}, kStringKind);
  }
  if (sml::IntElement* number = element->ConvertToIntElement()) return Add({number, std::move(life), {}}, kIntKind);
  if (sml::FloatElement* number = element->ConvertToFloatElement()) {
    return Add({number, std::move(life), {}}, kFloatKind);
  }
  return Add({element, std::move(life), {}});
}

jlong Give(sml::IdentifierSymbol* symbol, bindings::Life life) {
  return symbol ? Add({symbol, std::move(life), {}}) : 0;
}

jlong GiveOwned(sml::Kernel* kernel, bindings::Life life) {
  if (!kernel) return 0;
  std::shared_ptr<void> own(kernel, bindings::Owned{life});
  return Add({kernel, std::move(life), std::move(own)});
}

}  // namespace soarbox::java
