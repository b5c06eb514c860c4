// SPDX-License-Identifier: BSD-2-Clause
#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>

#include "cli/command.h"
#include "cli/interpreter.h"
#include "cli/load_image.h"
#include "cli/percepts.h"
#include "cli/rule_crowds.h"
#include "cli/source_run.h"
#include "diagnostics/plain_text.h"
#include "kernel/agent.h"
#include "kernel/rules/rule_gaps.h"

namespace soarbox::cli {
namespace {

std::string Counted(int count, std::string_view what) {
  return fmt::format("{} production{} {}.", count, count == 1 ? "" : "s", what);
}

/// "N productions sourced. M productions excised. K productions ignored.", and the names of the excised ones.
std::string CountsText(const SourceRun::Counts& counts, bool names) {
  std::string text = Counted(counts.sourced, "sourced");
  if (!counts.excised.empty()) {
    text += " " + Counted(static_cast<int>(counts.excised.size()), "excised");
    if (names) text += "\nExcised productions:";
    for (std::size_t i = 0; names && i < counts.excised.size(); ++i) text += "\n\t" + counts.excised[i];
  }
  if (counts.ignored > 0) text += " " + Counted(counts.ignored, "ignored");
  return text + "\n";
}

void FreshLine(CommandCall& call) {
  if (!call.result.text.empty() && call.result.text.back() != '\n') call.Out("\n");
}

/// Prints the errors of a failed command with their file and line; without errors, the file and line of the command.
/// Adds the place to all diagnostics from `first_diagnostic` on that have none.
void ReportPlace(CommandCall& call, const std::string& path, int line, std::size_t first_diagnostic) {
  FreshLine(call);
  bool reported = false;
  for (std::size_t i = first_diagnostic; i < call.result.diagnostics.size(); ++i) {
    Diagnostic& diagnostic = call.result.diagnostics[i];
    const bool inner = !diagnostic.file.empty() && diagnostic.file != path;
    if (diagnostic.file.empty()) {
      diagnostic.file = path;
      if (diagnostic.line == 0) diagnostic.line = line;
    }
    if (diagnostic.severity != Severity::kError || inner) continue;
    call.Out(Format(diagnostic));
    reported = true;
  }
  if (!reported) call.Out(fmt::format("\t{}:{}\n", path, line));
}

/// Executes all commands of a text, even if some fail; false if any failed.
bool RunCommands(CommandCall& call, SourceRun& run, const std::string& path, std::string_view text) {
  if (std::string why = WhyNoPlainText(text); !why.empty()) {
    Diagnostic diagnostic;
    diagnostic.file = path;
    diagnostic.line = 1;
    diagnostic.message = std::move(why);
    const std::size_t first_diagnostic = call.result.diagnostics.size();
    call.result.diagnostics.push_back(std::move(diagnostic));
    ReportPlace(call, path, 1, first_diagnostic);
    call.failure = CommandCall::Failure::kWithMessage;
    return false;
  }
  CommandReader reader(text);
  std::vector<Word> words;
  bool ok = true;
  while (true) {
    const std::size_t first_diagnostic = call.result.diagnostics.size();
    const CommandReader::Status status = reader.Next(words);
    if (status == CommandReader::Status::kEnd) break;
    if (run.opened > SourceRun::kMostFiles) {
      ok = false;
      break;
    }
    if (status == CommandReader::Status::kError) {
      ok = false;
      FreshLine(call);
      Diagnostic diagnostic;
      diagnostic.file = path;
      diagnostic.line = reader.error_line();
      diagnostic.column = reader.error_column();
      diagnostic.message = reader.error();
      call.Out(reader.error());
      call.result.diagnostics.push_back(std::move(diagnostic));
      ReportPlace(call, path, reader.error_line(), first_diagnostic);
      reader.Recover();
      continue;
    }
    const int line = words.front().line;
    run.line = line;
    call.failure = CommandCall::Failure::kNone;
    const bool generates = words.front().text == "gp";
    const bool stars = run.stars_pending && words.front().text != "sp";
    const std::size_t length = call.result.text.size();
    const bool command_ok = call.interpreter.ExecuteWords(call, words);
    if (stars) {
      // Every command other than `sp` ends the line of stars, even if it prints nothing. If the command read a file,
      // the line may have ended already.
      if (call.result.text.compare(length, 2, " \n") != 0) call.result.text.insert(length, " \n");
      run.stars_pending = false;
    }
    if (generates) run.stars_pending = false;  // The next command does not end the line of the stars of gp.
    if (!command_ok) {
      ok = false;
      ReportPlace(call, path, line, first_diagnostic);
    }
  }
  call.failure = ok ? CommandCall::Failure::kNone : CommandCall::Failure::kWithMessage;
  return ok;
}

/// Reads a file. If its size is known, it is read in one piece into a buffer of this size.
std::string TextOf(std::ifstream& in, const std::filesystem::path& path) {
  std::error_code error;
  std::string text;
  if (const std::uintmax_t size = std::filesystem::file_size(path, error); !error) {
    text.resize(size);
    in.read(text.data(), static_cast<std::streamsize>(size));
    text.resize(static_cast<std::size_t>(in.gcount()));
  }
  char block[16 * 1024];
  while (in.read(block, sizeof(block)) || in.gcount() > 0) text.append(block, static_cast<std::size_t>(in.gcount()));
  return text;
}

/// Reports problems of the loaded rules: dropped parts of their texts, numbers between the ranges of two proposals, and
/// orders of conditions with very many partial matches.
void ReportTraps(CommandCall& call, int loaded) {
  const kernel::Agent& agent = call.agent();
  std::vector<const kernel::Production*> rules;
  for (const kernel::ProductionId id : agent.Productions()) rules.push_back(&agent.production(id));
  std::vector<Diagnostic>& traps = call.result.traps;
  std::ranges::copy_if(call.result.diagnostics, std::back_inserter(traps),
                       [](const Diagnostic& warning) { return warning.topic == Topic::kDroppedText; });
  const auto known = static_cast<std::ptrdiff_t>(traps.size());
  for (Diagnostic& gap : kernel::FindRuleGaps(rules, static_cast<std::size_t>(loaded), agent.symbols())) {
    traps.push_back(std::move(gap));
  }
  for (Diagnostic& crowd : FindRuleCrowds(rules, static_cast<std::size_t>(loaded), agent.symbols())) {
    traps.push_back(std::move(crowd));
  }
  call.result.diagnostics.insert(call.result.diagnostics.end(), traps.begin() + known, traps.end());
}

/// While it exists, relative names are resolved from the folder of a file, as after `pushd`.
class InFolderOf {
 public:
  InFolderOf(Interpreter& interpreter, const std::string& file) : interpreter_(interpreter) {
    const std::size_t end = file.rfind('/');
    if (end == std::string::npos || end + 1 == file.size()) return;
    folder_ = file.substr(0, end + 1);
    const std::filesystem::path before = interpreter_.directory();
    if (!interpreter_.ChangeDirectory(folder_)) {
      ok_ = false;
      return;
    }
    interpreter_.directory_stack().push_back(before);
    entered_ = true;
  }
  ~InFolderOf() {
    std::vector<std::filesystem::path>& stack = interpreter_.directory_stack();
    if (!entered_ || stack.empty()) return;
    interpreter_.GoBackTo(stack.back());
    stack.pop_back();
  }
  InFolderOf(const InFolderOf&) = delete;
  InFolderOf& operator=(const InFolderOf&) = delete;

