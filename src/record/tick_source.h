// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "diagnostics/result.h"
#include "record/header.h"
#include "record/tick_record.h"

namespace soarbox::record {

/// The recorded ticks of a run: a recording on disk (Reader) or the memory of a running world (History). The ticks are
/// consecutive, but may begin after the start of the run. The inputs are always complete.
///
/// Not thread-safe.
class TickSource {
 public:
  virtual ~TickSource() = default;

  virtual const Header& header() const = 0;
  /// For messages: the name of the file, or a description of the run.
  virtual std::string name() const = 0;
  /// The first and last tick that have a record.
  virtual std::uint64_t first_tick() const = 0;
  virtual std::uint64_t last_tick() const = 0;
  bool Holds(std::uint64_t tick) const { return tick >= first_tick() && tick <= last_tick(); }

  /// The record of a tick. Reading ticks in ascending order is cheap. Fails for a tick that is not recorded and for a
  /// damaged part; other ticks remain readable. Valid until the next call.
  virtual Result<const TickRecord*> At(std::uint64_t tick) = 0;
  /// All inputs since the first tick of the run, in order.
  virtual Result<std::vector<TickInputs>> Inputs() = 0;
};

/// The error for a tick that a source does not contain.
Diagnostic NotThere(const TickSource& source, std::uint64_t tick);

}  // namespace soarbox::record
