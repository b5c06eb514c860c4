// SPDX-License-Identifier: BSD-2-Clause
// Cost of a large scene: an agent with many nodes and many extracts over all of them; in each decision some nodes move.
// usage: imagined_scene [NODES [EXTRACTS [MOVING [DECISIONS]]]]
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <random>
#include <string>

#include "kernel/agent.h"
#include "kernel/imagery/imagery.h"

namespace {

using namespace soarbox::kernel;

double Now() {
  // Processor time, because other programs may run at the same time.
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// Filters over all nodes, as agents use them.
constexpr const char* kFilters[] = {
    "^type distance ^distance_type centroid",
    "^type distance ^distance_type hull",
    "^type distance_select ^distance_type hull ^max 10",
    "^type closest ^distance_type hull",
    "^type intersect_select ^intersect_type hull",
    "^type axis_distance_select ^axis x ^min 0.1 ^max 5",
    "^type contain_select",
    "^type larger_select",
    "^type farthest",
    "^type intersect ^intersect_type bbox",
};

std::string Place(std::mt19937& random) {
  const auto number = [&] { return std::to_string(static_cast<double>(random() % 100000) / 1000.0); };
  return " p " + number() + " " + number() + " " + number();
}

}  // namespace

int main(int argc, char** argv) {
  const auto argument = [&](int n, int otherwise) { return argc > n ? std::max(1, std::atoi(argv[n])) : otherwise; };
  const int nodes = argument(1, 1000), extracts = argument(2, 50), moving = argument(3, 10),
            decisions = argument(4, 200);
  std::mt19937 random(1);
  Agent agent("dreamer");
  agent.mutable_settings().wait_snc = true;
  agent.imagery().Enable();
  std::string lines;
  for (int n = 0; n < nodes; ++n) {
    const std::string shape = n % 2 == 0 ? " b 0.5" : " v 0 0 0 1 0 0 0 1 0 0 0 1 1 1 0 1 0 1 0 1 1 1 1 1";
    lines += "add node-" + std::to_string(n) + " world" + shape + Place(random) + "\n";
  }
  agent.imagery().Send(lines);
  for (int n = 0; n < extracts; ++n) {
    agent.LoadProduction("ask*" + std::to_string(n) +
                         " (state <s> ^superstate nil ^svs.command <c>) --> (<c> ^extract <x>) (<x> " +
                         kFilters[static_cast<std::size_t>(n) % std::size(kFilters)] +
                         " ^a <a> ^b <b>) (<a> ^type node ^id node-" + std::to_string(n) + ") (<b> ^type all_nodes)");
  }
  const double begin = Now();
  for (int n = 0; n < 3; ++n) agent.Step(RunUnit::kDecision);
  const double made = Now();
  for (int n = 0; n < decisions; ++n) {
    lines.clear();
    for (int k = 0; k < moving; ++k)
      lines += "change node-" + std::to_string(random() % static_cast<unsigned>(nodes)) + Place(random) + "\n";
    agent.imagery().Send(lines);
    agent.Step(RunUnit::kDecision);
  }
  const double done = Now();
  std::printf(
      "%d nodes, %d extracts, %d moving: first answers %.3f s, then %.3f ms per decision; %.0f MB, %u elements\n",
      nodes, extracts, moving, made - begin, (done - made) / decisions * 1e3,
      static_cast<double>(agent.MemoryBytes()) / 1e6, agent.memory().wme_count());
  return 0;
}
