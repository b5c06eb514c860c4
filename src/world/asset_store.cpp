// SPDX-License-Identifier: BSD-2-Clause
#include "world/asset_store.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>
#include <map>
#include <mutex>

#include "world/state_hash.h"

namespace soarbox::world {
namespace {

constexpr std::size_t kHashDigits = 16;
constexpr char kSeparator = '#';

struct AssetFiles {
  std::mutex mutex;
  std::map<std::uint64_t, std::shared_ptr<const std::string>> by_hash;
};

AssetFiles& AllFiles() {
  static AssetFiles files;
  return files;
}

}  // namespace

std::string AssetKey(std::string_view name, std::uint64_t hash) {
  char digits[kHashDigits + 1];
  std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(hash));
  return std::string(name) + kSeparator + digits;
}

std::optional<std::uint64_t> HashInKey(std::string_view key) {
  if (AssetName(key).empty()) return std::nullopt;
  const char* const end = key.data() + key.size();
  std::uint64_t hash = 0;
  const auto [stopped, error] = std::from_chars(end - kHashDigits, end, hash, 16);
  if (error != std::errc{} || stopped != end) return std::nullopt;
  return hash;
}

std::string KeepAsset(std::string_view name, std::string content) {
  StateHash hash;
  hash.Add(std::string_view(content));
  AssetFiles& files = AllFiles();
  const std::scoped_lock lock(files.mutex);
  if (const auto found = files.by_hash.find(hash.value()); found == files.by_hash.end())
    files.by_hash.emplace(hash.value(), std::make_shared<const std::string>(std::move(content)));
  return AssetKey(name, hash.value());
}

std::shared_ptr<const std::string> FindAsset(std::string_view key) {
  const auto hash = HashInKey(key);
  if (!hash) return nullptr;
  AssetFiles& files = AllFiles();
  const std::scoped_lock lock(files.mutex);
  const auto found = files.by_hash.find(*hash);
  return found == files.by_hash.end() ? nullptr : found->second;
}

std::string_view AssetName(std::string_view key) {
  if (key.size() <= kHashDigits + 1 || key[key.size() - kHashDigits - 1] != kSeparator) return {};
  return key.substr(0, key.size() - kHashDigits - 1);
}

bool IsAssetName(std::string_view name) {
  static constexpr std::array<std::string_view, 5> kEndings = {".png", ".glb", ".gltf", ".bin", ".wav"};
  return std::ranges::any_of(kEndings, [name](std::string_view ending) { return name.ends_with(ending); });
}

}  // namespace soarbox::world
