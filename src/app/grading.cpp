// SPDX-License-Identifier: BSD-2-Clause
#include "app/grading.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <vector>

#include "diagnostics/problem.h"

namespace soarbox::app {
namespace {

Diagnostic CannotGrade(int error) {
  return NewProblem(std::string("your rules cannot be checked now: ") + std::strerror(error));
}

}  // namespace

struct Grading::Work {
  pid_t pid;
  int pipe;
};

Grading::Grading() = default;
Grading::~Grading() {
  Stop();
}

Result<void> Grading::Start(const std::string& lesson, const std::filesystem::path& folder,
                            const std::filesystem::path& from) {
  std::vector<std::string> words = {"soarbox",       "learn",  "check",       lesson,      "--folder",
                                    folder.string(), "--from", from.string(), "--progress"};
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) return CannotGrade(errno);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDERR_FILENO);
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  pid_t pid = 0;
  const int failed = posix_spawn(&pid, "/proc/self/exe", &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  close(ends[1]);
  if (failed != 0) {
    close(ends[0]);
    return CannotGrade(failed);
  }
  fcntl(ends[0], F_SETFL, O_NONBLOCK);
  work_ = std::make_unique<Work>(Work{pid, ends[0]});
  text_.clear();
  return {};
}

void Grading::Stop() {
  if (work_ == nullptr) return;
  kill(work_->pid, SIGTERM);  // The process then ends the runs that it started.
  waitpid(work_->pid, nullptr, 0);
  close(work_->pipe);
  work_.reset();
}

bool Grading::Poll() {
  if (work_ == nullptr) return false;
  std::array<char, 4096> bytes;
  while (true) {
    const ssize_t got = read(work_->pipe, bytes.data(), bytes.size());
    if (got < 0) return false;  // No output yet.
    if (got == 0) break;
    text_.append(bytes.data(), static_cast<std::size_t>(got));
  }
  waitpid(work_->pid, nullptr, 0);
  close(work_->pipe);
  work_.reset();
  return true;
}

}  // namespace soarbox::app
