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

/// Runs what may take long (disk, archives, starting a process) on threads of its own, so that the thread that accepts
/// connections never waits. Jobs with the same name run one after another, in the order in which they came.
class Work {
 public:
  explicit Work(boost::asio::io_context& io);
  /// Waits for the jobs that have begun; forgets those that have not.
  ~Work();
  Work(const Work&) = delete;
  Work& operator=(const Work&) = delete;

  /// Runs `job` on a thread of the pool, then `done` on the thread of `io`. If the job throws, `done` is called, too.
  /// Call it on the thread of `io`.
  void Do(const std::string& name, std::function<void()> job, std::function<void()> done);
  /// Number of jobs of this name that have not ended.
  std::size_t Waiting(const std::string& name) const;

 private:
  using Strand = boost::asio::strand<boost::asio::thread_pool::executor_type>;
  struct Line {
    Strand strand;
    std::size_t waiting = 0;
  };
  boost::asio::io_context& io_;
  boost::asio::thread_pool pool_;
  std::map<std::string, Line> lines_;  ///< Those with jobs.
};

/// What each place or address has cost lately. A cost is a number of points; one point is about a millisecond of a
/// thread. A name may cost `per_s` points in the mean, and `burst` at once.
class Costs {
 public:
  Costs(double per_s, double burst) : per_s_(per_s), burst_(burst) {}
  /// Whether this name may begin something now. A name may go into debt by what it has begun.
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
