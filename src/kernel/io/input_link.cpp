// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/io/input_link.h"

#include "kernel/io/input_tap.h"

namespace soarbox::kernel {

// Handles -------------------------------------------------------------------------------------------------------------

InputLink::Element* InputLink::Find(InputElement element) {
  return const_cast<Element*>(static_cast<const InputLink*>(this)->Find(element));
}

const InputLink::Element* InputLink::Find(InputElement element) const {
  const std::uint32_t handle = static_cast<std::uint32_t>(element);
  const std::uint32_t place = handle & kPlaceMask;
  if (place >= elements_.size()) return nullptr;
  const Element& found = elements_[place];
  return found.live && found.generation == handle >> kPlaceBits ? &found : nullptr;
}

InputLink::Object* InputLink::Find(InputObject object) {
  return const_cast<Object*>(static_cast<const InputLink*>(this)->Find(object));
}

const InputLink::Object* InputLink::Find(InputObject object) const {
  const std::uint32_t handle = static_cast<std::uint32_t>(object);
  const std::uint32_t place = handle & kPlaceMask;
  if (object == InputObject::kNone || place >= objects_.size()) return nullptr;
  const Object& found = objects_[place];
  return found.live && found.generation == handle >> kPlaceBits ? &found : nullptr;
}

InputObject InputLink::MakeObject(Symbol identifier) {
  std::uint32_t place;
  if (!free_objects_.empty()) {
    place = free_objects_.back();
    free_objects_.pop_back();
  } else {
    place = static_cast<std::uint32_t>(objects_.size());
    objects_.emplace_back();
  }
  Object& object = objects_[place];
  object.live = true;
  object.identifier = identifier;
  if (identifier) {
    if (object_of_.size() <= identifier.index()) object_of_.resize(identifier.index() + 1u, kNoPlace);
    object_of_[identifier.index()] = place;
  }
  return static_cast<InputObject>(place | object.generation << kPlaceBits);
}

InputObject InputLink::NewObject() {
  return MakeObject({});
}

InputObject InputLink::ObjectFor(Symbol identifier) {
  if (!identifier.IsIdentifier() || !memory_.identifier(identifier).live) return InputObject::kNone;
  if (identifier.index() < object_of_.size() && object_of_[identifier.index()] != kNoPlace) {
    const std::uint32_t place = object_of_[identifier.index()];
    return static_cast<InputObject>(place | objects_[place].generation << kPlaceBits);
  }
  return MakeObject(identifier);
}

WmeId InputLink::Wme(InputElement element) const {
  const Element* found = Find(element);
  return found == nullptr ? WmeId::kNone : found->wme;
}

Symbol InputLink::Identifier(InputObject object) const {
  const Object* found = Find(object);
  return found == nullptr ? Symbol() : found->identifier;
}

// Buffering -----------------------------------------------------------------------------------------------------------

InputElement InputLink::Add(InputObject parent, std::string_view attribute, const InputValue& value, std::int64_t tag) {
  if (Find(parent) == nullptr) return InputElement::kNone;
  if (const InputObject* object = std::get_if<InputObject>(&value); object != nullptr && Find(*object) == nullptr) {
    return InputElement::kNone;
  }
  std::uint32_t place;
  if (!free_elements_.empty()) {
    place = free_elements_.back();
    free_elements_.pop_back();
  } else {
    place = static_cast<std::uint32_t>(elements_.size());
    elements_.emplace_back().generation = first_generation_ & kGenerationMask;
  }
  Element& element = elements_[place];
  element.live = true;
  element.tag = tag;
  element.wme = WmeId::kNone;
  element.parent = parent;
  element.attribute = symbols_.String(attribute);
  const InputObject* object = std::get_if<InputObject>(&value);
  Buffer(Change::kAdd, place, object == nullptr ? Constant(value) : Symbol(),
         object == nullptr ? InputObject::kNone : *object);
  return HandleOf(place);
}

Symbol InputLink::Constant(const InputValue& value) {
  if (const auto* number = std::get_if<double>(&value)) return symbols_.Float(*number);
  if (const auto* integer = std::get_if<std::int64_t>(&value)) return symbols_.Integer(*integer);
  return symbols_.String(std::get<std::string_view>(value));
}

void InputLink::Buffer(Change kind, std::uint32_t place, Symbol constant, InputObject object) {
  ++elements_[place].buffered;
  pending_.push_back({kind, place, constant, object});
}

void InputLink::Update(InputElement handle, const InputValue& value, std::int64_t tag) {
  const InputObject* object = std::get_if<InputObject>(&value);
  if ((object != nullptr && Find(*object) == nullptr) || !Retag(handle, tag)) return;
  if (object == nullptr) return BufferUpdate(handle, Constant(value));
  const std::uint32_t place = static_cast<std::uint32_t>(handle) & kPlaceMask;
  Buffer(Change::kRemove, place);
  Buffer(Change::kAdd, place, {}, *object);
}

bool InputLink::Retag(InputElement handle, std::int64_t tag) {
  Element* element = Find(handle);
  if (element != nullptr) element->tag = tag;
  return element != nullptr;
}

void InputLink::Remove(InputElement handle) {
  Element* element = Find(handle);
  if (element == nullptr) return;
  Void(*element);
  Buffer(Change::kRemove, static_cast<std::uint32_t>(handle) & kPlaceMask);
}

void InputLink::Void(Element& element) {
  if (!element.live) return;
  element.live = false;
  element.generation = (element.generation + 1u) & kGenerationMask;
}

/// Frees the index of a removed element after its last change was applied.
void InputLink::ReleaseIfDone(std::uint32_t place) {
  Element& element = elements_[place];
  if (element.buffered > 0 || element.wme != WmeId::kNone) return;
  Void(element);
  free_elements_.push_back(place);
}

// The input phase -----------------------------------------------------------------------------------------------------

void InputLink::Apply(bool unheard) {
  if (tap_ != nullptr) [[unlikely]]
    tap_->OnInputPhase(*this);
  for (std::size_t n = 0; n < pending_.size(); ++n) {
    const Pending change = pending_[n];
    Element& element = elements_[change.element];
    if (tap_ != nullptr) [[unlikely]] {
      ApplyTapped(change);
    } else if (unheard && change.change == Change::kUpdate && element.wme != WmeId::kNone &&
               changes_.Renew(element.wme, change.constant)) {
      --element.buffered;
    } else {
      ApplyChange(change);
    }
  }
  pending_.clear();
}

void InputLink::LoseElement(std::uint32_t place) {
  // (Working memory may have removed the element already, together with the structure above it.)
  if (const WmeId wme = elements_[place].wme; wme != WmeId::kNone) changes_.Lose(wme);
}

void InputLink::ApplyChange(const Pending& change) {
  if (change.change != Change::kAdd) LoseElement(change.element);
  if (change.change != Change::kRemove) MakeElement(change);
  --elements_[change.element].buffered;
  ReleaseIfDone(change.element);
}

void InputLink::ApplyTapped(const Pending& change) {
  if (change.change == Change::kUpdate) {
    // A removal and an addition.
    ++elements_[change.element].buffered;
    ApplyTapped({Change::kRemove, change.element, {}, InputObject::kNone});
    ApplyTapped({Change::kAdd, change.element, change.constant, InputObject::kNone});
    return;
  }
  const auto describe = [this](WmeId wme, InputChange& told) {
    const kernel::Wme& content = memory_.wme(wme);
    told.timetag = content.timetag;
    told.id = content.id;
    told.attribute = content.attribute;
    told.value = content.value;
  };
  InputChange told;
  told.added = change.change == Change::kAdd;
  const WmeId before = elements_[change.element].wme;
  if (told.added) {
    const Object* object = Find(change.object);
    told.new_identifier = object != nullptr && !object->identifier;
  } else if (before != WmeId::kNone) {
    describe(before, told);
  }
  ApplyChange(change);
  if (const WmeId made = elements_[change.element].wme; told.added && made != before) describe(made, told);
  if (told.timetag != 0) tap_->OnInputChange(told);
}

void InputLink::DropPending() {
  for (const Pending& change : pending_) {
    --elements_[change.element].buffered;
    ReleaseIfDone(change.element);
  }
  pending_.clear();
}

void InputLink::MakeElement(const Pending& change) {
  Element& element = elements_[change.element];
  const Object* parent = Find(element.parent);
  Object* object = change.object == InputObject::kNone ? nullptr : Find(change.object);
  if (parent == nullptr || !parent->identifier || (object == nullptr && !change.constant)) return;
  Symbol value = change.constant;
  if (object != nullptr) {
    if (!object->identifier) {
      const char letter = LetterOfIdentifier(symbols_.Text(element.attribute));
      object->identifier = memory_.NewIdentifier(letter, memory_.level(parent->identifier));
      const std::uint32_t index = object->identifier.index();
      if (object_of_.size() <= index) object_of_.resize(index + 1u, kNoPlace);
      object_of_[index] = static_cast<std::uint32_t>(change.object) & kPlaceMask;
    }
    value = object->identifier;
  }
  const WmeId wme = changes_.Add(WmeKind::kInput, parent->identifier, element.attribute, value);
  memory_.mutable_record(wme).SetInputElement(change.element);
  element.wme = wme;
}

void InputLink::Forget(std::uint32_t place) {
  elements_[place].wme = WmeId::kNone;
  if (elements_[place].buffered == 0) ReleaseIfDone(place);
}

void InputLink::IdentifierGone(Symbol identifier) {
  if (identifier.index() >= object_of_.size() || object_of_[identifier.index()] == kNoPlace) return;
  const std::uint32_t place = object_of_[identifier.index()];
  object_of_[identifier.index()] = kNoPlace;
  if (place == 0) return;  // The input link itself.
  Object& object = objects_[place];
  object.live = false;
  object.identifier = Symbol();
  object.generation = (object.generation + 1) & kGenerationMask;
  free_objects_.push_back(place);
}

void InputLink::Reset(Symbol input_link) {
  if (tap_ != nullptr) tap_->OnInputReset();
  objects_.clear();
  free_objects_.clear();
  elements_.clear();
  free_elements_.clear();
  first_generation_ = (first_generation_ + 1) & kGenerationMask;
  pending_.clear();
  object_of_.clear();
  MakeObject(input_link);
}

}  // namespace soarbox::kernel
