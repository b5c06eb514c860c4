// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <optional>

#include "kernel/imagery/filter.h"

namespace soarbox::kernel::imagery {

/// A filter that computes at most one value for each combination, independently of other combinations.
class ComputedFilter : public Filter {
 public:
  using Filter::Filter;

 protected:
  enum class Verdict { kFail, kNothing, kValue };
  /// Computes the value into `content`. With kFail, the status describes the error.
  virtual Verdict Evaluate(const Combination& combination, Content& content) = 0;
  Verdict Refuse(std::string_view status) {
    Fail(status);
    return Verdict::kFail;
  }

 private:
  bool Compute() final;
};

/// A filter that returns the highest or lowest number of all combinations; if there are several, the first one.
class RankFilter : public Filter {
 public:
  RankFilter(FilterParts parts, bool highest) : Filter(std::move(parts)), highest_(highest) {}

 protected:
  /// The number of a combination; none if it failed, and then the status describes the error.
  virtual std::optional<double> Rank(const Combination& combination) = 0;
  void ClearOutput() override;

 private:
  bool Compute() final;
  bool MayChange(TrackedList<Combination>& combinations) const;

  bool highest_;
  Combination* best_ = nullptr;
};

}  // namespace soarbox::kernel::imagery
