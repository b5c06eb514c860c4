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

/// Where the Soar agents of a run live.
struct SoarSettings {
  int port = 0;             ///< TCP port on loopback for debuggers; 0: nobody can attach.
  std::string remote_host;  ///< Not empty: use the kernel that listens there instead of our own.
  int remote_port = 12121;
  int remote_limit_ms =
      2000;  ///< A kernel elsewhere that is silent for so long while it is asked something counts as gone.
  /// What rule files may read, below these; empty: anything. They write nothing then.
  std::vector<std::filesystem::path> folders;
  /// Carries out only rules and the loading of further files: the files are only checked.
  bool rules_only = false;
  /// How many threads the minds decide on; 0: one per core. With a port or a kernel elsewhere it is one.
  int threads = 0;
  std::uint64_t seed = 1;  ///< Seeds each agent's random choices.
};

/// One Soar kernel for all Soar minds of a run, so that debuggers find them all at one port, reached through the public
/// client API only: our own kernel, an official one that is linked in its place, or one in another process.
///
/// A run that no debugger can attach to has a kernel for each thread instead, with the agents dealt out to them:
/// kernels of one process share nothing. What an agent does depends on its rules, its percepts and its seed alone, not
/// on which kernel it lives in.
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
    std::size_t thread = 0;  ///< On which it decides: agents of different threads share nothing.
    std::vector<Diagnostic> problems;
  };
  /// Makes an agent and loads its rules. Fails if the file cannot be read or the kernel refuses the agent.
  /// `first`: a command that it gets before its rules. `beside_world`: the first thread, which is the world's, has
  /// other work while it decides, and gets half as many of these as each other thread.
  Result<Loaded> CreateAgent(const std::string& name, const std::filesystem::path& rules, const char* first = "",
                             bool beside_world = false);

  /// Destroys an agent, which gives its memory back.
  void DestroyAgent(const std::string& name);

  /// Answers debuggers that are attached. Called between ticks, also while the world is paused; at other times they
  /// wait.
  void ServeClients();
  /// What they said to the agents, in order, since the last call. Debuggers of a kernel elsewhere are not heard.
  std::vector<CommandInput> TakeHeard();
  /// Carries out a command line for an agent; returns what it printed. Fails if there is no such agent or the command
  /// fails. `recorded`: it comes from a recording, so it may read only below the folders, and write and start nothing.
  Result<std::string> Execute(const std::string& agent, const std::string& line, bool recorded = false);

  /// False once a remote kernel has gone away.
  bool IsConnected() const;
  /// Looks for a kernel at the address of the one that has gone: once a second of real time, on another thread. True
  /// once one answers; it then belongs to the host, and you must make all agents again.
  bool Reconnect();

  /// How many threads the minds decide on.
  std::size_t threads() const { return 1 + further_.size(); }

  const SoarSettings& settings() const { return settings_; }

 private:
  class Attempt;

  SoarHost(std::unique_ptr<sml::Kernel> kernel, const SoarSettings& settings);
  bool IsRemote() const { return !settings_.remote_host.empty(); }

  sml::Kernel& KernelOf(std::size_t thread) { return thread == 0 ? *kernel_ : *further_[thread - 1]; }
  void MakeFurtherKernels();

  std::unique_ptr<sml::Kernel> kernel_;
  std::vector<std::unique_ptr<sml::Kernel>> further_;  ///< One for each thread but the first.
  SoarSettings settings_;
  std::uint64_t agents_made_ = 0;
  std::uint64_t made_beside_world_ = 0;
  std::map<std::string, std::size_t> agents_;  ///< Names of those made, and their threads.
  std::vector<CommandInput> heard_;
  std::shared_ptr<Attempt> attempt_;  ///< To reach a kernel again; null while connected.
};

/// Reads "file:line:column: error: text" lines, as kernels print them, into diagnostics. Text without a place becomes
/// one diagnostic against `file`.
std::vector<Diagnostic> ParseDiagnostics(std::string_view text, const std::string& file);

}  // namespace soarbox::sim
