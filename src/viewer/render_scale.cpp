// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/render_scale.h"

#include <algorithm>

namespace soarbox::viewer {
namespace {

/// From large to small. Enlarging the scene takes a fifth of the time of drawing it in full size, so a scale slightly
/// below 1 would gain nothing.
constexpr double kScales[] = {1, 0.75, 0.65, 0.57, 0.5};
constexpr std::size_t kFirst = 1, kLast = std::size(kScales) - 1;

constexpr double kTooSlow_s = 1 / 30.0, kRoomy_s = 0.85 * kTooSlow_s;
/// Frames are judged in groups of this duration by their medians, because a single delayed frame means nothing.
constexpr double kGroup_s = 0.7;
constexpr std::size_t kGroup = 8;
/// Fraction of the drawing time that depends on the number of pixels.
constexpr double kOfPixels = 0.6;
/// Number of consecutive judgements with enough time before the scale goes up: at first, and at most.
constexpr int kFewRoomy = 4, kManyRoomy = 256;
/// Going down this soon after going up means that going up was a mistake.
constexpr int kSoon = 30;

double Median(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

AutoScale::AutoScale() : step_(kFirst), wanted_roomy_(kFewRoomy) {}

double AutoScale::scale() const {
  return kScales[step_];
}

void AutoScale::Note(double drawing_s, double whole_s) {
  drawing_s_.push_back(drawing_s);
  whole_s_.push_back(whole_s);
  noted_s_ += whole_s;
  if (noted_s_ < kGroup_s || whole_s_.size() < kGroup) return;
  Judge();
  drawing_s_.clear();
  whole_s_.clear();
  noted_s_ = 0;
}

void AutoScale::Judge() {
  const double drawing_s = Median(drawing_s_), whole_s = Median(whole_s_);
  since_up_ = std::min(since_up_ + 1, 1000);
  // If ticks take most of the time, a smaller scene does not help.
  if (whole_s > kTooSlow_s && drawing_s > 0.4 * whole_s) {
    roomy_ = 0;
    if (step_ == kLast) return;
    if (since_up_ < kSoon) wanted_roomy_ = std::min(2 * wanted_roomy_, kManyRoomy);
    ++step_;
    return;
  }
  if (step_ == 0) return;
  const double ratio = kScales[step_ - 1] / kScales[step_];
  const double larger_s = whole_s + kOfPixels * drawing_s * (ratio * ratio - 1);
  roomy_ = larger_s < kRoomy_s ? roomy_ + 1 : 0;
  if (roomy_ < wanted_roomy_) return;
  roomy_ = 0;
  if (since_up_ > 10 * kSoon) wanted_roomy_ = kFewRoomy;
  since_up_ = 0;
  --step_;
}

}  // namespace soarbox::viewer
