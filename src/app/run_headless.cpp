// SPDX-License-Identifier: BSD-2-Clause
#include "app/run_headless.h"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <thread>

namespace soarbox::app {
namespace {

using Clock = std::chrono::steady_clock;

/// A line on stderr that is rewritten about twice a second, once a run has lasted two seconds.
class Progress {
 public:
  explicit Progress(const RunOptions& options)
      : shown_(isatty(STDERR_FILENO) != 0 && !options.json && options.follow.empty()), total_s_(*options.seconds) {}
  ~Progress() {
    if (written_) std::fputs("\r\033[K", stderr);
  }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void Show(double time_s) {
    if (!shown_) return;
    const Clock::time_point now = Clock::now();
    if (now < next_) return;
    next_ = now + std::chrono::milliseconds(500);
    const double wall_s = std::chrono::duration<double>(now - start_).count();
    std::fputs(
        fmt::format("\r\033[K{:.0f} of {:.0f} s simulated, {:.1f} times real time", time_s, total_s_, time_s / wall_s)
            .c_str(),
        stderr);
    written_ = true;
  }

 private:
  bool shown_;
  double total_s_;
  bool written_ = false;
  Clock::time_point start_ = Clock::now();
  Clock::time_point next_ = start_ + std::chrono::seconds(2);
};

}  // namespace

int RunHeadless(RunSession& session, const RunOptions& options) {
  {
    Progress progress(options);
    const Clock::time_point start = Clock::now();
    while (!session.IsOver()) {
      session.Tick();
      progress.Show(session.simulation().time_s());
      if (options.speed) {
        std::this_thread::sleep_until(start + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(
                                                  session.simulation().time_s() / *options.speed)));
      }
    }
  }
  return session.Finish();
}

}  // namespace soarbox::app
