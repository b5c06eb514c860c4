// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <optional>

#include "kernel/imagery/filter.h"

namespace soarbox::kernel::imagery {

/// A filter that makes at most one value from each combination, and from that combination alone.
class ComputedFilter : public Filter {
 public:
  using Filter::Filter;

 protected:
  enum class Verdict { kFail, kNothing, kValue };
  /// kFail: the status says why.
  virtual Verdict Evaluate(const Combination& combination, Content& content) = 0;
  Verdict Refuse(std::string_view status) {
    Fail(status);
    return Verdict::kFail;
  }

 private:
  bool Compute() final;
};

/// A filter that gives the highest or lowest number of all combinations; among equal ones, the first.
class RankFilter : public Filter {
 public:
  RankFilter(FilterParts parts, bool highest) : Filter(std::move(parts)), highest_(highest) {}

 protected:
  /// None: it failed, and the status says why.
  virtual std::optional<double> Rank(const Combination& combination) = 0;
  void ClearOutput() override;

 private:
  bool Compute() final;
  bool MayChange(TrackedList<Combination>& combinations) const;

  bool highest_;
  Combination* best_ = nullptr;
};

}  // namespace soarbox::kernel::imagery
