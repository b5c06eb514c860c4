# SPDX-License-Identifier: BSD-2-Clause
list(APPEND SOARBOX_KERNEL_SOURCES agent.cpp)
