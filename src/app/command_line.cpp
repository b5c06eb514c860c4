// SPDX-License-Identifier: BSD-2-Clause
#include "app/command_line.h"

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <new>
#include <streambuf>
#include <string>
#include <string_view>

#include "app/argument_kinds.h"
#include "app/command_options.h"
#include "app/commit.h"
#include "app/completion.h"
#include "app/data_folders.h"
#include "app/exit_codes.h"
#include "app/next_run.h"
#include "app/page_server.h"
#include "app/refuse.h"
#include "app/run_session.h"
#include "app/sibling_program.h"
#include "app/usage_errors.h"
#include "app/usage_text.h"
#include "app/window.h"
#include "mission/testing.h"
#include "record/client_recording.h"
#include "record/header.h"
#include "record/manifest.h"
#include "sim/scenario.h"
#include "world/shared_navigation.h"

namespace soarbox::app {
namespace {

int List() {
  const Result<sim::DataFolders> data = FindDataFolders();
  if (!data) {
    std::cerr << Format(data.error());
    return kCannotStart;
  }
  for (const std::string& name : sim::ListScenarios(data.value())) {
    const std::string about = sim::DescribeScenario(name, data.value());
    std::cout << name << std::string(name.size() < 16 ? 16 - name.size() : 1, ' ') << about << '\n';
  }
  return kOk;
}

/// Call it after a window has closed. If its user requested another run, opens that in a new window, and so on. Returns
/// the exit code of the last one, or `code`.
int FollowedByOthers(int code, const RunOptions& first) {
  while (const auto next = TakeNextRun()) {
    if (next->is_recording) {
      RecordingOptions recording;
      recording.file = next->what;
      static_cast<WindowWishes&>(recording) = first;
      recording.ui_script_from = next->script_line;
      code = Replay(recording);
    } else {
      // Options that concern only the first run (an agent, inputs, a duration, the file of its recording) do not apply
      // to it.
      RunOptions run;
      run.scenario = next->what;
      run.lesson = next->lesson;
      run.speed = first.speed;
      static_cast<WindowWishes&>(run) = first;
      run.port = first.port;
      run.no_record = first.no_record;
      run.ui_script_from = next->script_line;
      code = Run(run);
    }
  }
  return code;
}

/// The default address of Soar kernels.
constexpr const char* kUsualKernel = "127.0.0.1:12121";

/// Executes a command that serves pages. If this program has no server, replaces it by soarbox-serve.
int WithServer(const PageServer* server, char** argv, const CommandOptions& options, bool is_replay) {
  if (server == nullptr) {
    GoOnAs("soarbox-serve", argv);
    return Refuse("this build has no server for browsers",
                  "./dev serve builds it, which puts soarbox-serve beside this program");
  }
  if (options.run.browser)
    return server->Show(
        {options.run.scenario, {}, options.run.seed, options.run.page, options.run.dis, options.run.follow});
  if (is_replay) return server->Show({{}, options.recording.file, {}, options.recording.page, {}, {}});
  return server->Serve(options.serve);
}

int Main(int argc, char** argv, const ProgramParts& parts) {
  CLI::App program("Soarbox: a 3D sandbox in which people learn and develop Soar agents", "soarbox");
  program.set_version_flag("--version", VersionText);
  program.require_subcommand(1);
  CommandOptions options;
  AddCommands(program, options);
  NameArguments(program);
  AddUsageTexts(program);
  if (argc > 1 && std::string_view(argv[1]) == "complete") {
    PrintCandidates(program, {argv + 2, argv + argc}, std::cout);
    return kOk;
  }
  if (const auto problem = FindSingleDash(program, argc, argv)) {
    std::cerr << Format(*problem);
    return kUsage;
  }
  if (const auto problem = FindMissingValue(program, argc, argv)) {
    std::cerr << Format(*problem);
    return kUsage;
  }
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    // The library reports --help and --version as errors with the exit code of success.
    if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) {
      program.exit(error);
      return kOk;
    }
    if (argc == 1) {
      std::cerr << program.help();
    } else {
      std::cerr << Format(ExplainUsage(program, error));
    }
    return kUsage;
  }
  // Recordings of an engine do not contain its command line: users get them, and the server made the command line.
  record::SetOrigin({Commit(), program.got_subcommand("engine") ? std::vector<std::string>()
                                                                : std::vector<std::string>(argv, argv + argc)});
  // Other programs store navigation meshes in files. An engine must not leave files, so it keeps them in memory for
  // restarts of its world.
  if (program.got_subcommand("engine")) {
    world::ShareNavigation();
  } else {
    world::KeepNavigation(mission::StateFolder("navigation"), record::BuildId());
  }
  if (const Result<sim::DataFolders> data = FindDataFolders()) record::SetDataFolders(*data);
  // SOARBOX_RECORD is only for kernels that clients use, not for the kernels of worlds.
  if (!program.got_subcommand("kernel")) unsetenv("SOARBOX_RECORD");
  const bool is_replay = program.got_subcommand("replay");
  if (program.got_subcommand("watch") && options.run.follow.empty()) options.run.follow = kUsualKernel;
  if (program.got_subcommand("serve") || options.run.browser || (is_replay && options.recording.browser))
    return WithServer(parts.server, argv, options, is_replay);
  // The other program repeats everything from the beginning, so it is started before anything is done.
  const bool is_run = program.got_subcommand("run") || program.got_subcommand("watch");
  if ((is_run && !options.run.headless) || (program.got_subcommand("learn") && !options.learn.headless) ||
      (is_replay && !NeedsNoWindow(options.recording))) {
    GoOnInWindow(argv);
  }
  if (is_run) return FollowedByOthers(Run(options.run), options.run);
  if (program.got_subcommand("learn")) return FollowedByOthers(Learn(options.learn), options.learn.window);
  if (is_replay && !NeedsNoWindow(options.recording) && CanOpenWindow()) {
    static_cast<WindowWishes&>(options.run) = options.recording;
    return FollowedByOthers(Replay(options.recording), options.run);
  }
  if (program.got_subcommand("help")) return Help(program, options.help, SOARBOX_VERSION);
  if (program.got_subcommand("list")) return List();
  if (parts.windowless == nullptr) {
    GoOnAs("soarbox", argv);
    return Refuse("this program does not have this command", "soarbox has it; ./dev build release builds it");
  }
  return parts.windowless(program.get_subcommands().front()->get_name(), options);
}

