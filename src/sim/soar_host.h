// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/diagnostic.h"
#include "diagnostics/result.h"
#include "sim/input.h"

namespace sml {
class Agent;
class Kernel;
}  // namespace sml

namespace soarbox::sim {

/// Where the Soar agents of a run are executed, and what they may do.
struct SoarSettings {
  int port = 0;             ///< TCP port on loopback for debuggers; 0: debuggers cannot attach.
  std::string remote_host;  ///< If not empty: use the kernel that listens there instead of our own.
  int remote_port = 12121;
  int remote_limit_ms = 2000;  ///< A remote kernel that does not answer within this time is treated as lost.
  /// The folders that rule files may read from; empty: all. If set, rule files cannot write.
  std::vector<std::filesystem::path> folders;
  /// Execute only rules and commands that load further files, because the files are only checked.
  bool rules_only = false;
  /// Number of threads on which minds decide; 0: one per core. With a port or a remote kernel, one thread is used.
  int threads = 0;
  std::uint64_t seed = 1;  ///< Seeds the random choices of each agent.
};

/// The Soar kernel for all minds of a run, so that debuggers find all agents at one port. It is used only through the
/// public client API: our own kernel, an official one that is linked instead, or one in another process.
///
/// A run to which no debugger can attach has one kernel per thread instead, and the agents are distributed among them.
/// Kernels of one process share nothing. What an agent does depends only on its rules, its percepts and its seed, not
/// on the kernel that it is in.
///
/// Owned by the simulation; used on its thread.
class SoarHost {
 public:
  /// Fails if the port is in use or no kernel answers at the remote address; the error names it.
  static Result<std::unique_ptr<SoarHost>> Create(const SoarSettings& settings);
  ~SoarHost();
  SoarHost(const SoarHost&) = delete;
  SoarHost& operator=(const SoarHost&) = delete;

  /// The result of loading an agent's rules. Rules with errors are reported, and the agent is created with the others.
  struct Loaded {
    sml::Agent* agent = nullptr;
    std::size_t thread = 0;  ///< The thread on which it decides. Agents of different threads share nothing.
    std::vector<Diagnostic> problems;
  };
  /// Creates an agent and loads its rules. Fails if the file cannot be read or the kernel refuses the agent. If `rules`
  /// is empty, returns an existing agent of a remote kernel instead. `first`: a command that is executed before the
  /// rules are loaded. `beside_world`: the agent decides in parallel to scripts. The first thread, which is the
  /// world's, then gets half as many of these agents as each other thread.
  Result<Loaded> CreateAgent(const std::string& name, const std::filesystem::path& rules, const char* first = "",
                             bool beside_world = false);

  /// Destroys an agent and frees its memory.
  void DestroyAgent(const std::string& name);

  /// Serves attached debuggers. Called between ticks, also while the world is paused. Debuggers wait at other times.
  void ServeClients();
  /// The commands of debuggers to agents since the last call, in order. Commands to a remote kernel are not included.
  std::vector<CommandInput> TakeHeard();
  /// Executes a command line for an agent and returns its output. Fails if there is no such agent or the command fails.
  /// `recorded`: the line comes from a recording; it may read only below the folders, and may not write or start
  /// anything.
  Result<std::string> Execute(const std::string& agent, const std::string& line, bool recorded = false);

  /// False after the connection to a remote kernel is lost.
  bool IsConnected() const;
  /// Tries to connect to a kernel at the address of the lost one, once per second of real time, on another thread.
  /// Returns true when one answers. The host then uses that kernel, and the caller must create all agents again.
  bool Reconnect();

  /// Number of threads on which minds decide.
  std::size_t threads() const { return 1 + further_.size(); }

  const SoarSettings& settings() const { return settings_; }

 private:
  class Attempt;

  SoarHost(std::unique_ptr<sml::Kernel> kernel, const SoarSettings& settings);
  bool IsRemote() const { return !settings_.remote_host.empty(); }

  sml::Kernel& KernelOf(std::size_t thread) { return thread == 0 ? *kernel_ : *further_[thread - 1]; }
  void MakeFurtherKernels();

  std::unique_ptr<sml::Kernel> kernel_;
  std::vector<std::unique_ptr<sml::Kernel>> further_;  ///< One for each thread except the first.
  SoarSettings settings_;
  std::uint64_t agents_made_ = 0;
  std::uint64_t made_beside_world_ = 0;
  std::map<std::string, std::size_t> agents_;  ///< Names of the created agents, with their threads.
  std::vector<CommandInput> heard_;
  std::shared_ptr<Attempt> attempt_;  ///< The attempt to reconnect; null while connected.
};

/// Converts lines "file:line:column: error: text", as kernels print them, to diagnostics. Text without a position
/// becomes one diagnostic about `file`.
std::vector<Diagnostic> ParseDiagnostics(std::string_view text, const std::string& file);

}  // namespace soarbox::sim
