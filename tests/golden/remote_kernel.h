// SPDX-License-Identifier: BSD-2-Clause
#pragma once

// Included before a program that creates its own kernel: it then uses the kernel on this machine at the port in the
// environment variable SOARBOX_KERNEL_PORT.

#include <cstdlib>

#include "sml_Client.h"

inline int RemoteKernelPort() {
  const char* port = std::getenv("SOARBOX_KERNEL_PORT");
  return port == nullptr ? 12121 : std::atoi(port);
}

#define CreateKernelInCurrentThread(optimized, port) CreateRemoteConnection(optimized, "127.0.0.1", RemoteKernelPort())
