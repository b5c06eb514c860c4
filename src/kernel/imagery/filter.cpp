// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/imagery/filter.h"

#include <utility>

#include "kernel/imagery/filter_kinds.h"
#include "kernel/imagery/filter_pool.h"
#include "kernel/imagery/scene_command.h"

namespace soarbox::kernel::imagery {

Filter::Filter(FilterParts parts)
    : scene_(parts.scene),
      pool_(parts.pool),
      random_(parts.random),
      kind_(parts.kind),
      inputs_(std::move(parts.parameters), parts.each_alone),
      serial_(parts.pool.Enter(*this)) {}

Filter::~Filter() {
  pool_.Leave(*this);
  if (watches_) scene_.Unwatch(*this);
  for (const Value& value : output_) {
    if (Node* const* const node = std::get_if<Node*>(&value.content)) scene_.Release(**node, *this, value.slot);
  }
}

bool Filter::Update() {
  if (look_ == pool_.look()) return works_;
  look_ = pool_.look();
  pool_.NoteUpdate(*this);
  works_ = false;
  if (const std::string_view error = inputs_.Update(); !error.empty()) {
    Fail(error);
    ClearOutput();
    return false;
  }
  if (!Compute()) {
    for (Combination& combination : inputs_.combinations()) combination.output = nullptr;
    inputs_.combinations().Restart();
    ClearOutput();
    return false;
  }
  Fail("success");
  inputs_.combinations().ClearChanges();
  works_ = true;
  return true;
}

void Filter::ClearChanges() {
  for (Value& value : output_.fresh()) value.rewritten = false;
  for (Value* const value : output_.changed()) {
    if (value != nullptr) value->rewritten = false;
  }
  cleared_ = will_be_cleared();
  output_.ClearChanges();
  inputs_.ClearRewritten();
  said_.clear();
}

void Filter::Fail(std::string_view status) {
  if (status_ == status) return;
  status_ = status;
  said_.push_back(status_);
}

Trouble Filter::Missing() const {
  return {};
}

Trouble Filter::FindTrouble() const {
  for (const Inputs::Parameter& parameter : inputs_.parameters()) {
    if (Trouble deeper = parameter.source->FindTrouble(); !deeper.problem.empty()) return deeper;
  }
  if (kind_ == nullptr || status() == "success") return Missing();
  const std::string name(kind_->name);
  return {"filter " + name + ": " + (status().empty() ? "it fails" : status()),
          "svs filters." + name + " lists its parameters"};
}

std::size_t Filter::MemoryBytes() const {
  return sizeof(Filter) + output_.MemoryBytes() + inputs_.MemoryBytes();
}

// The scene -----------------------------------------------------------------------------------------------------------

void Filter::WatchScene() {
  if (watches_) return;
  watches_ = true;
  scene_.Watch(*this);
}

void Filter::OnNode(Node&, NodeChange, std::string_view) {}

void Filter::OnHeld(std::uint32_t slot, NodeChange change) {
  Value& value = output_.At(slot);
  if (change != NodeChange::kRemoved) {
    output_.Change(value);
    return;
  }
  if (value.from != nullptr) value.from->output = nullptr;
  value.content = static_cast<Node*>(nullptr);
  output_.Remove(value);
}

// Arguments -----------------------------------------------------------------------------------------------------------

Filter::Slots Filter::SlotsOf(std::string_view name) const {
  Slots slots;
  for (std::size_t n = 0; n < inputs_.parameters().size(); ++n) {
    if (inputs_.parameters()[n].name == name) slots.push_back(n);
  }
  return slots;
}

const Value* Filter::Argument(const Combination& combination, const Slots& slots) const {
  for (const std::size_t slot : slots) {
    if (const Value* const value = inputs_.ArgumentOf(combination, slot)) return value;
  }
  return nullptr;
}

void Filter::TellWrongType(std::string_view name) {
  Fail("parameter \"" + std::string(name) + "\" has wrong type");
}

Node* Filter::NodeOf(const Combination& combination, const Slots& slots, std::string_view name) {
  const Value* const value = Argument(combination, slots);
  if (value == nullptr) return nullptr;
  if (Node* const* const node = std::get_if<Node*>(&value->content)) return *node;
  TellWrongType(name);
  return nullptr;
}

const std::string* Filter::TextOf(const Combination& combination, const Slots& slots, std::string_view name,
                                  bool tell) {
  const Value* const value = Argument(combination, slots);
  if (value == nullptr) return nullptr;
  const std::string* const text = std::get_if<std::string>(&value->content);
  if (text == nullptr && tell) TellWrongType(name);
  return text;
}

std::optional<double> Filter::NumberOf(const Combination& combination, const Slots& slots, std::string_view name) {
  const Value* const value = Argument(combination, slots);
  if (value == nullptr) return std::nullopt;
  if (const double* const number = std::get_if<double>(&value->content)) return *number;
  if (const std::int64_t* const number = std::get_if<std::int64_t>(&value->content)) {
    return static_cast<double>(*number);
  }
  TellWrongType(name);
  return std::nullopt;
}

// Values --------------------------------------------------------------------------------------------------------------

Value& Filter::Give(Combination* combination, Content content) {
  if (combination != nullptr && combination->output != nullptr) {
    Value& known = *combination->output;
    const bool other_node = std::holds_alternative<Node*>(content) && known.content != content;
    if (!other_node) {
      Change(known, std::move(content));
      return known;
    }
    Drop(*combination);
  }
  Value& value = output_.Add();
  value.content = std::move(content);
  value.from = combination;
  if (combination != nullptr) combination->output = &value;
  if (Node* const* const node = std::get_if<Node*>(&value.content)) scene_.Hold(**node, *this, value.slot);
  return value;
}

void Filter::Change(Value& value, Content content) {
  if (value.content == content) return;
  value.content = std::move(content);
  value.rewritten = true;
  output_.Change(value);
}

void Filter::Drop(Combination& combination) {
  if (combination.output != nullptr) Drop(*std::exchange(combination.output, nullptr));
}

void Filter::Drop(Value& value) {
  if (Node* const* const node = std::get_if<Node*>(&value.content)) scene_.Release(**node, *this, value.slot);
  output_.Remove(value);
}

/// The combinations of the values may have been removed already.
void Filter::ClearOutput() {
  for (const Value& value : output_) {
    if (Node* const* const node = std::get_if<Node*>(&value.content)) scene_.Release(**node, *this, value.slot);
  }
  output_.Clear();
  ++cleared_;
}

}  // namespace soarbox::kernel::imagery
