// SPDX-License-Identifier: BSD-2-Clause
#include <fmt/format.h>

#include "cli/command.h"
#include "cli/learning_text.h"
#include "cli/session.h"
#include "cli/summary.h"
#include "cli/version.h"
#include "kernel/agent.h"

namespace soarbox::cli {
namespace {

using kernel::AgentCounters;
using kernel::ProductionType;

constexpr OptionSpec kStatsOptionList[] = {
    {'a', "agent", OptionArgument::kNone, "counters of the agent"},
    {'c', "cycle", OptionArgument::kNone, "accepted for old scripts"},
    {'C', "cycle-csv", OptionArgument::kNone, "accepted for old scripts"},
    {'d', "decision", OptionArgument::kNone, "the number of decisions"},
    {'l', "learning", OptionArgument::kNone, "figures of learning"},
    {'m', "memory", OptionArgument::kNone, "memory"},
    {'M', "max", OptionArgument::kNone, "the largest figures of one decision cycle"},
    {'r', "rete", OptionArgument::kNone, "the match network"},
    {'R', "reset", OptionArgument::kNone, "accepted for old scripts"},
    {'s', "system", OptionArgument::kNone, "everything that matters"},
    {'S', "sort", OptionArgument::kRequired, "accepted for old scripts"},
    {'t', "track", OptionArgument::kNone, "accepted for old scripts"},
    {'T', "stop-track", OptionArgument::kNone, "accepted for old scripts"},
};

double Ratio(std::uint64_t a, std::uint64_t b) {
  return b == 0 ? 0 : static_cast<double>(a) / static_cast<double>(b);
}

std::string RuleCountsText(const kernel::Agent& agent) {
  const std::uint32_t user = agent.CountProductions(ProductionType::kUser);
  const std::uint32_t defaults = agent.CountProductions(ProductionType::kDefault);
  const std::uint32_t chunks = agent.CountProductions(ProductionType::kChunk);
  return fmt::format("{} productions ({} default, {} user, {} chunks)\n   + {} justifications\n",
                     user + defaults + chunks, defaults, user, chunks,
                     agent.CountProductions(ProductionType::kJustification));
}

constexpr kernel::Phase kTimedPhases[] = {kernel::Phase::kInput, kernel::Phase::kPropose, kernel::Phase::kDecide,
                                          kernel::Phase::kApply, kernel::Phase::kOutput};

/// Milliseconds per unit of work.
double Each(double seconds, std::uint64_t count) {
  return count == 0 ? 0 : 1000 * seconds / static_cast<double>(count);
}

std::string TimesText(const RunTimes& times) {
  constexpr std::string_view kRule = "========================================================|===========\n";
  std::string phases, none;
  for (const kernel::Phase phase : kTimedPhases) {
    phases += fmt::format("    {:.3f}", times.phase_seconds(phase));
    none += "    0.000";
  }
  std::string text =
      "                                                        |   Computed\n"
      "Phases:      Input   Propose   Decide   Apply    Output |     Totals\n";
  text += kRule;
  text += fmt::format("Kernel:  {}  | {:10.3f}\n", phases, times.all_phases_seconds());
  text += kRule;
  text += "Input fn:    0.000                                      |      0.000\n";
  text += kRule;
  text += "Outpt fn:                                        0.000  |      0.000\n";
  text += kRule;
  text += fmt::format("Callbcks:{}  |      0.000\n", none);
  text += kRule;
  text += "Computed------------------------------------------------+-----------\n";
  text += fmt::format("Totals:  {}  | {:10.3f}\n\n", phases, times.all_phases_seconds());
  text +=
      fmt::format("Values from single timers:\n Kernel CPU Time: {:11.3f} sec. \n Total  CPU Time: {:11.3f} sec.\n\n",
                  times.kernel_seconds(), times.run_seconds());
  return text;
}

void System(CommandCall& call) {
  const kernel::Agent& agent = call.agent();
  const AgentCounters& counters = agent.counters();
  const RunTimes& times = call.session.times();
  if (times.on() && !times.measures_phases()) {
    call.Hint("only whole runs are timed", "'soar timers on' times phases and decision cycles too");
  }
  std::string text = fmt::format("Soar {} (Soarbox {})\n\n", TextOf(agent.settings().like), kSoarboxVersion);
  text += RuleCountsText(agent);
  text += TimesText(times);
  const double spent = times.kernel_seconds();
  text += fmt::format("{} decisions ({:.3f} msec/decision)\n", counters.decision_phases,
                      Each(spent, counters.decision_phases));
  text += fmt::format("{} elaboration cycles ({:.3f} ec's per dc, {:.3f} msec/ec)\n", counters.elaborations,
                      Ratio(counters.elaborations, counters.decision_phases), Each(spent, counters.elaborations));
  text += fmt::format("{} inner elaboration cycles\n", counters.inner_elaborations);
  text += fmt::format("{} p-elaboration cycles ({:.3f} pe's per dc, {:.3f} msec/pe)\n", counters.pe_elaborations,
                      Ratio(counters.pe_elaborations, counters.decision_phases), Each(spent, counters.pe_elaborations));
  text += fmt::format("{} production firings ({:.3f} pf's per ec, {:.3f} msec/pf)\n", counters.firings,
                      Ratio(counters.firings, counters.elaborations), Each(spent, counters.firings));
  text += fmt::format("{} wme changes ({} additions, {} removals)\n", counters.wme_additions + counters.wme_removals,
                      counters.wme_additions, counters.wme_removals);
  text += fmt::format("WM size: {} current, {:.3f} mean, {} maximum\n\n", agent.memory().wme_count(),
                      Ratio(counters.wm_size_sum, counters.phases), counters.wm_size_maximum);
  call.Out(text);
}

void TellMemory(CommandCall& call) {
  const kernel::Agent& agent = call.agent();
  call.Out(
      fmt::format("{:8} bytes total memory allocated\n{:8} bytes of this agent alone\n"
                  "{:8} bytes of rules and match network, shared with agents that run the same rules\n",
                  agent.MemoryBytes() + agent.SharedMemoryBytes(), agent.MemoryBytes(), agent.SharedMemoryBytes()));
}

void Rete(CommandCall& call) {
  const kernel::Rete::Statistics statistics = call.agent().rete().statistics();
  const auto row = [&](std::string_view name, std::size_t count) {
    call.Out(fmt::format("{:>21}  {:>10}\n", name, count));
  };
  call.Out(fmt::format("{:>21}  {:>10}\n{}  {}\n", "Part", "Number", std::string(21, '-'), std::string(10, '-')));
  row("rules", statistics.productions);
  row("nodes", statistics.nodes);
  row("alpha memories", statistics.alpha_memories);
  row("tokens", statistics.tokens);
  row("elements", statistics.wmes);
}

void Maximums(CommandCall& call) {
  const AgentCounters& counters = call.agent().counters();
  call.Out(
      "Single decision cycle maximums:\nStat             Value       Cycle\n"
      "---------------- ----------- -----------\n");
  const auto row = [&](std::string_view name, std::uint64_t value, std::uint64_t cycle) {
    call.Out(fmt::format("{:>16} {:>10} {:>11}\n", name, value, cycle));
  };
  const RunTimes& times = call.session.times();
  call.Out(
      fmt::format("{:>16} {:>10.6f} {:>11}\n", "Time (sec)", times.longest_cycle_seconds(), times.longest_cycle()));
  call.Out(fmt::format("{:>16} {:>10} {:>11}\n", "EpMem Time (sec)", "0.000000", 0));
  call.Out(fmt::format("{:>16} {:>10} {:>11}\n", "SMem Time (sec)", "0.000000", 0));
  row("WM changes", counters.max_wme_changes, counters.max_wme_changes_cycle);
  row("Firing count", counters.max_firings, counters.max_firings_cycle);
}

void AddCounts(CommandCall& call) {
  const kernel::Agent& agent = call.agent();
  const AgentCounters& counters = agent.counters();
  const auto integer = [&](const char* name, std::uint64_t value) {
    call.AddArgument(name, "int", std::to_string(value));
  };
  const auto real = [&](const std::string& name, double value) { call.AddArgument(name, "double", Shortest(value)); };
  integer("statsproductioncountdefault", agent.CountProductions(ProductionType::kDefault));
  integer("statsproductioncountuser", agent.CountProductions(ProductionType::kUser));
  integer("statsproductioncountchunk", agent.CountProductions(ProductionType::kChunk));
  integer("statsproductioncountjustification", agent.CountProductions(ProductionType::kJustification));
  integer("statscyclecountdecision", counters.decision_phases);
  integer("statscyclecountelaboration", counters.elaborations);
  integer("statscyclecountinnerelaboration", counters.inner_elaborations);
  integer("statsproductionfiringcount", counters.firings);
  integer("statswmecountaddition", counters.wme_additions);
  integer("statswmecountremoval", counters.wme_removals);
  integer("statswmecount", agent.memory().wme_count());
  real("statswmecountsverage", Ratio(counters.wm_size_sum, counters.phases));
  integer("statswecountmax", counters.wm_size_maximum);
  const RunTimes& times = call.session.times();
  real("statskernelcputime", times.kernel_seconds());
  real("statstotalcputime", times.run_seconds());
  constexpr const char* kNames[] = {"input", "propose", "decision", "apply", "output"};
  for (const std::string kind : {"phase", "monitor"}) {
    for (std::size_t i = 0; i < std::size(kTimedPhases); ++i) {
      real("stats" + kind + "time" + kNames[i] + "phase", kind == "phase" ? times.phase_seconds(kTimedPhases[i]) : 0);
    }
    for (const std::string part : {"preference", "workingmemory"}) real("stats" + kind + "time" + part + "phase", 0);
  }
  real("statsinputfunctiontime", 0);
  real("statsoutputfunctiontime", 0);
  integer("statsmaxdecisioncycletimecycle", times.longest_cycle());
  real("statsmaxdecisioncycletimevaluesec", times.longest_cycle_seconds());
  integer("statsmaxdecisioncycletimevalueusec", static_cast<std::uint64_t>(1e6 * times.longest_cycle_seconds()));
  integer("statsmaxdecisioncycleepmemtimecycle", 0);
  real("statsmaxdecisioncycleepmemtimevaluesec", 0);
  integer("statsmaxdecisioncyclesmemtimecycle", 0);
  real("statsmaxdecisioncyclesmemtimevaluesec", 0);
  integer("statsmaxdecisioncyclewmchangescycle", counters.max_wme_changes_cycle);
  integer("statsmaxdecisioncyclewmchangesvalue", counters.max_wme_changes);
  integer("statsmaxdecisioncyclefirecountcycle", counters.max_firings_cycle);
  integer("statsmaxdecisioncyclefirecountvalue", counters.max_firings);
  integer("statsmemoryusagemiscellaneous", agent.MemoryBytes());
  integer("statsmemoryusagehash", 0);
  integer("statsmemoryusagestring", 0);
  integer("statsmemoryusagepool", agent.SharedMemoryBytes());
  integer("statsmemoryusagestatsoverhead", 0);
}

}  // namespace

const std::span<const OptionSpec> kStatsOptions = kStatsOptionList;

bool CommandStats(CommandCall& call) {
  ParsedWords parsed;
  if (!call.Parse(kStatsOptions, parsed)) return false;
  if (!parsed.arguments.empty()) return call.Fail("Syntax: stats [options]");
  call.session.times().Refresh();
  AddCounts(call);
  if (parsed.options.empty()) System(call);
  for (const ParsedOption& option : parsed.options) {
    switch (option.letter) {
      case 's':
        System(call);
        break;
      case 'm':
        TellMemory(call);
        break;
      case 'r':
        Rete(call);
        break;
      case 'M':
        Maximums(call);
        break;
      case 'd':
        call.Out(std::to_string(call.agent().counters().decision_phases));
        break;
      case 'a':
        call.Out("Agent counters:\nCounter          Value\n---------------- -----------\n");
        break;
      case 'l':
        call.Out(LearningStatisticsText(call.agent()));
        break;
      default:
        break;
    }
  }
  return true;
}

}  // namespace soarbox::cli
