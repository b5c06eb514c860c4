// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace soarbox::app {

/// What `soarbox serve` was asked for (docs/serve.md).
struct ServeOptions {
  std::string scenario;  ///< What a new place opens; empty: the list of lessons and worlds.
  std::string listen = "127.0.0.1:8080";
  std::string token;
  bool open = false;  ///< Anybody who reaches the address may use it.
  std::vector<std::string> hosts, proxies;
  std::size_t sessions = 128;
  int memory_mb = 256;
  int idle_min = 30;
  std::filesystem::path state;  ///< Empty: where the user's other state is.
  std::filesystem::path class_list;
  std::filesystem::path page;  ///< Empty: the one that comes with the program.
};

/// Serves until Ctrl-C. Returns an ExitCode.
int ServePages(const ServeOptions& options);

}  // namespace soarbox::app
