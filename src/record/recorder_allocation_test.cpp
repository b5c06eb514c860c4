// SPDX-License-Identifier: BSD-2-Clause
// A recorder whose run was out of memory for a moment keeps all its records.
#include <gtest/gtest.h>

#include <new>

#include "diagnostics/counted_allocations.h"
#include "diagnostics/without_threads.h"
#include "record/reader.h"
#include "record/run_test_support.h"
#include "record/ticks_test_support.h"

namespace soarbox::record {
namespace {

TEST(RecorderAllocation, ATickThatCouldNotBeCopiedLosesNoRecord) {
  const ScratchFolder scratch;
  const std::filesystem::path file = scratch.path() / "run";
  sim::SimulationSettings settings;
  settings.soar.threads = 1;
  const auto scenario = sim::FindScenario("thesis", Data()).value();
  const std::unique_ptr<sim::Simulation> run = std::move(sim::Simulation::Create(scenario, settings).value());
  // The refusals must not reach another thread.
  const WithoutThreads none;
  Recorder recorder(std::move(Writer::Create(file, SomeHeader(), {}).value()), Level::kAll, 1);
  for (int i = 0; i < 3; ++i) {
    allocations::RefuseAfter(0, allocations::Refusal::kOnce);
    EXPECT_THROW(static_cast<void>(recorder.Take(*run, {})), std::bad_alloc);
    allocations::Allow();
  }
  // Without its only record, it would wait for ever.
  EXPECT_TRUE(recorder.Take(*run, {}));
  run->Tick();
  EXPECT_TRUE(recorder.Take(*run, {}));
  EXPECT_TRUE(recorder.Finish());
  const Result<std::unique_ptr<Reader>> reader = Reader::Open(file);
  ASSERT_TRUE(reader) << Format(reader.error());
  EXPECT_EQ((*reader)->last_tick(), 1u);
  EXPECT_EQ((*reader)->waits().ticks, 0u);
}

}  // namespace
}  // namespace soarbox::record
