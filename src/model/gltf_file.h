// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/gltf.h"

namespace soarbox::model {

/// A parsed glTF file: its JSON, its buffers, and its accessors as plain numbers. The first error is kept; after it,
/// all functions return empty values. Used by gltf.cpp.
class GltfFile {
 public:
  using Json = nlohmann::json;

  GltfFile(std::string_view file, const ReadNeighbour& neighbour);

  const std::string& problem() const { return problem_; }
  bool ok() const { return problem_.empty(); }
  void Fail(std::string problem);

  /// The object at this index of a list ("meshes"); an empty object after a failure.
  const Json& At(const char* list, std::uint64_t index);
  /// A whole number below 2^31 in an object; nothing if the object has no such member.
  std::optional<std::uint64_t> Number(const Json& object, const char* member);
  /// Up to `most` numbers of an array in an object; empty if there is none. Fails if they are not finite.
  std::vector<float> Floats(const Json& object, const char* member, std::size_t most);

  /// The numbers of an accessor, `width` of them for each element, with normalised integers as fractions.
  struct Values {
    std::size_t width = 0, count = 0;
    std::vector<float> numbers;
  };
  Values FloatsOf(std::uint64_t accessor);
  std::vector<std::uint32_t> IndicesOf(std::uint64_t accessor);
  /// The bytes of an image: a buffer view, a data URI or a file next to the model.
  std::string ImageBytes(std::uint64_t image);

  const Json& root() const { return json_; }

 private:
  struct Slice;
  void CheckVersion();
  void ReadBinary(std::string_view file);
  void ReadJson(std::string_view text);
  std::string Resource(const Json& object, const std::string& what);
  std::string_view Buffer(std::uint64_t index);
  std::string_view View(std::uint64_t index, std::size_t& stride);
  bool Find(std::uint64_t accessor, Slice& slice);

  const ReadNeighbour& neighbour_;
  Json json_ = Json::object();
  std::string binary_;  ///< The second chunk of a .glb.
  std::vector<std::optional<std::string>> buffers_;
  std::size_t read_ = 0;  ///< Numbers of accessors so far.
  std::string problem_;
};

}  // namespace soarbox::model
