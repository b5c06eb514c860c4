// SPDX-License-Identifier: BSD-2-Clause
#include "app/recording_commands.h"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <optional>
#include <sstream>

#include "app/data_folders.h"
#include "app/exit_codes.h"
#include "app/open_recording.h"
#include "app/recording_info.h"
#include "app/recording_pictures.h"
#include "app/refuse.h"
#include "app/run_session.h"
#include "diagnostics/read_text.h"
#include "record/compare.h"
#include "record/export.h"
#include "record/manifest.h"
#include "record/operator_elements.h"
#include "record/reader.h"
#include "record/recorder.h"
#include "record/rerun.h"
#include "sweep/tidy_files.h"

namespace soarbox::app {
namespace {

void Tell(const std::vector<Diagnostic>& warnings) {
  for (const Diagnostic& warning : warnings) std::cerr << Format(warning);
}

/// Shows the progress of a long simulation on a terminal; Ctrl-C ends it.
record::Progress ShownProgress(std::uint64_t last_tick) {
  using Clock = std::chrono::steady_clock;
  return [last_tick, next = Clock::now() + std::chrono::seconds(2)](std::uint64_t tick) mutable {
    if (isatty(STDERR_FILENO) != 0 && Clock::now() >= next) {
      next = Clock::now() + std::chrono::milliseconds(500);
      std::fputs(fmt::format("\r\033[Ktick {} of {}{}", tick, last_tick, tick + 1 >= last_tick ? "\n" : "").c_str(),
                 stderr);
    }
    return !WasInterrupted();
  };
}

std::string Of(const record::Difference& difference) {
  return (difference.agent.empty() ? std::string() : difference.agent + "'s ") + difference.element;
}

}  // namespace

int PrintRecording(const RecordingOptions& options) {
  Result<std::unique_ptr<record::Reader>> reader = OpenRecording(options.file);
  if (!reader) return Refuse(reader.error());
  CatchInterrupts();
  if (options.info) {
    PrintRecordingInfo(**reader, options.json);
    return kOk;
  }
  const record::TickRange range = RangeOf(**reader, options);
  if (!options.pictures.empty() || !options.video.empty()) return DrawPictures(**reader, range, options);
  const Result<void> printed =
      options.json ? record::ExportJson(**reader, range, std::cout) : record::PrintTicks(**reader, range, std::cout);
  return printed ? static_cast<int>(kOk) : Refuse(printed.error());
}

int Verify(const RecordingOptions& options) {
  Result<std::unique_ptr<record::Reader>> reader = OpenRecording(options.file);
  if (!reader) return Refuse(reader.error());
  const Result<sim::DataFolders> data = FindDataFolders();
  if (!data) return Refuse(data.error());
  CatchInterrupts();
  const Result<record::Verdict> verdict =
      record::Verify(**reader, *data, ShownProgress((*reader)->last_tick()), options.threads,
                     options.as_recorded ? record::FilesFrom::kRecording : record::FilesFrom::kDisk);
  if (!verdict) return Refuse(verdict.error());
  Tell(verdict->warnings);
  if (verdict->interrupted) {
    std::cout << fmt::format("interrupted; equal up to tick {}\n", verdict->last_tick);
    return kCannotStart;
  }
  if (!verdict->difference) {
    std::cout << fmt::format("equal: ticks {} to {}, {:.3f} s\n", verdict->first_tick, verdict->last_tick,
                             static_cast<double>(verdict->last_tick) * (*reader)->header().step_s);
    return kOk;
  }
  const record::Difference& difference = *verdict->difference;
  std::cout << fmt::format("tick {} ({:.3f} s) differs: {}\n  recorded: {}\n  now:      {}\n", difference.tick,
                           static_cast<double>(difference.tick) * (*reader)->header().step_s, Of(difference),
                           difference.recorded, difference.now);
  return kProblems;
}

int Export(const RecordingOptions& options) {
  Result<std::unique_ptr<record::Reader>> reader = OpenRecording(options.file);
  if (!reader) return Refuse(reader.error());
  const record::TickRange range = RangeOf(**reader, options);
  if (options.tidy) {
    const Result<sweep::TidyCounts> written = sweep::WriteTidy(**reader, range, options.output);
    if (!written) return Refuse(written.error());
    std::cout << fmt::format("{}: {} rows of agents, {} of events, {} of percepts\n", options.output.string(),
                             written->agents, written->events, written->percepts);
    return kOk;
  }
  if (options.as_recording) {
    const Result<void> written = record::ExportRecording(**reader, range, options.output);
    return written ? static_cast<int>(kOk) : Refuse(written.error());
  }
  std::ofstream file;
  if (!options.output.empty()) {
    file.open(options.output, std::ios::binary);
    if (!file) return Refuse("this file cannot be written", "check the folder and its permissions", options.output);
  }
  std::ostream& out = options.output.empty() ? std::cout : file;
  const Result<void> written =
      options.json ? record::ExportJson(**reader, range, out) : record::ExportCsv(**reader, range, out);
  if (!written) return Refuse(written.error());
  out.flush();
  if (out) return kOk;
  return Refuse("writing failed; is the disk full?", {}, options.output);
}

namespace {

/// "file:line" of the first line that differs between two versions of a file.
std::string FirstOtherLine(const record::KeptFile& a, const record::KeptFile& b) {
  std::istringstream one(a.content), other(b.content);
  std::string line_a, line_b;
  for (int line = 1;; ++line) {
    const bool has_a = static_cast<bool>(std::getline(one, line_a));
    const bool has_b = static_cast<bool>(std::getline(other, line_b));
    if (!has_a && !has_b) return a.name;
    if (has_a != has_b || line_a != line_b) return a.name + ":" + std::to_string(line);
  }
}

void CompareFiles(const record::Header& a, const record::Header& b, std::vector<std::string>& lines) {
  if (a.files.empty() || b.files.empty()) {
    if (a.scenario_digest != b.scenario_digest)
      lines.emplace_back("their files differ; at least one recording does not contain its files");
    return;
  }
  const auto in = [](const record::Header& header, const record::KeptFile& file) {
    return std::ranges::find_if(header.files, [&](const record::KeptFile& other) {
      return other.folder == file.folder && other.name == file.name;
    });
  };
  for (const record::KeptFile& file : a.files) {
    const auto other = in(b, file);
    if (other == b.files.end()) lines.push_back("only A has the file " + file.name);
    if (other != b.files.end() && other->content != file.content)
      lines.push_back("files differ from " + FirstOtherLine(file, *other) + " on");
  }
  for (const record::KeptFile& file : b.files)
    if (in(a, file) == a.files.end()) lines.push_back("only B has the file " + file.name);
}

/// The inputs that differ between two runs: seeds, builds, rules.
std::vector<std::string> InputsThatDiffer(const record::Header& a, const record::Header& b) {
  std::vector<std::string> lines;
  if (a.seed != b.seed) lines.push_back(fmt::format("seeds differ: A {}, B {}", a.seed, b.seed));
  if (a.build != b.build) lines.push_back("builds differ: A " + a.build + ", B " + b.build);
  if (a.step_s != b.step_s) lines.push_back(fmt::format("ticks differ: A {} s, B {} s", a.step_s, b.step_s));
  if (a.own_kernel != b.own_kernel)
    lines.push_back(std::string("kernels differ: the minds of ") + (a.own_kernel ? "B" : "A") +
                    " ran in another kernel");
  CompareFiles(a, b, lines);
  if (a.replaced_rules != b.replaced_rules) {
    const auto tell = [](const record::Header& header) {
      std::string text;
      for (const auto& [agent, file] : header.replaced_rules) text += (text.empty() ? "" : ", ") + agent + "=" + file;
      return text.empty() ? std::string("none") : text;
    };
    lines.push_back("rules given on the command line differ: A " + tell(a) + ", B " + tell(b));
  }
  return lines;
}

}  // namespace

int Compare(const RecordingOptions& options) {
  Result<std::unique_ptr<record::Reader>> a = OpenRecording(options.file);
  if (!a) return Refuse(a.error());
  Result<std::unique_ptr<record::Reader>> b = OpenRecording(options.other);
  if (!b) return Refuse(b.error());
  const Result<record::Comparison> comparison = record::Compare(**a, **b);
  if (!comparison) return Refuse(comparison.error());
  const double step_s = (*a)->header().step_s;
  const std::vector<std::string> inputs = InputsThatDiffer((*a)->header(), (*b)->header());
  for (const std::string& line : inputs) std::cout << line << '\n';
  if (!comparison->difference) {
    std::cout << fmt::format("equal: ticks {} to {}\n", comparison->first_tick, comparison->last_tick);
    return kOk;
  }
  const auto tell = [&](const char* what, const record::Difference& difference) {
    std::cout << fmt::format("{}: tick {} ({:.3f} s), {}\n  A: {}\n  B: {}\n", what, difference.tick,
                             static_cast<double>(difference.tick) * step_s, Of(difference), difference.recorded,
                             difference.now);
  };
  tell("first difference", *comparison->difference);
  if (comparison->decision) {
    tell("first other decision", *comparison->decision);
    for (const auto& [name, source] : {std::pair{"A", a->get()}, {"B", b->get()}}) {
      const Result<std::string> elements =
          record::ElementsOfOperator(*source, comparison->decision->agent, comparison->decision->tick);
      if (elements && !elements->empty()) std::cout << "  " << name << ": " << *elements << '\n';
    }
    if (!comparison->why_a.empty()) std::cout << "  A: " << comparison->why_a << '\n';
    if (!comparison->why_b.empty()) std::cout << "  B: " << comparison->why_b << '\n';
    if (comparison->percepts.empty()) {
      std::cout << "  it perceived the same in both: "
                << (comparison->by_chance ? "chance selected, and other random numbers gave another result"
                                          : "its rules or its memory differ")
                << '\n';
    } else {
      std::cout << "  it perceived something else (A, B):\n";
      for (const std::string& line : comparison->percepts) std::cout << "    " << line << '\n';
    }
  }
  std::cout << "\n   time s   mean m    most m  agent             health A  health B  alive A  alive B\n";
  for (const record::Comparison::Moment& m : comparison->course) {
    std::cout << fmt::format("{:9.1f} {:8.3f} {:9.3f}  {:<16} {:9.1f} {:9.1f} {:8} {:8}\n", m.time_s, m.mean_distance_m,
                             m.greatest_distance_m, m.farthest.empty() ? "-" : m.farthest, m.health_a, m.health_b,
                             m.alive_a, m.alive_b);
  }
  return kProblems;
}

int Resume(const RecordingOptions& options) {
  Result<std::unique_ptr<record::Reader>> reader = OpenRecording(options.file);
  if (!reader) return Refuse(reader.error());
  const Result<sim::DataFolders> data = FindDataFolders();
  if (!data) return Refuse(data.error());
  std::string rules;
  for (const std::filesystem::path& file : options.rules) {
    const std::optional<std::string> text = ReadText(file);
    if (!text) return Refuse("these rules cannot be read", "check the name", file);
    rules.append(*text).append("\n");
  }
  CatchInterrupts();
  const std::uint64_t at = TickAt(**reader, options.at_s);
  Result<record::Rerun> rerun = record::GoTo(**reader, at, *data, ShownProgress(at), options.threads);
  if (!rerun) return Refuse(rerun.error());
  Tell(rerun->warnings);
  sim::Simulation& simulation = *rerun->simulation;
  std::cout << fmt::format("tick {} reached, its state is the recorded one: {:016x}\n", at, simulation.StateHash());
  for (const std::string& agent : options.agents) {
    if (!simulation.HasMind(agent)) return Refuse("there is no agent '" + agent + "' with a Soar mind at that time");
  }
  if (!rules.empty()) {
    for (std::size_t i = 0; i < simulation.soar_agents(); ++i) {
      const std::string agent = simulation.Mind(i).agent;
      if (!simulation.HasMind(agent)) continue;
      const bool wanted = options.agents.empty() ||
                          std::find(options.agents.begin(), options.agents.end(), agent) != options.agents.end();
      if (wanted) simulation.Submit(sim::Input{0, sim::CommandInput{agent, rules}, true});
    }
  }
  // Records the run from its beginning, not from `at_s`, so that it can be replayed, verified and compared.
  RunOptions run;
  run.scenario = (*reader)->header().scenario;
  run.json = options.json;
  run.headless = true;  // It ends when the scenario does.
  const double left_s =
      options.seconds.value_or(static_cast<double>((*reader)->last_tick() - at) * (*reader)->header().step_s);
  run.seconds = simulation.time_s() + left_s;
  std::unique_ptr<record::Recorder> recorder;
  if (!options.output.empty()) {
    record::Header header = (*reader)->header();
    header.build = record::BuildId();
    record::WriterSettings writing;
    writing.manifest = record::ManifestOfBranch(record::ManifestIn(options.file), header.build);
    std::error_code error;
    header.branched_from = std::filesystem::absolute(options.file, error).string();
    header.branch_tick = at;
    Result<std::unique_ptr<record::Writer>> writer = record::Writer::Create(options.output, header, writing);
    if (!writer) return Refuse(writer.error());
    if ((*reader)->first_tick() > 0) {
      Result<std::vector<record::TickInputs>> inputs = (*reader)->Inputs();
      if (!inputs) return Refuse(inputs.error());
      std::erase_if(*inputs, [&](const record::TickInputs& entry) { return entry.tick >= (*reader)->first_tick(); });
      if (const Result<void> added = (*writer)->AddEarlierInputs(*inputs); !added) return Refuse(added.error());
    }
    recorder = std::make_unique<record::Recorder>(std::move(*writer), header.level);
    for (std::uint64_t tick = (*reader)->first_tick(); tick <= at; ++tick) {
      const Result<const record::TickRecord*> record = (*reader)->At(tick);
      if (!record) return Refuse(record.error());
      if (const Result<void> added = recorder->Take(**record); !added) return Refuse(added.error());
    }
  }
  std::unique_ptr<EventPrinter> printer =
      options.json ? EventPrinter::MakeJson(std::cout) : EventPrinter::MakeText(std::cout, std::cerr);
  printer->Begin({run.scenario, (*reader)->header().seed, true});
  RunSession session(std::move(rerun->simulation), std::move(printer), run);
  session.Record(std::move(recorder), false);
  while (!session.IsOver()) session.Tick();
  return session.Finish();
}

}  // namespace soarbox::app
