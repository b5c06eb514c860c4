// SPDX-License-Identifier: BSD-2-Clause
#include "sim/input_mirror.h"

#include <algorithm>

#include "sml_Client.h"
#include "wording/mind_words.h"

namespace soarbox::sim {

InputMirror::InputMirror(sml::Agent& agent) : agent_(&agent) {}

// Slots of an object -------------------------------------------------------------------------------------------------

bool InputMirror::Slot::Holds(std::string_view value) const {
  if (size == kLong) return static_cast<sml::StringElement*>(element)->GetValue() == value;
  return std::string_view(text, size) == value;
}

void InputMirror::Slot::Hold(std::string_view value) {
  size = value.size() <= kShort ? static_cast<std::uint8_t>(value.size()) : kLong;
  if (size != kLong) value.copy(text, size);
}

/// The slot with this name in the previous update, which is nearly always the next one. Null if there is none.
InputMirror::Slot* InputMirror::Find(const Name& name) {
  for (Slot* slot = next_; slot != end_; ++slot) {
    if (slot->row != name.row || slot->key != name.key || slot->kind != name.kind) continue;
    if (name.row == nullptr && name.other != slot->element->GetAttribute()) continue;
    if (slot != next_) std::rotate(next_, slot, slot + 1);
    return next_++;
  }
  return nullptr;
}

/// Stores a new element. If it could not be created (for example, the kernel is lost), the next update tries again.
InputMirror::Slot* InputMirror::Insert(const Name& name, sml::WMElement* element) {
  ++changes_;
  if (element == nullptr) return nullptr;
  Slot slot;
  slot.row = name.row;
  slot.key = name.key;
  slot.kind = name.kind;
  slot.element = element;
  if (name.kind == Kind::kObject) {
    if (spare_.empty()) spare_.push_back(&slots_.emplace_front());
    slot.below = spare_.back();
    spare_.pop_back();
  }
  Slots& slots = *open_.back().slots;
  const std::ptrdiff_t place = next_ - slots.data();
  if (slots.size() == slots.capacity()) slots.reserve(slots.size() + slots.size() / 4 + 2);  // There are many.
  slots.insert(slots.begin() + place, slot);
  GoOn(slots, static_cast<std::size_t>(place) + 1);
  return next_ - 1;
}

void InputMirror::Recycle(Slots& slots) {
  for (const Slot& slot : slots) {
    if (slot.kind != Kind::kObject) continue;
    Recycle(*slot.below);
    spare_.push_back(slot.below);
  }
  slots.clear();
}

void InputMirror::Destroy(const Slot& slot) {
  if (log_ != nullptr) log_->Add(mind::PerceptGone{Path(), slot.element->GetAttribute(), slot.key});
  agent_->DestroyWME(slot.element);  // Also destroys everything below it.
  if (slot.kind == Kind::kObject) {
    Recycle(*slot.below);
    spare_.push_back(slot.below);
  }
  ++changes_;
}

/// Removes the elements that were not reported.
void InputMirror::DropRest() {
  OpenObject& open = open_.back();
  Slots& slots = *open.slots;
  for (const Slot* slot = next_; slot != end_; ++slot) Destroy(*slot);
  slots.resize(static_cast<std::size_t>(next_ - slots.data()));
  slots.erase(slots.begin(), slots.begin() + static_cast<std::ptrdiff_t>(open.dropped));
}

std::uint32_t InputMirror::NextKey() const {
  return next_ != end_ ? next_->key : 0;
}

void InputMirror::Drop() {
  Destroy(*next_++);
  open_.back().dropped = static_cast<std::size_t>(next_ - open_.back().slots->data());
}

void InputMirror::KeepRest() {
  next_ = end_;
}

// Reporting ----------------------------------------------------------------------------------------------------------

void InputMirror::Begin() {
  changes_ = 0;
  refused_ = 0;
  path_.clear();
  named_ = 0;
  open_.clear();
  open_.push_back({top_.get(), 0, agent_->GetInputLink()});
  GoOn(*top_, 0);
}

void InputMirror::End() {
  DropRest();
  next_ = end_ = nullptr;
}

void InputMirror::Note(const Slot& slot) {
  mind::PerceptChanged percept{Path(), slot.element->GetAttribute(), slot.key, {}};
  if (slot.kind == Kind::kInteger) {
    percept.value = slot.integer;
  } else if (slot.kind == Kind::kFloat) {
    percept.value = slot.number;
  } else {
    percept.value = std::string_view(static_cast<sml::StringElement*>(slot.element)->GetValue());
  }
  log_->Add(percept);
}

/// Computed only when something changes, because most objects are only compared.
std::string_view InputMirror::Path() {
  for (; named_ < open_.size(); ++named_) {
    if (named_ == 0) continue;  // The input link itself.
    OpenObject& object = open_[named_];
    object.path_length = path_.size();
    path_ += object.object->GetAttribute();
    if (object.key != 0) path_.append("#").append(std::to_string(object.key));
    path_ += '.';
  }
  return path_;
}

void InputMirror::TellInteger(const Name& name, std::int64_t value) {
  if (refused_ > 0) return;
  if (Slot* slot = Find(name); slot != nullptr) {
    if (slot->integer != value) Change(*slot, value);
    return;
  }
  const std::string attribute = name.attribute();
  Slot* slot = Insert(name, agent_->CreateIntWME(open_.back().object, attribute.c_str(), value));
  if (slot == nullptr) return;
  slot->integer = value;
  if (log_ != nullptr) Note(*slot);
}

void InputMirror::Change(Slot& slot, std::int64_t value) {
  agent_->Update(static_cast<sml::IntElement*>(slot.element), value);
  ++changes_;
  slot.integer = value;
  if (log_ != nullptr) Note(slot);
}

void InputMirror::TellFloat(const Name& name, double value) {
  if (refused_ > 0) return;
  if (Slot* slot = Find(name); slot != nullptr) {
    if (slot->number != value) Change(*slot, value);
    return;
  }
  const std::string attribute = name.attribute();
  Slot* slot = Insert(name, agent_->CreateFloatWME(open_.back().object, attribute.c_str(), value));
  if (slot == nullptr) return;
  slot->number = value;
  if (log_ != nullptr) Note(*slot);
}

void InputMirror::Change(Slot& slot, double value) {
  agent_->Update(static_cast<sml::FloatElement*>(slot.element), value);
  ++changes_;
  slot.number = value;
  if (log_ != nullptr) Note(slot);
}

void InputMirror::TellText(const Name& name, std::string_view value) {
  if (refused_ > 0) return;
  if (Slot* slot = Find(name); slot != nullptr) {
    Change(*slot, value);
    return;
  }
  const std::string attribute = name.attribute(), text(value);
  Slot* slot = Insert(name, agent_->CreateStringWME(open_.back().object, attribute.c_str(), text.c_str()));
  if (slot == nullptr) return;
  slot->Hold(value);
  if (log_ != nullptr) Note(*slot);
}

void InputMirror::Change(Slot& slot, std::string_view value) {
  if (slot.Holds(value)) return;
  agent_->Update(static_cast<sml::StringElement*>(slot.element), std::string(value).c_str());
  ++changes_;
  slot.Hold(value);
  if (log_ != nullptr) Note(slot);
}

void InputMirror::TellOther(std::string_view attribute, std::uint32_t key, const vocabulary::ConstantValue& value) {
  if (const auto* integer = std::get_if<std::int64_t>(&value)) {
    TellInteger({nullptr, attribute, key, Kind::kInteger}, *integer);
  } else if (const auto* number = std::get_if<double>(&value)) {
    TellFloat({nullptr, attribute, key, Kind::kFloat}, *number);
  } else {
    // Text after a zero byte would be lost on the way to the kernel.
    TellText({nullptr, attribute, key, Kind::kText}, std::get<std::string>(value).c_str());
  }
}

void InputMirror::OpenNamed(const Name& name) {
  Slot* slot = refused_ > 0 ? nullptr : Find(name);
  if (slot == nullptr && refused_ == 0) {
    const std::string attribute = name.attribute();
    slot = Insert(name, agent_->CreateIdWME(open_.back().object, attribute.c_str()));
  }
  if (slot == nullptr) {
    ++refused_;
    return;
  }
  Enter(*slot);
}

void InputMirror::Enter(const Slot& slot) {
  OpenObject& above = open_.back();
  above.next = static_cast<std::size_t>(next_ - above.slots->data());
  GoOn(*slot.below, 0);
  open_.push_back({.slots = slot.below, .object = static_cast<sml::Identifier*>(slot.element), .key = slot.key});
}

void InputMirror::Close() {
  if (refused_ > 0) {
    --refused_;
    return;
  }
  if (next_ != end_ || open_.back().dropped > 0) DropRest();
  if (named_ == open_.size()) {
    path_.resize(open_.back().path_length);
    --named_;
  }
  open_.pop_back();
  GoOn(*open_.back().slots, open_.back().next);
}

void InputMirror::ShowList(const vocabulary::PerceptList& list) {
  for (const vocabulary::Percept& percept : list) {
    if (const auto* integer = std::get_if<std::int64_t>(&percept.value)) {
      TellOther(percept.attribute, percept.key, *integer);
    } else if (const auto* number = std::get_if<double>(&percept.value)) {
      TellOther(percept.attribute, percept.key, *number);
    } else if (const std::string* text = percept.Text()) {
      TellOther(percept.attribute, percept.key, *text);
    } else {
      OpenNamed({nullptr, percept.attribute, percept.key, Kind::kObject});
      ShowList(std::get<vocabulary::PerceptList>(percept.value));
      Close();
    }
  }
}

void InputMirror::Show(const vocabulary::PerceptList& wanted) {
  Begin();
  ShowList(wanted);
  End();
}

}  // namespace soarbox::sim
