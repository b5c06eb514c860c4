// SPDX-License-Identifier: BSD-2-Clause
#include "sim/percept_link.h"

#include <algorithm>
#include <cstddef>
#include <functional>

#include "sim/client_input.h"
#ifdef SOARBOX_OWN_KERNEL
#include "soarbox_DirectInput.h"
#endif

namespace soarbox::sim {

mind::Value PerceptSlot::Value() const {
  if (kind == Kind::kInteger) return integer;
  if (kind == Kind::kFloat) return number;
  return Text().substr(0, Text().find('\0'));
}

PerceptLink::PerceptLink(sml::Agent& agent) {
#ifdef SOARBOX_OWN_KERNEL
  input_ = OpenDirectInput(agent, [this] {
    std::vector<Again> again;
    for (const Lister& list : listers_) list(again);
    WriteAgain(std::move(again));
  });
#endif
  if (input_ == nullptr) input_ = OpenClientInput(agent);
}

void PerceptLink::WriteAgain(std::vector<Again> again) {
  // A stack: the last element is next. Chains of objects may be too long for a recursive function.
  std::ranges::sort(again, std::ranges::greater(), &Again::element);
  while (!again.empty()) {
    const Again next = std::move(again.back());
    again.pop_back();
    const auto rest = static_cast<std::ptrdiff_t>(again.size());
    next.write(again);
    std::ranges::sort(again.begin() + rest, again.end(), std::ranges::greater(), &Again::element);
  }
}

void PerceptLink::ListAgain(Handle object, PerceptSlots& slots, std::vector<Again>& again) {
  for (PerceptSlot& slot : slots) {
    again.push_back({slot.element, [this, object, &slot](std::vector<Again>& below) {
                       if (!Add(object, slot) || slot.kind != PerceptSlot::Kind::kObject) return;
                       ListAgain(slot.object.handle, *slot.object.below, below);
                     }});
  }
}

bool PerceptLink::Add(Handle object, PerceptSlot& slot) {
  if (input_ == nullptr) return false;
  slot.element = slot.kind == PerceptSlot::Kind::kObject
                     ? input_->AddObject(object, slot.Attribute(), slot.object.handle)
                     : input_->Add(object, slot.Attribute(), slot.Value());
  return slot.element != 0;
}

}  // namespace soarbox::sim
