// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "diagnostics/result.h"
#include "sim/scenario.h"
#include "sim/simulation.h"

namespace soarbox::app {

/// A Soar kernel in another process whose agents a run follows (`soarbox watch`).
///
/// Our kernel keeps a log of what its clients do (sml/server/client_log.h). A thread reads the log as it grows. The
/// agents of the run execute the log, tick by tick, like the agents of a recorded client. So all panels and the past
/// work without asking the kernel. Command lines for the agents go to the kernel; they come back in its log.
///
/// Other kernels, and ours without a log, are queried for the data of panels. These show the present only, as far as
/// the client API of Soar reports it. A tick is a query that finds that at least one agent has decided since the last
/// one, was created or was destroyed.
class KernelWatch {
 public:
  /// Connects, and reads what the log holds so far. `address`: HOST:PORT. Fails if no kernel answers there.
  static Result<std::unique_ptr<KernelWatch>> Connect(const std::string& address);
  virtual ~KernelWatch() = default;

  /// Completes the settings with which the run's agents reach their kernel.
  virtual void Prepare(sim::SoarSettings& settings) const { static_cast<void>(settings); }
  /// The data that this kernel does not report; empty: it reports everything.
  [[nodiscard]] virtual std::string Remark() const { return {}; }

  /// The scenario in which the agents execute the log. Its copies of the client's files exist as long as this object.
  virtual Result<sim::Scenario> World(const sim::DataFolders& data) = 0;

  /// Returns the log's lines for the tick after this one. Repeated calls return the same lines. Null if the kernel's
  /// agents have not reached that tick yet. Valid until the next call.
  virtual const std::string* After(std::uint64_t tick) = 0;

  /// Call it before After() to get everything that the kernel's agents have done so far. Waits for at most one second.
  virtual void Sync() = 0;

  /// Whether the kernel has ended, so that After() will get no further ticks.
  [[nodiscard]] virtual bool HasEnded() const = 0;
  /// Returns once why the kernel has ended; otherwise an empty text.
  virtual std::string TakeNews() = 0;

  /// Executes a command line for an agent in the kernel.
  virtual Result<std::string> Command(const std::string& agent, const std::string& line) = 0;

 protected:
  KernelWatch() = default;
  KernelWatch(const KernelWatch&) = delete;
  KernelWatch& operator=(const KernelWatch&) = delete;
};

}  // namespace soarbox::app
