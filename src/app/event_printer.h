// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

#include "sim/findings.h"
#include "sim/run_event.h"
#include "world/scene_snapshot.h"

namespace soarbox::app {

/// Printed at the beginning and at the end of a run.
struct RunHeader {
  std::string scenario;
  std::uint64_t seed = 1;
  bool headless = true;
};
struct RunFooter {
  std::uint64_t ticks = 0;
  double time_s = 0;
  std::uint64_t state_hash = 0;
  std::size_t agents = 0;
  std::size_t soar_agents = 0;
  std::size_t problems = 0;
  std::vector<sim::Finding> findings;  ///< The errors of the run, the cause first.
};

/// Prints the events of a run as text or as lines of JSON. The output depends only on the run, not on the wall clock,
/// so that two runs with one seed print the same.
class EventPrinter {
 public:
  virtual ~EventPrinter() = default;
  virtual void Begin(const RunHeader& header) = 0;
  virtual void Print(const sim::RunEvent& event) = 0;
  /// The state of all agents, for --report.
  virtual void Report(const world::SceneSnapshot& snapshot) = 0;
  virtual void End(const RunFooter& footer) = 0;

  /// Text: events on `out`, diagnostics on `errors`.
  static std::unique_ptr<EventPrinter> MakeText(std::ostream& out, std::ostream& errors);
  /// One JSON object per line, all on `out`; docs/command.md lists the fields.
  static std::unique_ptr<EventPrinter> MakeJson(std::ostream& out);
};

}  // namespace soarbox::app
