// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/result.h"

namespace soarbox::lti {

/// A JSON Web Token (RFC 7519) in its compact form. Do not trust any of it before its signature is checked.
struct Jwt {
  std::string algorithm;    ///< "RS256". The sender chooses it: compare it with the required one, do not select by it.
  std::string key_id;       ///< Empty if the token names no key.
  std::string claims;       ///< JSON: an object.
  std::string signed_part;  ///< The bytes that are signed.
  std::string signature;
};

/// Parses a token of at most kMostJwtBytes. Does not check its signature. Fails with the reason if it is malformed.
Result<Jwt> ReadJwt(std::string_view text);
constexpr std::size_t kMostJwtBytes = 64u << 10;

/// Returns header and claims of a token, to be signed. Append "." and the signature in base64url to get the token.
std::string UnsignedJwt(const std::string& key_id, const std::string& claims);

/// An RSA key from a platform's JSON Web Key Set (RFC 7517). Modulus and exponent are bytes, the most significant
/// first.
struct WebKey {
  std::string id, modulus, exponent;
};

/// Parses a JSON Web Key Set. Leaves out keys that cannot check RS256 signatures. Fails if the text is not a set of at
/// most 100 keys.
Result<std::vector<WebKey>> ReadKeySet(std::string_view text);

}  // namespace soarbox::lti
