// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace soarbox::report {

/// What happened at a moment of a run.
struct StoryEvent {
  double time_s = 0;
  std::string agent, kind, text;
};

/// An operator that was selected for a while.
struct StorySpan {
  std::size_t agent = 0;
  double from_s = 0, to_s = 0;
  std::string name;
};

/// Where an agent was and how it fared, at one moment after another.
struct StoryWay {
  std::size_t from = 0;  ///< The index of the first moment in the run's times.
  std::vector<std::int32_t> x_cm, z_cm, health, speed_dmps;
};

/// At most this many bytes of text, cut between characters, with dots where it was cut.
std::string CutText(std::string text, std::size_t most_bytes);

/// Leaves events out until the rest takes at most this many bytes on a page: always every second one of the kind that
/// takes most room, so that what is rare stays and what is left is spread over the whole run. The order stays.
void ThinEvents(std::vector<StoryEvent>& events, std::size_t most_bytes);

/// Merges spans of one agent that begin in the same of `columns` columns and are each narrower than one: nobody could
/// tell them apart in a picture that is as many columns wide. The longest of them gives the name.
std::vector<StorySpan> MergeSpans(const std::vector<StorySpan>& spans, double seconds, std::size_t columns);

/// The moments that stay if only each `every`-th does, and the last: their indices.
std::vector<std::size_t> KeptMoments(std::size_t count, std::size_t every);
/// The part of a way at these moments.
StoryWay ThinWay(const StoryWay& way, const std::vector<std::size_t>& kept);

/// The first number, then differences: most of them are short, or 0.
std::vector<std::int32_t> Differences(std::vector<std::int32_t> numbers);

}  // namespace soarbox::report
