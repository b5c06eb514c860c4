// SPDX-License-Identifier: BSD-2-Clause
#include <chrono>

#include "sim/minds.h"

// Minds with scripted bodies decide on other threads while the world's thread runs scripts. They perceive before and
// receive the outcomes of commands afterwards, so they do not access the world while they decide. The results do not
// depend on timing, because the world's thread processes them agent by agent, in order.

namespace soarbox::sim {

void Minds::DecideNow(Mind& mind) {
  const auto begin = std::chrono::steady_clock::now();
  mind.soar.Decide();
  NoteDecisions(mind);
  mind.decide_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

void Minds::BeginBesideScripts() {
  for (std::atomic<std::size_t>& count : decided_) count.store(0, std::memory_order_relaxed);
  places_.assign(decided_.size(), 0);
  for (const std::size_t i : ready_) {
    Mind& mind = minds_[i];
    if (!mind.is_scripted) continue;
    mind.turn = Mind::Turn::kWaits;
    mind.place = places_[mind.thread]++;
  }
  pool_.Begin(decide_beside_scripts_);
}

void Minds::DecideBesideScripts(std::size_t thread) {
  for (const std::size_t i : ready_) {
    if (minds_[i].thread != thread || !minds_[i].is_scripted) continue;
    DecideNow(minds_[i]);
    decided_[thread].fetch_add(1, std::memory_order_release);
    decided_[thread].notify_one();
  }
}

void Minds::Await(Mind& mind) {
  if (mind.turn == Mind::Turn::kOver) return;
  if (mind.turn == Mind::Turn::kWaits) {
    if (mind.thread == 0) {
      if (host_.IsConnected()) DecideNow(mind);
    } else {
      const std::atomic<std::size_t>& decided = decided_[mind.thread];
      for (std::size_t count = decided.load(std::memory_order_acquire); count <= mind.place;
           count = decided.load(std::memory_order_acquire))
        decided.wait(count, std::memory_order_acquire);
    }
  }
  mind.turn = Mind::Turn::kOver;
  Conclude(mind);
}

void Minds::AwaitAll() {
  pool_.Join();
  for (const std::size_t i : ready_) {
    Mind& mind = minds_[i];
    if (mind.turn != Mind::Turn::kWaits) continue;
    if (mind.thread == 0 && host_.IsConnected()) DecideNow(mind);
    mind.turn = Mind::Turn::kHasDecided;
  }
}

void Minds::TellScripts(std::size_t thread) {
  for (Mind& mind : minds_) {
    if (mind.thread != thread) continue;
    for (const Outcome& outcome : mind.answers) mind.soar.Answer(outcome);
    mind.answers.clear();
  }
}

}  // namespace soarbox::sim
