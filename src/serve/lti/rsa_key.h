// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

/// OpenSSL's type of a key.
struct evp_pkey_st;

namespace soarbox::lti {

/// The public half of an RSA key: checks RS256 signatures. Copies share the key; any thread may use it.
class PublicKey {
 public:
  /// Creates a key from the bytes of its modulus and exponent; nothing if this is not a key of 2048 to 8192 bits.
  static std::optional<PublicKey> FromNumbers(std::string_view modulus, std::string_view exponent);
  bool Verify(std::string_view text, std::string_view signature) const;

 private:
  explicit PublicKey(std::shared_ptr<evp_pkey_st> key) : key_(std::move(key)) {}
  std::shared_ptr<evp_pkey_st> key_;
};

/// An RSA key of this server: makes RS256 signatures. Copies share the key; any thread may use it.
class PrivateKey {
 public:
  /// Creates a key of 2048 bits, which takes up to a second; nothing if the system has no random numbers.
  static std::optional<PrivateKey> New();
  static std::optional<PrivateKey> FromPem(const std::string& text);
  std::string ToPem() const;
  /// Returns the signature; empty if there is not enough memory.
  std::string Sign(std::string_view text) const;
  /// The bytes of the numbers of the public key, the most significant first.
  std::string modulus() const;
  std::string exponent() const;

 private:
  explicit PrivateKey(std::shared_ptr<evp_pkey_st> key) : key_(std::move(key)) {}
  std::shared_ptr<evp_pkey_st> key_;
};

/// HMAC-SHA256.
std::string Hmac(std::string_view key, std::string_view text);

}  // namespace soarbox::lti
