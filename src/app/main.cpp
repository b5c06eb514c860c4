// SPDX-License-Identifier: BSD-2-Clause
#include <CLI/CLI.hpp>
#include <exception>
#include <iostream>
#include <string>

#include "app/data_folders.h"
#include "app/exit_codes.h"
#include "app/inspect_command.h"
#include "app/kernel_server.h"
#include "app/look_commands.h"
#include "app/new_scenario.h"
#include "app/recording_commands.h"
#include "app/run_options.h"
#include "app/soar_shell.h"
#include "app/usage_errors.h"
#include "sim/scenario.h"

namespace {

/// No run lasts longer; its ticks are counted without loss.
constexpr double kLongest_s = 1e7;

using soarbox::app::KernelServerOptions;
using soarbox::app::NumberIn;
using soarbox::app::RecordingOptions;
using soarbox::app::RunOptions;
using soarbox::app::SoarShellOptions;

void AddRun(CLI::App& program, RunOptions& options) {
  CLI::App* run = program.add_subcommand("run", "Run a scenario, in a window or headless");
  run->add_option("scenario", options.scenario,
                  "A folder with scenario.toml or Sandbox.lua, a scenario, Lua or rules file (scout.soar: one agent in "
                  "a field), "
                  "or a name that `soarbox list` shows")
      ->capture_default_str();
  run->add_flag("--headless", options.headless, "No window; 60 simulated seconds unless --seconds says otherwise");
  run->add_option("--seconds", options.seconds, "End after so many simulated seconds")->check(NumberIn(0, kLongest_s));
  run->add_option("--seed", options.seed,
                  "Seed of the world, the scripts and the minds (default: the scenario's own, else 1)")
      ->check(soarbox::app::WholeNumber());
  run->add_option("--speed", options.speed, "Times real time (default: 1 in a window, as fast as possible headless)")
      ->check(NumberIn(0.001, 1000.0));
  run->add_option("--path", options.extra_folders, "Search this folder for scripts and rules too (may be repeated)")
      ->check(CLI::ExistingDirectory);
  run->add_option("--screenshot", options.screenshot, "Save a picture to this PNG file, then end");
  run->add_option("--at", options.screenshot_at_s, "Simulated seconds at which to take the picture")
      ->capture_default_str()
      ->check(NumberIn(0, kLongest_s));
  run->add_option("--detail", options.detail,
                  "Of the picture: low, full, or auto, which is low without a graphics card")
      ->capture_default_str()
      ->check(CLI::IsMember({"auto", "low", "full"}));
  run->add_option("--render-scale", options.render_scale,
                  "Draw the scene in this share of the picture's width and height, 0.5 to 1, and bring it up to it; "
                  "texts stay sharp (default: 1 with a graphics card, else what 30 pictures per second allow)")
      ->check(NumberIn(0.5, 1.0));
  run->add_option(
         "--show", options.show,
         "Overlays that are on from the start, apart by commas: labels, trails, senses, paths, targets, shots, "
         "messages, forces, belief, navigation, influence, physics")
      ->delimiter(',');
  run->add_option("--select", options.select, "Select this agent from the start");
  run->add_option("--camera", options.camera, "free, orbit, follow, eyes or map; all but free and map want --select");
  run->add_option("--panels", options.panels,
                  "Panels around the picture, for this run: default, none, or a list such as agents,mind,timeline");
  run->add_option("--text", options.text_percent, "Size of the texts of these panels, in percent")
      ->capture_default_str()
      ->check(CLI::Range(75, 200));
  run->add_option("--ui-script", options.ui_script,
                  "Play the user of the window from this file, then end (see docs/window.md)");
  run->add_option("--width", options.width_px, "Width of the window in pixels")
      ->capture_default_str()
      ->check(NumberIn(160, 7680));
  run->add_option("--height", options.height_px, "Height of the window in pixels")
      ->capture_default_str()
      ->check(NumberIn(120, 4320));
  run->add_flag("--json", options.json, "Print events as lines of JSON");
  run->add_flag("--every-command", options.every_command, "Print each command of each tick, not only changes");
  run->add_option("--report", options.report_s, "Print where all agents are, each so many simulated seconds")
      ->check(NumberIn(0.001, kLongest_s));
  run->add_option("--threads", options.threads,
                  "Threads that the Soar minds decide on; 0: one per core; the run is the same on any number")
      ->capture_default_str()
      ->check(NumberIn(0, 64));
  run->add_option("--input", options.input,
                  "Keys, buttons, pointer and wheel at ticks, from this text file (see docs/command.md)");
  run->add_flag("--watch", options.watch,
                "Let edits of rules and scripts reach the running world (a window always does)");
  run->add_option("--port", options.port, "Let Soar debuggers attach at this TCP port of this machine; 0: none")
      ->check(NumberIn(0, 65535));
  CLI::Option* record = run->add_option("--record", options.record, "Record the run to this file (docs/recording.md)");
  run->add_flag("--no-record", options.no_record, "No recording; without this a run in a window is recorded")
      ->excludes(record);
  run->add_option("--record-level", options.record_level, "How much: world, decisions or all")->capture_default_str();
  run->add_option("--record-limit", options.record_limit_mb,
                  "Megabytes; at this size the older half of the frames goes")
      ->check(NumberIn(1.0, 1e6));
  run->add_option("--kernel", options.kernel,
                  "HOST:PORT of a Soar kernel in another process to use instead of our own");
  run->add_option("--kernel-limit", options.kernel_limit_s,
                  "Seconds that this kernel may be silent before it counts as gone")
      ->capture_default_str()
      ->check(NumberIn(0.01, 3600.0));
}

void AddSoar(CLI::App& program, SoarShellOptions& options) {
  CLI::App* soar = program.add_subcommand("soar", "The interactive shell of the Soar command language");
  soar->add_option("files", options.files, "Sourced first, in order");
  soar->add_flag("--json", options.json, "Answer each command with a line of JSON");
}

void AddLooks(CLI::App& program, soarbox::app::CheckOptions& check, soarbox::app::WhyOptions& why) {
  CLI::App* checks =
      program.add_subcommand("check", "Look over rules, scripts and scenario files without running them");
  checks->add_option("files", check.files, "Files (.soar, .lua, .toml) and folders")->required();
  checks->add_flag("--json", check.json, "One line of JSON per problem");

  CLI::App* reasons = program.add_subcommand("why", "Tell why an agent does what it does at a moment of a run");
  reasons->add_option("scenario", why.scenario, "As for `soarbox run`, or a recording")->required();
  reasons->add_option("topic", why.topic,
                      "A command, an operator or a rule of the agent: why it comes about, or does not");
  reasons->add_option("--agent", why.agent, "Its name; the first one with a mind if it is not said");
  reasons->add_option("--at", why.at_s, "Simulated seconds")->capture_default_str()->check(NumberIn(0.0, 36000.0));
  reasons->add_option("--seed", why.seed, "As for `soarbox run`")->check(soarbox::app::WholeNumber());
  reasons->add_option("--path", why.extra_folders, "As for `soarbox run`")->check(CLI::ExistingDirectory);
}

void AddInspect(CLI::App& program, soarbox::app::InspectOptions& options) {
  CLI::App* inspect = program.add_subcommand("inspect", "Print what a debugger shows of an agent at a moment of a run");
  inspect->add_option("source", options.source, "A scenario as for `soarbox run`, or a recording")->required();
  inspect->add_option("--agent", options.agent, "Its name; the first one with a Soar mind if it is not said");
  inspect->add_option("--at", options.at_s, "Simulated seconds")->capture_default_str()->check(NumberIn(0.0, 36000.0));
  inspect->add_option("--view", options.view, "What to show: " + soarbox::app::ViewsText())->capture_default_str();
  inspect->add_option("--from", options.from_s, "Where views over ticks begin, in simulated seconds")
      ->capture_default_str()
      ->check(NumberIn(0.0, 36000.0));
  inspect->add_option("--until", options.until,
                      "Stop sooner: fire RULE, match RULE, element PATTERN, impasse KIND or command NAME");
  inspect->add_option("--kernel", options.kernel, "As for `soarbox run`: what only our own kernel tells is left out");
  inspect->add_flag("--json", options.json, "Print it as JSON");
  inspect->add_option("--seed", options.seed, "As for `soarbox run`")->check(soarbox::app::WholeNumber());
  inspect->add_option("--path", options.extra_folders, "As for `soarbox run`")->check(CLI::ExistingDirectory);
}

void AddNew(CLI::App& program, soarbox::app::NewOptions& options) {
  CLI::App* made = program.add_subcommand("new", "Write a commented starter scenario with a test into a new folder");
  made->add_option("name", options.name, "The folder to make; its last part is the scenario's name")->required();
  CLI::Option* of_soar =
      made->add_flag("--soar", options.soar, "One agent of Soar rules alone (this is what you get by default)");
  CLI::Option* of_lua = made->add_flag("--lua", options.lua, "A world made by a Lua script, with a body of its own");
  CLI::Option* of_team = made->add_flag("--team", options.team, "Two teams of Soar agents");
  of_soar->excludes(of_lua, of_team);
  of_lua->excludes(of_team);
}

void AddKernel(CLI::App& program, KernelServerOptions& options) {
  CLI::App* kernel = program.add_subcommand("kernel", "Serve a Soar kernel to clients and debuggers on this machine");
  kernel->add_option("agents", options.agents, "One agent per file of rules");
  kernel->add_option("--port", options.port, "TCP port; 0: any free one")
      ->capture_default_str()
      ->check(NumberIn(0, 65535));
}

int List() {
  const soarbox::Result<soarbox::sim::DataFolders> data = soarbox::app::FindDataFolders();
  if (!data) {
    std::cerr << soarbox::Format(data.error());
    return soarbox::app::kCannotStart;
  }
  for (const std::string& name : soarbox::sim::ListScenarios(data.value())) {
    const std::string about = soarbox::sim::DescribeScenario(name, data.value());
    std::cout << name << std::string(name.size() < 16 ? 16 - name.size() : 1, ' ') << about << '\n';
  }
  return soarbox::app::kOk;
}

void AddRecordingFile(CLI::App& command, RecordingOptions& options) {
  command.add_option("file", options.file, "A recording, as `soarbox run --record` makes them")->required();
}

void AddRange(CLI::App& command, RecordingOptions& options) {
  command.add_option("--from", options.from_s, "Begin at this simulated second")->check(NumberIn(0, kLongest_s));
  command.add_option("--to", options.to_s, "End at this simulated second")->check(NumberIn(0, kLongest_s));
}

void AddThreads(CLI::App& command, RecordingOptions& options) {
  command.add_option("--threads", options.threads, "How many threads the minds decide on; 0: one per core")
      ->check(NumberIn(0, 256));
}

void AddRecordings(CLI::App& program, RecordingOptions& options) {
  CLI::App* replay = program.add_subcommand("replay", "Show a recording, in the window or as text");
  AddRecordingFile(*replay, options);
  AddRange(*replay, options);
  replay->add_flag("--headless", options.headless, "Print what happened, tick by tick");
  replay->add_flag("--json", options.json, "Print it as lines of JSON");
  replay->add_option("--select", options.select, "Select this agent from the start");
  replay->add_option("--panels", options.panels, "As for `soarbox run`");
  replay->add_option("--text", options.text_percent, "As for `soarbox run`")
      ->capture_default_str()
      ->check(CLI::Range(75, 200));
  replay->add_option("--detail", options.detail, "As for `soarbox run`")->check(CLI::IsMember({"auto", "low", "full"}));
  replay->add_option("--render-scale", options.render_scale, "As for `soarbox run`")->check(NumberIn(0.5, 1.0));
  replay->add_option("--width", options.width_px, "As for `soarbox run`; the recorded window's if it is not said")
      ->check(NumberIn(160, 7680));
  replay->add_option("--height", options.height_px, "Likewise")->check(NumberIn(120, 4320));
  replay->add_option("--ui-script", options.ui_script, "Play the user of the window from this file, then end");
  CLI::App* verify = program.add_subcommand("verify", "Simulate a recorded run again and compare every tick");
  AddRecordingFile(*verify, options);
  AddThreads(*verify, options);
  verify->add_flag("--as-recorded", options.as_recorded,
                   "With the scenario's files as they were when the run began, not as they are now");
  CLI::App* export_data = program.add_subcommand("export", "Write a recording as a table or as JSON");
  AddRecordingFile(*export_data, options);
  AddRange(*export_data, options);
  CLI::Option* csv = export_data->add_flag("--csv", options.csv, "A row for each agent and tick (the default)");
  export_data->add_flag("--json", options.json, "Everything, a line per tick")->excludes(csv);
  CLI::Option* output = export_data->add_option("-o,--output", options.output, "Write to this file");
  export_data->add_flag("--recording", options.as_recording, "The part from --from to --to as a recording of its own")
      ->excludes(csv)
      ->needs(output);
  CLI::App* resume = program.add_subcommand("resume", "Go back to a moment of a recording and go on live from there");
  AddRecordingFile(*resume, options);
  AddThreads(*resume, options);
  resume->add_option("--at", options.at_s, "The simulated second")->required()->check(NumberIn(0, kLongest_s));
  resume->add_option("--rules", options.rules, "Rules that replace those of the same names (may be repeated)");
  resume->add_option("--agent", options.agents, "Only this agent's rules (may be repeated)");
  resume->add_option("--seconds", options.seconds, "Go on for so long (default: as long as the recording does)")
      ->check(NumberIn(0, kLongest_s));
  resume->add_option("--record", options.output, "Record the new future, whole, to this file");
  resume->add_flag("--json", options.json, "Print events as lines of JSON");
  CLI::App* compare = program.add_subcommand("compare", "Tell where two recordings part, and how they go on");
  AddRecordingFile(*compare, options);
  compare->add_option("other", options.other, "The second recording")->required();
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
  soarbox::app::NewOptions made;
  AddNew(program, made);
  RecordingOptions recording;
  AddRecordings(program, recording);
  soarbox::app::CheckOptions check;
  soarbox::app::WhyOptions why;
  AddLooks(program, check, why);
  soarbox::app::InspectOptions inspect;
  AddInspect(program, inspect);
  program.add_subcommand("list", "List the scenarios that come with the program");
  if (const auto problem = soarbox::app::FindSingleDash(program, argc, argv)) {
    std::cerr << soarbox::Format(*problem);
    return soarbox::app::kUsage;
  }
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    // Help and version are "errors" of this library too; they print and succeed.
    if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) {
      program.exit(error);
      return soarbox::app::kOk;
    }
    if (argc == 1) {
      std::cerr << program.help();
    } else {
      std::cerr << soarbox::Format(soarbox::app::ExplainUsage(program, error));
    }
    return soarbox::app::kUsage;
  }
  if (program.got_subcommand("run")) return soarbox::app::Run(run);
  if (program.got_subcommand("inspect")) return soarbox::app::Inspect(inspect);
  if (program.got_subcommand("soar")) return soarbox::app::RunSoarShell(soar);
  if (program.got_subcommand("replay")) return soarbox::app::Replay(recording);
  if (program.got_subcommand("verify")) return soarbox::app::Verify(recording);
  if (program.got_subcommand("export")) return soarbox::app::Export(recording);
  if (program.got_subcommand("resume")) return soarbox::app::Resume(recording);
  if (program.got_subcommand("compare")) return soarbox::app::Compare(recording);
  if (program.got_subcommand("kernel")) return soarbox::app::ServeKernel(kernel);
  if (program.got_subcommand("check")) return soarbox::app::Check(check);
  if (program.got_subcommand("why")) return soarbox::app::Why(why);
  if (program.got_subcommand("new")) return soarbox::app::NewScenario(made);
  return List();
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const int code = Main(argc, argv);
    std::cout.flush();
    if (std::cout) return code;
    std::cerr << "soarbox: error: standard output cannot be written; is the disk full?\n";
    return soarbox::app::kCannotStart;
  } catch (const std::exception& error) {
    std::cerr << "soarbox: error: " << error.what() << '\n';
    return soarbox::app::kCannotStart;
  }
}
