// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <vector>

namespace soarbox::app {

/// What `soarbox kernel` was asked for.
struct KernelServerOptions {
  int port = 12121;                           ///< On this machine only; 0: any free one, which is printed.
  std::vector<std::filesystem::path> agents;  ///< One agent per file of rules, named after it.
  /// What clients do is recorded to this file; empty: to what $SOARBOX_RECORD names, if anything.
  std::filesystem::path record;
  bool no_log = false;  ///< Keep no log for `soarbox watch`.
  /// The file with the secret that clients must show. Empty: what the environment names (sml/wire/secret.h).
  std::filesystem::path secret_file;
};

/// Serves a Soar kernel to clients and debuggers until Ctrl-C or a client shuts it down. Returns an ExitCode.
int ServeKernel(const KernelServerOptions& options);

}  // namespace soarbox::app
