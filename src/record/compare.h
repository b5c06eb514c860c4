// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "record/difference.h"
#include "record/percept_values.h"
#include "record/tick_source.h"

namespace soarbox::record {

/// How two futures, A and B, diverge.
struct Comparison {
  std::uint64_t first_tick = 0, last_tick = 0;  ///< The ticks that both contain.
  std::optional<Difference> difference;         ///< The first difference in the scene or in a mind.
  std::optional<Difference> decision;           ///< The first decision or command that differs: `recorded` is of A.
  /// How each future came to its decision, in words ("selected by chance among ..."); empty if it was not recorded.
  std::string why_a, why_b;
  bool by_chance = false;             ///< Chance selected the operator in at least one of them.
  std::vector<std::string> percepts;  ///< The percepts of that agent that differ in that tick: "path: A, B".

  /// The distance between the two futures at a time.
  struct Moment {
    double time_s = 0;
    double mean_distance_m = 0, greatest_distance_m = 0;  ///< Distances between an agent in A and the same agent in B.
    std::string farthest;                                 ///< The agent with the greatest distance.
    double health_a = 0, health_b = 0;                    ///< The sum over all agents.
    std::size_t alive_a = 0, alive_b = 0;
  };
  std::vector<Moment> course;  ///< Once per simulated second.
};

/// Compares two futures tick by tick while they are simulated or read.
class Comparer {
 public:
  explicit Comparer(double step_s);

  /// Adds what an agent perceived in a tick that both futures share, so that its percepts are known when they diverge.
  void Share(const std::string& agent, const mind::EventLog& events);
  /// Adds the next tick of both.
  void See(const TickRecord& a, const TickRecord& b);
  const Comparison& result() const { return result_; }

 private:
  using Perceived = std::map<std::string, PerceptValues, std::less<>>;

  std::uint64_t ticks_per_moment_;
  bool has_begun_ = false;
  Comparison result_;
  Perceived perceived_a_, perceived_b_;
};

/// Compares two recordings. Fails if they share no tick or one is damaged.
Result<Comparison> Compare(TickSource& a, TickSource& b);

}  // namespace soarbox::record
