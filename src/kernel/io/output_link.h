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

/// One change below the output link. Contents are copied, so that removed elements can be read.
struct OutputChange {
  bool added = true;
  std::uint64_t timetag = 0;
  Symbol id, attribute, value;
};

/// A command: an identifier-valued element directly on the output link.
struct OutputCommand {
  Symbol attribute;   ///< The command's name.
  Symbol identifier;  ///< Its object: parameters are the elements of this identifier.
  std::uint64_t timetag = 0;
};

/// What the agent says to its clients. In the output phase the structure reachable from the output link is compared
/// with that of the last output phase, if the agent changed any element in it (what comes from outside is no output by
/// itself); the differences stand here until the next output phase that finds a difference. Costs nothing while nothing
/// below the output link changes.
class OutputLink {
 public:
  OutputLink(const WorkingMemory& memory, OutputMarks& marks);

  /// The output link's own identifier (I3), or none before the first state exists.
  Symbol identifier() const { return identifier_; }
  /// The differences that the last changing output phase found: removals first in time-tag order, then additions in the
  /// order of a walk from the output link: an object's elements stand together, oldest attribute first and after those
  /// of the object that it was reached from; of several objects below one, the newest comes first.
  std::span<const OutputChange> changes() const { return changes_; }
  /// Counts output phases that found a difference: a client compares it with what it saw last.
  std::uint64_t generation() const { return generation_; }
  /// Everything that is below the output link as of the last output phase, in time-tag order.
  std::span<const OutputChange> current() const { return current_; }
  /// The commands that changes() adds.
  std::span<const OutputCommand> new_commands() const { return new_commands_; }

  /// For the engine.
  void SetIdentifier(Symbol identifier);
  /// The output phase: true if something changed.
  bool Collect();
  /// Calls `mark` for each symbol that the lists mention.
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
  /// Takes what `id` has into `next_`, and the objects below it into `pending_`.
  void Visit(Symbol id);
  /// Puts changes_[first...] from time-tag order into the order of the walk.
  void OrderAdditions(std::size_t first);

  const WorkingMemory& memory_;
  OutputMarks& marks_;  ///< Below the output link at the last collection.
  Symbol identifier_;
  std::uint64_t generation_ = 0;
  std::vector<Symbol> members_;  ///< Those that are marked.
  std::vector<OutputChange> current_, next_, changes_;
  std::vector<OutputCommand> new_commands_;
  std::vector<Symbol> pending_;         ///< During the walk: objects to visit, the next one last.
  std::vector<std::uint64_t> visited_;  ///< Time tags in the order of the last walk; empty if they only grew.
};

}  // namespace soarbox::kernel
