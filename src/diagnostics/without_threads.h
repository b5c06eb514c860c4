// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <pthread.h>

#include <cstddef>

namespace soarbox {

/// For tests: while an object exists, no thread can be started, as if memory for another stack were exhausted.
/// std::thread then throws std::system_error.
class WithoutThreads {
 public:
  WithoutThreads() {
    pthread_getattr_default_np(&before_);
    pthread_attr_t huge;
    pthread_attr_init(&huge);
    pthread_attr_setstacksize(&huge, std::size_t{1} << 56);  // More than a processor can address.
    pthread_setattr_default_np(&huge);
    pthread_attr_destroy(&huge);
  }
  ~WithoutThreads() {
    pthread_setattr_default_np(&before_);
    pthread_attr_destroy(&before_);
  }
  WithoutThreads(const WithoutThreads&) = delete;
  WithoutThreads& operator=(const WithoutThreads&) = delete;

 private:
  pthread_attr_t before_;
};

}  // namespace soarbox