  bool ok() const { return ok_; }
  const std::string& folder() const { return folder_; }

 private:
  Interpreter& interpreter_;
  std::string folder_;
  bool ok_ = true, entered_ = false;
};

/// Ends the output of a file: prints its counts if requested, and ends the line of stars.
void EndFile(CommandCall& call, SourceRun& run, const std::string& path) {
  if (run.per_file) call.Out(path + ": " + CountsText(run.counts, run.verbose));
  if (run.counts.sourced + run.counts.ignored > 0) {
    call.Out("\n");
    run.stars_pending = false;
  }
  run.total.sourced += run.counts.sourced;
  run.total.ignored += run.counts.ignored;
  run.total.excised.insert(run.total.excised.end(), run.counts.excised.begin(), run.counts.excised.end());
  run.counts = {};
}

/// The open files, outermost first, and the next one; if there are many, the first and the last ones.
std::string Chain(const SourceRun& run, const std::string& next) {
  constexpr std::size_t kMostAtEnd = 4;
  std::string text;
  for (std::size_t i = 0; i < run.files.size(); ++i) {
    if (i == kMostAtEnd && run.files.size() > 2 * kMostAtEnd) {
      i = run.files.size() - kMostAtEnd;
      text += "... -> ";
    }
    text += run.files[i].text() + " -> ";
  }
  return text + next;
}

/// Refuses a file that is open already, because it would source itself without end, and more than kMostFiles files.
bool MayOpen(CommandCall& call, SourceRun& run, const std::string& path) {
  if (std::ranges::any_of(run.files, [&](const auto& open) { return open.text() == path; }))
    return call.Fail("This file sources itself: " + Chain(run, path));
  if (++run.opened <= SourceRun::kMostFiles) return true;
  if (run.opened == SourceRun::kMostFiles + 1)
    call.Fail(fmt::format("More than {} files are sourced at once; the rest is left out: {}", SourceRun::kMostFiles,
                          Chain(run, path)));
  return false;
}

constexpr OptionSpec kFileOptions[] = {
    {'a', "all", OptionArgument::kNone, "count the rules of each file"},
    {'d', "disable", OptionArgument::kNone, "leave the total out"},
    {'v', "verbose", OptionArgument::kNone, "name the rules that were replaced"},
};

bool LoadFile(CommandCall& call) {
  ParsedWords parsed;
  if (!call.Parse(kFileOptions, parsed)) return false;
  if (parsed.arguments.empty()) {
    return call.Fail("Syntax: load file [--all | --disable | --verbose] <filename>");
  }
  const std::string file = call.interpreter.WithSlashes(parsed.arguments.front().text);
  std::filesystem::path path;
  if (!call.interpreter.ResolveForReading(call, file, path)) return false;
  const InFolderOf folder(call.interpreter, file);
  if (!folder.ok()) return call.Fail("Error changing to " + folder.folder());
  path = call.interpreter.Resolve(file.substr(folder.folder().size()));
  std::error_code error;
  std::ifstream in(path, std::ios::binary);
  if (!in || std::filesystem::is_directory(path, error)) {
    return call.Fail("Failed to open file for reading: " + file);
  }
  const bool is_image = path.extension() == ".soarx";
  const std::string content = is_image ? std::string() : TextOf(in, path);
  const std::string_view text = WithoutByteOrderMark(content);
  if (!is_image && call.interpreter.on_file_read) call.interpreter.on_file_read(path, content);

  SourceRun own;
  SourceRun*& current = call.interpreter.source_run();
  const bool outermost = current == nullptr;
  if (outermost) {
    current = &own;
    own.verbose = parsed.Has('v');
    own.per_file = parsed.Has('a');
    own.silent = parsed.Has('d');
  }
  SourceRun& run = *current;
  if (!MayOpen(call, run, path.string())) return false;
  if (run.verbose) call.Out("Sourcing " + path.filename().string() + ".\n");
  run.files.push_back(path.string());
  const bool ok = is_image ? LoadRuleImage(call, path.string()) : RunCommands(call, run, path.string(), text);
  run.files.pop_back();
  EndFile(call, run, path.string());
  if (!outermost) return ok;
  current = nullptr;

  if (run.total.sourced > 0) ReportTraps(call, run.total.sourced);
  FreshLine(call);
  if (!run.silent) call.Out("Total: " + CountsText(run.total, run.verbose));
  call.AddArgument("sourced-production-count", "int", std::to_string(run.total.sourced));
  call.AddArgument("excised-production-count", "int", std::to_string(run.total.excised.size()));
  call.AddArgument("ignored-production-count", "int", std::to_string(run.total.ignored));
  if (!ok) {
    call.Out("Error while sourcing file\n");
    call.failure = CommandCall::Failure::kReported;
  }
  return ok;
}

bool LoadLibrary(CommandCall& call) {
  return call.Fail("load library failed: Library not found.");
}

constexpr OptionSpec kReteOptions[] = {{'l', "load", OptionArgument::kRequired, "the file"},
                                       {'r', "restore", OptionArgument::kRequired, "the file"},
                                       {'s', "save", OptionArgument::kRequired, "write the image instead"}};

bool LoadRete(CommandCall& call) {
  ParsedWords parsed;
  if (!call.Parse(kReteOptions, parsed)) return false;
  // Older scripts use `rete-net -s FILE`, which also comes here.
  const auto save = parsed.Argument('s');
  if (save && parsed.arguments.empty()) return SaveRuleImage(call, *save);
  const auto load = parsed.Argument('l');
  const std::optional<std::string> file = load ? load : parsed.Argument('r');
  if (!file || !parsed.arguments.empty()) return call.Fail("Syntax: load rete-network --load <filename>");
  return LoadRuleImage(call, *file);
}

constexpr OptionSpec kPerceptsOptions[] = {{'o', "open", OptionArgument::kRequired, "the file"},
                                           {'c', "close", OptionArgument::kNone, "end the replay"}};

bool LoadPercepts(CommandCall& call) {
  ParsedWords parsed;
  if (!call.Parse(kPerceptsOptions, parsed)) return false;
  if (!parsed.arguments.empty()) return call.Fail("Syntax: load percepts [--open <filename> | --close]");
  std::unique_ptr<PerceptPlayer>& player = call.session.percept_player();
  const bool playing = player && player->playing();
  if (parsed.Has('c')) {
    if (!player) return call.Fail("Input is not being replayed: begin with 'load percepts --open FILE'.");
    if (call.interpreter.host().IsRunning(call.session)) {
      return call.Fail("The replay of input cannot be ended while the agent runs.");
    }
    player.reset();
    return true;
  }
  if (!parsed.Has('o')) {
    call.Out(playing ? "open" : "closed");
    return true;
  }
  if (playing) return call.Fail("Input is being replayed already: end that with 'load percepts --close'.");
  if (call.session.percept_recorder()) {
    return call.Fail("Input is being recorded: end that with 'save percepts --close' before a replay.");
  }
  if (call.interpreter.host().IsRunning(call.session)) {
    return call.Fail("A replay of input cannot begin while the agent runs.");
  }
  const std::string file = *parsed.Argument('o');
  std::error_code error;
  std::filesystem::path path;
  if (!call.interpreter.ResolveForReading(call, file, path)) return false;
  std::ifstream in(path, std::ios::binary);
  if (!in || std::filesystem::is_directory(path, error)) return call.Fail("Failed to open file for reading: " + file);
  std::ostringstream content;
  content << in.rdbuf();
  Result<PerceptFile> read = ReadPercepts(std::move(content).str(), file);
  if (!read) {
    call.Fail(fmt::format("{}:{}: {}", file, read.error().line, read.error().message));
    call.result.diagnostics.back() = read.error();
    return false;
  }
  const std::size_t changes = read->changes;
  player.reset();
  player = std::make_unique<PerceptPlayer>(call.agent(), *std::move(read),
                                           [&session = call.session](const std::string& line) {
                                             session.stream().FreshLine();
                                             session.stream().Print(line + "\n");
                                           });
  call.Out(fmt::format("Loaded {} actions.", changes));
  return true;
}

constexpr SubcommandInfo kLoadSubcommandList[] = {
    {"file", "[--all --disable --verbose] FILE", "carries out the commands of a file", kFileOptions, LoadFile},
    {"library", "NAME [ARGUMENTS]", "loads a library", {}, LoadLibrary},
    {"rete-network", "--load FILE", "replaces all rules with those of an image, and initialises the agent",
     kReteOptions, LoadRete},
    {"percepts", "[--open FILE | --close]", "replays recorded input instead of clients' input", kPerceptsOptions,
     LoadPercepts},
};

}  // namespace

const std::span<const SubcommandInfo> kLoadSubcommands = kLoadSubcommandList;

bool CommandLoad(CommandCall& call) {
  if (call.words.size() < 2) {
    return call.Fail("File type is required. \n\nUse 'load ?' or 'help load' to learn more about the load command.");
  }
  return RunSubcommand(call, {});
}

}  // namespace soarbox::cli
