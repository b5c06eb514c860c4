// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>

namespace soarbox::app {

/// What `soarbox report` was asked for.
struct ReportOptions {
  std::filesystem::path source;  ///< A recording, a folder of recordings, a sweep.
  std::filesystem::path output = "report.html";
  std::filesystem::path plots;  ///< Plots go into this folder instead; empty: the page is written.
};

int Report(const ReportOptions& options);

}  // namespace soarbox::app
