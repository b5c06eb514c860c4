// SPDX-License-Identifier: BSD-2-Clause
// Cost of an exercise of other simulations: PDUs read per second on one core, and a tick with foreign entities.
//   dis_traffic [ENTITIES [SECONDS]]
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "dis/exercise_view.h"
#include "dis/pdu_codec.h"
#include "dis/state_sender.h"
#include "sim/simulation.h"

using namespace soarbox;

namespace {

double Seconds(std::chrono::steady_clock::time_point from) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - from).count();
}

/// A datagram for each entity; each entity is at another point of a circle and moves.
std::vector<std::vector<std::byte>> Datagrams(int entities, const dis::LocalFrame& frame, double time_s) {
  std::vector<std::vector<std::byte>> datagrams;
  for (int i = 0; i < entities; ++i) {
    const double angle = i * 0.37 + time_s * 0.1, far_m = 20 + i % 50;
    dis::EntityState state;
    state.id = {9, 9, static_cast<std::uint16_t>(i + 1)};
    state.force = 2;
    state.type = {3, 1, 225, 1, 1, 0, 0};
    state.position = frame.ToEarth({far_m * std::sin(angle), 0, far_m * std::cos(angle)});
    state.velocity = frame.TurnToEarth({std::cos(angle), 0, -std::sin(angle)});
    state.orientation = frame.ToEuler({std::cos(angle), 0, -std::sin(angle)}, {0, 1, 0});
    state.marking = "e" + std::to_string(i);
    datagrams.push_back(dis::Encode({.body = state}));
  }
  return datagrams;
}

}  // namespace

int main(int argc, char** argv) {
  const int entities = argc > 1 ? std::atoi(argv[1]) : 100;
  const double seconds = argc > 2 ? std::atof(argv[2]) : 10;
  dis::Settings settings;
  const dis::LocalFrame frame(settings.anchor);
  const dis::StateSender ours(settings);

  // Reading only: decoded, stored, and converted to inputs once per tick.
  const auto datagrams = Datagrams(1000, frame, 0);
  dis::ExerciseView flood(settings);
  std::uint64_t read = 0;
  std::size_t inputs = 0;
  const auto begin = std::chrono::steady_clock::now();
  while (Seconds(begin) < 1) {
    for (const auto& datagram : datagrams) {
      const auto pdu = dis::Decode(datagram);
      flood.Take(std::get<dis::Pdu>(pdu).body, 0);
      if (++read % 333 == 0) inputs += flood.TakeInputs(ours).size();
    }
  }
  std::printf("read: %.0f PDUs/s of 1000 entities on one core (%zu inputs)\n",
              static_cast<double>(read) / Seconds(begin), inputs);

  // A world with one walker of its own, with and without the foreign entities.
  for (const int count : {0, entities}) {
    sim::Scenario scenario;
    const sim::DataFolders data{SOARBOX_SOURCE_DIR "/scenarios", SOARBOX_SOURCE_DIR "/media"};
    const Result<sim::Scenario> found = sim::FindScenario("soar_skirmish", data);
    if (!found) return 1;
    Result<std::unique_ptr<sim::Simulation>> made = sim::Simulation::Create(*found, {});
    if (!made) return 1;
    dis::ExerciseView view(settings);
    const auto start = std::chrono::steady_clock::now();
    int ticks = 0;
    for (; (*made)->time_s() < seconds; ++ticks) {
      if (ticks % 6 == 0)
        for (const auto& datagram : Datagrams(count, frame, (*made)->time_s()))
          view.Take(std::get<dis::Pdu>(dis::Decode(datagram)).body, 0);
      for (sim::InputValue& input : view.TakeInputs(ours)) (*made)->Submit(std::move(input));
      (*made)->Tick();
    }
    std::printf("soar_skirmish with %d foreign entities (5 states/s each): %.3f ms per tick\n", count,
                Seconds(start) * 1000 / ticks);
  }
  return 0;
}
