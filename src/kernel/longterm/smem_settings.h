// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace soarbox::kernel {

enum class ActivationMode : std::uint8_t { kRecency, kFrequency, kBaseLevel };
enum class BaseUpdatePolicy : std::uint8_t { kStable, kNaive, kIncremental };

/// The settings of `smem --set` that the kernel uses.
struct SmemSettings {
  bool enabled = false;
  std::uint64_t initial_number = 1;  ///< The first number for new objects in an empty memory.
  ActivationMode activation_mode = ActivationMode::kRecency;
  bool activate_on_query = true;
  double base_decay = 0.5;
  BaseUpdatePolicy base_update_policy = BaseUpdatePolicy::kStable;
  std::vector<std::uint64_t> base_incremental_threshes = {10};
  std::uint64_t thresh = 100;  ///< Minimum number of edges with which a touched object wins ties.
  bool base_inhibition = false;
  double base_unused_age_offset = 0;

  bool spreading = false;
  std::uint64_t spreading_limit = 300;
  std::uint64_t spreading_depth_limit = 10;
  double spreading_baseline = 0.0001;
  double spreading_continue_probability = 0.9;
  bool spreading_loop_avoidance = false;
  bool spreading_edge_updating = false;
  bool spreading_wma_source = false;
  double spreading_edge_update_factor = 0.99;
};

}  // namespace soarbox::kernel
