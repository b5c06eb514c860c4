// SPDX-License-Identifier: BSD-2-Clause
#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "cli/command.h"
#include "cli/interpreter.h"
#include "cli/lookup.h"
#include "cli/object_printer.h"

namespace soarbox::cli {
namespace {

/// Measures wall time, which appears only in the reply and does not affect the agent.
bool Time(CommandCall& call) {
  if (call.words.size() < 2) return call.Fail("You must submit a command that you'd like timed.");
  const auto start = std::chrono::steady_clock::now();
  std::vector<Word> words(call.words.begin() + 1, call.words.end());
  const bool ok = call.interpreter.ExecuteWords(call, words);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  const double seconds = std::chrono::duration_cast<std::chrono::microseconds>(taken).count() / 1e6;
  if (!ok) return false;
  call.Out(fmt::format("\n({:g}s) real", seconds));
  call.AddArgument("real-seconds", "double", fmt::format("{:g}", seconds));
  return true;
}

bool Port(CommandCall& call) {
  const std::string port = std::to_string(call.interpreter.host().Port());
  call.Out(port);
  call.AddArgument("port", "int", port);
  return true;
}

bool Allocate(CommandCall& call) {
  if (call.words.size() != 3) return call.Fail("Syntax: debug allocate <pool> <blocks>");
  const auto blocks = ParseInteger(call.words[2].text);
  if (!blocks || *blocks < 0) return call.Fail("Number of blocks expected.");
  call.Out(call.words[1].text + " has no blocks: memory grows as it is needed");
  return true;
}

bool InternalSymbols(CommandCall& call) {
  // Only the symbols in working memory, with the number of their occurrences there.
  const kernel::Agent& agent = call.agent();
  std::vector<std::string> strings, integers, floats, identifiers, variables;
  std::vector<std::uint32_t> seen;
  const auto add = [&](kernel::Symbol symbol) {
    if (!symbol) return;
    seen.push_back(symbol.bits());
  };
  for (const kernel::Wme& wme : agent.memory().wmes()) {
    if (!wme.live) continue;
    add(wme.id);
    add(wme.attribute);
    add(wme.value);
  }
  std::sort(seen.begin(), seen.end());
  for (std::size_t i = 0; i < seen.size();) {
    std::size_t next = i;
    while (next < seen.size() && seen[next] == seen[i]) ++next;
    const kernel::Symbol symbol = kernel::Symbol::FromBits(seen[i]);
    const std::string line = fmt::format("{} ({})\n", SymbolText(agent, symbol), next - i);
    if (symbol.IsIdentifier())
      identifiers.push_back(line);
    else if (symbol.IsVariable())
      variables.push_back(line);
    else if (symbol.IsInteger())
      integers.push_back(line);
    else if (symbol.IsFloat())
      floats.push_back(line);
    else
      strings.push_back(line);
    i = next;
  }
  const auto section = [&](std::string_view title, const std::vector<std::string>& lines) {
    call.Out(fmt::format("\n--- {}: ---\n", title));
    for (const std::string& line : lines) call.Out(line);
  };
  section("Symbolic Constants", strings);
  section("Integer Constants", integers);
  section("Floating-Point Constants", floats);
  section("Identifiers", identifiers);
  section("Variables", variables);
  return true;
}

constexpr SubcommandInfo kDebugSubcommandList[] = {
    {"allocate", "POOL BLOCKS", "accepted for old scripts; memory grows by itself", {}, Allocate},
    {"internal-symbols", "", "symbols that working memory uses, and how often", {}, InternalSymbols},
    {"port", "", "the port that the kernel listens on", {}, Port},
    {"time", "COMMAND...", "carries out a command and says how long it took", {}, Time},
};

}  // namespace

const std::span<const SubcommandInfo> kDebugSubcommands = kDebugSubcommandList;

bool CommandDebug(CommandCall& call) {
  if (call.words.size() < 2) {
    call.Out(
        "The debug command contains low-level technical debugging commands.\n\n"
        "Use 'debug ?' to learn more about the debug command.");
    return true;
  }
  // The timed command has its own options.
  if (call.words[1].text == "time" || call.words[1].text == "t") {
    const std::span<const Word> outer = call.words;
    call.words = outer.subspan(1);
    const bool ok = Time(call);
    call.words = outer;
    return ok;
  }
  return RunSubcommand(call, {"Debug| Invalid command: " + call.words[1].text + ".\n\nSyntax: Debug [command]",
                              "Use 'debug ?' to learn more about the debug command."});
}

}  // namespace soarbox::cli
