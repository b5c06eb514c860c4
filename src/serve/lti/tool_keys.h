// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "diagnostics/result.h"
#include "serve/lti/rsa_key.h"

namespace soarbox::lti {

/// The keys with which this server signs messages to platforms.
///
/// A new key is made every 90 days. Its public key is published two days before it signs, because platforms cache what
/// they have read. The old key stays published for two days after it has signed last. Times are seconds since 1970.
class ToolKeys {
 public:
  static constexpr std::int64_t kDay_s = 86'400, kSigns_s = 90 * kDay_s, kOverlap_s = 2 * kDay_s;

  /// Reads the output of ToText from a file. Fails if the file is damaged. Contains no keys if there is no file.
  static Result<ToolKeys> Read(const std::filesystem::path& file);
  std::string ToText() const;

  /// Whether it is time to add a key, or to remove one.
  bool NeedsRotation(std::int64_t now_s) const;
  /// Adds a key if it is time, and removes keys that are no longer published. Fails if no key can be made.
  Result<void> Rotate(std::int64_t now_s);

  /// A signed token with these claims; empty if there is no key.
  std::string Sign(const std::string& claims, std::int64_t now_s) const;
  /// The JSON Web Key Set of all public keys.
  std::string PublicSet() const;

 private:
  struct Key {
    std::string id;
    std::int64_t made_s = 0;
    PrivateKey key;
  };
  /// The key that signs at this time: the newest that was made at least kOverlap_s ago, else the oldest. Null if there
  /// is no key.
  const Key* Signer(std::int64_t now_s) const;
  bool NeedsNew(std::int64_t now_s) const;
  bool HasEnded(std::size_t index, std::int64_t now_s) const;

  std::vector<Key> keys_;  ///< In the order in which they were made.
};

}  // namespace soarbox::lti
