// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

#include "diagnostics/result.h"
#include "sim/scenario.h"

namespace soarbox::report {

/// What a page is made from in addition to its data: as npm builds it from web/.
struct PageTexts {
  std::string page;    ///< With a place for the data, and for what else FillIn puts into it.
  std::string script;  ///< Shows the data.
  std::string scene;   ///< Shows a recorded run in 3D above it.
};

/// A recorded run in 3D, as JSON for the script that shows it.
using RecordedRun = std::function<Result<std::string>(const std::filesystem::path& recording)>;

/// One page about a recording, a folder of recordings or a sweep's folder, as one file that needs nothing else: texts
/// reach it as data only, and it runs no script but its own. That of one recording shows its run in 3D, too; it takes
/// 10 MB at most.
Result<std::string> MakePage(const std::filesystem::path& source, const sim::DataFolders& data, const PageTexts& texts,
                             const RecordedRun& recorded_run);

/// The data of a recorded run, as JSON: the run is simulated again, so that every mind can be asked. `mission`: judged
/// by these checks; empty: by those of its scenario, if it has any. `most_bytes`: what it may take in a page, at least
/// a million; it says what that leaves out.
Result<std::string> RunData(const std::filesystem::path& recording, const sim::DataFolders& data,
                            std::size_t most_bytes);
/// The data of a sweep, from what its folder holds.
Result<std::string> SweepData(const std::filesystem::path& folder, const sim::DataFolders& data);

/// JSON that may stand inside an HTML script element: no character of it ends the element or begins another.
std::string ForScriptElement(std::string_view json);
/// A template with a text in place of each {{name}}; what is in the texts stays as it is.
std::string FillIn(std::string_view page, std::initializer_list<std::pair<std::string_view, std::string_view>> texts);
/// Text that stands for itself in HTML.
std::string EscapeHtml(std::string_view text);

}  // namespace soarbox::report
