// SPDX-License-Identifier: BSD-2-Clause
#include "app/server/serve_pages.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <iostream>
#include <thread>

#include "app/data_folders.h"
#include "app/exit_codes.h"
#include "app/refuse.h"
#include "app/shipped_catalog.h"
#include "app/sibling_program.h"
#include "diagnostics/problem.h"
#include "diagnostics/read_text.h"
#include "mission/testing.h"
#include "record/reader.h"
#include "serve/random_id.h"
#include "serve/server.h"
#include "serve/wall.h"

namespace soarbox::app {
namespace {

namespace fs = std::filesystem;

/// The folder of a scenario that is not one of the program's; empty: none.
fs::path FolderOf(const std::string& scenario) {
  std::error_code error;
  const fs::path path = fs::absolute(scenario, error).lexically_normal();
  const fs::path folder = path.filename().empty() ? path.parent_path() : path;
  return !scenario.empty() && fs::is_directory(folder, error) ? folder : fs::path();
}

/// The program of an engine and its arguments.
std::vector<std::string> EngineFor(const std::string& what, const serve::Place& place, const ServeOptions& options,
                                   const std::string& program, const ShippedCatalog& catalog, const fs::path& state) {
  std::vector<std::string> words = {program, "engine", "--home", "home", "--memory", std::to_string(options.memory_mb)};
  if (!options.no_wall) words.emplace_back("--walled");
  if (options.dis) words.emplace_back("--join");
  const std::size_t colon = what.find(':');
  const std::string kind = what.substr(0, colon), name = colon == std::string::npos ? "" : what.substr(colon + 1);
  if (!IsPlainName(name)) return {};
  if (kind == "match") {
    const fs::path file = state / "arena" / "matches" / name / "state" / "match.soarrec";
    if (!serve::IsId(name) || !fs::exists(file)) return {};
    words.insert(words.end(), {"--recording", file.string()});
    return words;
  }
  if (kind == "recording") {
    const Result<fs::path> file = place.FindRecording(name);
    if (!file) return {};
    // The process starts in the folder of its place.
    words.insert(words.end(), {"--recording", file->lexically_relative(place.root()).string()});
    return words;
  }
  const auto is_it = [&](const auto& each) { return each.name == name; };
  if (kind == "lesson") {
    if (std::ranges::none_of(catalog.Lessons(), is_it)) return {};
    words.insert(words.end(), {"--lesson", name});
    return words;
  }
  if (kind != "scenario") return {};
  words.insert(words.end(), {"--world", name});
  std::error_code error;
  if (fs::is_directory(place.home() / "worlds" / name, error)) return words;
  if (const fs::path folder = FolderOf(options.scenario); !folder.empty() && folder.filename() == name) {
    words.insert(words.end(), {"--from", folder.string()});
    return words;
  }
  return std::ranges::any_of(catalog.Scenarios(), is_it) ? words : std::vector<std::string>();
}

Result<void> ReadListen(const std::string& listen, serve::Settings& settings) {
  const std::size_t colon = listen.rfind(':');
  std::string address = listen.substr(0, colon);
  if (address.starts_with('[') && address.ends_with(']')) address = address.substr(1, address.size() - 2);
  int port = -1;
  const char* const begin = listen.data() + (colon == std::string::npos ? listen.size() : colon + 1);
  const auto [at, error] = std::from_chars(begin, listen.data() + listen.size(), port);
  if (error != std::errc{} || at != listen.data() + listen.size() || port < 0 || port > 65535)
    return NewProblem("--listen " + listen + " is not an address with a port",
                      "write it as 127.0.0.1:8080 or [::1]:8080");
  settings.address = address;
  settings.port = static_cast<std::uint16_t>(port);
  return {};
}

/// Whether a text is an origin, "https://school.example:8443": a scheme, a name and an optional port.
bool IsOrigin(std::string_view site) {
  const std::size_t name = site.starts_with("https://") ? 8 : site.starts_with("http://") ? 7 : std::string_view::npos;
  return name < site.size() && std::ranges::all_of(site.substr(name), [](char c) {
           return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '.' ||
                  c == ':';
         });
}

bool IsThisMachine(const std::string& address) {
  return address.starts_with("127.") || address == "::1";
}

/// Returns the token from the command line, from a file, or from the environment, which other users of this machine
/// cannot see.
Result<std::string> TokenOf(const ServeOptions& options) {
  std::string token = options.token;
  if (!options.token_file.empty()) {
    const std::optional<std::string> text = ReadText(options.token_file);
    if (!text) return ProblemIn(options.token_file, "this token file cannot be read");
    token = text->substr(0, text->find_first_of("\r\n"));
    if (token.empty())
      return ProblemIn(options.token_file, "the first line of this file is the token, and it is empty");
  } else if (const char* kept = std::getenv("SOARBOX_TOKEN"); token.empty() && kept != nullptr && !options.open) {
    token = kept;
  }
  // A browser sends it as the name of a WebSocket subprotocol.
  const bool is_good = std::ranges::all_of(token, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           std::string_view("-_.~!$*+").find(c) != std::string_view::npos;
  });
  if (!is_good)
    return NewProblem("this token cannot be used: a browser can send letters, digits and -_.~!$*+ only",
                      "choose another one, without blanks");
  return token;
}

/// Settings that both commands have in common; the error says why pages cannot be served.
Result<serve::Settings> SettingsFor(const ServeOptions& options, const sim::DataFolders& data) {
  serve::Settings settings;
  if (const Result<void> read = ReadListen(options.listen, settings); !read) return read.error();
  std::error_code error;
  const Result<std::string> token = TokenOf(options);
  if (!token) return token.error();
  settings.token = *token;
  settings.hosts = options.hosts;
  settings.proxies = options.proxies;
  for (const std::string& site : options.embedders) {
    if (!IsOrigin(site))
      return NewProblem("--embed " + site + " is not a site", "write it as https://school.example, without a path");
    settings.embedders.push_back(site);
  }
  settings.state = fs::absolute(options.state.empty() ? mission::StateFolder("serve") : options.state, error);
  settings.page = options.page.empty() ? PageFolder(data) : options.page;
  settings.class_list = options.class_list;
  settings.lti = options.lti;
  settings.limits.sessions = options.sessions;
  settings.limits.idle_min = options.idle_min;
  settings.limits.hang_s = options.hang_s;
  settings.limits.sessions_per_address = options.each > 0 ? options.each : (options.sessions * 3 + 3) / 4;
  return settings;
}

/// The program of engines: soarbox, next to this one.
Result<std::string> EngineProgram() {
  std::error_code error;
  const fs::path program = BesideThisProgram("soarbox", error);
  if (error) return NewProblem("the program cannot find its own path: " + error.message());
  return program.string();
}

/// Opens a link in the user's browser, if there is a program for this.
void OpenInBrowser(const std::string& link) {
  std::string program = "xdg-open", address = link;
  char* const words[] = {program.data(), address.data(), nullptr};
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  pid_t pid = 0;
  if (posix_spawnp(&pid, program.c_str(), &actions, nullptr, words, environ) == 0)
    std::thread([pid] { waitpid(pid, nullptr, 0); }).detach();
  posix_spawn_file_actions_destroy(&actions);
}

}  // namespace

