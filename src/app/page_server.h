// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace soarbox::app {

/// Options of `soarbox serve` (docs/serve.md).
struct ServeOptions {
  std::string scenario;  ///< The world that a new user's place opens: a name or a folder; empty: a list to choose from.
  std::string listen = "127.0.0.1:8080";
  std::string token;
  std::filesystem::path token_file;  ///< Its first line is the token.
  bool open = false;                 ///< Anybody who can reach the address may use it.
  bool no_wall = false;              ///< Worlds are not confined by serve/wall.h.
  std::vector<std::string> hosts, proxies;
  std::vector<std::string> embedders;  ///< Sites that may embed worlds in their pages.
  std::size_t sessions = 128;
  int memory_mb = 256;
  std::size_t each = 0;  ///< Maximum number of runs per address; 0: three quarters of all.
  int idle_min = 30;
  int hang_s = 60;
  bool dis = false;             ///< Worlds may join exercises of other simulations.
  std::filesystem::path state;  ///< Empty: the folder of the user's other state.
  std::filesystem::path class_list;
  std::filesystem::path lti;   ///< Learning platforms that may open lessons; empty: none.
  std::filesystem::path page;  ///< Empty: the one that comes with the program.
};

/// Options of `--browser`: shows one run or one recording of the user in the browser of this machine.
struct BrowserOptions {
  std::string run;                  ///< As for `soarbox run`.
  std::filesystem::path recording;  ///< Or a recording.
  std::optional<std::uint64_t> seed;
  std::filesystem::path page;  ///< As for `soarbox serve`.
  std::string dis;             ///< As for `soarbox run`.
  std::string follow;          ///< Or the address of a kernel whose agents are watched.
};

/// Serves pages to browsers. Like the window (window.h), it belongs to a program of its own, soarbox-serve. soarbox
/// starts that program if pages are needed. It takes long to compile, and a window does not need it.
class PageServer {
 public:
  PageServer() = default;
  PageServer(const PageServer&) = delete;
  PageServer& operator=(const PageServer&) = delete;
  virtual ~PageServer() = default;

  /// Serves until Ctrl-C. Returns an ExitCode.
  virtual int Serve(const ServeOptions& options) const = 0;
  /// Shows this until the page is closed. Returns an ExitCode.
  virtual int Show(const BrowserOptions& options) const = 0;
};

}  // namespace soarbox::app
