// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string_view>

namespace sml {

/// The one copy of a text that all agents of this process share: attributes are few, and each of them names thousands
/// of elements. It ends with a zero and stays while the process does. Null for a long text, and for a new one after
/// some thousands of others, so that a client with ever new attributes does not fill the memory. From any thread.
char const* SharedText(std::string_view text);

}  // namespace sml
