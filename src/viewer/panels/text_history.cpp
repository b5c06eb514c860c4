// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/panels/text_history.h"

#include <algorithm>
#include <utility>

namespace soarbox::viewer {

void TextHistory::Begin(std::string text) {
  steps_.clear();
  steps_.push_back(std::move(text));
  at_ = 0;
  may_go_on_ = false;
}

void TextHistory::Note(const std::string& text, bool goes_on) {
  if (steps_.empty()) return Begin(text);
  if (text == steps_[at_]) return;
  steps_.resize(at_ + 1);
  if (goes_on && may_go_on_ && at_ > 0) {
    steps_[at_] = text;
    return;
  }
  steps_.push_back(text);
  ++at_;
  may_go_on_ = true;
  Forget();
}

void TextHistory::Forget() {
  std::size_t bytes = 0;
  for (const std::string& step : steps_) bytes += step.size();
  std::size_t gone = 0;
  while (gone < at_ && (bytes > kMostBytes || steps_.size() - gone > kMostSteps)) bytes -= steps_[gone++].size();
  steps_.erase(steps_.begin(), steps_.begin() + static_cast<std::ptrdiff_t>(gone));
  at_ -= gone;
}

const std::string& TextHistory::GoTo(std::size_t step) {
  const std::string& before = steps_[at_];
  const std::string& now = steps_[step];
  const auto differs = std::mismatch(before.begin(), before.end(), now.begin(), now.end());
  changed_at_ = static_cast<std::size_t>(differs.second - now.begin());
  at_ = step;
  may_go_on_ = false;
  return now;
}

const std::string& TextHistory::Undo() {
  return GoTo(CanUndo() ? at_ - 1 : at_);
}

const std::string& TextHistory::Redo() {
  return GoTo(CanRedo() ? at_ + 1 : at_);
}

}  // namespace soarbox::viewer
