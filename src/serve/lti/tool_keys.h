// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "diagnostics/result.h"
#include "serve/lti/rsa_key.h"

namespace soarbox::lti {

/// The keys with which this server signs what it says to platforms, and their public halves for platforms.
///
/// A key signs for 90 days. Its successor is published two days before, because platforms keep what they have read, and
/// the old key stays published for two days after. Times are seconds since 1970.
class ToolKeys {
 public:
  static constexpr std::int64_t kDay_s = 86'400, kSigns_s = 90 * kDay_s, kOverlap_s = 2 * kDay_s;

  /// From what ToText has written; without a file there are no keys yet. The error says that the file is damaged.
  static Result<ToolKeys> Read(const std::filesystem::path& file);
  std::string ToText() const;

  /// Whether a key is to be added, or one to be removed, now.
  bool NeedsRotation(std::int64_t now_s) const;
  /// Adds a key if one is to be added, and removes those that have ended. The error says that there is no key.
  Result<void> Rotate(std::int64_t now_s);

  /// A signed token with these claims; empty if there is no key.
  std::string Sign(const std::string& claims, std::int64_t now_s) const;
  /// The JSON Web Key Set of all public halves.
  std::string PublicSet() const;

 private:
  struct Key {
    std::string id;
    std::int64_t made_s = 0;
    PrivateKey key;
  };
  /// The key that signs at this time: the newest that was published long enough ago; else the oldest. Null: none.
  const Key* Signer(std::int64_t now_s) const;
  bool NeedsNew(std::int64_t now_s) const;
  bool HasEnded(std::size_t index, std::int64_t now_s) const;

  std::vector<Key> keys_;  ///< In the order in which they were made.
};

}  // namespace soarbox::lti
