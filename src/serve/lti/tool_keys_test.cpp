// SPDX-License-Identifier: BSD-2-Clause
#include "serve/lti/tool_keys.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "bytes/base64.h"
#include "serve/lti/jwt.h"

namespace soarbox::lti {
namespace {

constexpr std::int64_t kBegin_s = 1'800'000'000, kDay_s = ToolKeys::kDay_s;

/// The id of the key that signs at this time, if its signature fits the published key.
std::string SignerAt(const ToolKeys& keys, std::int64_t now_s) {
  const Result<Jwt> token = ReadJwt(keys.Sign("{\"a\":1}", now_s));
  if (!token) return "no token";
  const Result<std::vector<WebKey>> set = ReadKeySet(keys.PublicSet());
  for (const WebKey& each : *set) {
    if (each.id != token->key_id) continue;
    const std::optional<PublicKey> key = PublicKey::FromNumbers(each.modulus, each.exponent);
    return key && key->Verify(token->signed_part, token->signature) ? each.id : "wrong signature";
  }
  return "a key that is not published";
}

std::size_t Published(const ToolKeys& keys) {
  return ReadKeySet(keys.PublicSet())->size();
}

TEST(ToolKeys, AKeySignsAfterItHasBeenPublishedAndIsPublishedAfterItHasSigned) {
  ToolKeys keys;
  EXPECT_TRUE(keys.NeedsRotation(kBegin_s));
  ASSERT_TRUE(keys.Rotate(kBegin_s));
  const std::string first = SignerAt(keys, kBegin_s);
  EXPECT_EQ(first.size(), 26u) << first;
  EXPECT_FALSE(keys.NeedsRotation(kBegin_s + 89 * kDay_s));

  const std::int64_t next_s = kBegin_s + 90 * kDay_s;
  EXPECT_TRUE(keys.NeedsRotation(next_s));
  ASSERT_TRUE(keys.Rotate(next_s));
  EXPECT_EQ(Published(keys), 2u);
  EXPECT_EQ(SignerAt(keys, next_s + kDay_s), first);
  const std::string second = SignerAt(keys, next_s + 2 * kDay_s);
  EXPECT_EQ(second.size(), 26u) << second;
  EXPECT_NE(second, first);

  EXPECT_FALSE(keys.NeedsRotation(next_s + 3 * kDay_s));
  EXPECT_TRUE(keys.NeedsRotation(next_s + 4 * kDay_s));
  ASSERT_TRUE(keys.Rotate(next_s + 4 * kDay_s));
  EXPECT_EQ(Published(keys), 1u);
  EXPECT_EQ(SignerAt(keys, next_s + 5 * kDay_s), second);
}

TEST(ToolKeys, KeysAreTheSameAfterARestart) {
  const std::filesystem::path file = testing::TempDir() + "keys_" + std::to_string(getpid()) + ".json";
  ToolKeys keys;
  ASSERT_TRUE(keys.Rotate(kBegin_s));
  std::ofstream(file) << keys.ToText();
  const Result<ToolKeys> again = ToolKeys::Read(file);
  ASSERT_TRUE(again);
  EXPECT_EQ(again->PublicSet(), keys.PublicSet());
  EXPECT_EQ(SignerAt(*again, kBegin_s), SignerAt(keys, kBegin_s));
  std::ofstream(file) << "{\"keys\":[{\"id\":\"a\",\"made\":1,\"pem\":\"x\"}]}";
  EXPECT_FALSE(ToolKeys::Read(file));
  std::filesystem::remove(file);
  EXPECT_TRUE(ToolKeys::Read(file)->NeedsRotation(kBegin_s));
}

TEST(PublicKey, WeakAndBrokenKeysAreNone) {
  const std::string good(256, '\xff');
  EXPECT_FALSE(PublicKey::FromNumbers(std::string(128, '\xff'), "\x03")) << "1024 bits";
  EXPECT_FALSE(PublicKey::FromNumbers(std::string(2000, '\xff'), "\x03")) << "too long";
  EXPECT_FALSE(PublicKey::FromNumbers(good, "\x01"));
  EXPECT_FALSE(PublicKey::FromNumbers(good, "\x02"));
  EXPECT_FALSE(PublicKey::FromNumbers(good, ""));
  EXPECT_FALSE(PublicKey::FromNumbers("", "\x03"));
  EXPECT_FALSE(PublicKey::FromNumbers(std::string(256, '\xfe'), "\x03")) << "even";
}

TEST(PublicKey, OneChangedBitIsNoticed) {
  ToolKeys keys;
  ASSERT_TRUE(keys.Rotate(kBegin_s));
  const Result<Jwt> token = ReadJwt(keys.Sign("{\"a\":1}", kBegin_s));
  const WebKey numbers = ReadKeySet(keys.PublicSet())->front();
  const std::optional<PublicKey> key = PublicKey::FromNumbers(numbers.modulus, numbers.exponent);
  ASSERT_TRUE(key && key->Verify(token->signed_part, token->signature));
  for (std::size_t i = 0; i < token->signature.size(); i += 37) {
    std::string changed = token->signature;
    changed[i] = static_cast<char>(changed[i] ^ 1);
    EXPECT_FALSE(key->Verify(token->signed_part, changed));
  }
  EXPECT_FALSE(key->Verify(token->signed_part + " ", token->signature));
  EXPECT_FALSE(key->Verify(token->signed_part, ""));
  EXPECT_FALSE(key->Verify(token->signed_part, std::string(5000, 'x')));
}

}  // namespace
}  // namespace soarbox::lti
