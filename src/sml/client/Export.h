// SPDX-License-Identifier: BSD-2-Clause
#pragma once

/// Marks what the shared library offers to its users.
#if defined(_WIN32)
#if defined(SOARBOX_SML_BUILDING)
#define EXPORT __declspec(dllexport)
#else
#define EXPORT __declspec(dllimport)
#endif
#else
#define EXPORT __attribute__((visibility("default")))
#endif
