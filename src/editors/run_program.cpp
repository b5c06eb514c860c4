// SPDX-License-Identifier: BSD-2-Clause
#include "editors/run_program.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <thread>

extern char** environ;

namespace soarbox::editors {
namespace {

using Clock = std::chrono::steady_clock;

struct Pipe {
  int read = -1, write = -1;
  bool Open() {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) return false;
    read = ends[0];
    write = ends[1];
    return true;
  }
  void CloseWrite() {
    if (write >= 0) close(write);
    write = -1;
  }
  void CloseRead() {
    if (read >= 0) close(read);
    read = -1;
  }
  ~Pipe() {
    CloseWrite();
    CloseRead();
  }
};

pid_t Spawn(const std::vector<std::string>& arguments, const Pipe& out, const Pipe& err) {
  std::vector<char*> words;
  for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
  words.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, out.write, STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, err.write, STDERR_FILENO);
  pid_t child = -1;
  const int failed = posix_spawn(&child, words.front(), &actions, nullptr, words.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  return failed == 0 ? child : -1;
}

}  // namespace

ProgramEnd RunProgram(const std::vector<std::string>& arguments, const ProgramLimits& limits) {
  ProgramEnd end;
  Pipe out, err;
  if (arguments.empty() || !out.Open() || !err.Open()) return end;
  const pid_t child = Spawn(arguments, out, err);
  out.CloseWrite();
  err.CloseWrite();
  if (child < 0) return end;
  const auto until =
      Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(limits.seconds));
  while (out.read >= 0 || err.read >= 0) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(until - Clock::now()).count();
    if (left <= 0) {
      end.hung = true;
      kill(child, SIGKILL);
      break;
    }
    std::array<pollfd, 2> waits{{{out.read, POLLIN, 0}, {err.read, POLLIN, 0}}};
    if (poll(waits.data(), waits.size(), static_cast<int>(std::min<long long>(left, 60'000))) < 0 && errno != EINTR)
      break;
    for (std::size_t i = 0; i < waits.size(); ++i) {
      if (waits[i].revents == 0) continue;
      Pipe& pipe = i == 0 ? out : err;
      std::string& kept = i == 0 ? end.out : end.err;
      char block[64 * 1024];
      const ssize_t size = read(pipe.read, block, sizeof block);
      if (size < 0 && errno == EINTR) continue;
      if (size <= 0) {
        pipe.CloseRead();
        continue;
      }
      const std::size_t room = limits.output_bytes - std::min(limits.output_bytes, kept.size());
      kept.append(block, std::min(room, static_cast<std::size_t>(size)));
      end.is_cut |= static_cast<std::size_t>(size) > room;
    }
  }
  // A program may close its outputs and go on.
  int status = 0;
  pid_t ended = waitpid(child, &status, WNOHANG);
  while (ended == 0 && !end.hung && Clock::now() < until) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    ended = waitpid(child, &status, WNOHANG);
  }
  if (ended == 0) {
    end.hung = true;
    kill(child, SIGKILL);
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
  }
  if (WIFEXITED(status)) end.code = WEXITSTATUS(status);
  return end;
}

}  // namespace soarbox::editors
