// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>

#include "kernel/base/symbol.h"

namespace soarbox::kernel {

class InputLink;

/// One change that the input link made in working memory.
struct InputChange {
  bool added = false;           ///< Else removed.
  bool new_identifier = false;  ///< The value is an identifier that this change made.
  std::uint64_t timetag = 0;
  Symbol id, attribute, value;
};

/// Sees what enters and leaves through the input link, change by change, and may take the place of the clients: for
/// recording input and for replaying it. Called on the agent's thread in the middle of the input phase.
class InputTap {
 public:
  virtual ~InputTap() = default;
  /// The input phase begins. May call link.DropPending() and buffer changes of its own, which are made at once.
  virtual void OnInputPhase(InputLink& link) { (void)link; }
  virtual void OnInputChange(const InputChange& change) = 0;
  /// init-soar: all elements and identifiers are gone.
  virtual void OnInputReset() {}
};

}  // namespace soarbox::kernel
