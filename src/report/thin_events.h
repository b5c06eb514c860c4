// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace soarbox::report {

/// An event of a run.
struct StoryEvent {
  double time_s = 0;
  std::string agent, kind, text;
};

/// The time during which an operator was selected.
struct StorySpan {
  std::size_t agent = 0;
  double from_s = 0, to_s = 0;
  std::string name;
};

/// Position, health and speed of an agent at consecutive moments.
struct StoryWay {
  std::size_t from = 0;  ///< Index of the first moment in the run's times.
  std::vector<std::int32_t> x_cm, z_cm, health, speed_dmps;
};

/// Cuts a text to at most `most_bytes` bytes, between characters, and marks the cut with dots.
std::string CutText(std::string text, std::size_t most_bytes);

/// Removes events until the rest uses at most `most_bytes` on a page. Repeatedly removes every second event of the kind
/// that uses most space, so that rare events stay and the rest is distributed over the entire run. Keeps the order.
void ThinEvents(std::vector<StoryEvent>& events, std::size_t most_bytes);

/// Merges spans of one agent that cannot be distinguished in a picture with this number of columns: each is narrower
/// than a column, and they begin in the same column. The merged span has the name of the longest of them, followed by
/// " and N more".
std::vector<StorySpan> MergeSpans(const std::vector<StorySpan>& spans, double seconds, std::size_t columns);

/// Indices of the moments that remain if only each `every`-th and the last are kept.
std::vector<std::size_t> KeptMoments(std::size_t count, std::size_t every);
/// The part of a path at these moments.
StoryWay ThinWay(const StoryWay& way, const std::vector<std::size_t>& kept);

/// Returns the first number followed by differences, most of which are short or 0.
std::vector<std::int32_t> Differences(std::vector<std::int32_t> numbers);

}  // namespace soarbox::report
