// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/window_wishes.h"

namespace soarbox::app {

/// Options of the commands for recordings. docs/options.md says which command uses which.
struct RecordingOptions : WindowWishes {
  std::filesystem::path file;
  std::filesystem::path other;         ///< compare: the second recording.
  std::optional<double> from_s, to_s;  ///< Simulated seconds; none: the entire recording.
  bool headless = false;               ///< replay: print, do not open a window.
  std::string select;                  ///< replay: name of the initially selected agent.
  bool info = false;                   ///< replay: print what it was made from, and exit.
  std::filesystem::path pictures;      ///< replay: draw PNG files into this folder; empty: none.
  std::filesystem::path video;         ///< replay: draw an animation into this file; empty: none.
  std::optional<double> every_s;       ///< replay: simulated seconds from picture to picture.
  bool is_plan = false;                ///< replay: pictures from straight above.
  bool json = false;
  bool csv = false;
  bool tidy = false;                         ///< export: tables in long form.
  bool as_recording = false;                 ///< export: a part as a separate recording.
  std::filesystem::path output;              ///< export, resume: output file; empty: standard output, or no recording.
  double at_s = 0;                           ///< resume.
  bool as_recorded = false;                  ///< verify: with the recorded contents of the scenario's files.
  int threads = 0;                           ///< verify, resume: for the minds; 0: one per core.
  std::optional<double> seconds;             ///< resume: duration; none: the rest of the recording's duration.
  std::vector<std::filesystem::path> rules;  ///< resume: files of rules that replace those of the same names.
  std::vector<std::string>
      agents;  ///< resume: the agents whose rules are replaced; empty: all agents with a Soar mind.
};

/// Whether `soarbox replay` needs no window, because it prints or draws pictures.
inline bool NeedsNoWindow(const RecordingOptions& options) {
  return options.headless || options.json || options.info || !options.pictures.empty() || !options.video.empty();
}

// Each executes one of these commands and returns an ExitCode.
/// Shows a recording in the window of this program, which must be able to open one (CanOpenWindow).
int Replay(const RecordingOptions& options);
/// replay without a window: prints the recording, or draws it into files.
int PrintRecording(const RecordingOptions& options);
int Verify(const RecordingOptions& options);
int Export(const RecordingOptions& options);
int Compare(const RecordingOptions& options);
int Resume(const RecordingOptions& options);

}  // namespace soarbox::app
