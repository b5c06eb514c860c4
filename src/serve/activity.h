// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

#include "serve/page_message.h"

namespace soarbox::serve {

/// Summarizes for the teacher's table what the user of a run does: the first error in the files, the number of gradings
/// since this world was opened, and since when. Callers pass the current time.
class Activity {
 public:
  using Time = std::chrono::steady_clock::time_point;
  enum class Kind : std::uint8_t {
    kWorks,
    kMistake,  ///< The rules have an error now.
    kStuck,    ///< The rules have had an error for kStuckAfter, or were graded kManyGrades times and did not pass.
    kIdle,     ///< The user has sent no request for kIdleAfter.
  };
  static constexpr std::chrono::seconds kStuckAfter{120}, kIdleAfter{600};
  static constexpr int kManyGrades = 3;

  /// A run was opened. If it is the same world as before, the counts continue.
  void Begin(const std::string& what, Time now);
  /// The user's page has sent a request.
  void NoteRequest(const PageMessage& message, Time now);
  /// The newest contents of panels from the engine (docs/workbench.md), as JSON; empty if there are none yet.
  void Look(const std::string& edit, const std::string& problems, const std::string& mission, Time now);

  struct Standing {
    Kind kind = Kind::kWorks;
    std::string text;  ///< "error in porter.soar, line 4: ..."; empty if there is nothing to report.
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
