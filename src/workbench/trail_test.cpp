// SPDX-License-Identifier: BSD-2-Clause
#include "workbench/trail.h"

#include <gtest/gtest.h>

#include <utility>

namespace soarbox::workbench {
namespace {

using Sides = std::pair<std::uint64_t, std::uint64_t>;

Sides SidesOf(const Trail& trail) {
  return {trail.before(), trail.after()};
}

TEST(Trail, LeadsBackAndForwardUntilAnotherNumberBeginsANewWay) {
  Trail trail;
  EXPECT_EQ(SidesOf(trail), Sides(0, 0));
  for (const std::uint64_t number : {7u, 8u, 8u, 0u, 9u}) trail.GoTo(number);
  EXPECT_EQ(SidesOf(trail), Sides(8, 0));
  trail.GoTo(8);
  trail.GoTo(7);
  EXPECT_EQ(SidesOf(trail), Sides(0, 8));
  trail.GoTo(8);
  EXPECT_EQ(SidesOf(trail), Sides(7, 9));
  trail.GoTo(5);
  EXPECT_EQ(SidesOf(trail), Sides(8, 0));
}

TEST(Trail, ForgetsTheOldestNumbers) {
  Trail trail;
  for (std::uint64_t number = 1; number <= 1'000; ++number) trail.GoTo(number);
  int steps = 0;
  for (; trail.before() != 0; ++steps) trail.GoTo(trail.before());
  EXPECT_EQ(steps, 199);
}

}  // namespace
}  // namespace soarbox::workbench
