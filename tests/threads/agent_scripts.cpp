// SPDX-License-Identifier: BSD-2-Clause
#include "agent_scripts.h"

#include <algorithm>
#include <fstream>
#include <string_view>

namespace {

/// Moves towards its percept, and completes its commands.
constexpr const char* kSeeker[] = {
    "sp {move (state <s> ^superstate nil ^io.input-link.range <r>) --> (<s> ^operator <o> + =) (<o> ^name move ^speed "
    "<r>)}",
    "sp {send (state <s> ^operator <o> ^io.output-link <out>) (<o> ^name move ^speed <v>) --> (<out> ^move <c>) "
    "(<c> ^speed <v> ^twice (* 2 <v>) ^root (sqrt <v>))}",
    "sp {done (state <s> ^operator.name ^io.output-link <out>) (<out> ^<name> <c>) (<c> ^status complete) --> "
    "(<out> ^<name> <c> -)}",
};

/// Chooses among equal operators at random and by values, and counts its choices.
constexpr const char* kGambler[] = {
    "sp {start (state <s> ^superstate nil -^noise) --> (<s> ^operator <o> +) (<o> ^name start)}",
    "sp {started (state <s> ^operator.name start) --> (<s> ^a 0 ^b 0 ^c 0 ^noise 0)}",
    "sp {propose (state <s> ^superstate nil ^noise ^{ << a b c >> <n> } <v>) --> (<s> ^operator <o> +) "
    "(<o> ^name <n> ^value <v>)}",
    "sp {a (state <s> ^operator <o> +) (<o> ^name a) --> (<s> ^operator <o> = 1)}",
    "sp {b (state <s> ^operator <o> +) (<o> ^name b) --> (<s> ^operator <o> = 2)}",
    "sp {c (state <s> ^operator <o> +) (<o> ^name c) --> (<s> ^operator <o> = 0.5)}",
    "sp {apply (state <s> ^operator <o> ^noise <r>) (<o> ^name <n> ^value <v>) --> "
    "(<s> ^<n> <v> - (+ <v> 1) ^noise <r> - (rand-int 1000))}",
};

/// Ties, a substate that compares the candidates, results that support themselves, state no-changes three levels deep.
constexpr const char* kThinker[] = {
    "sp {start (state <s> ^superstate nil -^turn) --> (<s> ^operator <o> +) (<o> ^name start)}",
    "sp {started (state <s> ^operator.name start) --> (<s> ^turn 0 ^block <x> <y> <z>) (<x> ^size 3) (<y> ^size 1) "
    "(<z> ^size 2)}",
    "sp {propose (state <s> ^superstate nil ^block <b> ^turn <t>) (<b> ^size <n> -^done <t>) --> (<s> ^operator <o> +) "
    "(<o> ^name take ^block <b> ^turn <t>)}",
    "sp {compare (state <s> ^impasse tie ^item <a> ^item <b> ^superstate <ss>) (<a> ^block.size <m>) "
    "(<b> ^block.size {<n> > <m>}) --> (<ss> ^operator <b> > <a>)}",
    "sp {apply (state <s> ^operator <o>) (<o> ^name take ^block <b> ^turn <t>) --> (<b> ^done <t>)}",
    "sp {next (state <s> ^superstate nil ^turn <t>) -{ (<s> ^block <b>) -(<b> ^done <t>) } --> (<s> ^operator <o> + <) "
    "(<o> ^name next ^turn <t>)}",
    "sp {ponder (state <s> ^superstate.operator.name next ^superstate.operator.turn <t>) --> (<s> ^operator <o> +) "
    "(<o> ^name wonder)}",
    "sp {advance (state <s> ^superstate <ss> ^operator.name wonder) (<ss> ^operator <o> ^turn <t>) (<o> ^turn <t>) --> "
    "(<ss> ^turn <t> - (+ <t> 1))}",
};

template <std::size_t kCount>
AgentScript Make(std::string name, const char* const (&rules)[kCount], std::vector<std::string> more) {
  AgentScript script{std::move(name), {}, {"trace 5"}};
  script.lines.insert(script.lines.end(), std::begin(rules), std::end(rules));
  script.lines.insert(script.lines.end(), more.begin(), more.end());
  return script;
}

bool IsForTheDriver(std::string_view line) {
  return line.empty() || line[0] == '#' || line[0] == '!';
}

}  // namespace

std::vector<AgentScript> LocalScripts() {
  const std::vector<std::string> ticks(40, "!tick");
  std::vector<std::string> gamble{"decide srand 7"};
  gamble.insert(gamble.end(), 30, "run 4");
  std::vector<std::string> think(20, "run 3");
  // Rules are added and excised while the agent runs, so its shared network becomes its own again.
  const std::vector<std::string> change{"excise compare",          "run 5", "init-soar", kThinker[3], "run 10",
                                        "production excise --all", "run 3"};
  think.insert(think.end(), change.begin(), change.end());
  return {Make("seeker", kSeeker, ticks), Make("gambler", kGambler, gamble), Make("thinker", kThinker, think)};
}

std::vector<AgentScript> GoldenScripts(const std::filesystem::path& folder) {
  std::vector<AgentScript> scripts;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
    std::ifstream file(entry.path() / "case.cmd");
    if (!file) continue;
    AgentScript script{entry.path().filename().string(), entry.path(), {}};
    for (std::string line; std::getline(file, line);) {
      if (!IsForTheDriver(line)) script.lines.push_back(line);
    }
    scripts.push_back(std::move(script));
  }
  std::ranges::sort(scripts, {}, &AgentScript::name);
  return scripts;
}

std::vector<AgentScript> BenchmarkScripts(const std::filesystem::path& folder, int decisions) {
  std::vector<AgentScript> scripts;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
    if (entry.path().extension() != ".soar") continue;
    AgentScript script{entry.path().stem().string(), folder, {"trace 1", "source " + entry.path().filename().string()}};
    for (int n = 0; n < 5; ++n) script.lines.push_back("run " + std::to_string(decisions / 5));
    scripts.push_back(std::move(script));
  }
  std::ranges::sort(scripts, {}, &AgentScript::name);
  return scripts;
}
