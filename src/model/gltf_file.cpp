// SPDX-License-Identifier: BSD-2-Clause
#include "model/gltf_file.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "bytes/base64.h"
#include "bytes/percent_code.h"
#include "diagnostics/plain_text.h"

namespace soarbox::model {
namespace {

using Json = GltfFile::Json;

constexpr std::size_t kChunkHead = 8, kBinaryHead = 12, kMostBuffers = 64, kMostRead = 20'000'000;
constexpr std::uint32_t kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;

const Json kNothing = Json::object();

std::uint32_t LittleAt(std::string_view bytes, std::size_t at) {
  std::uint32_t number = 0;
  for (std::size_t i = 4; i-- > 0;) number = number << 8 | static_cast<std::uint8_t>(bytes[at + i]);
  return number;
}

std::size_t BytesOf(std::uint64_t component) {
  switch (component) {
    case 5120:
    case 5121:
      return 1;
    case 5122:
    case 5123:
      return 2;
    case 5125:
    case 5126:
      return 4;
    default:
      return 0;
  }
}

std::size_t WidthOf(std::string_view type) {
  if (type == "SCALAR") return 1;
  if (type == "VEC2") return 2;
  if (type == "VEC3") return 3;
  if (type == "VEC4") return 4;
  return type == "MAT4" ? 16 : 0;
}

/// A number of a buffer, as a fraction if it is a normalised integer.
float NumberIn(std::string_view bytes, std::size_t at, std::uint64_t component, bool is_normalised) {
  const auto read = [&]<typename T>(T value) {
    std::memcpy(&value, bytes.data() + at, sizeof value);
    return value;
  };
  const auto fraction = [is_normalised](auto value, float most) {
    return is_normalised ? std::max(static_cast<float>(value) / most, -1.0f) : static_cast<float>(value);
  };
  switch (component) {
    case 5120:
      return fraction(read(std::int8_t{}), 127);
    case 5121:
      return fraction(read(std::uint8_t{}), 255);
    case 5122:
      return fraction(read(std::int16_t{}), 32767);
    case 5123:
      return fraction(read(std::uint16_t{}), 65535);
    case 5125:
      return static_cast<float>(read(std::uint32_t{}));
    default:
      return read(float{});
  }
}

}  // namespace

/// Where the elements of an accessor are.
struct GltfFile::Slice {
  std::string_view bytes;
  std::size_t stride = 0, count = 0, width = 0;
  std::uint64_t component = 0;
  bool is_normalised = false;
};

GltfFile::GltfFile(std::string_view file, const ReadNeighbour& neighbour) : neighbour_(neighbour) {
  if (file.starts_with("glTF")) {
    ReadBinary(file);
  } else {
    ReadJson(file);
  }
  if (ok()) CheckVersion();
}

void GltfFile::CheckVersion() {
  const auto asset = json_.find("asset");
  const bool has_version =
      asset != json_.end() && asset->is_object() && asset->contains("version") && (*asset)["version"].is_string();
  if (!has_version || !(*asset)["version"].get<std::string>().starts_with("2"))
    return Fail("it is not a model of glTF version 2");
  const auto required = json_.find("extensionsRequired");
  if (required == json_.end() || required->empty()) return;
  const Json& extension = required->is_array() ? required->front() : *required;
  const std::string name(Beginning(extension.is_string() ? extension.get<std::string>() : "?", 80));
  Fail("it requires the extension " + name + ", which is not supported: export it without this extension");
}

void GltfFile::Fail(std::string problem) {
  if (ok()) problem_ = std::move(problem);
}

void GltfFile::ReadBinary(std::string_view file) {
  if (file.size() < kBinaryHead) return Fail("the file is cut off");
  if (LittleAt(file, 4) != 2) return Fail("it is not a model of glTF version 2");
  const std::size_t size = LittleAt(file, 8);
  if (size > file.size()) return Fail("the file is cut off");
  file = file.substr(0, size);
  bool has_json = false;
  for (std::size_t at = kBinaryHead; at < file.size();) {
    if (file.size() - at < kChunkHead) return Fail("the file is cut off");
    const std::size_t length = LittleAt(file, at);
    const std::uint32_t kind = LittleAt(file, at + 4);
    at += kChunkHead;
    if (length > file.size() - at) return Fail("the file ends within a chunk");
    const std::string_view content = file.substr(at, length);
    at += length;
    if (!has_json) {
      if (kind != kJsonChunk) return Fail("its first chunk is not JSON");
      has_json = true;
      ReadJson(content);
    } else if (kind == kBinaryChunk && binary_.empty()) {
      binary_ = content;
    }
  }
  if (!has_json) Fail("the file is cut off");
}

void GltfFile::ReadJson(std::string_view text) {
  json_ = Json::parse(text, nullptr, false);
  if (json_.is_object()) return;
  json_ = Json::object();
  Fail("it is not a glTF file: neither .glb nor JSON");
}

const Json& GltfFile::At(const char* list, std::uint64_t index) {
  if (!ok()) return kNothing;
  const auto found = json_.find(list);
  if (found != json_.end() && found->is_array() && index < found->size() && (*found)[index].is_object())
    return (*found)[index];
  Fail("there is no " + std::string(list) + "[" + std::to_string(index) + "], which something refers to");
  return kNothing;
}

std::optional<std::uint64_t> GltfFile::Number(const Json& object, const char* member) {
  const auto found = object.find(member);
  if (!ok() || found == object.end()) return std::nullopt;
  constexpr std::uint64_t kMost = std::uint64_t{1} << 31;
  if (found->is_number_integer() && found->get<std::int64_t>() >= 0 && found->get<std::uint64_t>() < kMost)
    return found->get<std::uint64_t>();
  Fail("\"" + std::string(member) + "\" is not a whole number from 0");
  return std::nullopt;
}

std::vector<float> GltfFile::Floats(const Json& object, const char* member, std::size_t most) {
  std::vector<float> numbers;
  const auto found = object.find(member);
  if (!ok() || found == object.end()) return numbers;
  if (!found->is_array() || found->size() > most) {
    Fail("\"" + std::string(member) + "\" has no " + std::to_string(most) + " numbers");
    return numbers;
  }
  for (const Json& one : *found) {
    const float number = one.is_number() ? static_cast<float>(one.get<double>()) : NAN;
    if (!std::isfinite(number)) Fail("\"" + std::string(member) + "\" has something that is not a finite number");
    numbers.push_back(number);
  }
  if (!ok()) numbers.clear();
  return numbers;
}

/// What "uri" of a buffer or image leads to.
std::string GltfFile::Resource(const Json& object, const std::string& what) {
  const auto found = object.find("uri");
  if (found == object.end() || !found->is_string()) {
    Fail(what + " has no \"uri\"");
    return {};
  }
  const std::string uri = found->get<std::string>();
  if (uri.starts_with("data:")) {
    const std::size_t comma = uri.find(',');
    std::optional<std::string> bytes;
    if (comma != std::string::npos && std::string_view(uri).substr(0, comma).ends_with(";base64"))
      bytes = FromBase64(std::string_view(uri).substr(comma + 1));
    if (!bytes) Fail(what + " has a data URI that is not base 64");
    return bytes.value_or("");
  }
  if (uri.find(':') != std::string::npos) {
    Fail(what + " is not beside the model: " + uri.substr(0, 80));
    return {};
  }
  Result<std::string> read = neighbour_(PercentDecoded(uri));
  if (read) return std::move(*read);
  const Diagnostic& error = read.error();
  Fail(what + ": " + error.message + (error.hint.empty() ? "" : " (" + error.hint + ")"));
  return {};
}

std::string_view GltfFile::Buffer(std::uint64_t index) {
  const Json& buffer = At("buffers", index);
  if (!ok()) return {};
  const std::string what = "buffers[" + std::to_string(index) + "]";
  if (index >= kMostBuffers) {
    Fail("a model has at most " + std::to_string(kMostBuffers) + " buffers");
    return {};
  }
  if (buffers_.size() <= index) buffers_.resize(index + 1);
  std::optional<std::string>& known = buffers_[index];
  if (!known) known = index == 0 && !buffer.contains("uri") && !binary_.empty() ? binary_ : Resource(buffer, what);
  const std::size_t length = Number(buffer, "byteLength").value_or(0);
  if (ok() && length > known->size()) Fail(what + " is shorter than its \"byteLength\"");
  return ok() ? std::string_view(*known).substr(0, length) : std::string_view();
}

std::string_view GltfFile::View(std::uint64_t index, std::size_t& stride) {
  const Json& view = At("bufferViews", index);
  const auto buffer = Number(view, "buffer");
  if (ok() && !buffer) Fail("bufferViews[" + std::to_string(index) + "] has no buffer");
  if (!ok()) return {};
  const std::string_view bytes = Buffer(*buffer);
  const std::size_t offset = Number(view, "byteOffset").value_or(0), length = Number(view, "byteLength").value_or(0);
  stride = Number(view, "byteStride").value_or(0);
  if (ok() && (offset > bytes.size() || length > bytes.size() - offset))
    Fail("bufferViews[" + std::to_string(index) + "] lies outside of its buffer");
  return ok() ? bytes.substr(offset, length) : std::string_view();
}

bool GltfFile::Find(std::uint64_t accessor, Slice& slice) {
  const Json& from = At("accessors", accessor);
  const std::string what = "accessors[" + std::to_string(accessor) + "]";
  if (ok() && from.contains("sparse")) Fail(what + " is sparse, which is not supported");
  const auto type = from.find("type");
  slice.component = Number(from, "componentType").value_or(0);
  slice.count = Number(from, "count").value_or(0);
  slice.width = type != from.end() && type->is_string() ? WidthOf(type->get<std::string>()) : 0;
  const auto normalised = from.find("normalized");
  slice.is_normalised = normalised != from.end() && normalised->is_boolean() && normalised->get<bool>();
  const std::size_t element = BytesOf(slice.component) * slice.width;
  const auto view = Number(from, "bufferView");
  const std::size_t offset = Number(from, "byteOffset").value_or(0);
  if (ok() && (element == 0 || !view)) Fail(what + " has no known type or no data");
  if (ok() && (slice.count == 0 || slice.count > kMostIndices))
    Fail(what + " has " + std::to_string(slice.count) + " elements; 1 to " + std::to_string(kMostIndices) +
         " are read");
  // Several nodes may show the same mesh, which is read again for each.
  read_ += slice.count * slice.width;
  if (read_ > kMostRead) Fail("it is too large");
  if (!ok()) return false;
  std::size_t stride = 0;
  const std::string_view bytes = View(*view, stride);
  slice.stride = stride == 0 ? element : stride;
  if (!ok()) return false;
  // None of these numbers reaches 2^31, so that their products fit.
  if (slice.stride < element || offset > bytes.size() ||
      (slice.count - 1) * slice.stride + element > bytes.size() - offset) {
    Fail(what + " lies outside of its buffer view");
    return false;
  }
  slice.bytes = bytes.substr(offset);
  return true;
}

GltfFile::Values GltfFile::FloatsOf(std::uint64_t accessor) {
  Slice slice;
  if (!Find(accessor, slice)) return {};
  Values values{slice.width, slice.count, {}};
  values.numbers.reserve(slice.width * slice.count);
  for (std::size_t i = 0; i < slice.count; ++i) {
    for (std::size_t part = 0; part < slice.width; ++part) {
      const float number = NumberIn(slice.bytes, i * slice.stride + part * BytesOf(slice.component), slice.component,
                                    slice.is_normalised);
      if (!std::isfinite(number)) {
        Fail("accessors[" + std::to_string(accessor) + "] has something that is not a finite number");
        return {};
      }
      values.numbers.push_back(number);
    }
  }
  return values;
}

std::vector<std::uint32_t> GltfFile::IndicesOf(std::uint64_t accessor) {
  Slice slice;
  if (!Find(accessor, slice)) return {};
  const bool is_unsigned = slice.component == 5121 || slice.component == 5123 || slice.component == 5125;
  if (slice.width != 1 || !is_unsigned) {
    Fail("accessors[" + std::to_string(accessor) + "] is used for indices, but is not a list of whole numbers");
    return {};
  }
  std::vector<std::uint32_t> indices;
  indices.reserve(slice.count);
  for (std::size_t i = 0; i < slice.count; ++i) {
    std::uint32_t index = 0;
    for (std::size_t byte = BytesOf(slice.component); byte-- > 0;)
      index = index << 8 | static_cast<std::uint8_t>(slice.bytes[i * slice.stride + byte]);
    indices.push_back(index);
  }
  return indices;
}

std::string GltfFile::ImageBytes(std::uint64_t image) {
  const Json& from = At("images", image);
  if (const auto view = Number(from, "bufferView")) {
    std::size_t stride = 0;
    return std::string(View(*view, stride));
  }
  return ok() ? Resource(from, "images[" + std::to_string(image) + "]") : std::string();
}

}  // namespace soarbox::model
