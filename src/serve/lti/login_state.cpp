// SPDX-License-Identifier: BSD-2-Clause
#include "serve/lti/login_state.h"

#include <nlohmann/json.hpp>

#include "bytes/base64.h"
#include "diagnostics/json_text.h"
#include "serve/lti/rsa_key.h"
#include "serve/random_id.h"

namespace soarbox::lti {
namespace {

using StateJson = nlohmann::ordered_json;

/// Each login has its own cookie, because several tabs of a browser may log in at the same time.
std::string CookieName(const LoginState& state) {
  constexpr std::size_t kLetters = 8;
  return "soarbox-lti-" + state.id.substr(0, kLetters);
}

std::string SignatureOf(std::string_view packed, std::string_view secret) {
  return ToBase64Url(Hmac(secret, "login " + std::string(packed)));
}

}  // namespace

std::string WriteLoginState(const LoginState& state, std::string_view secret) {
  const std::string packed = ToBase64Url(JsonText(StateJson{{"id", state.id},
                                                            {"nonce", state.nonce},
                                                            {"issuer", state.issuer},
                                                            {"client_id", state.client_id},
                                                            {"ends", state.ends_s}}));
  return packed + "." + SignatureOf(packed, secret);
}

std::optional<LoginState> ReadLoginState(std::string_view text, std::string_view secret, std::int64_t now_s) {
  const std::size_t dot = text.find('.');
  if (dot == std::string_view::npos ||
      !serve::SameSecret(text.substr(dot + 1), SignatureOf(text.substr(0, dot), secret)))
    return std::nullopt;
  // The signature is valid, so this server wrote the text.
  const StateJson json = StateJson::parse(FromBase64Url(text.substr(0, dot)).value_or(""), nullptr, false);
  if (!json.is_object()) return std::nullopt;
  LoginState state{json.value("id", ""), json.value("nonce", ""), json.value("issuer", ""), json.value("client_id", ""),
                   json.value("ends", std::int64_t{0})};
  if (state.id.empty() || state.nonce.empty() || state.ends_s < now_s) return std::nullopt;
  return state;
}

std::string CookieOf(const LoginState& state) {
  // The answer is a form that a page of the platform submits. That is another site, which requires SameSite=None.
  return CookieName(state) + "=" + state.id + "; Path=/lti; Max-Age=" + std::to_string(kLoginLasts_s) +
         "; HttpOnly; Secure; SameSite=None; Partitioned";
}

bool HasCookieOf(const LoginState& state, std::string_view cookies) {
  const std::string name = CookieName(state) + "=";
  while (!cookies.empty()) {
    const std::size_t end = std::min(cookies.find(';'), cookies.size());
    std::string_view cookie = cookies.substr(0, end);
    while (cookie.starts_with(' ')) cookie.remove_prefix(1);
    if (cookie.starts_with(name) && serve::SameSecret(cookie.substr(name.size()), state.id)) return true;
    cookies.remove_prefix(std::min(end + 1, cookies.size()));
  }
  return false;
}

}  // namespace soarbox::lti