int ServePages(const ServeOptions& options) {
  const Result<sim::DataFolders> data = FindDataFolders();
  if (!data) return Refuse(data.error());
  Result<serve::Settings> settings = SettingsFor(options, *data);
  if (!settings) {
    std::cerr << Format(settings.error());
    return kUsage;
  }
  if (!IsThisMachine(settings->address) && settings->token.empty() && !options.open) {
    std::cerr << Format(
        NewProblem("other people could reach this address: the server needs a token",
                   "add --token SECRET, or --open if anybody who reaches it may run worlds on this machine"));
    return kUsage;
  }
  if (options.open && !IsThisMachine(settings->address))
    std::cerr << "soarbox: warning: ANYBODY WHO REACHES " << settings->address
              << " CAN RUN WORLDS ON THIS MACHINE (--open)\n";
  if (options.no_wall)
    std::cerr << "soarbox: warning: worlds have all rights of this server's user (--no-wall)\n";
  else
    for (const std::string& missing : serve::MissingOfWall())
      std::cerr << "soarbox: note: " << missing << " (docs/serve.md, The wall)\n";
  const Result<std::string> program = EngineProgram();
  if (!program) return Refuse(program.error());
  auto catalog = std::make_unique<const ShippedCatalog>(*data);
  if (!options.scenario.empty()) {
    const fs::path folder = FolderOf(options.scenario);
    const std::string name = folder.empty() ? options.scenario : folder.filename().string();
    const auto is_it = [&](const auto& each) { return each.name == name; };
    if (!IsPlainName(name) || (folder.empty() && std::ranges::none_of(catalog->Scenarios(), is_it)))
      return Refuse("there is no scenario '" + options.scenario + "' to serve",
                    "name a folder with scenario.toml, or one that soarbox list shows");
    settings->opens = "scenario:" + name;
  }
  settings->engine = [&options, &program, shipped = catalog.get(), state = settings->state](const std::string& what,
                                                                                            const serve::Place& place) {
    return EngineFor(what, place, options, *program, *shipped, state);
  };
  settings->match = [&options, &program](std::uint64_t seed, int seconds) {
    std::vector<std::string> words = {*program,    "engine",
                                      "--home",    "home",
                                      "--match",   "home/match",
                                      "--seed",    std::to_string(seed),
                                      "--seconds", std::to_string(seconds),
                                      "--memory",  std::to_string(options.memory_mb)};
    if (!options.no_wall) words.emplace_back("--walled");
    return words;
  };
  const auto tell = [](const std::vector<serve::Address>& links) {
    std::cout << "Open " << links.front().link << " in a browser. Ctrl-C ends the server.\n";
    for (std::size_t i = 1; i < links.size(); ++i) std::cout << "  " << links[i].name << ": " << links[i].link << '\n';
    std::cout.flush();
  };
  const Result<void> served = serve::Serve(std::move(*settings), std::move(catalog), tell);
  return served ? static_cast<int>(kOk) : Refuse(served.error());
}

