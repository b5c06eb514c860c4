// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/strand.hpp>
#include <boost/asio/thread_pool.hpp>
#include <chrono>
#include <cstddef>
#include <functional>
#include <map>
#include <string>

namespace soarbox::serve {

/// Executes slow work (disk, archives, starting a process) on a pool of threads, so that the thread that accepts
/// connections never blocks. Jobs with the same name are executed one after another, in the order of the calls.
class Work {
 public:
  explicit Work(boost::asio::io_context& io);
  /// Waits for running jobs; drops those that have not started.
  ~Work();
  Work(const Work&) = delete;
  Work& operator=(const Work&) = delete;

  /// Executes `job` on a thread of the pool, then `done` on the thread of `io`, also if the job throws. Call it on the
  /// thread of `io`.
  void Do(const std::string& name, std::function<void()> job, std::function<void()> done);
  /// Number of jobs with this name that have not finished.
  std::size_t Waiting(const std::string& name) const;

 private:
  using Strand = boost::asio::strand<boost::asio::thread_pool::executor_type>;
  struct Line {
    Strand strand;
    std::size_t waiting = 0;
  };
  boost::asio::io_context& io_;
  boost::asio::thread_pool pool_;
  std::map<std::string, Line> lines_;  ///< By name; only names with unfinished jobs.
};

/// A limit of the work that each place or address causes. Costs are measured in points; one point is about a
/// millisecond of a thread. A name may use `per_s` points per second on average, and `burst` at once.
class Costs {
 public:
  Costs(double per_s, double burst) : per_s_(per_s), burst_(burst) {}
  /// Whether this name may start something now. The cost of what it starts may exceed its remaining points.
  bool MayBegin(const std::string& name);
  void Charge(const std::string& name, double points);

 private:
  using Clock = std::chrono::steady_clock;
  struct Account {
    double left = 0;
    Clock::time_point when;
  };
  Account& Find(const std::string& name);

  double per_s_, burst_;
  std::map<std::string, Account> accounts_;
};

}  // namespace soarbox::serve
