// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace soarbox::lti {

/// Bytes as base64url without padding, as JSON Web Tokens use it (RFC 7515).
std::string ToBase64Url(std::string_view bytes);
/// The bytes; nothing if the text has other characters, a padding, or bits after its last byte that are not 0.
std::optional<std::string> FromBase64Url(std::string_view text);

}  // namespace soarbox::lti
