// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace soarbox::lti {

/// The data that this server sends with a browser to a platform, and gets back with the platform's answer. The text is
/// signed with a secret of the server. So the server stores nothing for logins that are never finished.
struct LoginState {
  std::string id;     ///< Also in a cookie, which shows that the answer comes from the same browser.
  std::string nonce;  ///< The platform's token must contain it.
  std::string issuer, client_id;
  std::int64_t ends_s = 0;  ///< When it expires, in seconds since 1970.
};
constexpr std::int64_t kLoginLasts_s = 600;

std::string WriteLoginState(const LoginState& state, std::string_view secret);
/// Returns nothing if the text was not written with this secret, or has expired.
std::optional<LoginState> ReadLoginState(std::string_view text, std::string_view secret, std::int64_t now_s);

/// The value of Set-Cookie for a login.
std::string CookieOf(const LoginState& state);
/// Whether a browser's cookies contain that of this login.
bool HasCookieOf(const LoginState& state, std::string_view cookies);

}  // namespace soarbox::lti
