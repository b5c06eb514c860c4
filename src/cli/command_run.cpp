// SPDX-License-Identifier: BSD-2-Clause
#include "cli/command.h"
#include "cli/interpreter.h"
#include "cli/lookup.h"
#include "cli/run_text.h"

namespace soarbox::cli {
namespace {

using kernel::RunUnit;

constexpr OptionSpec kRunOptionList[] = {
    {'d', "decision", OptionArgument::kNone, "count decision cycles"},
    {'e', "elaboration", OptionArgument::kNone, "count elaboration cycles"},
    {'g', "goal", OptionArgument::kNone, "stop when the state that is the lowest now has been removed"},
    {'i', "interleave", OptionArgument::kRequired, "with several agents, change after each e, p, d or o"},
    {'n', "noupdate", OptionArgument::kNone, "leave the world as it is"},
    {'o', "output", OptionArgument::kNone, "count outputs"},
    {'p', "phase", OptionArgument::kNone, "count phases"},
    {'s', "self", OptionArgument::kNone, "run this agent only"},
    {'u', "update", OptionArgument::kNone, "let the world advance"},
};

bool ReadUnit(std::string_view letter, RunUnit& unit) {
  if (letter == "e")
    unit = RunUnit::kElaboration;
  else if (letter == "p")
    unit = RunUnit::kPhase;
  else if (letter == "d")
    unit = RunUnit::kDecision;
  else if (letter == "o")
    unit = RunUnit::kOutput;
  else
    return false;
  return true;
}

/// Number of cycles that a run by decisions executes before it continues to the stop phase.
std::uint64_t CyclesOf(const kernel::Agent& agent, const RunRequest& request) {
  const bool at_stop = agent.next_phase() == agent.settings().stop_phase;
  return request.count > 0 && !at_stop ? request.count - 1 : request.count;
}

/// Whether an interrupted run is nevertheless complete, because the interrupt came at its end.
bool IsComplete(const RunRequest& request, bool by_phase, std::uint64_t cycles, std::uint64_t wanted_cycles) {
  if (by_phase) return true;
  return request.unit == RunUnit::kElaboration || (request.unit == RunUnit::kDecision && cycles >= wanted_cycles);
}

}  // namespace

const std::span<const OptionSpec> kRunOptions = kRunOptionList;

bool CommandRun(CommandCall& call) {
  ParsedWords parsed;
  if (!call.Parse(kRunOptions, parsed)) return false;
  RunRequest request;
  bool has_unit = false;
  // The smallest unit is used.
  for (const std::string_view letter : {"e", "p", "d", "o"}) {
    if (!has_unit && parsed.Has(letter.front())) has_unit = ReadUnit(letter, request.unit);
  }
  request.self_only = parsed.Has('s');
  request.until_goal_removed = parsed.Has('g');
  request.update_world = parsed.Has('u') || (!request.self_only && !parsed.Has('n'));
  if (const auto interleave = parsed.Argument('i')) {
    request.interleave_given = true;
    if (!ReadUnit(*interleave, request.interleave)) {
      call.Out("Invalid interleave switch: " + *interleave + "\n\n");
      return call.FailPrinted();
    }
  }
  if (parsed.arguments.size() > 1) {
    return call.Fail(
        "Syntax: run  [-f|count]\nrun -[d|e|o|p][s][un][g] [f|count]\nrun -[d|e|o|p][un] count [-i e|p|d|o]");
  }
  if (!parsed.arguments.empty()) {
    const auto count = ParseLeadingInteger(parsed.arguments.front().text);
    if (!count) return call.Fail("Integer count expected.");
    if (*count < 0 || (*count == 0 && has_unit && request.unit != RunUnit::kDecision)) {
      return call.Fail("Count must be positive.");
    }
    request.count = static_cast<std::uint64_t>(*count);
    if (!has_unit) request.unit = RunUnit::kDecision;
  }
  request.interleave_given = parsed.Has('i');
  const bool fixed = request.unit == RunUnit::kPhase || request.unit == RunUnit::kElaboration;
  if (request.interleave > request.unit || (fixed && request.interleave != request.unit)) {
    if (parsed.Has('i')) return call.Fail("Run type and interleave setting incompatible.");
    request.interleave = request.unit;
  }
  Host& host = call.interpreter.host();
  if (host.IsRunning(call.session)) return call.Fail("Soar is already running");

  kernel::Agent& agent = call.agent();
  const std::uint64_t wanted_cycles = CyclesOf(agent, request);
  const RunCounts before = RunCounts::Of(agent);
  kernel::RunResult run;
  {
    PrintStream::Uncaptured uncaptured(call.stream());
    run = host.Run(call.session, request);
  }
  const RunUnit own = request.unit == RunUnit::kForever ? RunUnit::kPhase : request.unit;
  const bool by_phase = (request.interleave_given ? request.interleave : own) == RunUnit::kPhase;
  if (run.reason == kernel::StopReason::kInterrupted && IsComplete(request, by_phase, run.decisions, wanted_cycles)) {
    run.reason = kernel::StopReason::kCompleted;
  }
  const std::vector<std::string> lines = RunLines(agent, before, run);
  for (const std::string& line : lines) {
    call.AddArgument("message", "string", line);
    call.Out(line);
  }
  if (run.reason != kernel::StopReason::kCompleted && !agent.halted()) call.AddArgument("runresult", "int", "4");
  if (agent.out_of_memory()) call.failure = CommandCall::Failure::kReported;
  return !agent.out_of_memory();
}

}  // namespace soarbox::cli
