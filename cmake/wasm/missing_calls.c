// SPDX-License-Identifier: BSD-2-Clause
// Calls that emscripten's C library declares and does not define, and calls that do not work in Node.js. There is one
// process with one thread, so nobody else can hold a lock, and no other program can be started.
#include <emscripten.h>
#include <errno.h>
#include <poll.h>
#include <pthread.h>
#include <signal.h>
#include <spawn.h>
#include <sys/file.h>
#include <sys/random.h>
#include <unistd.h>

int posix_spawnp(pid_t* process, const char* file, const posix_spawn_file_actions_t* actions,
                 const posix_spawnattr_t* attributes, char* const arguments[], char* const environment[]) {
  (void)process, (void)file, (void)actions, (void)attributes, (void)arguments, (void)environment;
  return ENOSYS;
}

int flock(int file, int operation) {
  (void)file, (void)operation;
  return 0;
}

int syncfs(int file) {
  (void)file;
  return 0;
}

ssize_t getrandom(void* bytes, size_t count, unsigned flags) {
  (void)flags;
  return getentropy(bytes, count) == 0 ? (ssize_t)count : -1;
}

int pthread_kill(pthread_t thread, int signal) {
  (void)thread, (void)signal;
  return ENOSYS;
}

// Emscripten's own takes pipes for terminals.
EM_JS(int, is_terminal_of_node, (int file), {
  return typeof require == "function" && require("tty").isatty(file) ? 1 : 0;
})
int isatty(int file) {
  if (is_terminal_of_node(file)) return 1;
  errno = ENOTTY;
  return 0;
}

// Node.js cannot wait for input for a limited time. Nothing is ready in such a time; without a limit, the call that reads waits.
int poll(struct pollfd* files, nfds_t count, int most_ms) {
  if (most_ms >= 0) return 0;
  for (nfds_t i = 0; i < count; ++i) files[i].revents = files[i].events;
  return (int)count;
}
