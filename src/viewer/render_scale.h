// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <vector>

namespace soarbox::viewer {

/// Finds the largest share of the picture's size that the scene can be drawn in with thirty frames per second.
///
/// It goes down as soon as frames have been too slow for about a second, and up only when the larger size would leave
/// room for some seconds; a size that turned out to be too large is tried again later and later, so that the picture
/// does not go to and fro. Its only clock is what Note is told: the same times give the same sizes.
class AutoScale {
 public:
  AutoScale();

  /// A frame took `drawing_s`, and from its beginning to that of the next one `whole_s`, without what was slept.
  void Note(double drawing_s, double whole_s);

  /// 0.5 to 1.
  double scale() const;

 private:
  void Judge();

  std::size_t step_;
  std::vector<double> drawing_s_, whole_s_;  ///< Of the frames that are judged together next.
  double noted_s_ = 0;                       ///< Their sum.
  int roomy_ = 0;                            ///< Times in a row that the next larger size would have had room.
  int wanted_roomy_;                         ///< How many it takes.
  int since_up_ = 1000;                      ///< Judgements since it went up.
};

}  // namespace soarbox::viewer
