// SPDX-License-Identifier: BSD-2-Clause
#include "serve/wall.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <fstream>
#include <functional>

namespace soarbox::serve {
namespace {

namespace fs = std::filesystem;

/// Two places next to each other.
class Wall : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::path(::testing::TempDir()) / "wall-XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    root_ = name;
    for (const char* place : {"own", "other", "data"}) {
      fs::create_directories(root_ / place);
      std::ofstream(root_ / place / "file.txt") << place;
    }
  }
  void TearDown() override { fs::remove_all(root_); }

  /// The result of `act` in a process with the wall of a place.
  int Behind(const std::function<int()>& act, bool may_connect = false) const {
    const pid_t pid = fork();
    if (pid == 0) {
      RaiseWall({{root_ / "own"}, {root_ / "data"}, may_connect});
      _exit(act());
    }
    int status = 0;
    waitpid(pid, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  }
  /// 0, or the error of an open.
  static int Open(const fs::path& file, int flags) {
    const int opened = open(file.c_str(), flags, 0600);
    return opened >= 0 ? 0 : errno;
  }
  static bool Has(const char* word) {
    for (const std::string& sentence : MissingOfWall())
      if (sentence.find(word) != std::string::npos) return false;
    return true;
  }

  fs::path root_;
};

TEST_F(Wall, ItsOwnPlaceIsOpenAndDataCanBeRead) {
  EXPECT_EQ(Behind([&] { return Open(root_ / "own" / "file.txt", O_RDWR | O_TRUNC); }), 0);
  EXPECT_EQ(Behind([&] { return Open(root_ / "own" / "new.txt", O_WRONLY | O_CREAT); }), 0);
  EXPECT_EQ(Behind([&] { return fs::create_directory(root_ / "own" / "folder") ? 0 : 1; }), 0);
  EXPECT_EQ(Behind([&] { return Open(root_ / "data" / "file.txt", O_RDONLY); }), 0);
}

TEST_F(Wall, AnotherPlaceCannotBeOpened) {
  if (!Has("landlock")) GTEST_SKIP() << "no landlock here";
  EXPECT_EQ(Behind([&] { return Open(root_ / "other" / "file.txt", O_RDONLY); }), EACCES);
  EXPECT_EQ(Behind([&] { return Open(root_ / "other" / "new.txt", O_WRONLY | O_CREAT); }), EACCES);
  EXPECT_EQ(Behind([&] { return Open(root_, O_RDONLY | O_DIRECTORY); }), EACCES) << "names of places are secrets";
  EXPECT_EQ(Behind([&] { return Open(root_ / "data" / "file.txt", O_WRONLY); }), EACCES);
  EXPECT_EQ(Behind([&] { return Open("/etc/passwd", O_RDONLY); }), EACCES);
  EXPECT_EQ(Behind([&] {
              fs::create_symlink(root_ / "other", root_ / "own" / "way");
              return Open(root_ / "own" / "way" / "file.txt", O_RDONLY);
            }),
            EACCES);
}

TEST_F(Wall, NothingCanBeConnected) {
  if (!Has("seccomp")) GTEST_SKIP() << "no seccomp here";
  for (const int family : {AF_INET, AF_INET6, AF_UNIX, AF_NETLINK})
    EXPECT_EQ(Behind([&] { return socket(family, SOCK_DGRAM, 0) >= 0 ? 0 : errno; }), EPERM) << family;
  // A socket that it already has.
  const int before = socket(AF_INET, SOCK_DGRAM, 0);
  EXPECT_EQ(Behind([&] {
              sockaddr_in to{};
              to.sin_family = AF_INET;
              to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
              to.sin_port = htons(9);
              return connect(before, reinterpret_cast<const sockaddr*>(&to), sizeof to) == 0 ? 0 : errno;
            }),
            EPERM);
  close(before);
  EXPECT_EQ(Behind([] { return socket(AF_INET, SOCK_DGRAM, 0) >= 0 ? 0 : errno; }, true), 0)
      << "an exercise was allowed";
}

TEST_F(Wall, NoOtherProgramIsStarted) {
  if (!Has("landlock")) GTEST_SKIP() << "no landlock here";
  std::ofstream(root_ / "own" / "script") << "#!/bin/sh\nexit 0\n";
  fs::permissions(root_ / "own" / "script", fs::perms::owner_all);
  for (const std::string& program :
       {std::string("/bin/sh"), std::string("/usr/bin/env"), (root_ / "own" / "script").string()})
    EXPECT_EQ(Behind([&] {
                execl(program.c_str(), program.c_str(), nullptr);
                return errno;
              }),
              EACCES)
        << program;
}

TEST_F(Wall, OtherProcessesAreOutOfReach) {
  if (!Has("seccomp")) GTEST_SKIP() << "no seccomp here";
  EXPECT_EQ(Behind([] { return ptrace(PTRACE_ATTACH, getppid(), nullptr, nullptr) == 0 ? 0 : errno; }), EPERM);
}

TEST_F(Wall, ProcessesAreCounted) {
  if (!Has("counts")) GTEST_SKIP() << "not counted here";
  EXPECT_EQ(Behind([] {
              rlimit limit{};
              constexpr rlim_t kTooMany = 5'000;
              if (getrlimit(RLIMIT_NPROC, &limit) != 0 || limit.rlim_cur > kTooMany) return 2;
              // The system does not count root's processes.
              if (getuid() == 0) return 0;
              // Each of them waits until this process ends, so that all exist at the same time.
              int ends[2];
              if (pipe(ends) != 0) return 3;
              for (rlim_t started = 0; started <= limit.rlim_cur; ++started) {
                const pid_t pid = fork();
                if (pid < 0) return errno == EAGAIN ? 0 : 4;
                if (pid > 0) continue;
                close(ends[1]);
                char byte = 0;
                [[maybe_unused]] const auto got = read(ends[0], &byte, 1);
                _exit(0);
              }
              return 1;
            }),
            0)
      << "a process that starts others without end";
}

}  // namespace
}  // namespace soarbox::serve
