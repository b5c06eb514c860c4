// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <vector>

namespace soarbox::viewer {

/// Finds the largest scale at which the scene can be drawn with thirty frames per second.
///
/// The scale goes down when frames have been too slow for about a second. It goes up only if the larger scale would
/// have been fast enough for some seconds. A scale that was too large is tried again after increasing intervals, so
/// that the picture does not alternate between two scales. The only clock is the argument of Note: the same times give
/// the same scales.
class AutoScale {
 public:
  AutoScale();

  /// Notes a frame that was drawn in `drawing_s`. `whole_s` is the time from its beginning to that of the next frame,
  /// without sleep.
  void Note(double drawing_s, double whole_s);

  /// 0.5 to 1.
  double scale() const;

 private:
  void Judge();

  std::size_t step_;
  std::vector<double> drawing_s_, whole_s_;  ///< Of the frames that are judged together next.
  double noted_s_ = 0;                       ///< Sum of `whole_s_`.
  int roomy_ = 0;        ///< Consecutive judgements at which the next larger scale would have been fast enough.
  int wanted_roomy_;     ///< Number of such judgements needed to go up.
  int since_up_ = 1000;  ///< Judgements since the scale last went up.
};

}  // namespace soarbox::viewer
