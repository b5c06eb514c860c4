// SPDX-License-Identifier: BSD-2-Clause
#include "app/soar_shell.h"

#include <pthread.h>
#include <signal.h>
#include <unistd.h>

#include <atomic>
#include <cstdio>
#include <iostream>
#include <optional>
#include <string>
#include <system_error>
#include <thread>

#include "app/diagnostic_json.h"
#include "app/exit_codes.h"
#include "app/line_editor.h"
#include "cli/interpreter.h"
#include "cli/session.h"
#include "cli/tokens.h"
#include "kernel/agent.h"

namespace soarbox::app {
namespace {

constexpr const char* kPrompt = "soar> ";
constexpr const char* kContinuation = "    > ";
constexpr const char* kColourPrompt = "\1\033[1;36m\1soar>\1\033[0m\1 ";
constexpr const char* kRed = "\033[31m";
constexpr const char* kPlain = "\033[0m";

/// Converts Ctrl-C to a request to stop while commands run. The signal is blocked in all threads and awaited by a
/// thread of its own, so that no signal handler runs. Without threads, Ctrl-C ends the program.
class InterruptWatch {
 public:
  explicit InterruptWatch(kernel::Agent& agent) : agent_(agent) {
    sigemptyset(&signals_);
    sigaddset(&signals_, SIGINT);
    sigaddset(&signals_, SIGUSR1);
    pthread_sigmask(SIG_BLOCK, &signals_, nullptr);
    try {
      thread_ = std::thread([this] { Watch(); });
    } catch (const std::system_error&) {
      pthread_sigmask(SIG_UNBLOCK, &signals_, nullptr);
    }
  }
  ~InterruptWatch() {
    if (!thread_.joinable()) return;
    ending_ = true;
    pthread_kill(thread_.native_handle(), SIGUSR1);
    thread_.join();
  }
  InterruptWatch(const InterruptWatch&) = delete;
  InterruptWatch& operator=(const InterruptWatch&) = delete;

  void SetBusy(bool busy) { busy_ = busy; }

 private:
  void Watch() {
    int signal = 0;
    while (sigwait(&signals_, &signal) == 0 && !ending_) {
      if (signal != SIGINT) continue;
      if (busy_) {
        agent_.RequestStop("interrupted by Ctrl-C");
      } else {
        std::fputs("\n(end with Ctrl-D or 'exit')\n", stderr);
      }
    }
  }

  kernel::Agent& agent_;
  sigset_t signals_;
  std::atomic<bool> busy_ = false;
  std::atomic<bool> ending_ = false;
  std::thread thread_;
};

/// Number of braces that a text leaves open. Braces between bars or quotes, in comments and after backslashes do not
/// count.
int OpenBraces(std::string_view text) {
  int open = 0;
  char quote = 0;
  bool in_comment = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_comment) {
      in_comment = c != '\n';
    } else if (c == '\\') {
      ++i;
    } else if (quote != 0) {
      if (c == quote) quote = 0;
    } else if (c == '|' || c == '"') {
      quote = c;
    } else if (c == '#' && open == 0) {
      in_comment = true;
    } else if (c == '{') {
      ++open;
    } else if (c == '}') {
      --open;
    }
  }
  return open;
}

bool IsExit(std::string_view line) {
  const std::size_t first = line.find_first_not_of(" \t");
  const std::size_t last = line.find_last_not_of(" \t\r");
  if (first == std::string_view::npos) return false;
  line = line.substr(first, last - first + 1);
  return line == "exit" || line == "quit";
}

class Shell {
 public:
  explicit Shell(const SoarShellOptions& options)
      : json_(options.json),
        terminal_(isatty(STDIN_FILENO) != 0 && !options.json),
        colour_(isatty(STDOUT_FILENO) != 0 && std::getenv("NO_COLOR") == nullptr),
        watch_(agent_) {
    session_.stream().SetSink([this](std::string_view text) { Print(text); });
    session_.stream().SetSinkIsConsole(true);
  }

