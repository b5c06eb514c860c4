// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/imagery/filter.h"

#include <algorithm>
#include <utility>

#include "kernel/base/known_symbols.h"
#include "kernel/imagery/filter_kinds.h"
#include "kernel/imagery/scene_command.h"

namespace soarbox::kernel::imagery {

// Status --------------------------------------------------------------------------------------------------------------

StatusLine::StatusLine(MemoryWriter& writer, Symbol owner)
    : writer_(writer), owner_(owner), shown_(owner ? writer.ValueOf(owner, "status") : Symbol()) {}

void StatusLine::Set(std::string_view text) {
  if (text_ == text) return;
  text_ = text;
  if (!owner_) return;
  if (shown_) writer_.Remove(owner_, "status", shown_);
  shown_ = writer_.Text(text);
  writer_.Add(owner_, "status", shown_);
}

// Inputs --------------------------------------------------------------------------------------------------------------

std::string_view Inputs::Update() {
  std::size_t product = 1;
  for (const Parameter& parameter : parameters_) {
    if (!parameter.source->Update()) {
      Forget();
      return "Errors in input";
    }
    const std::size_t values = parameter.source->output().entries().size();
    product = product > kMostCombinations || values > kMostCombinations ? kMostCombinations + 1 : product * values;
  }
  if (!each_alone_ && product > kMostCombinations) {
    Forget();
    return "too many combinations of values (2000000 at most)";
  }
  for (const Parameter& parameter : parameters_) {
    for (const auto& gone : parameter.source->output().removed()) DropUsersOf(*gone);
  }
  for (const Parameter& parameter : parameters_) {
    for (Value* const changed : parameter.source->output().changed()) NoteChanges(*changed);
  }
  if (each_alone_) {
    for (std::size_t n = 0; n < parameters_.size(); ++n) {
      const TrackedList<Value>& values = parameters_[n].source->output();
      for (auto at = values.FirstFresh(); at != values.entries().end(); ++at) {
        std::vector<Value*> arguments(parameters_.size(), nullptr);
        arguments[n] = at->get();
        Add(std::move(arguments));
      }
    }
  } else {
    CombineEachWithEach();
  }
  for (const Parameter& parameter : parameters_) parameter.source->output().ClearChanges();
  return {};
}

void Inputs::Forget() {
  combinations_.Clear();
  for (const Parameter& parameter : parameters_) {
    for (const auto& value : parameter.source->output().entries()) value->users.clear();
    parameter.source->output().Restart();
  }
}

void Inputs::DropUsersOf(Value& gone) {
  for (Combination* const user : std::exchange(gone.users, {})) {
    for (Value* const argument : user->arguments) {
      if (argument != nullptr && argument != &gone) std::erase(argument->users, user);
    }
    combinations_.Remove(*user);
  }
}

void Inputs::NoteChanges(Value& changed) {
  for (Combination* const user : changed.users) {
    if (user->fresh || user->changed) continue;
    combinations_.Change(*user);
    if (on_change) on_change(*user);
  }
}

void Inputs::Add(std::vector<Value*> arguments) {
  auto combination = std::make_unique<Combination>();
  combination->arguments = std::move(arguments);
  Combination& added = combinations_.Add(std::move(combination));
  for (Value* const argument : added.arguments) {
    if (argument != nullptr) argument->users.push_back(&added);
  }
}

/// For each parameter in turn: the old values of those before it, its new ones, and all of those behind it. So each new
/// combination comes once.
void Inputs::CombineEachWithEach() {
  using At = TrackedList<Value>::List::const_iterator;
  const std::size_t count = parameters_.size();
  std::vector<At> begin(count), end(count), at(count);
  for (std::size_t turn = 0; turn < count; ++turn) {
    bool empty = false;
    for (std::size_t n = 0; n < count && !empty; ++n) {
      const TrackedList<Value>& values = parameters_[n].source->output();
      begin[n] = n == turn ? values.FirstFresh() : values.entries().begin();
      end[n] = n < turn ? values.FirstFresh() : values.entries().end();
      empty = begin[n] == end[n];
    }
    if (empty) continue;
    at = begin;
    for (bool done = false; !done;) {
      std::vector<Value*> arguments;
      arguments.reserve(count);
      for (const At& value : at) arguments.push_back(value->get());
      Add(std::move(arguments));
      std::size_t n = 0;
      while (n < count && ++at[n] == end[n]) {
        at[n] = begin[n];
        ++n;
      }
      done = n == count;
    }
  }
}

// Filters -------------------------------------------------------------------------------------------------------------

Filter::Filter(FilterParts parts)
    : scene_(parts.scene),
      random_(parts.random),
      kind_(parts.kind),
      status_(parts.writer, parts.owner),
      inputs_(std::move(parts.parameters), parts.each_alone) {}

Filter::~Filter() {
  if (watches_) scene_.Unwatch(*this);
}

bool Filter::Update() {
  if (const std::string_view error = inputs_.Update(); !error.empty()) {
    status_.Set(error);
    ClearOutput();
    return false;
  }
  if (!Compute()) {
    for (const auto& combination : inputs_.combinations().entries()) combination->output = nullptr;
    inputs_.combinations().Restart();
    ClearOutput();
    return false;
  }
  status_.Set("success");
  inputs_.combinations().ClearChanges();
  return true;
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

void Filter::Mark(const std::function<void(Symbol)>& mark) const {
  if (status_.owner()) mark(status_.owner());
  if (status_.symbol()) mark(status_.symbol());
  for (const Inputs::Parameter& parameter : inputs_.parameters()) parameter.source->Mark(mark);
}

void Filter::WatchScene() {
  if (watches_) return;
  watches_ = true;
  scene_.Watch(*this);
}

void Filter::OnNode(Node& node, NodeChange change, std::string_view) {
  const auto found = nodes_.find(&node);
  if (found == nodes_.end()) return;
  if (change != NodeChange::kRemoved) {
    for (Value* const value : found->second) output_.Change(*value);
    return;
  }
  for (Value* const value : std::exchange(found->second, {})) {
    if (value->from != nullptr) value->from->output = nullptr;
    output_.Remove(*value);
  }
  nodes_.erase(&node);
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
    if (combination.arguments[slot] != nullptr) return combination.arguments[slot];
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
  auto made = std::make_unique<Value>();
  made->content = std::move(content);
  made->from = combination;
  Value& value = output_.Add(std::move(made));
  if (combination != nullptr) combination->output = &value;
  if (Node* const* const node = std::get_if<Node*>(&value.content)) {
    WatchScene();
    nodes_[*node].push_back(&value);
  }
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
  if (Node* const* const node = std::get_if<Node*>(&value.content)) {
    const auto found = nodes_.find(*node);
    if (found != nodes_.end()) {
      std::erase(found->second, &value);
      if (found->second.empty()) nodes_.erase(found);
    }
  }
  output_.Remove(value);
}

/// The combinations that the values came from may have gone already.
void Filter::ClearOutput() {
  nodes_.clear();
  output_.Clear();
}

}  // namespace soarbox::kernel::imagery
