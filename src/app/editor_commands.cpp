// SPDX-License-Identifier: BSD-2-Clause
#include "app/editor_commands.h"

#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <fstream>
#include <iostream>

#include "app/data_folders.h"
#include "app/exit_codes.h"
#include "app/refuse.h"
#include "diagnostics/plain_text.h"
#include "diagnostics/problem.h"
#include "diagnostics/read_text.h"
#include "editors/dap_server.h"
#include "editors/lsp_server.h"
#include "editors/mcp_server.h"
#include "language/datamap.h"
#include "language/format_rules.h"
#include "language/workspace.h"

namespace soarbox::app {
namespace {

namespace fs = std::filesystem;

/// Returns the given files of rules, and those below the given folders.
std::vector<fs::path> RuleFiles(const std::vector<fs::path>& named) {
  std::vector<fs::path> files;
  for (const fs::path& path : named) {
    std::error_code error;
    if (!fs::is_directory(path, error)) {
      files.push_back(path);
      continue;
    }
    std::vector<fs::path> below;
    for (fs::recursive_directory_iterator it(path, error), end; !error && it != end; it.increment(error))
      if (it->path().extension() == ".soar" && !it->is_symlink(error)) below.push_back(it->path());
    std::ranges::sort(below);
    files.insert(files.end(), below.begin(), below.end());
  }
  return files;
}

/// Writes a new file and renames it, so that there is never a partly written file.
bool Replace(const fs::path& file, const std::string& text) {
  std::error_code error;
  const fs::path target = fs::canonical(file, error);
  const fs::path beside = target.string() + ".soarbox-format";
  if (error || !(std::ofstream(beside, std::ios::binary) << text).flush()) {
    fs::remove(beside, error);
    return false;
  }
  fs::permissions(beside, fs::status(target, error).permissions(), error);
  fs::rename(beside, target, error);
  return !error;
}

}  // namespace

int FormatFiles(const FormatOptions& options) {
  int code = kOk;
  for (const fs::path& file : RuleFiles(options.files)) {
    const std::optional<std::string> text = ReadText(file);
    const std::string why = !text ? "this file cannot be read" : WhyNoPlainText(*text);
    if (!why.empty()) {
      std::cerr << Format(ProblemIn(file, why));
      code = kProblems;
      continue;
    }
    const std::string made = language::FormatRules(*text);
    if (made == *text) continue;
    if (options.check) {
      std::cout << file.string() << '\n';
      code = kProblems;
    } else if (!Replace(file, made)) {
      std::cerr << Format(ProblemIn(file, "this file cannot be written"));
      code = kProblems;
    }
  }
  return code;
}

int WriteDatamap(const DatamapOptions& options) {
  std::error_code error;
  if (!fs::is_regular_file(options.rules, error))
    return Refuse(ProblemIn(options.rules, "there is no such file of rules", "name the file that loads all others"));
  const fs::path root = fs::absolute(options.rules, error).lexically_normal();
  language::Workspace workspace;
  language::Program program = workspace.ProgramOf(root);
  std::vector<const language::Document*> documents;
  std::vector<std::string> layout;
  const fs::path base = options.output.empty() ? root.parent_path()
                                               : fs::absolute(options.output, error).lexically_normal().parent_path();
  for (const auto& document : program.documents) {
    documents.push_back(document.get());
    layout.push_back(document->path().lexically_relative(base).string());
  }
  const std::string text = language::ToProjectJson(language::DatamapOf(documents), root.stem().string(), layout);
  if (options.output.empty()) {
    std::cout << text;
    return kOk;
  }
  if (!(std::ofstream(options.output, std::ios::binary) << text).flush())
    return Refuse(ProblemIn(options.output, "this file cannot be written"));
  return kOk;
}

std::vector<Diagnostic> DatamapProblems(const fs::path& file) {
  if (file.extension() != ".soar" && !language::IsVisualSoarProject(file)) return {};
  return language::CheckAgainstDatamap(file);
}

int ServeLanguage() {
  std::signal(SIGPIPE, SIG_IGN);
  const Result<sim::DataFolders> data = FindDataFolders();
  return editors::ServeLsp(STDIN_FILENO, STDOUT_FILENO, data ? &*data : nullptr);
}

int ServeDebugger() {
  std::signal(SIGPIPE, SIG_IGN);
  const Result<sim::DataFolders> data = FindDataFolders();
  return editors::ServeDap(STDIN_FILENO, STDOUT_FILENO, data ? &*data : nullptr);
}

int ServeAssistant(const fs::path& folder) {
  std::signal(SIGPIPE, SIG_IGN);
  std::error_code error;
  if (!fs::is_directory(folder, error)) return Refuse(ProblemIn(folder, "there is no such folder"));
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (error) return Refuse(ProblemIn({}, "the program cannot find its own path in /proc"));
  return editors::ServeMcp(STDIN_FILENO, STDOUT_FILENO, program, folder);
}

}  // namespace soarbox::app
