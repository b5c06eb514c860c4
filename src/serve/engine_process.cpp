// SPDX-License-Identifier: BSD-2-Clause
#include "serve/engine_process.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <boost/asio/buffer.hpp>
#include <boost/asio/write.hpp>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "diagnostics/problem.h"

namespace soarbox::serve {
namespace {

constexpr int kEngineSocket = 3;
constexpr std::size_t kMostUnread = 16u << 20;

void Limit(int what, rlim_t most) {
  const rlimit limit{most, most};
  setrlimit(static_cast<__rlimit_resource_t>(what), &limit);
}

struct Child {
  std::vector<char*> words, environment;
  const char* folder;
  int socket;
  const Limits& limits;
};

/// Runs in the new process, between fork and exec: only calls that are safe there.
[[noreturn]] void Become(const Child& child) {
  setpgid(0, 0);
  const int null = open("/dev/null", O_RDWR);
  // First moves the descriptor away from the number that it must get.
  const int socket = fcntl(child.socket, F_DUPFD, 10);
  dup2(null, STDIN_FILENO);
  dup2(null, STDOUT_FILENO);
  dup2(null, STDERR_FILENO);
  dup2(socket, kEngineSocket);
  for (int i = kEngineSocket + 1; i < 4096; ++i) close(i);
  constexpr rlim_t kMostFiles = 64, kMostFileBytes = rlim_t{256} << 20;
  Limit(RLIMIT_DATA, static_cast<rlim_t>(child.limits.engine_data_mb) << 20);
  Limit(RLIMIT_NOFILE, kMostFiles);
  Limit(RLIMIT_FSIZE, kMostFileBytes);
  Limit(RLIMIT_CORE, 0);
  constexpr int kNice = 5;
  setpriority(PRIO_PROCESS, 0, kNice);
  signal(SIGPIPE, SIG_DFL);
  // All users of this machine can read its arguments, so they name files relative to the place.
  if (chdir(child.folder) == 0) execve(child.words.front(), child.words.data(), child.environment.data());
  _exit(127);
}

std::vector<char*> Pointers(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  return pointers;
}

}  // namespace

EngineProcess::EngineProcess(boost::asio::io_context& io) : socket_(io), timer_(io) {}

EngineProcess::~EngineProcess() {
  if (pid_ <= 0) return;
  kill(-pid_, SIGKILL);
  waitpid(pid_, nullptr, 0);
}

Result<EngineProcess::Spawned> EngineProcess::Spawn(const std::vector<std::string>& given, const Place& place,
                                                    const Limits& limits) {
  const auto refuse = [] {
    return NewProblem(std::string("the server cannot start another run: ") + std::strerror(errno), "try again later");
  };
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) return refuse();
  // Removes the temporary files of the previous run, which may have crashed.
  const std::filesystem::path temporary = place.state() / "tmp";
  std::error_code error;
  std::filesystem::remove_all(temporary, error);
  std::filesystem::create_directories(temporary, error);
  std::vector<std::string> words = given, environment = {"HOME=" + place.home().string(),
                                                         "XDG_STATE_HOME=" + place.state().string(),
                                                         "SOARBOX_PLACE=" + place.root().string(),
                                                         "TMPDIR=" + temporary.string(),
                                                         "PATH=/usr/bin:/bin",
                                                         "LANG=C.UTF-8"};
  if (const char* data = std::getenv("SOARBOX_DATA"))
    environment.push_back("SOARBOX_DATA=" + std::filesystem::absolute(data, error).string());
  const std::string root = place.root().string();
  const Child child{Pointers(words), Pointers(environment), root.c_str(), ends[1], limits};
  const pid_t pid = fork();
  if (pid == 0) Become(child);
  const Diagnostic problem = refuse();
  close(ends[1]);
  if (pid > 0) return Spawned{pid, ends[0]};
  close(ends[0]);
  return problem;
}

std::shared_ptr<EngineProcess> EngineProcess::Adopt(boost::asio::io_context& io, const Spawned& spawned, Hooks hooks) {
  std::shared_ptr<EngineProcess> engine(new EngineProcess(io));
  engine->pid_ = spawned.pid;
  engine->hooks_ = std::move(hooks);
  engine->socket_.assign(boost::asio::local::stream_protocol(), spawned.socket);
  engine->Read();
  return engine;
}

void EngineProcess::Read() {
  socket_.async_read_some(boost::asio::buffer(bytes_),
                          [self = shared_from_this()](boost::system::error_code error, std::size_t size) {
                            if (!error) self->reader_.Add({self->bytes_.data(), size});
                            while (std::optional<Frame> frame = error ? std::nullopt : self->reader_.Take())
                              if (self->hooks_.on_frame) self->hooks_.on_frame(std::move(*frame));
                            if (error || self->reader_.is_broken()) return self->AwaitEnd();
                            self->Read();
                          });
}

void EngineProcess::Send(std::string text) {
  if (is_closed_) return;
  waiting_bytes_ += text.size();
  // The process has not read for a long time, so it is considered to hang.
  if (waiting_bytes_ > kMostUnread) return AwaitEnd();
  waiting_.push_back(WriteFrame(FrameKind::kText, text));
  if (waiting_.size() == 1) Write();
}

void EngineProcess::Write() {
  boost::asio::async_write(socket_, boost::asio::buffer(waiting_.front()),
                           [self = shared_from_this()](boost::system::error_code error, std::size_t) {
                             if (error) return;
                             self->waiting_bytes_ -= std::min(self->waiting_bytes_, self->waiting_.front().size());
                             self->waiting_.pop_front();
                             if (!self->waiting_.empty()) self->Write();
                           });
}

void EngineProcess::End(std::function<void()> on_gone) {
  hooks_ = {};
  if (on_gone) hooks_.on_end = [on_gone = std::move(on_gone)](Ending) { on_gone(); };
  AwaitEnd();
}

void EngineProcess::Kill() {
  if (pid_ > 0) kill(-pid_, SIGKILL);
  AwaitEnd();
}

void EngineProcess::AwaitEnd() {
  boost::system::error_code ignored;
  if (!std::exchange(is_closed_, true)) socket_.close(ignored);
  if (pid_ <= 0) return;
  int status = 0;
  if (waitpid(pid_, &status, WNOHANG) == pid_) {
    kill(-pid_, SIGKILL);  // All processes that it started.
    pid_ = 0;
    constexpr int kMostGood = 1, kCannotStart = 3;
    const bool by_itself = WIFEXITED(status);
    if (const Hooks hooks = std::exchange(hooks_, {}); hooks.on_end)
      hooks.on_end(by_itself && WEXITSTATUS(status) <= kMostGood      ? Ending::kGood
                   : by_itself && WEXITSTATUS(status) == kCannotStart ? Ending::kRefused
                                                                      : Ending::kCrashed);
    return;
  }
  constexpr int kMostWaits = 60;
  if (++waits_ == kMostWaits) kill(-pid_, SIGKILL);
  timer_.expires_after(std::chrono::milliseconds(50));
  timer_.async_wait([self = shared_from_this()](boost::system::error_code error) {
    if (!error) self->AwaitEnd();
  });
}

}  // namespace soarbox::serve
