// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/result.h"

namespace soarbox::lti {

/// A JSON Web Token (RFC 7519) in its compact form. Nothing in it can be trusted before its signature is checked.
struct Jwt {
  std::string algorithm;    ///< "RS256"; of a stranger's choice: compare it, never select by it.
  std::string key_id;       ///< Empty: it names none.
  std::string claims;       ///< JSON: an object.
  std::string signed_part;  ///< The bytes that are signed.
  std::string signature;
};

/// Reads a token of at most kMostJwtBytes. The error says what is wrong with it.
Result<Jwt> ReadJwt(std::string_view text);
constexpr std::size_t kMostJwtBytes = 64u << 10;

/// What is to be signed of a token with these claims: header and claims. Append "." and the signature in base64url.
std::string UnsignedJwt(const std::string& key_id, const std::string& claims);

/// An RSA key of a platform, as its JSON Web Key Set (RFC 7517) names it: numbers as bytes, the highest first.
struct WebKey {
  std::string id, modulus, exponent;
};

/// The keys of a set that can check RS256 signatures; others are left out. The error says that it is not a set of keys.
Result<std::vector<WebKey>> ReadKeySet(std::string_view text);

}  // namespace soarbox::lti
