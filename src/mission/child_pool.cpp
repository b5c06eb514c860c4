// SPDX-License-Identifier: BSD-2-Clause
#include "mission/child_pool.h"

#include <fcntl.h>
#include <poll.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstring>
#include <exception>
#include <vector>

#include "diagnostics/problem.h"
#include "world/shared_navigation.h"

namespace soarbox::mission {
namespace {

/// Precedes the output of a child, so that an incomplete output is detected.
struct Frame {
  std::uint64_t size = 0;
  std::uint64_t hash = 0;
};

std::uint64_t HashOf(const std::string& text) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  return hash;
}

bool WriteAll(int file, const void* data, std::size_t size) {
  const char* at = static_cast<const char*>(data);
  while (size > 0) {
    const ssize_t written = write(file, at, size);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    at += written;
    size -= static_cast<std::size_t>(written);
  }
  return true;
}

void Limit(int what, rlim_t soft, rlim_t hard) {
  const rlimit limit{soft, hard};
  (void)setrlimit(static_cast<__rlimit_resource>(what), &limit);
}

/// Runs in the child: sets the limits, discards what is printed, calls `work` and writes its result to the pipe.
[[noreturn]] void RunChild(int pipe, const std::function<std::string()>& work, const ChildLimits& limits) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  for (const int signal : {SIGTERM, SIGALRM, SIGXCPU}) std::signal(signal, SIG_DFL);
  std::signal(SIGINT, SIG_IGN);  // The parent handles it.
  if (const int nothing = open("/dev/null", O_RDWR); nothing >= 0) {
    dup2(nothing, STDIN_FILENO);
    dup2(nothing, STDOUT_FILENO);
    dup2(nothing, STDERR_FILENO);
  }
  const auto cpu_s = static_cast<rlim_t>(std::ceil(std::max(1.0, limits.cpu_s)));
  Limit(RLIMIT_CPU, cpu_s, cpu_s + 2);
  Limit(RLIMIT_CORE, 0, 0);
  if (limits.memory_bytes > 0) Limit(RLIMIT_AS, limits.memory_bytes, limits.memory_bytes);
  std::string output;
  try {
    output = work();
  } catch (const std::exception&) {
    _exit(1);  // Usually out of memory. The output is incomplete, so it counts as a crash.
  }
  const Frame frame{output.size(), HashOf(output)};
  const bool written = WriteAll(pipe, &frame, sizeof frame) && WriteAll(pipe, output.data(), output.size());
  _exit(written ? 0 : 1);
}

}  // namespace

ChildPool::ChildPool(int jobs) : jobs_(jobs) {
  world::ShareNavigation();
}

ChildPool::~ChildPool() {
  for (const auto& [pid, child] : running_) kill(pid, SIGKILL);
  while (!running_.empty()) Reap(running_.begin()->first);
}

Result<void> ChildPool::Start(std::size_t id, const std::function<std::string()>& work, const ChildLimits& limits) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0)
    return NewProblem(std::string("no pipe to another process: ") + std::strerror(errno));
  const int pid = fork();
  if (pid < 0) {
    const Diagnostic problem = NewProblem(std::string("no other process can be started: ") + std::strerror(errno),
                                          "try fewer at a time with --jobs");
    close(ends[0]);
    close(ends[1]);
    return problem;
  }
  if (pid == 0) {
    close(ends[0]);
    for (const auto& [other, child] : running_) close(child.pipe);
    RunChild(ends[1], work, limits);
  }
  close(ends[1]);
  Child& child = running_[pid];
  child.id = id;
  child.pipe = ends[0];
  // The limit of real time is ten times that of processor time, so that runs do not fail on a busy machine.
  child.deadline = std::chrono::steady_clock::now() +
                   std::chrono::milliseconds(static_cast<std::int64_t>(10'000 * std::max(1.0, limits.cpu_s)));
  return {};
}

ChildPool::Done ChildPool::Reap(int pid) {
  Child child = std::move(running_[pid]);
  running_.erase(pid);
  close(child.pipe);
  int status = 0;
  rusage used{};
  while (wait4(pid, &status, 0, &used) < 0 && errno == EINTR) {
  }
  Done done;
  done.id = child.id;
  ChildEnd& end = done.end;
  end.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  end.hung = child.hung || end.signal == SIGXCPU;
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) / 1e6;
  };
  end.cpu_s = seconds(used.ru_utime) + seconds(used.ru_stime);
  end.peak_mb = static_cast<double>(used.ru_maxrss) / 1024;
  Frame frame;
  if (child.read.size() < sizeof frame) return done;
  std::memcpy(&frame, child.read.data(), sizeof frame);
  child.read.erase(0, sizeof frame);
  if (frame.size != child.read.size() || frame.hash != HashOf(child.read)) return done;
  end.is_whole = true;
  end.output = std::move(child.read);
  return done;
}

std::optional<ChildPool::Done> ChildPool::Wait(double seconds) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point until = Clock::now() + std::chrono::milliseconds(static_cast<std::int64_t>(seconds * 1000));
  while (!running_.empty()) {
    std::vector<pollfd> files;
    std::vector<int> pids;
    Clock::time_point wake = until;
    for (const auto& [pid, child] : running_) {
      files.push_back({child.pipe, POLLIN, 0});
      pids.push_back(pid);
      wake = std::min(wake, child.deadline);
    }
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(wake - Clock::now()).count();
    const int ready = poll(files.data(), files.size(), static_cast<int>(std::clamp<std::int64_t>(left + 1, 0, 60'000)));
    if (ready < 0) return std::nullopt;  // A signal came. The caller checks whether it has to stop.
    for (std::size_t i = 0; i < files.size(); ++i) {
      Child& child = running_[pids[i]];
      if (files[i].revents != 0) {
        char bytes[65536];
        const ssize_t got = read(child.pipe, bytes, sizeof bytes);
        if (got > 0) {
          child.read.append(bytes, static_cast<std::size_t>(got));
        } else if (got == 0 || errno != EINTR) {
          return Reap(pids[i]);
        }
      }
      if (Clock::now() >= child.deadline && !child.hung) {
        child.hung = true;
        kill(pids[i], SIGKILL);
      }
    }
    if (Clock::now() >= until) break;
  }
  return std::nullopt;
}

int Processors() {
  cpu_set_t set;
  if (sched_getaffinity(0, sizeof set, &set) != 0) return 1;
  return std::max(1, CPU_COUNT(&set));
}

}  // namespace soarbox::mission
