// SPDX-License-Identifier: BSD-2-Clause
#include "app/refuse.h"

#include <gtest/gtest.h>

#include <new>
#include <stdexcept>

#include "app/exit_codes.h"

namespace soarbox::app {
namespace {

TEST(Refuse, AnExceptionIsToldAsTheReasonOfTheEnd) {
  std::string told;
  OnRefusal([&](const Diagnostic& problem) { told = problem.message; });
  EXPECT_EQ(RefuseExceptions([]() -> int { throw std::length_error("this text is too long"); }), kCannotStart);
  EXPECT_EQ(told, "this text is too long");
  told.clear();
  EXPECT_EQ(RefuseExceptions([] { return 7; }), 7);
  // The server takes an end without a reason as a lack of memory.
  EXPECT_THROW(RefuseExceptions([]() -> int { throw std::bad_alloc(); }), std::bad_alloc);
  EXPECT_EQ(told, "");
  OnRefusal({});
}

}  // namespace
}  // namespace soarbox::app
