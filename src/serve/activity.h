// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

#include "serve/page_message.h"

namespace soarbox::serve {

/// What the person at a run does, for the teacher's table: the first mistake in the rules, how often they were graded
/// since the run was opened, and since when. Times are given by the caller.
class Activity {
 public:
  using Time = std::chrono::steady_clock::time_point;
  enum class Kind : std::uint8_t {
    kWorks,
    kMistake,  ///< The rules have an error now.
    kStuck,    ///< They have had one for kStuckAfter, or were graded kManyGrades times and did not pass.
    kIdle,     ///< Nothing was asked for kIdleAfter.
  };
  static constexpr std::chrono::seconds kStuckAfter{120}, kIdleAfter{600};
  static constexpr int kManyGrades = 3;

  /// A run begins. If it is the same world as before, the counts go on.
  void Begin(const std::string& what, Time now);
  /// The person's page asks for something.
  void NoteRequest(const PageMessage& message, Time now);
  /// Contents of panels as the engine has sent them (docs/workbench.md), as JSON; empty: none came yet.
  void Look(const std::string& edit, const std::string& problems, const std::string& mission, Time now);

  struct Standing {
    Kind kind = Kind::kWorks;
    std::string text;  ///< "error in porter.soar, line 4: ..."; empty: nothing to say.
    std::chrono::seconds lasts{0};
    int grades = 0;
  };
  Standing At(Time now) const;

 private:
  std::string what_, mistake_;
  int grades_ = 0;
  bool is_passed_ = false;
  Time mistake_since_, graded_since_, asked_;
};

}  // namespace soarbox::serve
