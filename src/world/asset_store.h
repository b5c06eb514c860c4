// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace soarbox::world {

// Images, models and sounds that scripts load from files of their world. A scene refers to such a file by its key.
// Renderers and sound players get the content here. One store serves all worlds of the process. A key depends only on
// the name and the content, so worlds cannot disturb each other. Nothing is removed before the process ends.
// Thread-safe.

/// Largest file that is stored.
inline constexpr std::size_t kLargestAsset = std::size_t{8} << 20;

/// Stores a file and returns its key: "images/badge.png#0123456789abcdef", the name and a hash of the content.
std::string KeepAsset(std::string_view name, std::string content);

/// The content of a key; null if no such file was stored in this process.
std::shared_ptr<const std::string> FindAsset(std::string_view key);

/// The name in a key; empty if the text is not a key.
std::string_view AssetName(std::string_view key);

/// Makes the key of a name and a hash. HashInKey returns the hash in a key; nothing if the text is not a key.
std::string AssetKey(std::string_view name, std::uint64_t hash);
std::optional<std::uint64_t> HashInKey(std::string_view key);

/// Whether a file of this name can be an image, a model or a sound, by its ending: .png, .glb, .gltf, .bin, .wav.
bool IsAssetName(std::string_view name);

}  // namespace soarbox::world
