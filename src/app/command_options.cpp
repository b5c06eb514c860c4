// SPDX-License-Identifier: BSD-2-Clause
#include "app/command_options.h"

#include "app/argument_kinds.h"
#include "app/usage_errors.h"
#include "debugger/views.h"

namespace soarbox::app {
namespace {

/// Maximum duration of a run in simulated seconds. Above it, the number of ticks would no longer be exact.
constexpr double kLongest_s = 1e7;

/// The words for --view, for its help.
std::string ViewsText() {
  std::string text;
  for (const debugger::ViewInfo& view : debugger::Views()) {
    text += (text.empty() ? "" : ", ") + std::string(view.name);
    if (!view.of.empty()) text += " " + std::string(view.of);
  }
  return text + ", panel PANEL";
}

void AddBrowser(CLI::App& command, WindowWishes& wishes) {
  command.add_flag("--browser", wishes.browser, "Show it in the browser of this machine instead of a window");
  command.add_option("--page", wishes.page, "For --browser: as for `soarbox serve`")->check(CLI::ExistingDirectory);
}

/// Adds the options of a window.
void AddWindow(CLI::App& command, WindowWishes& wishes) {
  command
      .add_option("--detail", wishes.detail,
                  "Detail of the picture: low, full, or auto, which is low without a graphics card")
      ->capture_default_str()
      ->check(CLI::IsMember(WordsOf("--detail")));
  command
      .add_option("--render-scale", wishes.render_scale,
                  "Draw the scene with this share of the picture's width and height, 0.5 to 1, and enlarge it; "
                  "texts stay sharp (default: 1 with a graphics card, else what 30 pictures per second allow)")
      ->check(NumberIn(0.5, 1.0));
  command.add_option("--panels", wishes.panels,
                     "Panels around the picture, for this run: default, none, or a list such as agents,mind,timeline");
  command.add_option("--text", wishes.text_percent, "Text size of these panels, 75 to 200 percent")
      ->capture_default_str()
      ->check(NumberIn(75, 200));
  command
      .add_option("--width", wishes.width_px,
                  "Width of the window in pixels (default: what suits the display, or as in the recorded window; 1280 "
                  "for a picture)")
      ->check(NumberIn(160, 7680));
  command.add_option("--height", wishes.height_px, "Height of the window in pixels (720 for a picture)")
      ->check(NumberIn(120, 4320));
  command.add_option("--ui-script", wishes.ui_script,
                     "Play the mouse and keyboard events in this file, then end (see docs/window.md)");
}

void AddSeedAndPath(CLI::App& command, auto& options) {
  command.add_option("--seed", options.seed, "As for `soarbox run`")->check(WholeNumber());
  command.add_option("--path", options.extra_folders, "As for `soarbox run`")->check(CLI::ExistingDirectory);
}

void AddJobs(CLI::App& command, auto& jobs) {
  command.add_option("--jobs", jobs, "Runs at a time; 0: one per processor")
      ->capture_default_str()
      ->check(NumberIn(0, 1000));
}

void AddRun(CLI::App& program, RunOptions& options) {
  CLI::App* run = program.add_subcommand("run", "Run a scenario, in a window or headless");
  run->add_option("scenario", options.scenario,
                  "A folder with scenario.toml or Sandbox.lua, a scenario, Lua or rules file (scout.soar: one agent in "
                  "a field), "
                  "or a name that `soarbox list` shows")
      ->capture_default_str();
  AddBrowser(*run, options);
  AddWindow(*run, options);
  run->add_flag("--headless", options.headless,
                "Run without a window, for as long as the scenario says, else for 60 simulated seconds");
  run->add_option("--seconds", options.seconds,
                  "End after this many simulated seconds (default: until the window is closed; headless: the "
                  "scenario's, else 60)")
      ->check(NumberIn(0, kLongest_s));
  run->add_option("--seed", options.seed,
                  "Seed of the world, the scripts and the minds (default: the scenario's own, else 1)")
      ->check(WholeNumber());
  run->add_option("--speed", options.speed, "Times real time (default: 1 in a window, as fast as possible headless)")
      ->check(NumberIn(0.001, 1000.0));
  run->add_option("--path", options.extra_folders, "Search this folder for scripts and rules too (may be repeated)")
      ->check(CLI::ExistingDirectory);
  run->add_option("--rules", options.rules,
                  "Give the agent of this name the rules in this file instead (may be repeated); the first of several "
                  "agents eater-1, eater-2 is also called eater");
  CLI::Option* picture =
      run->add_option("--screenshot", options.screenshot, "Save a picture to this PNG file, then end");
  run->add_option("--at", options.screenshot_at_s, "Simulated seconds at which to take the picture")
      ->needs(picture)
      ->capture_default_str()
      ->check(NumberIn(0, kLongest_s));
  run->add_option("--show", options.show,
                  "Overlays to switch on at the start, separated by commas: " + ListedWordsOf("--show"))
      ->delimiter(',');
  run->add_option("--select", options.select, "Select this agent from the start");
  run->add_option("--camera", options.camera,
                  "Where to look from: " + ListedWordsOf("--camera") + "; all but free and map require --select");
  run->add_flag("--json", options.json, "Print events as lines of JSON");
  run->add_flag("--every-command", options.every_command, "Print each command of each tick, not only changes");
  run->add_flag("--profile", options.profile,
                "Print at the end how often functions of Lua scripts were called, and how long they took");
  run->add_option("--report", options.report_s, "Print where all agents are, at this interval in simulated seconds")
      ->check(NumberIn(0.001, kLongest_s));
  run->add_option(
         "--threads", options.threads,
         "Threads on which the Soar minds decide, if no debugger can attach; 0: one per core. The run is the same with "
         "any number")
      ->capture_default_str()
      ->check(NumberIn(0, 64));
  run->add_option("--memory", options.memory_mb,
                  "MB that the world may use, scripts, minds and bodies together; above it, the largest mind is halted")
      ->capture_default_str()
      ->check(NumberIn(64, 1'000'000));
  run->add_option("--input", options.input,
                  "Read inputs (keys, pointer, commands) with their ticks from this text file (see docs/command.md)");
  run->add_flag(
      "--watch", options.watch,
      "Reload edited rules and scripts into the running world; working memory is kept (a window always does this)");
  run->add_option("--port", options.port,
                  "Let Soar debuggers on this machine attach at this TCP port; 0: none (default: 12121 with a window, "
                  "none headless)")
      ->check(NumberIn(0, 65535));
  CLI::Option* record = run->add_option("--record", options.record, "Record the run to this file (docs/recording.md)");
  run->add_flag("--no-record", options.no_record,
                "Record nothing; otherwise a run in a window is recorded in ~/.local/state/soarbox")
      ->excludes(record);
  run->add_option("--record-level", options.record_level, "How much to record")->capture_default_str();
  run->add_option("--record-limit", options.record_limit_mb,
                  "Megabytes at which the older half of the recording is dropped (default: none; 256 in a window)")
      ->check(NumberIn(1.0, 1e6));
  run->add_option("--kernel", options.kernel, "Use a Soar kernel in another process instead of Soarbox's own");
  run->add_option("--dis", options.dis, "Join other simulations (IEEE 1278.1; docs/dis.md)");
  run->add_option("--kernel-limit", options.kernel_limit_s,
                  "Seconds without an answer after which this kernel counts as gone")
      ->capture_default_str()
      ->check(NumberIn(0.01, 3600.0));
}

void AddWatch(CLI::App& program, RunOptions& options) {
  CLI::App* watch =
      program.add_subcommand("watch", "Show the agents of a Soar kernel that another program drives, with all panels");
  watch->add_option("address", options.follow, "Where the kernel listens: HOST:PORT, HOST or, on this machine, :PORT")
      ->default_str("127.0.0.1:12121");
  AddBrowser(*watch, options);
  AddWindow(*watch, options);
  watch->add_flag("--headless", options.headless, "Print what the agents do, without a window, until the kernel ends");
  watch->add_option("--seconds", options.seconds, "End after this many simulated seconds; a decision takes 1/30 s")
      ->check(NumberIn(0, kLongest_s));
  watch->add_option("--select", options.select, "Select this agent from the start");
  watch->add_flag("--json", options.json, "Print events as lines of JSON");
}

void AddSoar(CLI::App& program, SoarShellOptions& options) {
  CLI::App* soar = program.add_subcommand("soar", "The interactive shell of the Soar command language");
  soar->add_option("files", options.files, "Files to source first, in order");
  soar->add_flag("--json", options.json, "Answer each command with a line of JSON");
}

void AddLooks(CLI::App& program, CheckOptions& check, WhyOptions& why) {
  CLI::App* checks = program.add_subcommand("check", "Check rules, scripts and scenario files without running them");
  checks->add_option("files", check.files, "Files (.soar, .lua, .toml) and folders")->required();
  checks->add_flag("--json", check.json, "One line of JSON per problem");

  CLI::App* reasons = program.add_subcommand("why", "Explain why an agent does what it does at a moment of a run");
  reasons->add_option("scenario", why.scenario, "As for `soarbox run`, or a recording")->required();
  reasons->add_option("topic", why.topic,
                      "A command, an operator or a rule of the agent: explain why it happens, or does not");
  reasons->add_flag("--json", why.json, "Print the answer as JSON, as a tree");
  reasons->add_option("--agent", why.agent, "The agent's name (default: the first one with a mind)");
  reasons->add_option("--at", why.at_s, "Simulated seconds (default: 5, or the end of a shorter recording)")
      ->check(NumberIn(0.0, 36000.0));
  AddSeedAndPath(*reasons, why);
}

void AddInspect(CLI::App& program, InspectOptions& options) {
  CLI::App* inspect = program.add_subcommand("inspect", "Print what a debugger shows of an agent at a moment of a run");
  inspect->add_option("source", options.source, "A scenario as for `soarbox run`, or a recording")->required();
  inspect->add_option("--agent", options.agent, "The agent's name (default: the first one with a Soar mind)");
  inspect->add_option("--at", options.at_s, "Simulated seconds")->capture_default_str()->check(NumberIn(0.0, 36000.0));
  inspect->add_option("--view", options.view, "What to show: " + ViewsText())->capture_default_str();
  inspect->add_option("--from", options.from_s, "Where views over ticks begin, in simulated seconds")
      ->capture_default_str()
      ->check(NumberIn(0.0, 36000.0));
  inspect->add_option(
      "--until", options.until,
      "Stop sooner: fire RULE, operator NAME, number \"^ATTRIBUTE < NUMBER\", command NAME, ... (see docs/inspect.md)");
  inspect->add_option("--kernel", options.kernel,
                      "As for `soarbox run`; facts that only Soarbox's own kernel reports are missing");
  inspect->add_flag("--json", options.json, "Print it as JSON");
  inspect->add_flag("--recorded", options.recorded, "Show what the recording holds; do not simulate it again");
  AddSeedAndPath(*inspect, options);
}

void AddTest(CLI::App& program, TestOptions& options) {
  CLI::App* test =
      program.add_subcommand("test", "Run missions: check that agents do what they should, over many seeds");
  test->add_option("paths", options.paths, "Missions, scenarios and folders (default: all below this folder)");
  test->add_option("--seeds", options.seeds, "1..20 or 1,4,7, instead of the missions' own");
  test->add_option("--rules", options.rules, "As for `soarbox run`");
  AddJobs(*test, options.jobs);
  test->add_option("--junit", options.junit, "Write the results to this file as JUnit XML, for continuous integration");
  test->add_flag("--json", options.json, "One line of JSON per run, then one per mission");
  test->add_flag("--watch", options.watch, "Test again whenever a file is saved");
  test->add_flag("--empty", options.empty,
                 "Run with minds that have no rules: a mission that then passes tests nothing");
  CLI::Option* keep = test->add_option("--keep", options.keep, "Keep recordings of runs that fail in this folder");
  test->add_flag("--no-keep", options.no_keep, "Keep no recordings")->excludes(keep);
}

void AddSweep(CLI::App& program, SweepOptions& options) {
  CLI::App* sweep = program.add_subcommand(
      "sweep", "Run each variant of a scenario with each seed and make a table, on all cores or on Slurm");
  sweep->add_option("spec", options.spec, "What to run: a file (docs/sweeps.md), or a scenario that comes with a sweep")
      ->required();
  sweep->add_flag("--verify", options.verify,
                  "Repeat runs of this sweep's folder and compare them with the stored results");
  sweep->add_option("--sample", options.sample, "How many runs --verify repeats, 0 for all")->capture_default_str();
  sweep->add_flag("--json", options.json, "One line of JSON per run, then one about the sweep");
  sweep->add_option("--folder", options.folder,
                    "Where rows, tables and variants go (default: the spec's name with .sweep)");
  sweep->add_option("--rules", options.rules, "As for `soarbox run`, in each variant");
  AddJobs(*sweep, options.jobs);
  sweep->add_option("--on", options.on, "Where to run: here, or slurm (as a job array)")
      ->capture_default_str()
      ->check(CLI::IsMember(WordsOf("--on")));
  sweep->add_option("--tasks", options.tasks, "Tasks of the job array")
      ->capture_default_str()
      ->check(NumberIn(1, 100000));
  sweep->add_option("--task", options.task, "Make only this part of the runs, 0 to tasks - 1, and no tables")
      ->check(NumberIn(0, 100000));
  sweep->add_option("--sbatch", options.sbatch,
                    "An argument of sbatch, such as --sbatch=--partition=short (may be repeated)");
  sweep->add_flag("--cancel", options.cancel, "End the sweep's job on Slurm");
  sweep->add_flag("--mix", options.mix, "Continue even if another build of the program made the existing rows");
  sweep->add_flag("--retry", options.retry, "Repeat runs that crashed or hung three times");
}

void AddReport(CLI::App& program, ReportOptions& options) {
  CLI::App* report =
      program.add_subcommand("report", "Write one page about a recording or a sweep, to send to somebody");
  report->add_option("source", options.source, "A recording, a folder of recordings, a sweep")->required();
  report->add_option("-o,--output", options.output, "Write the page to this file")->capture_default_str();
  report->add_option("--plots", options.plots,
                     "Write its plots into this folder instead of the page, as SVG and PNG files");
}

void AddLearn(CLI::App& program, LearnOptions& options) {
  CLI::App* learn = program.add_subcommand("learn", "Lessons that grade what you write");
  learn->add_option("words", options.words,
                    "[COURSE] [N | next | check N | hint N | reset N | test [N]]; without words, it lists the lessons");
  learn->add_option("--folder", options.folder, "Where your files are (default: ~/soarbox-lessons)");
  learn
      ->add_option("--from", options.from, "Use the lessons in this folder instead of those that come with the program")
      ->check(CLI::ExistingDirectory);
  learn->add_flag("--json", options.json, "Print the list as lines of JSON");
  learn->add_flag("--headless", options.headless, "Do not open the window");
  learn->add_flag("--progress", options.progress, "Print a line for each seed that is graded");
  RunOptions& window = options.window;
  AddWindow(*learn, window);
  learn->add_option("--port", window.port, "As for `soarbox run`")->check(NumberIn(0, 65535));
  learn->add_flag("--no-record", window.no_record, "As for `soarbox run`");
}

void AddNew(CLI::App& program, NewOptions& options) {
  CLI::App* made = program.add_subcommand("new",
                                          "Write a commented starter scenario with a test into a new folder: one "
                                          "agent made of Soar rules, or another kind");
  made->add_option("name", options.name, "The folder to create; its last part is the scenario's name")->required();
  CLI::Option* of_lua = made->add_flag("--lua", options.lua, "A world made by a Lua script, with a body of its own");
  CLI::Option* of_team = made->add_flag("--team", options.team, "Two teams of Soar agents");
  of_lua->excludes(of_team);
}

void AddKernel(CLI::App& program, KernelServerOptions& options) {
  CLI::App* kernel = program.add_subcommand("kernel", "Serve a Soar kernel to clients and debuggers on this machine");
  kernel->add_option("agents", options.agents, "One agent per file of rules");
  kernel->add_option("--port", options.port, "TCP port; 0: any free one")
      ->capture_default_str()
      ->check(NumberIn(0, 65535));
  kernel->add_option("--record", options.record,
                     "Record what clients do to the agents, for `soarbox replay`, `why` and the like");
  kernel->add_flag("--no-log", options.no_log,
                   "Keep no log of what clients do: `soarbox watch` cannot show the agents");
  kernel->add_option("--secret-file", options.secret_file,
                     "Serve only clients that show the secret in the first line of this file");
}

void AddEditors(CLI::App& program, FormatOptions& format, DatamapOptions& datamap, std::string& folder) {
  CLI::App* lays_out = program.add_subcommand("format", "Format files of rules in place");
  lays_out->add_option("files", format.files, "Files of rules (.soar) and folders")->required();
  lays_out->add_flag("--check", format.check, "Change nothing; name the files that would be changed");
  CLI::App* maps = program.add_subcommand("datamap", "Write a project for VisualSoar, with a datamap of the rules");
  maps->add_option("rules", datamap.rules, "The file of rules that loads all others")->required();
  maps->add_option("-o,--output", datamap.output, "Write to this file, such as scout.vsa.json");
  program.add_subcommand("lsp", "Serve an editor on standard input and output (docs/editors.md)");
  program.add_subcommand("dap", "Serve an editor's debugger on standard input and output (docs/editors.md)");
  program.add_subcommand("mcp", "Serve a coding assistant on standard input and output (docs/editors.md)")
      ->add_option("--folder", folder, "Let it read below this folder only")
      ->capture_default_str();
}

void AddServe(CLI::App& program, ServeOptions& options, EngineOptions& engine) {
  CLI::App* serve = program.add_subcommand("serve", "Serve lessons and worlds to browsers (docs/serve.md)");
  serve->add_option("scenario", options.scenario,
                    "The scenario that every visitor sees first (default: a list to choose from)");
  serve->add_option("--listen", options.listen, "Address and port; beyond this machine only with --token or --open")
      ->capture_default_str();
  CLI::Option* token = serve->add_option("--token", options.token, "Serve only visitors who have this secret");
  serve
      ->add_option("--token-file", options.token_file,
                   "Read the secret from the first line of this file; or set SOARBOX_TOKEN")
      ->check(CLI::ExistingFile)
      ->excludes(token);
  serve->add_flag("--open", options.open, "Serve anybody who reaches the address")->excludes(token);
  serve->add_option("--class", options.class_list,
                    "Names of learners, one a line: each gets a link, and the teacher one");
  serve->add_option("--lti", options.lti,
                    "Learning platforms (Moodle, Canvas) that may open lessons and get grades (docs/lti.md)");
  serve->add_option("--sessions", options.sessions, "Runs at a time")->capture_default_str()->check(NumberIn(1, 10000));
  serve->add_option("--each", options.each, "Simultaneous runs per client address (default: 3/4 of --sessions)")
      ->check(NumberIn(1, 10000));
  serve->add_option("--memory", options.memory_mb, "MB that one world may use")
      ->capture_default_str()
      ->check(NumberIn(64, 1'000'000));
  serve->add_option("--idle", options.idle_min, "Minutes after which a run without viewers ends")
      ->capture_default_str()
      ->check(NumberIn(1, 100'000));
  serve->add_option("--hang", options.hang_s, "Seconds after which a run that sends no heartbeat is ended")
      ->capture_default_str()
      ->check(NumberIn(2, 100'000));
  serve->add_flag("--no-wall", options.no_wall,
                  "Run worlds with all rights of the server's user; only the interpreters of Soar and Lua limit which "
                  "files a world can use");
  serve->add_option("--state", options.state, "Keep the files, progress and recordings of all visitors in this folder");
  serve->add_option("--host", options.hosts, "A name by which browsers call the server (may be repeated)");
  serve->add_option("--proxy", options.proxies, "Believe X-Forwarded-For of this address (may be repeated)");
  serve->add_option("--embed", options.embedders,
                    "Let this site, https://NAME, show worlds in its pages (may be repeated)");
  serve->add_flag("--dis", options.dis, "Let worlds join exercises of other simulations, as they say (docs/dis.md)");
  serve->add_option("--page", options.page, "Serve the page in this folder instead of the program's own")
      ->check(CLI::ExistingDirectory);
  // The server starts it with a connection; users do not.
  CLI::App* runs = program.add_subcommand("engine", "Run one world for a server")->group("");
  runs->add_option("--world", engine.world);
  runs->add_option("--from", engine.from);
  runs->add_option("--run", engine.run);
  runs->add_option("--follow", engine.follow);
  runs->add_option("--seed", engine.seed);
  runs->add_option("--lesson", engine.lesson);
  runs->add_option("--recording", engine.recording);
  runs->add_option("--home", engine.home)->required();
  runs->add_option("--match", engine.match);
  runs->add_option("--seconds", engine.match_s);
  runs->add_option("--memory", engine.memory_mb);
  runs->add_flag("--walled", engine.is_walled);
  runs->add_flag("--join", engine.may_join);
  runs->add_option("--dis", engine.dis);
}

void AddHelp(CLI::App& program, HelpOptions& options) {
  CLI::App* help = program.add_subcommand("help", "Print the help of a sub-command");
  help->add_option("command", options.command, "The sub-command (default: the entire program)");
  help->add_flag("--man", options.man, "Print it as a manual page, for man -l -");
  help->add_option("--pages", options.pages, "Write all manual pages into this folder");
  help->add_flag("--markdown", options.markdown, "Print all sub-commands with their options as one page in Markdown");
}

void AddRecordingFile(CLI::App& command, RecordingOptions& options) {
  command.add_option("file", options.file, "A recording, as `soarbox run --record` makes them")->required();
}

void AddRange(CLI::App& command, RecordingOptions& options) {
  command.add_option("--from", options.from_s, "Begin at this simulated second")->check(NumberIn(0, kLongest_s));
  command.add_option("--to", options.to_s, "End at this simulated second")->check(NumberIn(0, kLongest_s));
}

void AddThreads(CLI::App& command, RecordingOptions& options) {
  command.add_option("--threads", options.threads, "Threads on which the minds decide; 0: one per core")
      ->check(NumberIn(0, 256));
}

void AddRecordings(CLI::App& program, RecordingOptions& options) {
  CLI::App* replay = program.add_subcommand("replay", "Show a recording, in the window or as text");
  AddRecordingFile(*replay, options);
  AddRange(*replay, options);
  replay->add_flag("--headless", options.headless, "Print what happened, tick by tick");
  replay->add_flag("--json", options.json, "Print it as lines of JSON");
  replay->add_flag("--info", options.info, "Print which files and which program made the recording, then end");
  replay->add_option("--pictures", options.pictures, "Draw pictures into this folder, without a window");
  replay->add_option("--video", options.video,
                     "Draw an animation: a .gif, or with ffmpeg another format, by the file's ending");
  replay
      ->add_option("--every", options.every_s,
                   "Simulated seconds from picture to picture (default: 1; 0.1 for an animation)")
      ->check(NumberIn(0.001, kLongest_s));
  replay->add_flag("--plan", options.is_plan, "Draw these pictures from straight above");
  replay->add_option("--select", options.select, "Select this agent from the start; pictures follow it");
  AddBrowser(*replay, options);
  AddWindow(*replay, options);
  CLI::App* verify = program.add_subcommand("verify", "Simulate a recorded run again and compare every tick");
  AddRecordingFile(*verify, options);
  AddThreads(*verify, options);
  verify->add_flag("--as-recorded", options.as_recorded,
                   "Use the scenario's files as they were when the run began, not as they are now");
  CLI::App* export_data = program.add_subcommand("export", "Write a recording as a table or as JSON");
  AddRecordingFile(*export_data, options);
  AddRange(*export_data, options);
  CLI::Option* csv = export_data->add_flag("--csv", options.csv, "Write a row for each agent and tick (the default)");
  export_data->add_flag("--json", options.json, "Write everything, one line per tick")->excludes(csv);
  CLI::Option* output = export_data->add_option("-o,--output", options.output, "Write to this file");
  export_data
      ->add_flag("--tidy", options.tidy,
                 "Write tables in long form: agents, events and percepts. The output is a folder of CSV files, or a "
                 ".sqlite file")
      ->excludes(csv)
      ->needs(output);
  export_data
      ->add_flag("--recording", options.as_recording, "Write the part from --from to --to as a recording of its own")
      ->excludes(csv)
      ->needs(output);
  CLI::App* resume =
      program.add_subcommand("resume", "Go back to a moment of a recording and continue live from there");
  AddRecordingFile(*resume, options);
  AddThreads(*resume, options);
  resume->add_option("--at", options.at_s, "Continue from this simulated second")
      ->required()
      ->check(NumberIn(0, kLongest_s));
  resume->add_option("--rules", options.rules,
                     "Replace rules by those of the same names in this file (may be repeated)");
  resume->add_option("--agent", options.agents, "Replace only this agent's rules (may be repeated)");
  resume->add_option("--seconds", options.seconds, "Continue for this long (default: as long as the recording)")
      ->check(NumberIn(0, kLongest_s));
  resume->add_option("--record", options.output, "Record the whole new run to this file");
  resume->add_flag("--json", options.json, "Print events as lines of JSON");
  CLI::App* compare =
      program.add_subcommand("compare", "Report where two recordings differ first, and how they continue");
  AddRecordingFile(*compare, options);
  compare->add_option("other", options.other, "The second recording")->required();
}

}  // namespace

void AddCommands(CLI::App& program, CommandOptions& options) {
  AddRun(program, options.run);
  AddSoar(program, options.soar);
  AddKernel(program, options.kernel);
  AddWatch(program, options.run);
  AddNew(program, options.made);
  AddRecordings(program, options.recording);
  AddLooks(program, options.check, options.why);
  AddInspect(program, options.inspect);
  AddSweep(program, options.sweep);
  AddReport(program, options.report);
  AddLearn(program, options.learn);
  AddTest(program, options.test);
  program.add_subcommand("list", "List the scenarios that come with the program");
  // Added after `list`, so that `list` and not `lsp` is suggested for "lst".
  AddEditors(program, options.format, options.datamap, options.assistant_folder);
  AddServe(program, options.serve, options.engine);
  AddHelp(program, options.help);
}

}  // namespace soarbox::app