/// Prints that the memory is exhausted. Can be called on any thread, and allocates nothing.
void TellNoMemory() {
  static const char kText[] =
      "soarbox: error: out of memory\n"
      "   note: the system has less memory than the world may use (--memory, by default 2048 MB); a recording "
      "contains what happened up to here\n";
  [[maybe_unused]] const auto written = write(STDERR_FILENO, kText, sizeof kText - 1);
}

[[noreturn]] void EndOnTerminate() {
  if (const std::exception_ptr thrown = std::current_exception()) {
    try {
      std::rethrow_exception(thrown);
    } catch (const std::bad_alloc&) {
      TellNoMemory();
      _exit(kCannotStart);
    } catch (...) {
    }
  }
  std::abort();
}

/// Forwards all writes to the buffer of a stream, and stores errno of the first one that fails. Streams themselves do
/// not report it. Has no buffer of its own, so several threads may write.
class OutputErrors final : public std::streambuf {
 public:
  explicit OutputErrors(std::ostream& stream) : stream_(stream), buffer_(stream.rdbuf(this)) {}
  ~OutputErrors() override { stream_.rdbuf(buffer_); }
  OutputErrors(const OutputErrors&) = delete;
  OutputErrors& operator=(const OutputErrors&) = delete;

  /// 0 if no write failed.
  int first_error() const { return first_error_; }

 protected:
  int_type overflow(int_type letter) override {
    if (traits_type::eq_int_type(letter, traits_type::eof())) return traits_type::not_eof(letter);
    const int_type written = buffer_->sputc(traits_type::to_char_type(letter));
    if (traits_type::eq_int_type(written, traits_type::eof())) StoreError();
    return written;
  }
  std::streamsize xsputn(const char* text, std::streamsize size) override {
    const std::streamsize written = buffer_->sputn(text, size);
    if (written != size) StoreError();
    return written;
  }
  int sync() override {
    const int result = buffer_->pubsync();
    if (result != 0) StoreError();
    return result;
  }

 private:
  void StoreError() {
    int none = 0;
    first_error_.compare_exchange_strong(none, errno);
  }

  std::ostream& stream_;
  std::streambuf* buffer_;
  std::atomic<int> first_error_ = 0;
};

}  // namespace

int CommandLine(int argc, char** argv, const ProgramParts& parts) {
  SetProgramWindow(parts.window);
  if (parts.window != nullptr) BeThatBuild();
  std::set_terminate(EndOnTerminate);
  // At the limit of a file's size, the write then fails with an error instead of a signal that ends the program.
  std::signal(SIGXFSZ, SIG_IGN);
  const OutputErrors output(std::cout);
  try {
    const int code = Main(argc, argv, parts);
    std::cout.flush();
    if (std::cout) return code;
    // The program that reads the output has ended, as after `| head`. Without signals (in WebAssembly, or if the parent
    // process ignores SIGPIPE), only the error code shows it.
    if (WasInterrupted() || output.first_error() == EPIPE) return 128 + SIGPIPE;
    std::cerr << "soarbox: error: standard output cannot be written; is the disk full?\n";
    return kCannotStart;
  } catch (const std::bad_alloc&) {
    TellNoMemory();
    return kCannotStart;
  } catch (const std::exception& error) {
    std::cerr << "soarbox: error: " << error.what() << '\n';
    return kCannotStart;
  }
}

}  // namespace soarbox::app
