// SPDX-License-Identifier: BSD-2-Clause
#include "app/kernel_server.h"

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <memory>
#include <set>
#include <string>
#include <thread>

#include "app/exit_codes.h"
#include "app/refuse.h"
#include "app/run_session.h"
#include "diagnostics/diagnostic.h"
#include "sml/wire/channel.h"
#include "sml/wire/secret.h"
#include "sml_Client.h"
#ifdef SOARBOX_OWN_KERNEL
#include "soarbox_ClientLog.h"
#endif

namespace soarbox::app {
namespace {

/// Interval for checking whether to end. Clients do not wait for it: a thread of the kernel serves them at once.
constexpr auto kLookAtSignals = std::chrono::milliseconds(20);

/// The file's stem, followed by a number if another agent has this name.
std::string NameFor(const std::filesystem::path& file, std::set<std::string>& taken) {
  const std::string stem = file.stem().empty() ? "agent" : file.stem().string();
  std::string name = stem;
  for (int n = 2; !taken.insert(name).second; ++n) name = stem + "-" + std::to_string(n);
  return name;
}

/// Creates an agent and loads its rules; problems are printed and counted. False if there is no such file.
bool AddAgent(sml::Kernel& kernel, const std::filesystem::path& file, std::set<std::string>& names) {
  if (!std::ifstream(file)) {
    Refuse(file.string() + " cannot be read", "name files of Soar rules");
    return false;
  }
  const std::string name = NameFor(file, names);
  sml::Agent* agent = kernel.CreateAgent(name.c_str());
  if (agent == nullptr) {
    Refuse("the kernel refuses an agent named " + name);
    return false;
  }
  std::cout << "agent " << name << ": " << file.string() << std::endl;
  if (!agent->LoadProductions(std::filesystem::absolute(file).string().c_str())) {
    const char* why = agent->GetLastErrorDescription();
    std::cerr << (why == nullptr ? "" : why) << std::flush;
  }
  return true;
}

/// Starts recording the kernel's clients, if that is requested. Returns an error message; empty if there is no error.
std::string Record([[maybe_unused]] sml::Kernel& kernel, const KernelServerOptions& options) {
#ifdef SOARBOX_OWN_KERNEL
  if (!options.record.empty()) return RecordClients(kernel, std::filesystem::absolute(options.record).string());
  const char* const named = std::getenv("SOARBOX_RECORD");
  const bool is_recorded = named != nullptr && *named != '\0';
  // Keeps the log in any case, so that a program that watches later gets it from the beginning. Ignores errors: the
  // kernel works without a log.
  if (!options.no_log && !is_recorded) static_cast<void>(RecordClients(kernel, {}));
  return {};
#else
  return options.record.empty() ? "" : "only Soarbox's own kernel records its clients";
#endif
}

}  // namespace

int ServeKernel(const KernelServerOptions& options) {
  if (!wire::HasSockets())
    return Refuse("this build has no sockets", "use the native soarbox for connections to other programs");
  CatchInterrupts();
  if (!options.secret_file.empty()) {
    // The kernel's listener reads these variables.
    unsetenv(wire::kSecretVariable);
    setenv(wire::kSecretFileVariable, options.secret_file.c_str(), 1);
  }
  const Result<std::string> secret = wire::SecretOfEnvironment();
  if (!secret) {
    return Refuse(secret.error().file + ": " + secret.error().message, "write the secret into its first line");
  }
  if (!options.record.empty()) unsetenv("SOARBOX_RECORD");
  const int port = options.port == 0 ? static_cast<int>(sml::Kernel::kUseAnyPort) : options.port;
  const std::unique_ptr<sml::Kernel> kernel(sml::Kernel::CreateKernelInNewThread(port));
  if (kernel->HadError()) {
    const char* why = kernel->GetLastErrorDescription();
    return Refuse("port " + std::to_string(options.port) + " cannot be opened" +
                      (why == nullptr ? "" : std::string(" (") + why + ")"),
                  "another program uses it; choose another with --port N, or any free one with --port 0");
  }
  if (const std::string problem = Record(*kernel, options); !problem.empty()) return Refuse(problem);
  std::set<std::string> names;
  for (const std::filesystem::path& file : options.agents) {
    if (!AddAgent(*kernel, file, names)) {
      kernel->Shutdown();
      return kCannotStart;
    }
  }
  std::cout << "a Soar kernel listens on 127.0.0.1:" << kernel->GetListenerPort()
            << (secret->empty() ? "" : ", for clients that show its secret") << " (end with Ctrl-C)" << std::endl;
  while (!WasInterrupted() && !kernel->IsConnectionClosed()) std::this_thread::sleep_for(kLookAtSignals);
  kernel->Shutdown();
  return kOk;
}

}  // namespace soarbox::app
