// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace soarbox::lti {

/// What this server says when it sends a browser to a platform, and gets back with the platform's answer. The browser
/// carries it, signed with a secret of the server, so that the server keeps nothing for logins that nobody finishes.
struct LoginState {
  std::string id;     ///< Also in a cookie: the browser that brings the answer is the one that asked.
  std::string nonce;  ///< Which the platform's token must contain.
  std::string issuer, client_id;
  std::int64_t ends_s = 0;  ///< Since 1970.
};
constexpr std::int64_t kLoginLasts_s = 600;

std::string WriteLoginState(const LoginState& state, std::string_view secret);
/// Nothing if it was not written with this secret, or has ended.
std::optional<LoginState> ReadLoginState(std::string_view text, std::string_view secret, std::int64_t now_s);

/// The value of Set-Cookie for a login.
std::string CookieOf(const LoginState& state);
/// Whether a browser's cookies contain that of this login.
bool HasCookieOf(const LoginState& state, std::string_view cookies);

}  // namespace soarbox::lti
