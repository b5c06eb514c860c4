// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/imagery/memory_writer.h"

#include <cmath>
#include <limits>

namespace soarbox::kernel::imagery {

bool MemoryWriter::IsReached(Symbol id) const {
  const IdentifierRecord& record = memory_.identifier(id);
  return record.live && !record.gone && record.level > 0 && (record.is_goal || record.rooted);
}

std::string MemoryWriter::NameOf(Symbol id) const {
  return symbols_.Letter(id) + std::to_string(symbols_.Number(id));
}

double MemoryWriter::NumberOf(Symbol number) const {
  return number.IsFloat() ? symbols_.FloatValue(number) : static_cast<double>(symbols_.IntegerValue(number));
}

std::int64_t MemoryWriter::IntegerOf(Symbol number) const {
  return symbols_.IntegerValue(number);
}

Symbol MemoryWriter::Float(double value) {
  if (std::isnan(value)) value = 0;
  if (std::isinf(value)) value = std::copysign(std::numeric_limits<double>::max(), value);
  return symbols_.Float(value);
}

// Reading -------------------------------------------------------------------------------------------------------------

SlotId MemoryWriter::FindSlot(Symbol id, std::string_view attribute) const {
  const Symbol name = symbols_.FindString(attribute);
  return name && id.IsIdentifier() && memory_.identifier(id).live ? memory_.FindSlot(id, name) : SlotId::kNone;
}

Symbol MemoryWriter::ValueOf(Symbol id, std::string_view attribute) const {
  const SlotId slot = FindSlot(id, attribute);
  if (slot == SlotId::kNone) return {};
  const WmeId wme = memory_.slot(slot).wmes;
  return wme == WmeId::kNone ? Symbol() : memory_.wme(wme).value;
}

WmeId MemoryWriter::ElementOf(Symbol id, Symbol attribute, Symbol value) const {
  const SlotId slot = memory_.FindSlot(id, attribute);
  WmeId wme = slot == SlotId::kNone ? WmeId::kNone : memory_.slot(slot).wmes;
  while (wme != WmeId::kNone && memory_.wme(wme).value != value) wme = memory_.record(wme).next;
  return wme;
}

std::optional<std::string> MemoryWriter::TextOf(Symbol id, std::string_view attribute) const {
  const Symbol value = ValueOf(id, attribute);
  if (!value.IsString()) return std::nullopt;
  return std::string(symbols_.Text(value));
}

std::optional<Vec3> MemoryWriter::VectorOf(Symbol id, std::string_view attribute) const {
  const Symbol object = ValueOf(id, attribute);
  if (!object.IsIdentifier()) return std::nullopt;
  Vec3 vector;
  constexpr std::string_view kAxes[] = {"x", "y", "z"};
  for (int axis = 0; axis < 3; ++axis) {
    const Symbol number = ValueOf(object, kAxes[axis]);
    if (!number.IsNumber()) return std::nullopt;
    vector[axis] = NumberOf(number);
    if (!(std::abs(vector[axis]) <= 1e60)) return std::nullopt;  // The same limit as in scene lines.
  }
  return vector;
}

// Writing -------------------------------------------------------------------------------------------------------------

void MemoryWriter::Add(Symbol id, std::string_view attribute, Symbol value) {
  if (!IsReached(id)) return;
  const Symbol name = symbols_.String(attribute);
  const SlotId slot = memory_.FindOrMakeSlot(id, name, false);
  for (WmeId wme = memory_.slot(slot).wmes; wme != WmeId::kNone; wme = memory_.record(wme).next) {
    if (memory_.wme(wme).value == value) return;
  }
  changes_.Add(WmeKind::kSlot, id, name, value, slot);
}

Symbol MemoryWriter::AddObject(Symbol id, std::string_view attribute) {
  return AddObject(id, attribute, LetterOfIdentifier(attribute));
}

Symbol MemoryWriter::AddObject(Symbol id, std::string_view attribute, char letter) {
  if (!IsReached(id)) return {};
  const Symbol object = memory_.NewIdentifier(letter, memory_.level(id));
  Add(id, attribute, object);
  return object;
}

void MemoryWriter::Lose(SlotId slot, WmeId wme) {
  changes_.Lose(wme);
  if (memory_.SlotIsEmpty(slot)) preferences_.empty_slots().push_back(slot);
}

void MemoryWriter::Remove(Symbol id, std::string_view attribute, Symbol value) {
  const SlotId slot = FindSlot(id, attribute);
  if (slot == SlotId::kNone) return;
  for (WmeId wme = memory_.slot(slot).wmes; wme != WmeId::kNone; wme = memory_.record(wme).next) {
    if (memory_.wme(wme).value != value) continue;
    if (memory_.record(wme).preference == PreferenceId::kNone) Lose(slot, wme);
    return;
  }
}

void MemoryWriter::Replace(Symbol id, Symbol attribute, Symbol value) {
  if (!memory_.identifier(id).live) return;
  const bool reached = IsReached(id);
  const SlotId slot = reached ? memory_.FindOrMakeSlot(id, attribute, false) : memory_.FindSlot(id, attribute);
  if (slot == SlotId::kNone) return;
  bool there = false;
  WmeId next;
  for (WmeId wme = memory_.slot(slot).wmes; wme != WmeId::kNone; wme = next) {
    next = memory_.record(wme).next;
    if (memory_.record(wme).preference == PreferenceId::kNone) {
      changes_.Lose(wme);
    } else {
      there |= memory_.wme(wme).value == value;
    }
  }
  if (reached && !there) changes_.Add(WmeKind::kSlot, id, attribute, value, slot);
  if (memory_.SlotIsEmpty(slot)) preferences_.empty_slots().push_back(slot);
}

void MemoryWriter::RemoveAll(Symbol id, std::string_view attribute) {
  const SlotId slot = FindSlot(id, attribute);
  if (slot == SlotId::kNone) return;
  WmeId next;
  for (WmeId wme = memory_.slot(slot).wmes; wme != WmeId::kNone; wme = next) {
    next = memory_.record(wme).next;
    if (memory_.record(wme).preference == PreferenceId::kNone) Lose(slot, wme);
  }
}

}  // namespace soarbox::kernel::imagery
