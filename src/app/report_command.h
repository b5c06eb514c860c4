// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>

namespace soarbox::app {

/// Options of `soarbox report`.
struct ReportOptions {
  std::filesystem::path source;  ///< A recording, a folder of recordings, a sweep.
  std::filesystem::path output = "report.html";
  std::filesystem::path plots;  ///< Writes plots into this folder instead of the page; empty: the page.
};

int Report(const ReportOptions& options);

}  // namespace soarbox::app
