// SPDX-License-Identifier: BSD-2-Clause
#pragma once

/// Marks symbols that the shared library exports.
#if defined(_WIN32)
#if defined(SOARBOX_SML_BUILDING)
#define EXPORT __declspec(dllexport)
#else
#define EXPORT __declspec(dllimport)
#endif
#else
#define EXPORT __attribute__((visibility("default")))
#endif

/// Marks the entry function of a library that a kernel loads.
#if defined(_WIN32)
#define RHS_EXPORT __declspec(dllexport)
#else
#define RHS_EXPORT __attribute__((visibility("default")))
#endif
