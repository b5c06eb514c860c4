// SPDX-License-Identifier: BSD-2-Clause
#include "cli/interpreter.h"

#include <algorithm>
#include <new>
#include <system_error>

#include "cli/command.h"
#include "cli/tokens.h"

namespace soarbox::cli {
namespace {

/// Maximum nesting of commands (sourced files, rules that run commands), so that the program's stack does not overflow.
constexpr int kMaxDepth = 50;
/// Maximum size of a file that a command reads. Files with hundreds of thousands of rules are smaller.
constexpr std::uintmax_t kMostFileBytes = 256u << 20;

void CloseFailure(CommandResult& result, CommandCall::Failure failure) {
  result.ok = false;
  switch (failure) {
    case CommandCall::Failure::kWithMessage:
      result.text += "\nError while sourcing file\n";
      break;
    case CommandCall::Failure::kWithoutMessage:
      result.text += "command failed (see return string for details)\n";
      break;
    case CommandCall::Failure::kPlain:
      result.text += "\n";
      break;
    case CommandCall::Failure::kReported:
    case CommandCall::Failure::kNone:
      break;
  }
}

/// Whether the reply of this command moves the column at which the next objects are wrapped: Soar's printer counts the
/// tables of these commands, although they are not output of the agent.
bool MovesColumn(std::string_view command, std::span<const Word> words, bool ok) {
  const std::string_view second = words.size() > 1 ? std::string_view(words[1].text) : std::string_view();
  if (command == "chunk") return ok && !second.starts_with("max-");
  if (command == "explain") return ok || second == "record" || second == "list";
  for (const std::string_view name : {"decide", "load", "output", "production", "save", "smem", "soar"}) {
    if (command == name) return second == "?" || (ok && second.empty());
  }
  return false;
}

}  // namespace

Interpreter::Interpreter(Host* host) : host_(host ? host : &default_host_) {
  std::error_code error;
  directory_ = std::filesystem::current_path(error);
  if (error) directory_ = "/";
}

Interpreter::~Interpreter() = default;

CommandResult Interpreter::Execute(Session& session, std::string_view line) {
  CommandResult result;
  session.Log(session.name() + "> " + std::string(line) + "\n");
  CommandReader reader(line);
  std::vector<Word> words;
  while (true) {
    const CommandReader::Status status = reader.Next(words);
    if (status == CommandReader::Status::kEnd) break;
    if (status == CommandReader::Status::kError) {
      result.ok = false;
      result.text += reader.error() + "\n";
      Diagnostic diagnostic;
      diagnostic.line = reader.error_line();
      diagnostic.column = reader.error_column();
      diagnostic.message = reader.error();
      result.diagnostics.push_back(std::move(diagnostic));
      break;
    }
    CommandCall call{*this, session, {}, result};
    if (!ExecuteWords(call, words)) {
      CloseFailure(result, call.failure);
      break;
    }
  }
  session.stream().ToConsole(result.text);
  session.Log(result.text);
  if (session.log_open() && (result.text.empty() || result.text.back() != '\n')) session.Log("\n");
  return result;
}

bool Interpreter::ExecuteWords(CommandCall& call, std::vector<Word>& words) {
  if (words.empty()) return true;
  if (depth_ >= kMaxDepth) return call.Fail("Commands are nested too deeply: a file may source itself.");
  aliases_.Expand(words);
  if (words.empty()) return true;
  std::string error;
  const CommandInfo* command = FindCommand(words.front().text, error);
  if (!command) {
    call.Out(error);
    call.failure = CommandCall::Failure::kPlain;
    const std::string nearest = NearestCommand(words.front().text, aliases_.All());
    Diagnostic diagnostic;
    diagnostic.line = words.front().line;
    diagnostic.column = words.front().column;
    diagnostic.message = "no such command '" + words.front().text + "'";
    if (!nearest.empty()) diagnostic.hint = "did you mean '" + nearest + "'?";
    call.result.diagnostics.push_back(std::move(diagnostic));
    return false;
  }
  words.front().text = command->name;
  const std::span<const Word> outer = call.words;
  call.words = words;
  const std::size_t length = call.result.text.size();
  ++depth_;
  bool ok = false;
  try {
    const Fence::Answer may = fence_ ? fence_->Ask(words) : Fence::Answer{};
    ok = may.carry_out ? command->handler(call) : may.refusal.empty() || call.Fail(may.refusal);
  } catch (const std::bad_alloc&) {
    // The likely cause is a very large reply, because runs of agents limit their own output.
    call.result.text = std::string();
    call.Fail("There is no memory for this command.");
  }
  --depth_;
  call.words = outer;
  if (call.result.text.size() > length && MovesColumn(command->name, words, ok)) {
    const std::string_view answer = std::string_view(call.result.text).substr(length);
    const bool ends_line = command->name == std::string_view("explain") || answer.find('\n') == std::string_view::npos;
    call.stream().SetColumn(ends_line ? 0 : static_cast<int>(answer.size() - answer.rfind('\n') - 1));
  }
  if (!ok && call.failure == CommandCall::Failure::kNone) call.failure = CommandCall::Failure::kWithoutMessage;
  return ok;
}

std::filesystem::path Interpreter::Resolve(const std::string& file) const {
  std::filesystem::path path(file);
  if (path.is_absolute()) return path.lexically_normal();
  return (directory_ / path).lexically_normal();
}

std::string Interpreter::WithSlashes(const std::string& file) const {
  std::error_code error;
  if (file.find('\\') == std::string::npos || std::filesystem::exists(Resolve(file), error)) return file;
  std::string slashes = file;
  std::replace(slashes.begin(), slashes.end(), '\\', '/');
  return std::filesystem::exists(Resolve(slashes), error) ? slashes : file;
}

std::string WithWholeFileName(const Interpreter& interpreter, std::string_view line) {
  CommandReader reader(line);
  std::vector<Word> words, next;
  const bool is_one = reader.Next(words) == CommandReader::Status::kCommand && words.size() > 1 &&
                      reader.Next(next) == CommandReader::Status::kEnd;
  if (!is_one || (words.front().text != "source" && words.front().text != "load")) return std::string(line);
  std::string whole = words.front().text;
  bool is_found = false;
  for (std::size_t i = 1; i < words.size(); ++i) {
    const std::string& word = words[i].text;
    std::error_code error;
    const std::filesystem::path file =
        std::filesystem::canonical(interpreter.Resolve(interpreter.WithSlashes(word)), error);
    const bool is_file = !is_found && !word.starts_with('-') && std::filesystem::is_regular_file(file, error);
    whole += " " + (is_file ? QuoteWord(file.string()) : word);
    is_found = is_found || is_file;
  }
  return is_found ? whole : std::string(line);
}

bool Interpreter::ResolveForReading(CommandCall& call, const std::string& file, std::filesystem::path& path) const {
  path = Resolve(file);
  if (fence_ && !fence_->MayRead(path))
    return call.Fail("The files of a scenario may read plain files in its folder only: " + file);
  // For special files, file_size reports an error: they have no limit.
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  return error || size <= kMostFileBytes ||
         call.Fail("This file is too large, " + std::to_string(size >> 20) + " MB: " + file);
}

bool Interpreter::ResolveForWriting(CommandCall& call, const std::string& file, std::filesystem::path& path) const {
  path = Resolve(file);
  return !fence_ || call.Fail("The files of a scenario may not write files: " + file);
}

bool Interpreter::ChangeDirectory(const std::string& path) {
  std::error_code error;
  std::filesystem::path target = std::filesystem::canonical(Resolve(path), error);
  if (error || !std::filesystem::is_directory(target, error)) return false;
  if (fence_ && !fence_->MayRead(target)) return false;
  directory_ = std::move(target);
  return true;
}

void Interpreter::GoBackTo(std::filesystem::path directory) {
  directory_ = std::move(directory);
}

}  // namespace soarbox::cli
