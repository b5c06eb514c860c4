// SPDX-License-Identifier: BSD-2-Clause
#include <charconv>
#include <cstdlib>
#include <iostream>

#include "app/data_folders.h"
#include "app/exit_codes.h"
#include "app/run_headless.h"
#include "app/run_options.h"
#include "app/run_session.h"
#include "app/run_window.h"

namespace soarbox::app {
namespace {

constexpr double kHeadlessSeconds = 60;
constexpr int kDefaultPort = 12121;

int CannotStart(const Diagnostic& problem) {
  std::cerr << Format(problem);
  return kCannotStart;
}

/// Splits "HOST:PORT"; the port may be missing.
Result<void> ReadKernelAddress(const std::string& text, sim::SoarSettings& settings) {
  const std::size_t colon = text.rfind(':');
  settings.remote_host = text.substr(0, colon);
  settings.remote_port = kDefaultPort;
  if (colon != std::string::npos) {
    const char* end = text.data() + text.size();
    const auto [at, error] = std::from_chars(text.data() + colon + 1, end, settings.remote_port);
    if (error != std::errc{} || at != end || settings.remote_port < 1 || settings.remote_port > 65535) {
      Diagnostic problem;
      problem.message = "'" + text + "' is no address of a kernel";
      problem.hint = "write HOST:PORT, for example --kernel 127.0.0.1:12121";
      return problem;
    }
  }
  return {};
}

bool HasDisplay() {
  const char* display = std::getenv("DISPLAY");
  return display != nullptr && *display != '\0';
}

}  // namespace

int Run(const RunOptions& given) {
  RunOptions options = given;
  const Result<sim::DataFolders> data = FindDataFolders();
  if (!data) return CannotStart(data.error());
  const Result<sim::Scenario> scenario = sim::FindScenario(options.scenario, data.value(), options.extra_folders);
  if (!scenario) return CannotStart(scenario.error());

  // A window unless told otherwise; without a display the same world runs headless, and says so.
  const bool wants_screenshot = !options.screenshot.empty();
  if (!options.headless && (!HasDisplay() || !kHasWindow)) {
    Diagnostic note;
    note.message = kHasWindow ? "there is no display (DISPLAY is not set)" : "this build has no window";
    note.hint =
        kHasWindow ? "on a machine without a screen, xvfb-run gives a virtual one" : "build with -DSOARBOX_VIEWER=ON";
    if (wants_screenshot) {
      note.message += ", so no picture can be taken";
      return CannotStart(note);
    }
    note.severity = Severity::kWarning;
    note.message += ": the world runs headless";
    std::cerr << Format(note);
    options.headless = true;
  }
  if (options.headless && !options.seconds) options.seconds = kHeadlessSeconds;

  sim::SimulationSettings settings;
  settings.seed = options.seed;
  settings.screen_width_px = options.width_px;
  settings.screen_height_px = options.height_px;
  settings.every_command = options.every_command;
  settings.soar.seed = options.seed;
  settings.soar.remote_limit_ms = static_cast<int>(options.kernel_limit_s * 1000);
  if (!options.kernel.empty()) {
    if (const Result<void> read = ReadKernelAddress(options.kernel, settings.soar); !read) {
      std::cerr << Format(read.error());
      return kUsage;
    }
  } else {
    settings.soar.port = options.port.value_or(options.headless ? 0 : kDefaultPort);
  }

  Result<std::unique_ptr<sim::Simulation>> simulation = sim::Simulation::Create(scenario.value(), settings);
  if (!simulation && !options.port && settings.soar.port != 0) {
    // Nobody asked for the port: the run goes on without debuggers if that was what failed.
    settings.soar.port = 0;
    Result<std::unique_ptr<sim::Simulation>> again = sim::Simulation::Create(scenario.value(), settings);
    if (again) {
      Diagnostic note = simulation.error();
      note.severity = Severity::kWarning;
      note.hint = "debuggers cannot attach to this run; choose another port with --port N";
      std::cerr << Format(note);
      simulation = std::move(again);
    }
  }
  if (!simulation) return CannotStart(simulation.error());

  CatchInterrupts();
  std::unique_ptr<EventPrinter> printer =
      options.json ? EventPrinter::MakeJson(std::cout) : EventPrinter::MakeText(std::cout, std::cerr);
  printer->Begin({scenario.value().name, options.seed, options.headless});
  RunSession session(std::move(*simulation), std::move(printer), options);
  return options.headless ? RunHeadless(session, options) : RunWindow(session, options, data.value());
}

}  // namespace soarbox::app
