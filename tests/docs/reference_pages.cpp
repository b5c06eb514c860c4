// SPDX-License-Identifier: BSD-2-Clause
//
// Writes the pages of docs/ that are generated from tables of the source, the page's types of contents, and its tables
// of panels and of commands of the run.
//
//   reference_pages FOLDER           writes them into the folder, usually docs
//   reference_pages --check FOLDER   fails if one of the folder's pages differs

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <vector>

#include "cli/help.h"
#include "diagnostics/read_text.h"
#include "script/api_reference.h"
#include "stream/scene_layout.h"
#include "vocabulary/vocabulary.h"
#include "workbench/contents_json.h"
#include "workbench/flow_info.h"

int main(int argc, char** argv) {
  const bool checks = argc == 3 && std::string_view(argv[1]) == "--check";
  if (argc != 2 && !checks) {
    std::fputs("usage: reference_pages [--check] FOLDER\n", stderr);
    return 2;
  }
  std::vector<soarbox::script::ReferencePage> pages = soarbox::script::ApiReference();
  for (soarbox::script::ReferencePage& page : pages) page.file = "lua/" + page.file;
  pages.push_back({"percepts.md", soarbox::vocabulary::PerceptReference()});
  pages.push_back({"commands.md", soarbox::vocabulary::CommandReference()});
  pages.push_back({"soar_commands.md", soarbox::cli::CommandReference()});
  pages.push_back({"workbench.md", soarbox::workbench::WorkbenchReference()});
  pages.push_back({"../web/src/format/scene_records.ts", soarbox::stream::SceneRecords()});
  pages.push_back({"../web/src/document/nodes.ts", soarbox::workbench::DocumentTypes()});
  pages.push_back({"../web/src/run/contents.ts", soarbox::workbench::ContentTypes()});
  pages.push_back({"../web/src/panels/panel_table.ts", soarbox::workbench::PanelTable()});
  pages.push_back({"../web/src/app/flow_table.ts", soarbox::workbench::FlowTable()});
  const std::filesystem::path folder = argv[argc - 1];
  int status = 0;
  for (const soarbox::script::ReferencePage& page : pages) {
    const std::filesystem::path file = folder / page.file;
    if (checks) {
      if (soarbox::ReadText(file) == page.text) continue;
      std::fprintf(stderr, "%s is out of date; write it again with: reference_pages %s\n", file.c_str(),
                   folder.c_str());
      status = 1;
      continue;
    }
    std::ofstream out(file, std::ios::binary);
    if (out << page.text && out.flush()) continue;
    std::fprintf(stderr, "cannot write %s\n", file.c_str());
    status = 1;
  }
  return status;
}
