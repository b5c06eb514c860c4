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

/// The files from which a page is built, in addition to its data. npm builds them from web/.
struct PageTexts {
  std::string page;    ///< A template with places for the data and other texts (FillIn).
  std::string script;  ///< Displays the data.
  std::string scene;   ///< Displays a recorded run in 3D.
};

/// Returns a recorded run in 3D, as JSON for PageTexts::scene.
using RecordedRun = std::function<Result<std::string>(const std::filesystem::path& recording)>;

/// Builds a page about a recording, a folder of recordings (the first 50), a sweep's folder, or a sweep's file with its
/// folder next to it. The page is a single file without other resources. Texts are included only as data, and the page
/// executes only its own scripts. The page of a single recording also shows its run in 3D; it has at most about 10 MB.
Result<std::string> MakePage(const std::filesystem::path& source, const sim::DataFolders& data, const PageTexts& texts,
                             const RecordedRun& recorded_run);

/// The data of a recorded run, as JSON. The run is simulated again, so that all minds can be queried. It is judged by
/// the checks of its scenario, if there are any. `most_bytes`: maximum size in the page, at least a million. Data that
/// do not fit are left out; `thinned` in the result lists them.
Result<std::string> RunData(const std::filesystem::path& recording, const sim::DataFolders& data,
                            std::size_t most_bytes);
/// The data of a sweep, from its folder.
Result<std::string> SweepData(const std::filesystem::path& folder, const sim::DataFolders& data);

/// Escapes JSON for an HTML script element, so that no character sequence ends the element or begins another.
std::string ForScriptElement(std::string_view json);
/// Replaces each {{name}} in a template by a text. The texts themselves are not changed.
std::string FillIn(std::string_view page, std::initializer_list<std::pair<std::string_view, std::string_view>> texts);
/// Escapes a text for HTML.
std::string EscapeHtml(std::string_view text);

}  // namespace soarbox::report
