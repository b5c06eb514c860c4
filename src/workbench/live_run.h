// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "diagnostics/diagnostic.h"
#include "record/tick_record.h"
#include "sim/simulation.h"
#include "workbench/contents.h"

namespace soarbox::workbench {

/// A run under way, as far as a desk needs it. The program that drives the run implements it.
class LiveRun {
 public:
  virtual ~LiveRun() = default;
  virtual sim::Simulation& simulation() = 0;
  /// What minds must note even if nobody looks at them.
  virtual sim::MindDetail LeastDetail() const { return sim::MindDetail::kNone; }
  /// Calls the function with what is there now, and then with each tick; an empty function ends that.
  using OnTick = std::function<void(const record::TickRecord&)>;
  virtual void Watch(OnTick on_tick) = 0;
  /// The exercise of other simulations that the run takes part in; nothing: none.
  virtual std::optional<ExerciseContents> Exercise() { return std::nullopt; }
  /// Gets what live edits report: what was reloaded (notes), and what is wrong with a file. It changes no run.
  using OnEdit = std::function<void(const Diagnostic& told)>;
  virtual void SetOnEdit(OnEdit on_edit) = 0;
  /// Goes on with another simulation of the same run, as it was at an earlier tick, which is recorded as `at`; `inputs`
  /// are what had come in by then.
  virtual void GoOnWith(std::unique_ptr<sim::Simulation> simulation, const record::TickRecord& at,
                        const std::vector<record::TickInputs>& inputs) = 0;
};

}  // namespace soarbox::workbench
