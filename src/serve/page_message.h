// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace soarbox::serve {

/// The fields of a page's message that the server uses. The engine reads the rest.
struct PageMessage {
  std::string request;
  std::string what;                                ///< For "open".
  std::string id;                                  ///< As JSON; empty if it is absent.
  std::optional<std::vector<std::string>> panels;  ///< For "look"; nothing if it is not a list of words.
};

/// Reads a message in one pass, without building its values. Returns nothing if it is not a JSON object with a text
/// `request`, or if it exceeds a limit: 64 levels, 256 fields in one object, 20,000 values in all. Its cost is linear
/// in the number of bytes, and it stops at the first limit that is exceeded.
std::optional<PageMessage> ReadPageMessage(std::string_view text);

}  // namespace soarbox::serve
