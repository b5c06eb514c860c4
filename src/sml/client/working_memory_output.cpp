// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>

#include "sml/client/agent_data.h"
#include "sml/client/client_memory.h"

namespace sml {

using soarbox::server::InputWme;

void WorkingMemory::EnableTracking(bool by_user) {
  if (tracking_ == Tracking::kOn || (tracking_ == Tracking::kUserOff && !by_user)) return;
  tracking_ = Tracking::kOn;
  if (AgentLink* link = data_.Usable()) {
    link->WatchApplyPhases(true);
    changes_at_ = link->ApplyCount();
  }
}

void WorkingMemory::DisableTracking() {
  ClearChanges();
  if (tracking_ == Tracking::kOn && data_.link) data_.link->WatchApplyPhases(false);
  tracking_ = Tracking::kUserOff;
}

void WorkingMemory::DropOldChanges() {
  if (tracking_ != Tracking::kOn || changes_.deltas_.empty() || !data_.link) return;
  if (data_.link->ApplyCount() != changes_at_) ClearChanges();
}

void WorkingMemory::ClearChanges() {
  for (WMDelta& delta : changes_.deltas_) {
    WMElement* wme = delta.getWME();
    wme->just_added_ = false;
    if (wme->parent_) wme->parent_->children_modified_ = false;
  }
  changes_.deltas_.clear();
  if (removed_.empty()) return;
  releasing_.swap(removed_);
  for (WMElement* wme : releasing_) {
    // (Removed output is not a child and not in the table any more. So for most elements nothing else remains to be
    // done.)
    if (wme->kind_ == WMElement::Kind::kIdentifier) {
      Release(wme);
    } else {
      RetireElement(wme);
    }
  }
  releasing_.clear();
}

int WorkingMemory::CountCommands() {
  DropOldChanges();
  if (!output_link_) return 0;
  int count = 0;
  for (const WMElement* child : *output_link_->symbol_) {
    if (child->just_added_ && child->kind_ == WMElement::Kind::kIdentifier) ++count;
  }
  return count;
}

Identifier* WorkingMemory::Command(int index) {
  DropOldChanges();
  if (!output_link_ || index < 0) return nullptr;
  for (WMElement* child : *output_link_->symbol_) {
    if (!child->just_added_ || child->kind_ != WMElement::Kind::kIdentifier) continue;
    if (index-- == 0) return static_cast<Identifier*>(child);
  }
  return nullptr;
}

void WorkingMemory::BeginOutput() {
  DropOldChanges();
  if (tracking_ == Tracking::kOn) changes_at_ = data_.link->ApplyCount();
}

WMElement* WorkingMemory::MakeOutput(const OutputWme& wme, IdentifierSymbol* parent) {
  switch (wme.type) {
    case InputWme::Type::kInt: {
      IntElement* made = ints_.Take();
      made->value_ = wme.integer;
      Attach(made, parent, wme.attribute, wme.tag, true);
      return made;
    }
    case InputWme::Type::kDouble: {
      FloatElement* made = floats_.Take();
      made->value_ = wme.real;
      Attach(made, parent, wme.attribute, wme.tag, true);
      return made;
    }
    case InputWme::Type::kId: {
      if (wme.value_id == 0) break;
      Identifier* made = identifiers_.Take();
      made->symbol_ = SymbolFor(wme.value_id);
      made->symbol_->UsedBy(made);
      made->symbol_->hint_ = wme.value_hint;
      Attach(made, parent, wme.attribute, wme.tag, true);
      return made;
    }
    case InputWme::Type::kString:
      break;
  }
  StringElement* made = strings_.Take();
  made->value_ = wme.text;
  Attach(made, parent, wme.attribute, wme.tag, true);
  return made;
}

/// Whether this client added the element to the output itself, such as ^status complete.
bool WorkingMemory::HasOwn(IdentifierSymbol& parent, const OutputWme& wme) {
  return std::any_of(parent.begin(), parent.end(), [&](WMElement* child) {
    if (child->output_ || wme.attribute != child->attribute_) return false;
    switch (wme.type) {
      case InputWme::Type::kInt:
        return child->ConvertToIntElement() && child->ConvertToIntElement()->value_ == wme.integer;
      case InputWme::Type::kDouble:
        return child->ConvertToFloatElement() && child->ConvertToFloatElement()->value_ == wme.real;
      case InputWme::Type::kString:
        return child->ConvertToStringElement() && wme.text == child->ConvertToStringElement()->GetValue();
      case InputWme::Type::kId:
        return child->IsIdentifier();
    }
    return false;
  });
}

void WorkingMemory::ReceiveOutput(const OutputWme& wme) {
  if (!wme.add) {
    RemoveOutput(wme.tag);
  } else if (!AddOutput(wme)) {
    Orphan& orphan = orphans_.emplace_back(Orphan{wme, std::string(wme.attribute), std::string(wme.text)});
    orphan.wme.attribute = {};
    orphan.wme.text = {};
  }
}

bool WorkingMemory::AddOutput(const OutputWme& wme) {
  if (wme.tag == 0 || output_by_tag_.Find(wme.tag)) return true;
  if (!output_link_ && wme.type == InputWme::Type::kId && wme.value_id != 0 && wme.attribute == "output-link") {
    output_link_ = static_cast<Identifier*>(MakeOutput(wme, nullptr));
    output_link_->just_added_ = false;
    output_by_tag_.Set(wme.tag, output_link_);
    return true;
  }
  IdentifierSymbol* parent = FindSymbol(wme.id);
  if (!parent) return false;
  if (parent->has_own_ && HasOwn(*parent, wme)) return true;
  WMElement* made = MakeOutput(wme, parent);
  parent->children_modified_ = true;
  output_by_tag_.Add(wme.tag, made);
  if (tracking()) changes_.deltas_.emplace_back(WMDelta::kAdded, made);
  return true;
}

void WorkingMemory::RemoveOutput(long long tag) {
  const auto found = output_by_tag_.Take(tag);
  if (!found || *found == output_link_) return;
  WMElement* wme = *found;
  if (wme->parent_) wme->parent_->children_modified_ = true;
  if (!tracking()) {
    Release(wme);
    return;
  }
  Detach(wme);
  wme->live_ = false;
  removed_.push_back(wme);
  changes_.deltas_.emplace_back(WMDelta::kRemoved, wme);
}

bool WorkingMemory::AttachOrphans() {
  bool progress = true;
  while (progress && !orphans_.empty()) {
    progress = false;
    waiting_orphans_.clear();
    waiting_orphans_.swap(orphans_);
    for (Orphan& orphan : waiting_orphans_) {
      if (!FindSymbol(orphan.wme.id)) {
        orphans_.push_back(std::move(orphan));
        continue;
      }
      OutputWme wme = orphan.wme;
      wme.attribute = orphan.attribute;
      wme.text = orphan.text;
      ReceiveOutput(wme);
      progress = true;
    }
  }
  const bool complete = orphans_.empty();
  orphans_.clear();
  return complete;
}

void WorkingMemory::InvalidateOutput() {
  ClearChanges();
  orphans_.clear();
  if (!output_link_) return;
  Identifier* link = output_link_;
  output_link_ = nullptr;
  Release(link);
}

bool WorkingMemory::SynchronizeOutput() {
  if (!data_.Usable()) return false;
  InvalidateOutput();
  BeginOutput();
  data_.link->ListOutput([this](const OutputWme& wme) { ReceiveOutput(wme); });
  return EndOutput();
}

}  // namespace sml
