// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/run_options.h"
#include "app/run_session.h"
#include "record/header.h"
#include "sim/scenario.h"
#include "sim/simulation.h"

namespace soarbox::app {

/// Which run this is, for its recordings and for the memory of its past: as the user named it, with its files as they
/// are now. Call when the run begins.
record::Header HeaderOfRun(const RunOptions& options, const sim::Scenario& scenario,
                           const sim::SimulationSettings& settings, const sim::Simulation& simulation,
                           record::Level level);

/// A run is recorded if the user asks for it; one in a window always, unless told otherwise.
bool WantsRecording(const RunOptions& options);

/// The recordings of a run from the command line, one after the other: it may begin again, and go back and on.
class RunRecordings {
 public:
  explicit RunRecordings(const RunOptions& options) : options_(options) {}

  /// What recordings from now on say they were made from (record::ManifestOf).
  void SetManifest(std::string manifest) { manifest_ = std::move(manifest); }

  /// Starts recording a run that has made no tick yet: into the file named, or into the usual one, which is bounded;
  /// one that begins again, into the next such file, so that what was recorded stays. If it cannot be written that is
  /// told. Returns a remark on where it goes, or nothing if there is no recording.
  std::string Begin(RunSession& session, const record::Header& header);

  /// Records what comes after the run has gone back: into a file beside the one before, which begins with the tick
  /// `at` that the run goes on from and holds all that came in before. Returns a remark likewise.
  std::string GoOn(RunSession& session, const record::Header& header, record::TickRecord at,
                   std::vector<record::TickInputs> inputs);

 private:
  std::string Write(RunSession& session, const std::filesystem::path& file, const record::Header& header,
                    const record::TickRecord* at, const std::vector<record::TickInputs>& inputs);

  RunOptions options_;
  std::filesystem::path file_;  ///< The latest; empty: none.
  std::string manifest_;
};

/// "fight-2.soarrec" beside "fight.soarrec", with the first number that no file has.
std::filesystem::path NextRecording(const std::filesystem::path& file);

}  // namespace soarbox::app
