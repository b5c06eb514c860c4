// SPDX-License-Identifier: BSD-2-Clause
#include "app/report_command.h"

#include <fstream>
#include <iostream>
#include <optional>

#include "app/data_folders.h"
#include "app/exit_codes.h"
#include "app/refuse.h"
#include "app/scene_report.h"
#include "diagnostics/problem.h"
#include "diagnostics/read_text.h"
#include "picture/png.h"
#include "record/reader.h"
#include "report/page.h"
#include "report/report_plots.h"

namespace soarbox::app {
namespace {

/// Reads the files of the page that npm has built. The error says how to build them.
Result<report::PageTexts> ReadPageTexts(const sim::DataFolders& data) {
  const std::filesystem::path folder = PageFolder(data);
  const std::optional<std::string> page = ReadText(folder / "report.html"), script = ReadText(folder / "report.js"),
                                   scene = ReadText(folder / "report_scene.js");
  if (page && script && scene) return report::PageTexts{*page, *script, *scene};
  return ProblemIn(
      folder, "the page that reports are shown in is not built",
      "in the source folder, ./dev soarbox report builds it and writes the report, and ./dev package packs it");
}

}  // namespace

namespace {

/// Returns the data of a page about one recording or one sweep.
Result<std::string> DataOf(const std::filesystem::path& source, const sim::DataFolders& data) {
  std::error_code error;
  const std::filesystem::path beside = std::filesystem::path(source).replace_extension(".sweep");
  if (std::filesystem::exists(source / "sweep.id", error)) return report::SweepData(source, data);
  if (record::IsRecording(source)) {
    constexpr std::size_t kMostBytes = 50'000'000;
    return report::RunData(source, data, kMostBytes);
  }
  if (source.extension() == ".toml" && std::filesystem::exists(beside / "sweep.id", error))
    return report::SweepData(beside, data);
  return ProblemIn(source, "there is nothing here to make plots of",
                   "name a recording, a sweep that has runs, or its folder");
}

/// Writes each plot as SVG and as PNG.
int WritePlots(const ReportOptions& options, const sim::DataFolders& data) {
  const Result<std::string> made = DataOf(options.source, data);
  if (!made) return Refuse(made.error());
  std::error_code error;
  std::filesystem::create_directories(options.plots, error);
  if (error) return Refuse(ProblemIn(options.plots, "this folder cannot be made: " + error.message()));
  const std::vector<report::Plot> plots = report::PlotsOf(*made);
  for (const report::Plot& plot : plots) {
    for (const auto& [ending, bytes] :
         {std::pair{".svg", picture::SvgOf(plot.drawing)}, {".png", picture::PngOf(picture::ImageOf(plot.drawing))}}) {
      const std::filesystem::path file = options.plots / (plot.name + ending);
      if (!(std::ofstream(file, std::ios::binary) << bytes).flush())
        return Refuse(ProblemIn(file, "this plot cannot be written", "is the disk full, or the folder not yours?"));
    }
  }
  std::cout << options.plots.string() << ": " << plots.size() << " plots, each as SVG and PNG\n";
  return kOk;
}

}  // namespace

int Report(const ReportOptions& options) {
  const Result<sim::DataFolders> data = FindDataFolders();
  if (!data) return Refuse(data.error());
  if (!options.plots.empty()) return WritePlots(options, *data);
  const Result<report::PageTexts> texts = ReadPageTexts(*data);
  if (!texts) return Refuse(texts.error());
  const Result<std::string> page = report::MakePage(options.source, *data, *texts, RecordedRun);
  if (!page) return Refuse(page.error());
  std::error_code error;
  // Renaming a file to a device's path would replace the device.
  const std::filesystem::file_status there = std::filesystem::status(options.output, error);
  if (std::filesystem::exists(there) && !std::filesystem::is_regular_file(there))
    return Refuse("this is not a plain file, so no page is written to it", "name a file with -o", options.output);
  // An existing page is kept until the new one is complete.
  std::filesystem::path making = options.output;
  making += ".part";
  error.clear();
  const bool written = static_cast<bool>((std::ofstream(making, std::ios::binary) << *page).flush());
  if (written) std::filesystem::rename(making, options.output, error);
  if (!written || error) {
    std::filesystem::remove(making, error);
    return Refuse("this page cannot be written", "is the disk full, or the folder not yours?", options.output);
  }
  std::cout << options.output.string() << ": " << (page->size() + 1023) / 1024 << " KB\n";
  return kOk;
}

}  // namespace soarbox::app
