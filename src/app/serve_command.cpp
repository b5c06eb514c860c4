// SPDX-License-Identifier: BSD-2-Clause
#include "app/serve_command.h"

#include <algorithm>
#include <charconv>
#include <iostream>

#include "app/data_folders.h"
#include "app/exit_codes.h"
#include "app/lesson.h"
#include "app/lesson_progress.h"
#include "app/refuse.h"
#include "diagnostics/problem.h"
#include "mission/test_missions.h"
#include "serve/server.h"
#include "sim/scenario.h"

namespace soarbox::app {
namespace {

namespace fs = std::filesystem;

/// Lessons and worlds that come with the program, read once.
class ShippedCatalog final : public serve::Catalog {
 public:
  explicit ShippedCatalog(const sim::DataFolders& data) {
    std::vector<Diagnostic> problems;
    for (const Lesson& lesson : ReadLessons(ShippedLessons(data), data, problems))
      lessons_.push_back({lesson.name, lesson.title});
    for (const Diagnostic& problem : problems) std::cerr << Format(problem);
    for (const std::string& name : sim::ListScenarios(data))
      scenarios_.push_back({name, sim::DescribeScenario(name, data)});
  }
  std::vector<serve::Lesson> Lessons() const override { return lessons_; }
  std::vector<Scenario> Scenarios() const override { return scenarios_; }
  serve::Progress ProgressOf(const fs::path& state, const std::string& lesson) const override {
    const LessonProgress progress = LessonProgress::Below(state);
    return {progress.IsPassed(lesson), progress.Get(lesson, "attempts"), progress.Get(lesson, "hints")};
  }

 private:
  std::vector<serve::Lesson> lessons_;
  std::vector<Scenario> scenarios_;
};

/// Letters, digits and what joins them: no path.
bool IsPlainName(std::string_view name) {
  return !name.empty() && name.size() <= 100 && name.front() != '.' && std::ranges::all_of(name, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_' ||
           c == '.';
  });
}

/// The program of an engine and its arguments.
std::vector<std::string> EngineFor(const std::string& what, const serve::Place& place, const ServeOptions& options,
                                   const std::string& program, const ShippedCatalog& catalog) {
  std::vector<std::string> words = {
      program, "engine", "--home", place.home().string(), "--memory", std::to_string(options.memory_mb)};
  const std::size_t colon = what.find(':');
  const std::string kind = what.substr(0, colon), name = colon == std::string::npos ? "" : what.substr(colon + 1);
  if (!IsPlainName(name)) return {};
  if (kind == "recording") {
    const Result<fs::path> file = place.FindRecording(name);
    if (!file) return {};
    words.insert(words.end(), {"--recording", file->string()});
    return words;
  }
  const auto is_it = [&](const auto& each) { return each.name == name; };
  if (kind == "lesson") {
    if (std::ranges::none_of(catalog.Lessons(), is_it)) return {};
    words.insert(words.end(), {"--lesson", name});
    return words;
  }
  if (kind != "scenario") return {};
  const bool is_own = fs::is_directory(place.home() / "worlds" / name);
  if (!is_own && std::ranges::none_of(catalog.Scenarios(), is_it)) return {};
  words.insert(words.end(), {"--world", name});
  return words;
}

Result<void> ReadListen(const std::string& listen, serve::Settings& settings) {
  const std::size_t colon = listen.rfind(':');
  std::string address = listen.substr(0, colon);
  if (address.starts_with('[') && address.ends_with(']')) address = address.substr(1, address.size() - 2);
  int port = -1;
  const char* const begin = listen.data() + (colon == std::string::npos ? listen.size() : colon + 1);
  const auto [at, error] = std::from_chars(begin, listen.data() + listen.size(), port);
  if (error != std::errc{} || at != listen.data() + listen.size() || port < 0 || port > 65535)
    return NewProblem("--listen " + listen + " is no address with a port", "write it as 127.0.0.1:8080 or [::1]:8080");
  settings.address = address;
  settings.port = static_cast<std::uint16_t>(port);
  return {};
}

bool IsThisMachine(const std::string& address) {
  return address.starts_with("127.") || address == "::1";
}

}  // namespace

int ServePages(const ServeOptions& options) {
  const Result<sim::DataFolders> data = FindDataFolders();
  if (!data) return Refuse(data.error());
  serve::Settings settings;
  if (const Result<void> read = ReadListen(options.listen, settings); !read) {
    std::cerr << Format(read.error());
    return kUsage;
  }
  if (!IsThisMachine(settings.address) && options.token.empty() && !options.open) {
    std::cerr << Format(
        NewProblem("others than you could reach this address: the server needs a token",
                   "add --token SECRET, or --open if anybody who reaches it may run worlds on this machine"));
    return kUsage;
  }
  if (options.open && !IsThisMachine(settings.address))
    std::cerr << "soarbox: warning: ANYBODY WHO REACHES " << settings.address
              << " CAN RUN WORLDS ON THIS MACHINE (--open)\n";
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (error) return Refuse("the program does not find itself: " + error.message());
  auto catalog = std::make_unique<const ShippedCatalog>(*data);
  settings.token = options.token;
  settings.hosts = options.hosts;
  settings.proxies = options.proxies;
  settings.state = fs::absolute(options.state.empty() ? mission::StateFolder("serve") : options.state, error);
  settings.page = options.page.empty() ? PageFolder(*data) : options.page;
  settings.class_list = options.class_list;
  settings.version = "1";
  settings.limits.sessions = options.sessions;
  settings.limits.engine_mb = options.memory_mb;
  settings.limits.idle_min = options.idle_min;
  if (!options.scenario.empty()) settings.opens = "scenario:" + options.scenario;
  settings.engine = [&options, program = program.string(), shipped = catalog.get()](const std::string& what,
                                                                                    const serve::Place& place) {
    return EngineFor(what, place, options, program, *shipped);
  };
  const Result<void> served =
      serve::Serve(std::move(settings), std::move(catalog), [](const std::vector<serve::Address>& links) {
        std::cout << "Open " << links.front().link << " in a browser. Ctrl-C ends the server.\n";
        for (std::size_t i = 1; i < links.size(); ++i)
          std::cout << "  " << links[i].name << ": " << links[i].link << '\n';
        std::cout.flush();
      });
  return served ? static_cast<int>(kOk) : Refuse(served.error());
}

}  // namespace soarbox::app