  int Run(const SoarShellOptions& options) {
    for (const std::filesystem::path& file : options.files) Execute("source " + cli::QuoteWord(file.string()));
    if (terminal_) {
      std::puts("Soarbox's Soar shell. 'help' lists the commands; Tab completes; Ctrl-C stops a run; Ctrl-D ends.");
      ReadTerminal();
      return kOk;
    }
    ReadPipe();
    return failures_ == 0 ? kOk : kProblems;
  }

 private:
  void ReadTerminal() {
    LineEditor editor([this](std::string_view line) { return interpreter_.Complete(session_, line); });
    std::string command;
    while (true) {
      const char* prompt = !command.empty() ? kContinuation : colour_ ? kColourPrompt : kPrompt;
      const std::optional<std::string> line = editor.Read(prompt);
      if (!line) break;
      if (!line->empty()) editor.Remember(*line);
      if (!Take(*line, command)) return;
    }
    std::putchar('\n');
  }

  void ReadPipe() {
    std::string command, line;
    while (std::getline(std::cin, line)) {
      if (!Take(line, command)) return;
    }
    // An incomplete command at the end is executed, so that its error is printed.
    if (!command.empty()) Execute(command);
  }

  /// Adds a line to the command, and executes the command if its braces are closed. False if the line ends the shell.
  bool Take(const std::string& line, std::string& command) {
    if (command.empty() && IsExit(line)) return false;
    command += line;
    if (OpenBraces(command) > 0) {
      command += '\n';
      return true;
    }
    Execute(command);
    command.clear();
    return true;
  }

  void Execute(const std::string& command) {
    if (command.find_first_not_of(" \t\r\n") == std::string::npos) return;
    printed_.clear();
    watch_.SetBusy(true);
    const cli::CommandResult result = interpreter_.Execute(session_, command);
    watch_.SetBusy(false);
    if (!result.ok) ++failures_;
    if (json_) {
      WriteJson(command, result);
    } else {
      WriteText(result);
    }
  }

  void Print(std::string_view text) {
    if (json_) {
      printed_ += text;
    } else {
      std::fwrite(text.data(), 1, text.size(), stdout);
      std::fflush(stdout);
    }
  }

  void WriteText(const cli::CommandResult& result) {
    const bool red = colour_ && !result.ok;
    if (red) std::fputs(kRed, stdout);
    std::fwrite(result.text.data(), 1, result.text.size(), stdout);
    if (!result.text.empty() && result.text.back() != '\n') std::fputc('\n', stdout);
    if (red) std::fputs(kPlain, stdout);
    // Prints the hints of errors that the text does not contain yet. Errors in sourced files already have theirs.
    for (const Diagnostic& diagnostic : result.diagnostics) {
      if (diagnostic.severity != Severity::kError || diagnostic.hint.empty()) continue;
      if (result.text.find(diagnostic.hint) != std::string::npos) continue;
      std::fputs(("   note: " + diagnostic.hint + "\n").c_str(), stdout);
    }
    std::fflush(stdout);
  }

  void WriteJson(const std::string& command, const cli::CommandResult& result) {
    Json json;
    json["command"] = command;
    json["ok"] = result.ok;
    if (!printed_.empty()) json["printed"] = printed_;
    json["text"] = result.text;
    if (!result.structured.children.empty()) json["result"] = ToJson(result.structured);
    for (const Diagnostic& diagnostic : result.diagnostics) json["diagnostics"].push_back(app::ToJson(diagnostic));
    std::puts(JsonText(json).c_str());
    std::fflush(stdout);
  }

  static Json ToJson(const cli::ResultNode& node) {
    Json json;
    json["tag"] = node.tag;
    for (const auto& [name, value] : node.attributes) json["attributes"][name] = value;
    if (!node.text.empty()) json["text"] = node.text;
    for (const cli::ResultNode& child : node.children) json["children"].push_back(ToJson(child));
    return json;
  }

  bool json_;
  bool terminal_;
  bool colour_;
  std::string printed_;
  std::size_t failures_ = 0;
  kernel::Agent agent_{"soar"};
  cli::Session session_{agent_};
  cli::Interpreter interpreter_;
  InterruptWatch watch_;
};

}  // namespace

int RunSoarShell(const SoarShellOptions& options) {
  return Shell(options).Run(options);
}

}  // namespace soarbox::app
