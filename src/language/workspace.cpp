// SPDX-License-Identifier: BSD-2-Clause
#include "language/workspace.h"

#include <algorithm>
#include <set>

#include "cli/rule_crowds.h"
#include "cli/svs_paths.h"
#include "diagnostics/read_text.h"
#include "explain/odd_characters.h"
#include "explain/rule_slips.h"
#include "kernel/rules/rule_gaps.h"
#include "sim/check.h"

namespace soarbox::language {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostFiles = 10'000;  ///< Maximum number of files in a folder that is searched.
constexpr std::size_t kMostSlips = 500;     ///< Maximum number of slips per file.

fs::path FolderOf(const fs::path& file) {
  return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

bool IsBelow(const fs::path& file, const fs::path& folder) {
  return std::ranges::mismatch(folder, file).in1 == folder.end();
}

bool HasErrors(const Document& document) {
  return std::ranges::any_of(document.problems(), [](const Diagnostic& p) { return p.severity == Severity::kError; });
}

}  // namespace

const Document* Program::Find(const fs::path& path) const {
  for (const std::shared_ptr<const Document>& document : documents)
    if (document->path().native() == path.native()) return document.get();
  return nullptr;
}

void Workspace::Open(const fs::path& path, std::string text) {
  auto document = std::make_shared<const Document>(path, std::move(text), reader_, words_);
  for (auto& [region, graph] : regions_)
    if (IsBelow(path, region)) graph.Add(path, document->text());
  open_[path] = std::move(document);
}

void Workspace::Close(const fs::path& path) {
  open_.erase(path);
  LookAgain();
}

void Workspace::SetFolders(std::vector<fs::path> folders) {
  editor_folders_ = std::move(folders);
  LookAgain();
}

std::vector<fs::path> Workspace::OpenFiles() const {
  std::vector<fs::path> files;
  for (const auto& [path, document] : open_) files.push_back(path);
  return files;
}

bool Workspace::MayRead(const fs::path& path) const {
  std::error_code error;
  return folders_.empty() ? fs::is_regular_file(path, error) : IsPlainFileBelow(path, folders_);
}

std::shared_ptr<const Document> Workspace::Find(const fs::path& path) {
  if (const auto open = open_.find(path); open != open_.end()) return open->second;
  if (!MayRead(path)) return nullptr;
  std::error_code error;
  const fs::file_time_type time = fs::last_write_time(path, error);
  const std::uintmax_t size = fs::file_size(path, error);
  OnDisk& known = disk_[path];
  if (known.document != nullptr && known.time == time && known.size == size) return known.document;
  const std::optional<std::string> text = ReadText(path);
  if (!text) return nullptr;
  known = {time, size, std::make_shared<const Document>(path, *text, reader_, words_)};
  return known.document;
}

fs::path Workspace::RegionOf(const fs::path& file) {
  const fs::path* outermost = nullptr;
  for (const fs::path& folder : editor_folders_)
    if (IsBelow(file, folder) && (outermost == nullptr || IsBelow(*outermost, folder))) outermost = &folder;
  if (outermost != nullptr) return *outermost;
  const VisualSoarProject* project = ProjectOf(file);
  return project != nullptr ? FolderOf(project->file) : sim::FolderOfProgram(file);
}

const sim::SourceGraph& Workspace::GraphOf(const fs::path& region) {
  const auto [at, is_new] = regions_.try_emplace(region);
  sim::SourceGraph& graph = at->second;
  if (!is_new) return graph;
  const sim::FoundRules rules = sim::FindRulesBelow(region, kMostFiles);
  if (rules.is_cut && told_cut_.insert(region).second)
    notices_.push_back("the folder " + region.string() + " is too large: " + std::to_string(rules.files.size()) +
                       " of its files of rules are looked at. Open the folder of one agent instead.");
  for (const fs::path& file : rules.files) {
    std::error_code error;
    if (open_.contains(file) || !MayRead(file)) continue;
    const fs::file_time_type time = fs::last_write_time(file, error);
    const std::uintmax_t size = fs::file_size(file, error);
    Scanned& known = scanned_[file.native()];
    if (known.time != time || known.size != size) known = {time, size, sim::SourcedIn(ReadText(file).value_or(""))};
    graph.Add(file, known.sources);
  }
  for (const auto& [path, document] : open_)
    if (IsBelow(path, region)) graph.Add(path, document->text());
  return graph;
}

const VisualSoarProject* Workspace::ProjectOf(const fs::path& file) {
  const fs::path found = FindVisualSoarProject(FolderOf(file));
  if (found.empty() || !MayRead(found)) return nullptr;
  std::error_code error;
  const fs::file_time_type time = fs::last_write_time(found, error);
  ReadProject& known = projects_[found];
  if (known.time != time) {
    known = {time, std::nullopt, {}};
    if (Result<VisualSoarProject> read = ReadVisualSoar(found, known.problems)) known.project = std::move(*read);
  }
  return known.project ? &*known.project : nullptr;
}

void Workspace::AddReached(const fs::path& root, Program& program, std::set<std::string>& taken) {
  std::vector<fs::path> waiting = {root};
  while (!waiting.empty() && taken.size() < kMostFiles) {
    const fs::path next = std::move(waiting.back());
    waiting.pop_back();
    if (!taken.insert(next.native()).second) continue;
    const std::shared_ptr<const Document> document = Find(next);
    if (document == nullptr) continue;
    program.documents.push_back(document);
    for (auto it = document->sourced().rbegin(); it != document->sourced().rend(); ++it)
      waiting.push_back((FolderOf(next) / it->file).lexically_normal());
  }
}

Program Workspace::ProgramOf(const fs::path& path) {
  Program program;
  if (const VisualSoarProject* project = ProjectOf(path); project != nullptr) program.project = project->file;
  const sim::SourceGraph& graph = GraphOf(RegionOf(path));
  program.roots = graph.RootsOf(path);
  program.root = program.roots.front();
  std::set<std::string> taken;
  for (const fs::path& root : program.roots) AddReached(root, program, taken);
  if (program.Find(path) == nullptr) AddReached(path, program, taken);
  return program;
}

std::vector<fs::path> Workspace::FilesOfPrograms(std::size_t most) {
  std::vector<fs::path> files;
  std::set<std::vector<fs::path>> known;
  for (const fs::path& folder : editor_folders_) {
    const sim::FoundRules rules = sim::FindRulesBelow(folder, most);
    if (rules.is_cut) continue;
    for (const fs::path& file : rules.files)
      if (MayRead(file) && known.insert(RootsOf(file)).second) files.push_back(file);
  }
  return files;
}

std::vector<Diagnostic> Workspace::MissingFiles(const Document& document) const {
  std::vector<Diagnostic> problems;
  for (const Document::Sourced& sourced : document.sourced()) {
    const fs::path file = (FolderOf(document.path()) / sourced.file).lexically_normal();
    if (open_.contains(file) || MayRead(file)) continue;
    Diagnostic problem;
    problem.file = document.path().string();
    problem.line = sourced.line;
    problem.excerpt = document.lines().Line(static_cast<std::size_t>(sourced.line) - 1);
    const std::size_t column = problem.excerpt.find(sourced.name);
    if (column != std::string::npos) problem.column = static_cast<int>(column) + 1;
    problem.excerpt_length = static_cast<int>(sourced.name.size());
    problem.message = "there is no file " + sourced.name + " beside this one";
    problem.hint = "the name is relative to the folder of the file that sources it";
    if (sourced.file.has_parent_path()) problem.message = "there is no file " + file.string();
    problems.push_back(std::move(problem));
  }
  return problems;
}

void Workspace::AddDuplicates(const Program& program, std::map<fs::path, std::vector<Diagnostic>>& found) {
  // Programs that share files may have rules of the same name.
  constexpr std::size_t kMostPrograms = 4;
  for (std::size_t i = 0; i < std::min(program.roots.size(), kMostPrograms); ++i) {
    Program one;
    std::set<std::string> taken;
    AddReached(program.roots[i], one, taken);
    std::vector<explain::RuleFile> files;
    for (const std::shared_ptr<const Document>& document : one.documents)
      files.push_back({document->path(), document->code()});
    for (Diagnostic& twice : explain::FindDuplicates(files)) {
      std::vector<Diagnostic>& known = found[twice.file];
      const bool is_known = std::ranges::any_of(
          known, [&](const Diagnostic& other) { return other.line == twice.line && other.message == twice.message; });
      if (!is_known) known.push_back(std::move(twice));
    }
  }
}

std::map<fs::path, std::vector<Diagnostic>> Workspace::Slips(const Program& program) {
  std::map<fs::path, std::vector<Diagnostic>> found;
  std::vector<explain::RuleText> rules;
  std::vector<const kernel::Production*> productions;
  std::vector<explain::RuleFile> files;
  std::map<std::string, const Document*> of_rule;
  std::map<std::string, std::pair<const Document*, int>> of_read;
  bool complete = true;
  for (const std::shared_ptr<const Document>& document : program.documents) {
    found[document->path()];
    complete = complete && !HasErrors(*document);
    files.push_back({document->path(), document->code()});
    for (const DocumentCommand& command : document->commands()) {
      rules.insert(rules.end(), command.read->texts.begin(), command.read->texts.end());
      for (const kernel::ProductionPtr& rule : command.read->rules) productions.push_back(rule.get());
      for (const explain::RuleText& text : command.read->texts) of_rule[text.name] = document.get();
      of_read[command.read->id] = {document.get(), command.line};
    }
  }
  AddDuplicates(program, found);
  for (const explain::RuleFile& file : files)
    for (Diagnostic& warning : explain::FindOddCharacters(file))
      if (of_rule.contains(warning.rule)) found[file.file].push_back(std::move(warning));
  explain::KnownWords known = sim::WordsAround(program.root);
  known.complete = complete;
  if (explain::MentionsScenes(rules)) known.scene = explain::ReadSceneKinds(cli::AllSceneKinds());
  for (const explain::Slip& slip : explain::FindSlips(rules, known)) {
    const auto document = of_rule.find(slip.rule);
    if (document == of_rule.end() || found[document->second->path()].size() >= kMostSlips) continue;
    const fs::path& path = document->second->path();
    found[path].push_back(explain::PlaceSlip(slip, path, document->second->code()));
  }
  // Gaps and crowds only contain a rule's text; its place is that of the text.
  std::vector<Diagnostic> traps = kernel::FindRuleGaps(productions, productions.size(), reader_.symbols());
  for (Diagnostic& crowd : cli::FindRuleCrowds(productions, productions.size(), reader_.symbols()))
    traps.push_back(std::move(crowd));
  for (Diagnostic& trap : traps) {
    const auto place = of_read.find(trap.file);
    if (place == of_read.end()) continue;
    trap.file = place->second.first->path().string();
    trap.line += place->second.second - 1;
    found[place->second.first->path()].push_back(std::move(trap));
  }
  if (const VisualSoarProject* project = ProjectOf(program.root); project != nullptr) {
    for (const std::shared_ptr<const Document>& document : program.documents)
      for (Diagnostic& unknown : FindUnknown(project->datamap, *document))
        found[document->path()].push_back(std::move(unknown));
  }
  return found;
}

std::vector<Diagnostic> CheckAgainstDatamap(const fs::path& file) {
  std::vector<Diagnostic> problems;
  std::error_code error;
  fs::path project = IsVisualSoarProject(file) ? file : FindVisualSoarProject(FolderOf(file));
  if (project.empty()) return problems;
  Result<VisualSoarProject> read = ReadVisualSoar(project, problems);
  const bool named = IsVisualSoarProject(file);
  if (!read) {
    if (named) problems.push_back(read.error());
    return problems;
  }
  // A file that happens to be next to or below a project does not belong to it.
  if (!named && std::ranges::count(read->rules, fs::absolute(file, error).lexically_normal()) == 0 &&
      RootOfProject(project) != fs::absolute(file, error).lexically_normal())
    return problems;
  Workspace workspace({FolderOf(project)});
  std::set<fs::path> seen;
  const std::vector<fs::path> files = named ? read->rules : std::vector<fs::path>{file};
  for (const fs::path& one : files) {
    if (!seen.insert(one).second) continue;
    const std::shared_ptr<const Document> document = workspace.Find(one);
    if (document == nullptr) continue;
    for (Diagnostic& unknown : FindUnknown(read->datamap, *document)) problems.push_back(std::move(unknown));
  }
  // Errors of the project itself are reported when the project is named.
  if (!named) std::erase_if(problems, [&](const Diagnostic& problem) { return problem.file == project.string(); });
  return problems;
}

}  // namespace soarbox::language
