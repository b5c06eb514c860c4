// SPDX-License-Identifier: BSD-2-Clause
// The combination of the values of a filter's parameters.
#include <algorithm>
#include <utility>

#include "kernel/imagery/filter.h"

namespace soarbox::kernel::imagery {

/// Constants in rules never change, so they need no column, unless each value is a combination of its own.
Inputs::Inputs(std::vector<Parameter> parameters, bool each_alone)
    : parameters_(std::move(parameters)), each_alone_(each_alone), column_of_(parameters_.size(), kNoColumn) {
  for (std::size_t n = 0; n < parameters_.size(); ++n) {
    if (parameters_[n].source->is_constant() && !each_alone_) continue;
    column_of_[n] = columns_.size();
    columns_.push_back({n, 0, {}});
  }
}

const Value* Inputs::ArgumentOf(const Combination& combination, std::size_t parameter) const {
  const std::size_t column = column_of_[parameter];
  if (column != kNoColumn) return links_[combination.slot * columns_.size() + column].value;
  const TrackedList<Value>& values = parameters_[parameter].source->output();
  return values.size() == 0 ? nullptr : &*values.begin();
}

std::size_t Inputs::MemoryBytes() const {
  std::size_t bytes = combinations_.MemoryBytes() + links_.capacity() * sizeof(Link);
  for (const Column& column : columns_) bytes += column.chains.capacity() * sizeof(std::uint32_t);
  return bytes;
}

std::string_view Inputs::Update() {
  std::size_t product = 1;
  for (const Parameter& parameter : parameters_) {
    if (!parameter.source->Update()) {
      Forget();
      return "Errors in input";
    }
    const std::size_t values = parameter.source->output().size();
    product = product > kMostCombinations || values > kMostCombinations ? kMostCombinations + 1 : product * values;
  }
  if (!each_alone_ && product > kMostCombinations) {
    Forget();
    return "too many combinations of values (2000000 at most)";
  }
  const bool anew = MissedChanges();
  if (anew) {
    while (combinations_.size() > 0) combinations_.Remove(*combinations_.begin());
    for (Column& column : columns_) column.chains.assign(column.chains.size(), 0);
  } else {
    for (std::size_t n = 0; n < columns_.size(); ++n) {
      for (const Value& gone : SourceOf(columns_[n]).output().removed()) DropUsersOf(n, gone);
    }
    for (std::size_t n = 0; n < columns_.size(); ++n) {
      for (const Value* const changed : SourceOf(columns_[n]).output().changed()) {
        if (changed != nullptr) NoteChanges(n, *changed);
      }
    }
  }
  for (Column& column : columns_) {
    column.chains.resize(SourceOf(column).output().slots(), 0);
    column.expected = SourceOf(column).will_be_cleared();
  }
  if (each_alone_) {
    CombineEachAlone(anew);
  } else {
    CombineEachWithEach(anew);
  }
  return {};
}

/// Also returns true before the first update.
bool Inputs::MissedChanges() const {
  return std::any_of(columns_.begin(), columns_.end(),
                     [this](const Column& column) { return column.expected != SourceOf(column).cleared(); });
}

void Inputs::ClearRewritten() {
  for (const Rewritten& rewritten : rewritten_) rewritten.combination->told = false;
  rewritten_.clear();
}

void Inputs::Forget() {
  combinations_.Clear();
  for (Column& column : columns_) {
    column.expected = 0;
    column.chains.assign(column.chains.size(), 0);
  }
}

void Inputs::DropUsersOf(std::size_t column, const Value& gone) {
  if (gone.slot >= columns_[column].chains.size()) return;  // It was added and removed between two updates.
  for (std::uint32_t user = std::exchange(columns_[column].chains[gone.slot], 0); user != 0;) {
    const std::uint32_t slot = user - 1;
    user = LinkOf(slot, column).next;
    for (std::size_t other = 0; other < columns_.size(); ++other) {
      if (other != column) Unchain(slot, other);
    }
    combinations_.Remove(combinations_.At(slot));
  }
}

/// The first entry of a chain refers to the last by `previous`.
void Inputs::Chain(std::uint32_t combination, std::size_t column, Value* value) {
  Link& link = LinkOf(combination, column);
  link = {value, combination + 1, 0};
  if (value == nullptr) return;
  std::uint32_t& first = columns_[column].chains[value->slot];
  if (first == 0) {
    first = combination + 1;
    return;
  }
  std::uint32_t& last = LinkOf(first - 1, column).previous;
  link.previous = last;
  LinkOf(last - 1, column).next = combination + 1;
  last = combination + 1;
}

void Inputs::Unchain(std::uint32_t combination, std::size_t column) {
  const Link& link = LinkOf(combination, column);
  if (link.value == nullptr) return;
  std::uint32_t& first = columns_[column].chains[link.value->slot];
  if (first == combination + 1) {
    first = link.next;
    if (first != 0) LinkOf(first - 1, column).previous = link.previous;
    return;
  }
  LinkOf(link.previous - 1, column).next = link.next;
  LinkOf((link.next == 0 ? first : link.next) - 1, column).previous = link.previous;
}

void Inputs::NoteChanges(std::size_t column, const Value& changed) {
  if (changed.slot >= columns_[column].chains.size()) return;
  for (std::uint32_t user = columns_[column].chains[changed.slot]; user != 0; user = LinkOf(user - 1, column).next) {
    Combination& combination = combinations_.At(user - 1);
    if (combination.fresh) continue;
    combinations_.Change(combination);
    if (!changed.rewritten || combination.told) continue;
    combination.told = true;
    rewritten_.push_back({&combination, combination.output});
  }
}

void Inputs::Add(const std::vector<Value*>& values) {
  const Combination& added = combinations_.Add();
  const std::size_t end = (added.slot + std::size_t{1}) * columns_.size();
  if (links_.size() < end) links_.resize(end);
  for (std::size_t n = 0; n < columns_.size(); ++n) Chain(added.slot, n, values[n]);
}

void Inputs::CombineEachAlone(bool anew) {
  std::vector<Value*> values(columns_.size(), nullptr);
  for (std::size_t n = 0; n < columns_.size(); ++n) {
    const TrackedList<Value>& source = SourceOf(columns_[n]).output();
    const TrackedList<Value>::Iterator begin = anew ? source.begin() : source.fresh().begin();
    for (auto at = begin; at != source.end(); ++at) {
      values[n] = &*at;
      Add(values);
    }
    values[n] = nullptr;
  }
}

/// For each parameter in turn: combines the old values of the parameters before it, its new values, and all values of
/// those after it. So each new combination is added exactly once.
void Inputs::CombineEachWithEach(bool anew) {
  using At = TrackedList<Value>::Iterator;
  const std::size_t count = columns_.size();
  std::vector<At> begin(count), end(count), at(count);
  std::vector<Value*> values(count);
  if (count == 0) {
    // Constants alone are one combination. Without parameters there is none.
    if (!parameters_.empty() && combinations_.size() == 0) Add(values);
    return;
  }
  for (std::size_t turn = 0; turn < count; ++turn) {
    bool empty = false;
    for (std::size_t n = 0; n < count && !empty; ++n) {
      const TrackedList<Value>& source = SourceOf(columns_[n]).output();
      const At first_fresh = anew ? source.begin() : source.fresh().begin();
      begin[n] = n == turn ? first_fresh : source.begin();
      end[n] = n < turn ? first_fresh : source.end();
      empty = begin[n] == end[n];
    }
    if (empty) continue;
    at = begin;
    for (bool done = false; !done;) {
      for (std::size_t n = 0; n < count; ++n) values[n] = &*at[n];
      Add(values);
      std::size_t n = 0;
      while (n < count && ++at[n] == end[n]) {
        at[n] = begin[n];
        ++n;
      }
      done = n == count;
    }
  }
}

}  // namespace soarbox::kernel::imagery