int ShowInBrowser(const BrowserOptions& shown) {
  const Result<sim::DataFolders> data = FindDataFolders();
  if (!data) return Refuse(data.error());
  const Result<std::string> program = EngineProgram();
  if (!program) return Refuse(program.error());
  ServeOptions options;
  options.listen = "127.0.0.1:0";
  options.page = shown.page;
  // Requires a token, because other users of this machine can reach the address.
  options.token = serve::NewId();
  Result<serve::Settings> settings = SettingsFor(options, *data);
  if (!settings) return Refuse(settings.error());
  settings->ends_when_alone = true;
  settings->opens = !shown.follow.empty() ? "run:kernel"
                    : shown.run.empty()   ? "recording:" + shown.recording.filename().string()
                                          : "run:" + shown.run;
  std::error_code error;
  const fs::path folder = shown.follow.empty() ? FolderOf(shown.run) : fs::path();
  std::vector<std::string> words = {*program, "engine", "--home", folder.empty() ? "/nowhere" : folder.string()};
  if (!shown.follow.empty()) {
    words.insert(words.end(), {"--follow", shown.follow});
  } else if (shown.run.empty()) {
    if (!fs::is_regular_file(shown.recording, error))
      return Refuse("there is no such recording", {}, shown.recording.string());
    words.insert(words.end(), {"--recording", fs::absolute(shown.recording, error).string()});
  } else {
    words.insert(words.end(), {"--run", folder.empty() ? shown.run : folder.string()});
  }
  if (!shown.dis.empty()) words.insert(words.end(), {"--dis", shown.dis});
  if (shown.seed) words.insert(words.end(), {"--seed", std::to_string(*shown.seed)});
  settings->engine = [opens = settings->opens, words](const std::string& what, const serve::Place&) {
    return what == opens ? words : std::vector<std::string>();
  };
  const auto tell = [](const std::vector<serve::Address>& links) {
    std::cout << "Open " << links.front().link << " in a browser. Closing its page ends the server.\n";
    std::cout.flush();
    OpenInBrowser(links.front().link);
  };
  const Result<void> served = serve::Serve(std::move(*settings), std::make_unique<const ShippedCatalog>(*data), tell);
  return served ? static_cast<int>(kOk) : Refuse(served.error());
}

}  // namespace soarbox::app
