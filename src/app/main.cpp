// SPDX-License-Identifier: BSD-2-Clause
#include <CLI/CLI.hpp>
#include <exception>
#include <iostream>
#include <string>

#include "app/data_folders.h"
#include "app/exit_codes.h"
#include "app/kernel_server.h"
#include "app/run_options.h"
#include "app/soar_shell.h"
#include "sim/scenario.h"

namespace {

using soarbox::app::KernelServerOptions;
using soarbox::app::RunOptions;
using soarbox::app::SoarShellOptions;

void AddRun(CLI::App& program, RunOptions& options) {
  CLI::App* run = program.add_subcommand("run", "Run a scenario, in a window or headless");
  run->add_option("scenario", options.scenario,
                  "A folder with Sandbox.lua, a Lua file, or a name that `soarbox list` shows")
      ->capture_default_str();
  run->add_flag("--headless", options.headless, "No window; 60 simulated seconds unless --seconds says otherwise");
  run->add_option("--seconds", options.seconds, "End after so many simulated seconds")->check(CLI::NonNegativeNumber);
  run->add_option("--seed", options.seed, "Seed of the world, the scripts and the minds")->capture_default_str();
  run->add_option("--speed", options.speed, "Times real time (default: 1 in a window, as fast as possible headless)")
      ->check(CLI::Range(0.001, 1000.0));
  run->add_option("--path", options.extra_folders, "Search this folder for scripts and rules too (may be repeated)")
      ->check(CLI::ExistingDirectory);
  run->add_option("--screenshot", options.screenshot, "Save a picture to this PNG file, then end");
  run->add_option("--at", options.screenshot_at_s, "Simulated seconds at which to take the picture")
      ->capture_default_str()
      ->check(CLI::NonNegativeNumber);
  run->add_option("--width", options.width_px, "Width of the window in pixels")
      ->capture_default_str()
      ->check(CLI::Range(160, 7680));
  run->add_option("--height", options.height_px, "Height of the window in pixels")
      ->capture_default_str()
      ->check(CLI::Range(120, 4320));
  run->add_flag("--json", options.json, "Print events as lines of JSON");
  run->add_flag("--every-command", options.every_command, "Print each command of each tick, not only changes");
  run->add_option("--report", options.report_s, "Print where all agents are, each so many simulated seconds")
      ->check(CLI::PositiveNumber);
  run->add_option("--port", options.port, "Let Soar debuggers attach at this TCP port of this machine; 0: none")
      ->check(CLI::Range(0, 65535));
  run->add_option("--kernel", options.kernel,
                  "HOST:PORT of a Soar kernel in another process to use instead of our own");
  run->add_option("--kernel-limit", options.kernel_limit_s,
                  "Seconds that this kernel may be silent before it counts as gone")
      ->capture_default_str()
      ->check(CLI::Range(0.01, 3600.0));
}

void AddSoar(CLI::App& program, SoarShellOptions& options) {
  CLI::App* soar = program.add_subcommand("soar", "The interactive shell of the Soar command language");
  soar->add_option("files", options.files, "Sourced first, in order");
  soar->add_flag("--json", options.json, "Answer each command with a line of JSON");
}

void AddKernel(CLI::App& program, KernelServerOptions& options) {
  CLI::App* kernel = program.add_subcommand("kernel", "Serve a Soar kernel to clients and debuggers on this machine");
  kernel->add_option("agents", options.agents, "One agent per file of rules");
  kernel->add_option("--port", options.port, "TCP port; 0: any free one")
      ->capture_default_str()
      ->check(CLI::Range(0, 65535));
}

int List() {
  const soarbox::Result<soarbox::sim::DataFolders> data = soarbox::app::FindDataFolders();
  if (!data) {
    std::cerr << soarbox::Format(data.error());
    return soarbox::app::kCannotStart;
  }
  for (const std::string& name : soarbox::sim::ListScenarios(data.value())) std::cout << name << '\n';
  return soarbox::app::kOk;
}

int Main(int argc, char** argv) {
  CLI::App program("Soarbox: a 3D sandbox in which people learn and develop Soar agents", "soarbox");
  program.set_version_flag("--version", SOARBOX_VERSION);
  program.require_subcommand(1);
  RunOptions run;
  AddRun(program, run);
  SoarShellOptions soar;
  AddSoar(program, soar);
  KernelServerOptions kernel;
  AddKernel(program, kernel);
  program.add_subcommand("list", "List the scenarios that come with the program");
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    // Help and version are "errors" of this library too; they print and succeed.
    return program.exit(error) == 0 ? soarbox::app::kOk : soarbox::app::kUsage;
  }
  if (program.got_subcommand("run")) return soarbox::app::Run(run);
  if (program.got_subcommand("soar")) return soarbox::app::RunSoarShell(soar);
  if (program.got_subcommand("kernel")) return soarbox::app::ServeKernel(kernel);
  return List();
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return Main(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << "soarbox: error: " << error.what() << '\n';
    return soarbox::app::kCannotStart;
  }
}
