// SPDX-License-Identifier: BSD-2-Clause
#include "serve/lti/tool_keys.h"

#include <nlohmann/json.hpp>
#include <optional>

#include "bytes/base64.h"
#include "diagnostics/json_text.h"
#include "diagnostics/problem.h"
#include "diagnostics/read_text.h"
#include "serve/lti/jwt.h"
#include "serve/random_id.h"

namespace soarbox::lti {
namespace {

using KeyJson = nlohmann::ordered_json;

}  // namespace

Result<ToolKeys> ToolKeys::Read(const std::filesystem::path& file) {
  ToolKeys keys;
  const std::optional<std::string> text = ReadText(file);
  if (!text) return keys;
  const Diagnostic damaged = ProblemIn(file, "this file is damaged: it holds the server's keys for learning platforms",
                                       "restore it, or move it away; then the server makes a new key");
  try {
    const KeyJson json = KeyJson::parse(*text);
    for (const KeyJson& each : json.at("keys")) {
      std::optional<PrivateKey> key = PrivateKey::FromPem(each.at("pem").get<std::string>());
      if (!key) return damaged;
      keys.keys_.push_back({each.at("id").get<std::string>(), each.at("made").get<std::int64_t>(), std::move(*key)});
    }
  } catch (const KeyJson::exception&) {
    return damaged;
  }
  return keys;
}

std::string ToolKeys::ToText() const {
  KeyJson keys = KeyJson::array();
  for (const Key& each : keys_) keys.push_back({{"id", each.id}, {"made", each.made_s}, {"pem", each.key.ToPem()}});
  return JsonText(KeyJson{{"keys", std::move(keys)}}, 2) + "\n";
}

bool ToolKeys::NeedsNew(std::int64_t now_s) const {
  return keys_.empty() || keys_.back().made_s + kSigns_s <= now_s;
}

bool ToolKeys::HasEnded(std::size_t index, std::int64_t now_s) const {
  // The next key signs kOverlap_s after it was made. The old one stays published for kOverlap_s after that.
  return index + 1 < keys_.size() && keys_[index + 1].made_s + 2 * kOverlap_s <= now_s;
}

bool ToolKeys::NeedsRotation(std::int64_t now_s) const {
  return NeedsNew(now_s) || HasEnded(0, now_s);
}

Result<void> ToolKeys::Rotate(std::int64_t now_s) {
  if (NeedsNew(now_s)) {
    std::optional<PrivateKey> fresh = PrivateKey::New();
    if (!fresh) return NewProblem("the server cannot make a key for learning platforms");
    keys_.push_back({serve::NewId(), now_s, std::move(*fresh)});
  }
  while (HasEnded(0, now_s)) keys_.erase(keys_.begin());
  return {};
}

const ToolKeys::Key* ToolKeys::Signer(std::int64_t now_s) const {
  for (auto key = keys_.rbegin(); key != keys_.rend(); ++key)
    if (key->made_s + kOverlap_s <= now_s) return &*key;
  return keys_.empty() ? nullptr : &keys_.front();
}

std::string ToolKeys::Sign(const std::string& claims, std::int64_t now_s) const {
  const Key* const signer = Signer(now_s);
  if (signer == nullptr) return {};
  const std::string text = UnsignedJwt(signer->id, claims);
  return text + "." + ToBase64Url(signer->key.Sign(text));
}

std::string ToolKeys::PublicSet() const {
  KeyJson keys = KeyJson::array();
  for (const Key& each : keys_)
    keys.push_back({{"kty", "RSA"},
                    {"use", "sig"},
                    {"alg", "RS256"},
                    {"kid", each.id},
                    {"n", ToBase64Url(each.key.modulus())},
                    {"e", ToBase64Url(each.key.exponent())}});
  return JsonText(KeyJson{{"keys", std::move(keys)}});
}

}  // namespace soarbox::lti
