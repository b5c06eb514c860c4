// SPDX-License-Identifier: BSD-2-Clause
#include <arpa/inet.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "app/data_folders.h"
#include "app/exit_codes.h"
#include "app/kernel_address.h"
#include "app/kernel_watch.h"
#include "app/mission_watch.h"
#include "app/record_run.h"
#include "app/refuse.h"
#include "app/rules_of_project.h"
#include "app/run_headless.h"
#include "app/run_options.h"
#include "app/run_session.h"
#include "app/run_setup.h"
#include "app/window.h"
#include "diagnostics/problem.h"
#include "diagnostics/read_text.h"
#include "dis/gateway.h"
#include "record/header.h"
#include "record/manifest.h"
#include "record/recorder.h"
#include "script/script_profiler.h"
#include "sim/client_world.h"
#include "sim/input_text.h"
#include "sim/replaced_rules.h"
#include "sim/scenario_file.h"
#include "world/world.h"
#ifdef SOARBOX_OWN_KERNEL
#include "sml/wire/channel.h"
#endif

namespace soarbox::app {
namespace {

constexpr double kHeadlessSeconds = 60;

/// A file of rules alone runs in a world of the program. Prints a note if a scenario next to it uses these rules.
void NoteOwnScenario(const sim::Scenario& scenario) {
  if (scenario.rules.empty() || !scenario.rules.has_parent_path()) return;
  const std::filesystem::path folder = scenario.rules.parent_path();
  std::error_code error;
  if (!std::filesystem::is_regular_file(std::filesystem::symlink_status(folder / "scenario.toml", error))) return;
  const Result<sim::ScenarioFile> beside = sim::ReadScenarioFile(folder / "scenario.toml");
  if (!beside || std::ranges::none_of(beside->agents, [&](const sim::ScenarioFile::Agent& agent) {
        return agent.rules == scenario.rules.filename().string();
      }))
    return;
  Remark(Severity::kNote,
         NewProblem(scenario.rules.filename().string() + " runs alone, in a world that comes with the program",
                    "soarbox run " + folder.string() + " runs it in the scenario beside it"));
}

/// Reads the file of inputs. Returns false, after printing the errors, if it cannot be read or any line is wrong.
bool SubmitInputs(const std::string& file, sim::Simulation& simulation) {
  if (file.empty()) return true;
  const std::optional<std::string> text = ReadText(file, ReadFrom::kAnything);
  if (!text) {
    Refuse("this file of inputs cannot be read", {}, file);
    return false;
  }
  const sim::InputText read = sim::ReadInputs(*text, file);
  for (const Diagnostic& problem : read.problems) std::cerr << Format(problem);
  for (sim::Input input : read.inputs) {
    input.recorded = true;  // A file of inputs may come from anybody.
    simulation.Submit(std::move(input));
  }
  return read.problems.empty();
}

/// Settings for joining an exercise of other simulations; nothing if neither the command line nor the scenario
/// specifies one.
Result<std::optional<dis::Settings>> ExerciseOf(const RunOptions& options, const sim::Scenario& scenario,
                                                const sim::DataFolders& data) {
  Result<dis::Settings> table = dis::ReadTable(data.media / "dis" / "entities.toml");
  if (!table) return table.error();
  Result<std::optional<dis::Settings>> own = dis::ReadSettings(scenario.definition, *table);
  if (!own || options.dis.empty()) return own;
  Result<dis::Settings> asked = dis::ParseOption(options.dis, own->value_or(*table));
  if (!asked) return asked.error();
  return std::optional<dis::Settings>(std::move(*asked));
}

/// Whether sent data stay on this machine.
bool IsOfThisMachine(const dis::Settings& settings) {
  constexpr std::string_view kLoopback = "127.";
  in_addr address{};
  const bool is_group =
      inet_pton(AF_INET, settings.address.c_str(), &address) == 1 && IN_MULTICAST(ntohl(address.s_addr));
  return (is_group ? settings.interface : settings.address).starts_with(kLoopback) || settings.address == "localhost";
}

/// Completes the options of a run that follows a kernel. The run is a copy, so it is not recorded and has no port for
/// debuggers: the kernel has these.
void CompleteToFollow(RunOptions& options) {
  constexpr double kLong_s = 1e9;
  options.scenario = sim::kClientWorld;
  options.port = 0;
  options.threads = 1;
  options.no_record = true;
  if (options.headless && !options.seconds) options.seconds = kLong_s;
}

/// Prints a remark on the run; nothing if it is empty.
void Note(const std::string& remark) {
  if (!remark.empty()) std::cerr << "soarbox: " << remark << '\n';
}

}  // namespace

int SetUpRun(const RunOptions& given, std::unique_ptr<RunSetup>& result) {
  auto setup = std::make_unique<RunSetup>();
  RunOptions& options = setup->options = given;
  const Result<sim::DataFolders> data = FindDataFolders();
  if (!data) return Refuse(data.error());
  setup->data = *data;
  std::unique_ptr<KernelWatch> followed;
  if (!options.follow.empty()) {
    Result<std::unique_ptr<KernelWatch>> connected = KernelWatch::Connect(options.follow);
    if (!connected) return Refuse(connected.error());
    followed = std::move(*connected);
    CompleteToFollow(options);
    options.warning = followed->Remark();
  }
  const Result<std::filesystem::path> rules = RulesOfProject(options.scenario);
  if (!rules) return Refuse(rules.error());
  options.scenario = rules->string();
  Result<sim::Scenario> scenario = followed != nullptr
                                       ? followed->World(data.value())
                                       : sim::FindScenario(options.scenario, data.value(), options.extra_folders);
  if (!scenario) return Refuse(scenario.error());
  if (const Result<void> replaced = sim::ReplaceRules(*scenario, options.rules); !replaced) {
    Refuse(replaced.error());
    return kUsage;
  }

  // Options that are missing on the command line may be in the scenario's file.
  double headless_s = kHeadlessSeconds;
  if (!scenario.value().definition.empty()) {
    std::vector<Diagnostic> further;
    Result<sim::ScenarioFile> file = sim::ReadScenarioFile(scenario.value().definition, &further);
    if (!file) {
      const int code = Refuse(file.error());
      for (const Diagnostic& problem : further) std::cerr << Format(problem);
      return code;
    }
    if (!options.seed) options.seed = file->seed;
    headless_s = file->seconds.value_or(headless_s);
  }
  const std::uint64_t seed = options.seed.value_or(1);

  // Opens a window by default; without a display the same world runs headless, with a note.
  const bool wants_screenshot = !options.screenshot.empty();
  if (options.headless && wants_screenshot) {
    Refuse("a headless run draws nothing, so no picture can be taken",
           "leave --headless out: with --screenshot no window is shown; on a machine without a screen, xvfb-run "
           "gives a virtual one");
    return kUsage;
  }
  if (!options.headless && !CanOpenWindow()) {
    const std::string why = HasDisplay() ? "this build has no window" : "there is no display (DISPLAY is not set)";
    const std::string hint = HasDisplay()
                                 ? "build with -DSOARBOX_VIEWER=ON, which puts soarbox-window beside this program"
                                 : "on a machine without a screen, xvfb-run gives a virtual one";
    if (wants_screenshot) return Refuse(why + ", so no picture can be taken", hint);
    Remark(Severity::kWarning, NewProblem(why + ": the world runs headless", hint));
    options.headless = true;
  }
  if (options.headless && !options.seconds) options.seconds = headless_s;
  NoteOwnScenario(*scenario);
  setup->scenario = *scenario;

  sim::SimulationSettings& settings = setup->settings;
  settings.seed = seed;
  const WindowSize window = WindowSizeOf(options);
  settings.screen_width_px = window.width;
  settings.screen_height_px = window.height;
  settings.every_command = options.every_command;
  settings.typed_by_strangers = options.by_strangers;
  settings.soar.threads = options.threads;
  settings.limits.memory_bytes = static_cast<std::size_t>(options.memory_mb) << 20;
  settings.soar.remote_limit_ms = static_cast<int>(options.kernel_limit_s * 1000);
  if (!options.kernel.empty()) {
    if (const Result<void> read = ReadKernelAddress(options.kernel, settings.soar); !read) {
      Refuse(read.error());
      return kUsage;
    }
  } else {
#ifdef SOARBOX_OWN_KERNEL
    if (options.port.value_or(0) != 0 && !wire::HasSockets())
      return Refuse("this build has no sockets for debuggers", "use the native soarbox, or leave out --port");
#endif
    settings.soar.port = options.port.value_or(options.headless ? 0 : kDefaultPort);
  }

  if (followed != nullptr) {
    followed->Prepare(settings.soar);
    Note(followed->Remark());
  }
  Result<std::optional<dis::Settings>> exercise = ExerciseOf(options, *scenario, *data);
  if (!exercise) return Refuse(exercise.error());
  std::optional<dis::Settings> joins = *std::move(exercise);
  if (joins && !options.may_join) {
    options.warning = "This world joins no exercise of other simulations: the server was not started with --dis.";
    joins.reset();
  } else if (joins && options.dis.empty() && !options.by_strangers && !IsOfThisMachine(*joins)) {
    // Does not connect to other machines because of a scenario file alone: it may come from somebody else.
    options.warning = "This world joins no exercise of other simulations: its scenario names " + joins->address +
                      ", beyond this machine. Add --dis " + joins->address + ':' + std::to_string(joins->port) +
                      " to join it.";
    std::cerr << "soarbox: warning: " << options.warning << '\n';
    joins.reset();
  }

  const Result<record::Level> level = record::LevelNamed(options.record_level);
  if (!level) {
    Refuse(level.error());
    return kUsage;
  }
  const bool is_recorded = WantsRecording(options);
  if (is_recorded) settings.mind_detail = record::DetailOf(*level);
  // Labels and panels show the decisions of minds.
  if (!options.headless && settings.mind_detail == sim::MindDetail::kNone)
    settings.mind_detail = sim::MindDetail::kDecisions;
  // Checks are evaluated if their results will be shown.
  std::unique_ptr<MissionWatch> mission;
  if (is_recorded || !options.headless) mission = MissionWatch::Of(*scenario, options.lesson, *data);
  if (mission != nullptr) settings.mind_detail = std::max(settings.mind_detail, mission->LeastDetail());
  // Without a window and a port, nothing can ask why during the run. Afterwards, the recording is simulated again.
  settings.records_origins = !options.headless || settings.soar.port != 0;

  CatchInterrupts();
  Result<std::unique_ptr<sim::Simulation>> simulation = sim::Simulation::Create(scenario.value(), settings);
  if (!simulation && !options.port && settings.soar.port != 0) {
    // The port was not requested: if it cannot be used, the run continues without debuggers.
    settings.soar.port = 0;
    Result<std::unique_ptr<sim::Simulation>> again = sim::Simulation::Create(scenario.value(), settings);
    if (again) {
      Diagnostic note = simulation.error();
      note.hint = "debuggers cannot attach to this run; choose another port with --port N";
      Remark(Severity::kWarning, std::move(note));
      simulation = std::move(again);
    }
  }
  if (!simulation) return Refuse(simulation.error());

  if (!SubmitInputs(options.input, **simulation)) return kCannotStart;
  options.watch |= !options.headless && !wants_screenshot;
  std::unique_ptr<EventPrinter> printer =
      options.json ? EventPrinter::MakeJson(std::cout) : EventPrinter::MakeText(std::cout, std::cerr);
  printer->Begin({scenario.value().name, seed, options.headless});
  RunSession& session =
      setup->session.emplace(std::move(*simulation), std::move(printer), options, std::move(followed));
  session.SetMission(std::move(mission));
  if (joins) {
    Result<std::unique_ptr<dis::Gateway>> gateway = dis::Gateway::Open(*joins);
    if (!gateway) return Refuse(gateway.error());
    session.Join(std::move(*gateway));
    // Other simulations run in real time.
    if (!options.speed) options.speed = 1;
    std::cerr << "soarbox: " << session.gateway()->Describe() << '\n';
  }
  session.ExpectInputs(!options.input.empty());
  record::Header& header = setup->header = HeaderOfRun(options, *scenario, settings, session.simulation(), *level);
  RunRecordings& recordings = setup->recordings.emplace(options);
  if (is_recorded) {
    recordings.SetManifest(record::ManifestOf(*scenario, header));
    const std::string note = recordings.Begin(session, header);
    if (note.empty() && !options.record.empty()) return kCannotStart;
    options.remark = note;
    if (!note.empty() && options.record.empty()) std::cerr << "soarbox: " << note << '\n';
  }
  // These functions are called later, when the local variables are gone. They use the set-up, which still exists.
  session.SetMake(
      seed, scenario.value().name,
      [raw = setup.get()](std::uint64_t with_seed) {
        raw->settings.seed = with_seed;
        return sim::Simulation::Create(raw->scenario, raw->settings);
      },
      [raw = setup.get(), is_recorded, level = *level] {
        raw->header = HeaderOfRun(raw->options, raw->scenario, raw->settings, raw->session->simulation(), level);
        if (is_recorded) {
          raw->recordings->SetManifest(record::ManifestOf(raw->scenario, raw->header));
          Note(raw->recordings->Begin(*raw->session, raw->header));
        }
      });
  session.SetOnBranch([raw = setup.get()](const record::TickRecord& at, const std::vector<record::TickInputs>& inputs) {
    Note(raw->recordings->GoOn(*raw->session, raw->header, at, inputs));
  });
  result = std::move(setup);
  return kOk;
}

int Run(const RunOptions& options) {
  script::ScriptProfiler profiler;
  const script::ObserveNewHosts observed(options.profile ? &profiler : nullptr);
  std::unique_ptr<RunSetup> run;
  if (const int code = SetUpRun(options, run); code != kOk) return code;
  const auto print_profile = [&] {
    constexpr std::size_t kMostFunctions = 40;
    if (options.profile) std::cerr << profiler.Table(run->session->simulation().tick(), kMostFunctions);
  };
  if (!run->options.headless) {
    const int code =
        ProgramWindow()->Run(*run->session, run->options, run->data, {run->scenario, run->settings, run->header});
    print_profile();
    return code;
  }
  const int code = RunHeadless(*run->session, run->options);
  print_profile();
  if (run->session->gateway() != nullptr) Note(run->session->gateway()->Describe());
  return code;
}

}  // namespace soarbox::app
