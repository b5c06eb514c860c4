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

/// The interface of a live run that a desk needs. The program that runs the simulation implements it.
class LiveRun {
 public:
  virtual ~LiveRun() = default;
  virtual sim::Simulation& simulation() = 0;
  /// The minimum detail that minds must record even if no panel needs it.
  virtual sim::MindDetail LeastDetail() const { return sim::MindDetail::kNone; }
  /// Calls the function with the present tick, and then after each tick. An empty function ends the subscription, and
  /// the observation of scripts (sim::ObserveScripts).
  using OnTick = std::function<void(const record::TickRecord&)>;
  virtual void Watch(OnTick on_tick) = 0;
  /// The exercise of other simulations that the run takes part in; nothing if there is none.
  virtual std::optional<ExerciseContents> Exercise() { return std::nullopt; }
  /// Sets the receiver of reports of live edits: notes on what was reloaded, and problems of a file. Does not change
  /// the run.
  using OnEdit = std::function<void(const Diagnostic& told)>;
  virtual void SetOnEdit(OnEdit on_edit) = 0;
  /// Continues with another simulation of the same run, which is at an earlier tick. `at` is the record of that tick,
  /// and `inputs` are all inputs up to it.
  virtual void GoOnWith(std::unique_ptr<sim::Simulation> simulation, const record::TickRecord& at,
                        const std::vector<record::TickInputs>& inputs) = 0;
};

}  // namespace soarbox::workbench
