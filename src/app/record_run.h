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

/// Returns the header of this run, for its recordings and for its history in memory: with the name that the user gave
/// and the current contents of its files. Call it when the run begins.
record::Header HeaderOfRun(const RunOptions& options, const sim::Scenario& scenario,
                           const sim::SimulationSettings& settings, const sim::Simulation& simulation,
                           record::Level level);

/// Whether to record: if the user requests it; in a window always, unless it is switched off.
bool WantsRecording(const RunOptions& options);

/// The recordings of a run from the command line, one after the other: the run may restart, and continue from an
/// earlier tick.
class RunRecordings {
 public:
  explicit RunRecordings(const RunOptions& options) : options_(options) {}

  /// Sets the manifest of all later recordings (record::ManifestOf).
  void SetManifest(std::string manifest) { manifest_ = std::move(manifest); }

  /// Starts recording a run before its first tick: into the file of the options, or into a new file of the folder for
  /// automatic recordings, whose size is limited. After a restart it uses the next file name, so that earlier
  /// recordings are kept. Prints an error if the file cannot be written. Returns "recording to FILE", or nothing if
  /// there is no recording.
  std::string Begin(RunSession& session, const record::Header& header);

  /// Records a run that continues from an earlier tick `at`, into a new file next to the previous one. The file begins
  /// with that tick and contains all earlier inputs. Returns the same as Begin.
  std::string GoOn(RunSession& session, const record::Header& header, record::TickRecord at,
                   std::vector<record::TickInputs> inputs);

 private:
  std::string Write(RunSession& session, const std::filesystem::path& file, const record::Header& header,
                    const record::TickRecord* at, const std::vector<record::TickInputs>& inputs);

  RunOptions options_;
  std::filesystem::path file_;  ///< The latest file; empty: none.
  std::string manifest_;
};

/// "fight-2.soarrec" next to "fight.soarrec", with the first unused number.
std::filesystem::path NextRecording(const std::filesystem::path& file);

}  // namespace soarbox::app
