// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <vector>

namespace soarbox::app {

/// Options of `soarbox kernel`.
struct KernelServerOptions {
  int port = 12121;                           ///< On this machine only; 0: any free port, which is printed.
  std::vector<std::filesystem::path> agents;  ///< One agent per file of rules, named after it.
  /// Records the actions of clients to this file; empty: to the file in $SOARBOX_RECORD, if it is set.
  std::filesystem::path record;
  bool no_log = false;  ///< Keep no log for `soarbox watch`.
  /// The file with the secret that clients must show. Empty: the secret of the environment (sml/wire/secret.h), if any.
  std::filesystem::path secret_file;
};

/// Serves a Soar kernel to clients and debuggers until Ctrl-C or until a client shuts it down. Returns an ExitCode.
int ServeKernel(const KernelServerOptions& options);

}  // namespace soarbox::app
