// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string_view>

namespace sml {

/// Returns the copy of a text that all agents of this process share. (There are few attributes, but each is used by
/// thousands of elements.) It is zero-terminated and is never freed. Returns null for long texts. Also returns null for
/// new texts after some thousands of others, so that a client with ever new attributes cannot exhaust the memory.
/// Callable from any thread.
char const* SharedText(std::string_view text);

}  // namespace sml
