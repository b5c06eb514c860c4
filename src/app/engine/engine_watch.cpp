// SPDX-License-Identifier: BSD-2-Clause
#include "app/engine/engine_watch.h"

#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <thread>

namespace soarbox::app {

void EndWithServer(int socket) {
  if (getpgrp() != getpid()) return;
  std::thread([socket] {
    // Blocks all signals here, so that the thread that runs the world handles them.
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, nullptr);
    pollfd gone{socket, POLLRDHUP, 0};
    while (poll(&gone, 1, -1) < 0 && errno == EINTR) {
    }
    constexpr auto kTimeToEnd = std::chrono::seconds(10);
    std::this_thread::sleep_for(kTimeToEnd);
    kill(0, SIGKILL);
  }).detach();
}

}  // namespace soarbox::app
