// SPDX-License-Identifier: BSD-2-Clause
// Calls that emscripten's C library declares and does not define. There is one process with one thread, so nobody else can hold a lock,
// and no other program can be started.
#include <errno.h>
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
