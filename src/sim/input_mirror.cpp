// SPDX-License-Identifier: BSD-2-Clause
#include "sim/input_mirror.h"

#include <algorithm>

namespace soarbox::sim {

// Slots of an object -------------------------------------------------------------------------------------------------

std::string* InputMirror::Texts::Take(std::string_view text) {
  if (spare_.empty()) return &texts_.emplace_front(text);
  std::string* const taken = spare_.back();
  spare_.pop_back();
  taken->assign(text);
  return taken;
}

void InputMirror::Texts::GiveBack(const std::string* text) {
  auto* const own = const_cast<std::string*>(text);
  *own = std::string();
  spare_.push_back(own);
}

InputMirror::Slot InputMirror::NewSlot(const Name& name) {
  Slot slot;
  slot.has_row = name.row != nullptr;
  if (slot.has_row) {
    slot.row = name.row;
    slot.attribute_size = static_cast<std::uint8_t>(name.row->Attribute().size());
  } else {
    slot.other = texts_.Take(name.other);
  }
  slot.key = name.key;
  slot.kind = name.kind;
  return slot;
}

/// Long texts end at the first zero byte, because the rest would be lost on the way to the kernel.
void InputMirror::Hold(Slot& slot, std::string_view value) {
  if (slot.size == Slot::kLong) texts_.GiveBack(slot.long_text);
  slot.size = value.size() <= Slot::kShort ? static_cast<std::uint8_t>(value.size()) : Slot::kLong;
  if (slot.size != Slot::kLong) {
    value.copy(slot.text, slot.size);
  } else {
    slot.long_text = texts_.Take(value.substr(0, value.find('\0')));
  }
}

void InputMirror::Free(const Slot& slot) {
  if (!slot.has_row) texts_.GiveBack(slot.other);
  if (slot.kind == Kind::kText && slot.size == Slot::kLong) texts_.GiveBack(slot.long_text);
  if (slot.kind != Kind::kObject) return;
  for (const Slot& below : *slot.object.below) Free(below);
  slot.object.below->clear();
  spare_.push_back(slot.object.below);
}

/// The slot with this name in the previous update, which is nearly always the next one. Null if there is none.
InputMirror::Slot* InputMirror::Find(const Name& name) {
  for (Slot* slot = next_; slot != end_; ++slot) {
    if (slot->has_row != (name.row != nullptr) || slot->key != name.key || slot->kind != name.kind) continue;
    if (name.row != nullptr ? slot->row != name.row : *slot->other != name.other) continue;
    if (slot != next_) std::rotate(next_, slot, slot + 1);
    return next_++;
  }
  return nullptr;
}

/// Writes and stores a new element. Returns null if it could not be created (for example, the kernel is lost): the next
/// update tries again.
InputMirror::Slot* InputMirror::Insert(Slot slot) {
  ++changes_;
  if (slot.kind == Kind::kObject) {
    if (spare_.empty()) spare_.push_back(&slots_.emplace_front());
    slot.object.below = spare_.back();
    spare_.pop_back();
  }
  if (!link_->Add(open_.back().slot->object.handle, slot)) {
    Free(slot);
    return nullptr;
  }
  Slots& slots = open_.back().slots();
  const std::uint32_t place = Reported();
  if (slots.size() == slots.capacity()) slots.reserve(slots.size() + slots.size() / 4 + 2);  // There are many.
  slots.insert(slots.begin() + place, slot);
  GoOn(place + std::size_t{1});
  if (log_ != nullptr && slot.kind != Kind::kObject) Note(slot);
  return next_ - 1;
}

void InputMirror::Destroy(const Slot& slot) {
  if (log_ != nullptr) log_->Add(mind::PerceptGone{Path(), slot.Attribute(), slot.key});
  link_->Remove(slot);
  Free(slot);
  ++changes_;
}

/// Removes the elements that were not reported.
void InputMirror::DropRest() {
  Slots& slots = open_.back().slots();
  for (const Slot* slot = next_; slot != end_; ++slot) Destroy(*slot);
  slots.resize(Reported());
  slots.erase(slots.begin(), slots.begin() + open_.back().dropped);
}

std::uint32_t InputMirror::NextKey() const {
  return next_ != end_ ? next_->key : 0;
}

void InputMirror::Drop() {
  Destroy(*next_++);
  open_.back().dropped = Reported();
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
  input_link_.object = {top_.get(), link_->InputLink()};
  open_.push_back({.slot = &input_link_});
  GoOn(0);
}

void InputMirror::End() {
  DropRest();
  next_ = end_ = nullptr;
}

void InputMirror::Note(const Slot& slot) {
  log_->Add(mind::PerceptChanged{Path(), slot.Attribute(), slot.key, slot.Value()});
}

/// Computed only when something changes, because most objects are only compared.
std::string_view InputMirror::Path() {
  for (; named_ < open_.size(); ++named_) {
    if (named_ == 0) continue;  // The input link itself.
    OpenObject& object = open_[named_];
    object.path_length = path_.size();
    path_ += object.slot->Attribute();
    if (object.slot->key != 0) path_.append("#").append(std::to_string(object.slot->key));
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
  Slot slot = NewSlot(name);
  slot.integer = value;
  Insert(slot);
}

void InputMirror::TellFloat(const Name& name, double value) {
  if (refused_ > 0) return;
  if (Slot* slot = Find(name); slot != nullptr) {
    if (slot->number != value) Change(*slot, value);
    return;
  }
  Slot slot = NewSlot(name);
  slot.number = value;
  Insert(slot);
}

void InputMirror::TellText(const Name& name, std::string_view value) {
  if (refused_ > 0) return;
  if (Slot* slot = Find(name); slot != nullptr) return Change(*slot, value);
  Slot slot = NewSlot(name);
  Hold(slot, value);
  Insert(slot);
}

void InputMirror::Change(Slot& slot, std::int64_t value) {
  slot.integer = value;
  Send(slot);
}

void InputMirror::Change(Slot& slot, double value) {
  slot.number = value;
  Send(slot);
}

void InputMirror::Change(Slot& slot, std::string_view value) {
  if (slot.Text() == value) return;
  Hold(slot, value);
  Send(slot);
}

/// Sends the new value of a slot.
void InputMirror::Send(const Slot& slot) {
  link_->Change(slot);
  ++changes_;
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
  if (slot == nullptr && refused_ == 0) slot = Insert(NewSlot(name));
  if (slot != nullptr) return Enter(*slot);
  if (refused_++ > 0) return;
  open_.back().next = Reported();
  next_ = end_ = nullptr;  // No slot is the next one until it is closed.
}

void InputMirror::Enter(const Slot& slot) {
  open_.back().next = Reported();
  open_.push_back({.slot = &slot});
  GoOn(0);
}

void InputMirror::Close() {
  if (refused_ > 0) {
    if (--refused_ == 0) GoOn(open_.back().next);
    return;
  }
  if (next_ != end_ || open_.back().dropped > 0) DropRest();
  if (named_ == open_.size()) {
    path_.resize(open_.back().path_length);
    --named_;
  }
  open_.pop_back();
  GoOn(open_.back().next);
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
