// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>

#include "kernel/base/symbol.h"

namespace soarbox::kernel {

class InputLink;

/// One change that the input link made in working memory.
struct InputChange {
  bool added = false;           ///< The element was added; if false, it was removed.
  bool new_identifier = false;  ///< The value is an identifier that this change made.
  std::uint64_t timetag = 0;
  Symbol id, attribute, value;
};

/// Receives each change that the input link makes, and may replace the clients' changes: for recording and replaying
/// input. Called on the agent's thread during the input phase.
class InputTap {
 public:
  virtual ~InputTap() = default;
  /// The input phase begins. May call link.DropPending() and buffer other changes, which are applied in this phase.
  virtual void OnInputPhase(InputLink& link) { (void)link; }
  virtual void OnInputChange(const InputChange& change) = 0;
  /// init-soar: all elements and identifiers were removed.
  virtual void OnInputReset() {}
};

}  // namespace soarbox::kernel
