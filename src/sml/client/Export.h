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

/// Marks the function by which a library that a kernel loads offers itself.
#if defined(_WIN32)
#define RHS_EXPORT __declspec(dllexport)
#else
#define RHS_EXPORT __attribute__((visibility("default")))
#endif
