// SPDX-License-Identifier: BSD-2-Clause
#include "app/report_command.h"

#include <fstream>
#include <iostream>

#include "app/data_folders.h"
#include "app/exit_codes.h"
#include "app/refuse.h"
#include "report/page.h"

namespace soarbox::app {

int Report(const ReportOptions& options) {
  const Result<sim::DataFolders> data = FindDataFolders();
  if (!data) return Refuse(data.error());
  const Result<std::string> page = report::MakePage(options.source, *data);
  if (!page) return Refuse(page.error());
  // A page that is there stays until the new one is whole.
  std::filesystem::path making = options.output;
  making += ".part";
  std::error_code error;
  const bool written = static_cast<bool>((std::ofstream(making, std::ios::binary) << *page).flush());
  if (written) std::filesystem::rename(making, options.output, error);
  if (!written || error) {
    Diagnostic problem;
    problem.file = options.output.string();
    problem.message = "this page cannot be written";
    problem.hint = "is the disk full, or the folder not yours?";
    std::filesystem::remove(making, error);
    return Refuse(problem);
  }
  std::cout << options.output.string() << ": " << (page->size() + 1023) / 1024 << " KB\n";
  return kOk;
}

}  // namespace soarbox::app
