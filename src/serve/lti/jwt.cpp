// SPDX-License-Identifier: BSD-2-Clause
#include "serve/lti/jwt.h"

#include <array>
#include <nlohmann/json.hpp>
#include <optional>

#include "bytes/base64.h"
#include "diagnostics/json_text.h"
#include "diagnostics/problem.h"

namespace soarbox::lti {
namespace {

using TokenJson = nlohmann::ordered_json;

std::string TokenText(const TokenJson& json, const char* field) {
  const auto found = json.find(field);
  return found != json.end() && found->is_string() ? found->get<std::string>() : std::string();
}

/// The key's modulus and exponent; nothing if it cannot check RS256 signatures.
std::optional<WebKey> ReadKey(const TokenJson& json) {
  if (!json.is_object() || TokenText(json, "kty") != "RSA") return std::nullopt;
  if (json.contains("use") && TokenText(json, "use") != "sig") return std::nullopt;
  if (json.contains("alg") && TokenText(json, "alg") != "RS256") return std::nullopt;
  const std::optional<std::string> modulus = FromBase64Url(TokenText(json, "n")),
                                   exponent = FromBase64Url(TokenText(json, "e"));
  if (!modulus || !exponent || modulus->empty() || exponent->empty()) return std::nullopt;
  return WebKey{TokenText(json, "kid"), *modulus, *exponent};
}

}  // namespace

Result<Jwt> ReadJwt(std::string_view text) {
  if (text.size() > kMostJwtBytes) return NewProblem("this token is longer than 64 KB");
  const std::size_t first = text.find('.'),
                    second = first == std::string_view::npos ? first : text.find('.', first + 1);
  if (second == std::string_view::npos || text.find('.', second + 1) != std::string_view::npos)
    return NewProblem("this is not a token: it needs three parts with dots between them");
  const std::optional<std::string> header = FromBase64Url(text.substr(0, first)),
                                   claims = FromBase64Url(text.substr(first + 1, second - first - 1)),
                                   signature = FromBase64Url(text.substr(second + 1));
  if (!header || !claims || !signature) return NewProblem("a part of this token is not base64url");
  const TokenJson head = TokenJson::parse(*header, nullptr, false);
  if (!head.is_object()) return NewProblem("the header of this token is not a JSON object");
  if (head.contains("crit")) return NewProblem("this token needs an extension that Soarbox does not know");
  if (!TokenJson::parse(*claims, nullptr, false).is_object())
    return NewProblem("the claims of this token are not a JSON object");
  return Jwt{TokenText(head, "alg"), TokenText(head, "kid"), *claims, std::string(text.substr(0, second)), *signature};
}

std::string UnsignedJwt(const std::string& key_id, const std::string& claims) {
  const TokenJson header = {{"typ", "JWT"}, {"alg", "RS256"}, {"kid", key_id}};
  return ToBase64Url(JsonText(header)) + "." + ToBase64Url(claims);
}

Result<std::vector<WebKey>> ReadKeySet(std::string_view text) {
  constexpr std::size_t kMostKeys = 100;
  const TokenJson json = TokenJson::parse(text, nullptr, false);
  const auto found = json.is_object() ? json.find("keys") : json.end();
  if (!json.is_object() || found == json.end() || !found->is_array() || found->size() > kMostKeys)
    return NewProblem("this is not a set of at most 100 keys", "a set of keys is {\"keys\": [...]}, as RFC 7517 says");
  std::vector<WebKey> keys;
  for (const TokenJson& each : *found)
    if (std::optional<WebKey> key = ReadKey(each)) keys.push_back(std::move(*key));
  return keys;
}

}  // namespace soarbox::lti
