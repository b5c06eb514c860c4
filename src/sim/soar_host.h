// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/diagnostic.h"
#include "diagnostics/result.h"

namespace sml {
class Agent;
class Kernel;
}  // namespace sml

namespace soarbox::sim {

/// Where the Soar agents of a run live.
struct SoarSettings {
  int port = 0;             ///< TCP port on loopback for debuggers; 0: nobody can attach.
  std::string remote_host;  ///< Not empty: use the kernel that listens there instead of our own.
  int remote_port = 12121;
  int remote_limit_ms =
      2000;  ///< A kernel elsewhere that is silent for so long while it is asked something counts as gone.
  std::uint64_t seed = 1;  ///< Seeds each agent's random choices.
};

/// One Soar kernel for all Soar minds of a run, reached through the public client API only: our own kernel, an official
/// one that is linked in its place, or one in another process.
///
/// Owned by the simulation; used on its thread.
class SoarHost {
 public:
  /// Fails if the port is taken or nobody answers at the remote address; the error names it.
  static Result<std::unique_ptr<SoarHost>> Create(const SoarSettings& settings);
  ~SoarHost();
  SoarHost(const SoarHost&) = delete;
  SoarHost& operator=(const SoarHost&) = delete;

  /// What came of loading an agent's rules. An agent with faulty rules lives with those that loaded.
  struct Loaded {
    sml::Agent* agent = nullptr;
    std::vector<Diagnostic> problems;
  };
  /// Makes an agent and loads its rules. Fails if the file cannot be read or the kernel refuses the agent.
  Result<Loaded> CreateAgent(const std::string& name, const std::filesystem::path& rules);

  /// Answers debuggers that are attached. Called between ticks, also while the world is paused.
  void ServeClients();

  /// False once a remote kernel has gone away.
  bool IsConnected() const;
  /// Looks for a kernel at the address of the one that has gone: once a second of real time, on another thread. True
  /// once one answers; it is then the host's, and all agents have to be made again.
  bool Reconnect();

  const SoarSettings& settings() const { return settings_; }

 private:
  class Attempt;

  SoarHost(std::unique_ptr<sml::Kernel> kernel, const SoarSettings& settings);
  bool IsRemote() const { return !settings_.remote_host.empty(); }

  std::unique_ptr<sml::Kernel> kernel_;
  SoarSettings settings_;
  std::uint64_t agents_made_ = 0;
  std::set<std::string> agents_;      ///< Names of those made, so that a remote kernel is left without them.
  std::shared_ptr<Attempt> attempt_;  ///< To reach a kernel again; null while connected.
};

/// Reads "file:line:column: error: text" lines, as kernels print them, into diagnostics. Text without a place becomes
/// one diagnostic against `file`.
std::vector<Diagnostic> ParseDiagnostics(std::string_view text, const std::string& file);

}  // namespace soarbox::sim
