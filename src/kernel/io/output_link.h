// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "kernel/base/ids.h"
#include "kernel/base/symbol.h"
#include "kernel/memory/output_marks.h"
#include "kernel/memory/working_memory.h"

namespace soarbox::kernel {

/// One change below the output link. Contains copies, so that removed elements can be read.
struct OutputChange {
  bool added = true;
  std::uint64_t timetag = 0;
  Symbol id, attribute, value;
};

/// A command: an element directly on the output link whose value is an identifier.
struct OutputCommand {
  Symbol attribute;   ///< The command's name.
  Symbol identifier;  ///< Its object; the elements of this identifier are the parameters.
  std::uint64_t timetag = 0;
};

/// The agent's output to its clients. If the agent changed an element that is reachable from the output link, the
/// output phase compares the reachable structure with its previous state. Changes by clients alone do not count as
/// output. The differences are available until the next output phase that finds a difference. Costs nothing while
/// nothing below the output link changes.
class OutputLink {
 public:
  OutputLink(const WorkingMemory& memory, OutputMarks& marks);

  /// The output link's identifier (I3); none before the first state exists.
  Symbol identifier() const { return identifier_; }
  /// The differences found by the last output phase with changes. Removals come first, in time-tag order. Additions
  /// follow in the order of a walk from the output link: the elements of an object are adjacent, oldest attribute
  /// first, and follow those of the parent object. If a parent has several objects, the newest comes first.
  std::span<const OutputChange> changes() const { return changes_; }
  /// Number of output phases that found a difference. A client compares it with the number that it saw last.
  std::uint64_t generation() const { return generation_; }
  /// Everything below the output link at the last output phase, in time-tag order.
  std::span<const OutputChange> current() const { return current_; }
  /// The commands that changes() adds.
  std::span<const OutputCommand> new_commands() const { return new_commands_; }

  /// For the core.
  void SetIdentifier(Symbol identifier);
  /// The output phase: true if something changed.
  bool Collect();
  /// Calls `mark` for each symbol in the lists.
  template <typename MarkSymbol>
  void Mark(MarkSymbol mark) const {
    for (const std::vector<OutputChange>* list : {&current_, &changes_}) {
      for (const OutputChange& change : *list) {
        mark(change.id);
        mark(change.attribute);
        mark(change.value);
      }
    }
    for (const Symbol id : members_) mark(id);
  }
  std::span<const Symbol> members() const { return members_; }
  void Reset();

 private:
  /// Appends the elements of `id` to `next_`, and the objects below it to `pending_`.
  void Visit(Symbol id);
  /// Sorts changes_[first...], which is in time-tag order, into the order of the walk.
  void OrderAdditions(std::size_t first);

  const WorkingMemory& memory_;
  OutputMarks& marks_;  ///< Identifiers below the output link at the last collection.
  Symbol identifier_;
  std::uint64_t generation_ = 0;
  std::vector<Symbol> members_;  ///< The marked identifiers.
  std::vector<OutputChange> current_, next_, changes_;
  std::vector<OutputCommand> new_commands_;
  std::vector<Symbol> pending_;         ///< During the walk: objects to visit; the last one is next.
  std::vector<std::uint64_t> visited_;  ///< Time tags in the order of the last walk; empty if they were ascending.
};

}  // namespace soarbox::kernel
