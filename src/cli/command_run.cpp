// SPDX-License-Identifier: BSD-2-Clause
#include "cli/command.h"
#include "cli/interpreter.h"
#include "cli/lookup.h"
#include "cli/run_text.h"

namespace soarbox::cli {
namespace {

using kernel::RunUnit;

constexpr OptionSpec kOptions[] = {
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

int Size(RunUnit unit) {
  switch (unit) {
    case RunUnit::kElaboration:
      return 0;
    case RunUnit::kPhase:
      return 1;
    case RunUnit::kDecision:
      return 2;
    case RunUnit::kOutput:
      return 3;
    case RunUnit::kForever:
      return 4;
  }
  return 4;
}

/// How often the agent has come to the stop phase so far.
std::uint64_t StopsPassed(const kernel::Agent& agent) {
  return agent.counters().decision_cycles + (agent.next_phase() >= agent.settings().stop_phase ? 1 : 0);
}

/// Whether an interrupt came in the last unit that was asked for: then it cut nothing off.
bool BeganLastUnit(const kernel::Agent& agent, const RunRequest& request, std::uint64_t stops_before) {
  switch (request.unit) {
    case RunUnit::kElaboration:
      return true;
    case RunUnit::kPhase:
      return request.count == 1;
    case RunUnit::kDecision: {
      const bool arrived = agent.next_phase() == agent.settings().stop_phase && !agent.in_middle_of_phase();
      return StopsPassed(agent) - stops_before + (arrived ? 0 : 1) >= request.count;
    }
    case RunUnit::kOutput:
    case RunUnit::kForever:
      return false;
  }
  return false;
}

}  // namespace

const std::span<const OptionSpec> kRunOptions = kOptions;

bool CommandRun(CommandCall& call) {
  ParsedWords parsed;
  if (!call.Parse(kOptions, parsed)) return false;
  RunRequest request;
  bool has_unit = false;
  for (const ParsedOption& option : parsed.options) {
    if (ReadUnit(std::string(1, option.letter), request.unit)) has_unit = true;
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
    const auto count = ParseInteger(parsed.arguments.front().text);
    if (!count) return call.Fail("Integer count expected.");
    if (*count < 0 || (*count == 0 && has_unit && request.unit != RunUnit::kDecision)) {
      return call.Fail("Count must be positive.");
    }
    request.count = static_cast<std::uint64_t>(*count);
    if (!has_unit) request.unit = RunUnit::kDecision;
  }
  request.interleave_given = parsed.Has('i');
  if (Size(request.interleave) > Size(request.unit)) {
    if (parsed.Has('i')) return call.Fail("Run type and interleave setting incompatible.");
    request.interleave = request.unit;
  }
  Host& host = call.interpreter.host();
  if (host.IsRunning(call.session)) return call.Fail("Soar is already running");

  kernel::Agent& agent = call.agent();
  const std::uint64_t stops_before = StopsPassed(agent);
  const RunCounts before = RunCounts::Of(agent);
  kernel::RunResult run;
  {
    PrintStream::Uncaptured uncaptured(call.stream());
    run = host.Run(call.session, request);
  }
  if (run.reason == kernel::StopReason::kInterrupted && BeganLastUnit(agent, request, stops_before)) {
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
