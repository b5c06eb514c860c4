// SPDX-License-Identifier: BSD-2-Clause
#include "model/gltf.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "diagnostics/problem.h"
#include "model/gltf_file.h"
#include "picture/jpeg_reader.h"
#include "picture/png_reader.h"

namespace soarbox::model {
namespace {

using Json = GltfFile::Json;
using world::Vec3;

constexpr int kDeepestNode = 64;
constexpr int kMostNodes = 20'000;
/// Of all textures together.
constexpr std::size_t kMostPixels = std::size_t{1} << 24;
/// Further away nothing is drawn, and floats become coarse.
constexpr float kFarthest_m = 1e5f;

/// A transformation: three axes and a place.
struct Frame {
  Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1}, place;

  Vec3 Turned(Vec3 v) const { return x * v.x + y * v.y + z * v.z; }
  Vec3 Placed(Vec3 v) const { return Turned(v) + place; }
  float Determinant() const { return Dot(Cross(x, y), z); }
  /// Turns a normal. It stays perpendicular to the surface even if the axes have different scales: the matrix of
  /// cofactors does that.
  Vec3 TurnedNormal(Vec3 n) const {
    const Vec3 turned = Cross(y, z) * n.x + Cross(z, x) * n.y + Cross(x, y) * n.z;
    return Normalized(Determinant() < 0 ? -turned : turned);
  }
};

Frame operator*(const Frame& a, const Frame& b) {
  return {a.Turned(b.x), a.Turned(b.y), a.Turned(b.z), a.Placed(b.place)};
}

float ToLight(float shown) {
  return std::pow(std::clamp(shown, 0.0f, 1.0f), 2.2f);
}
float ToShown(float light) {
  return std::pow(std::clamp(light, 0.0f, 1.0f), 1 / 2.2f);
}

struct Light {
  float red = 1, green = 1, blue = 1;
};

/// The base colour of a material.
struct Paint {
  Light factor;
  const picture::Pixels* texture = nullptr;
  std::string set = "TEXCOORD_0";

  /// The nearest pixel; textures repeat.
  Light At(float u, float v) const {
    if (texture == nullptr) return factor;
    const auto pixel = [](float at, int size) {
      const float share = at - std::floor(at);
      return std::clamp(static_cast<int>(share * static_cast<float>(size)), 0, size - 1);
    };
    const auto index = std::size_t{4} *
                       (static_cast<std::size_t>(pixel(v, texture->height)) * static_cast<std::size_t>(texture->width) +
                        static_cast<std::size_t>(pixel(u, texture->width)));
    const auto light = [&](std::size_t channel) {
      return ToLight(static_cast<float>(texture->rgba[index + channel]) / 255);
    };
    return {factor.red * light(0), factor.green * light(1), factor.blue * light(2)};
  }
};

class ModelReader {
 public:
  ModelReader(std::string_view file, const ReadNeighbour& neighbour) : file_(file, neighbour) {}

  Result<Model> Read() {
    AddScene();
    if (file_.ok() && model_.indices.empty()) file_.Fail("it has no triangles");
    if (!file_.ok()) return NewProblem(file_.problem());
    model_.min = model_.max = model_.corners.front().position;
    for (const Corner& corner : model_.corners) {
      const Vec3& at = corner.position;
      model_.min = {std::min(model_.min.x, at.x), std::min(model_.min.y, at.y), std::min(model_.min.z, at.z)};
      model_.max = {std::max(model_.max.x, at.x), std::max(model_.max.y, at.y), std::max(model_.max.z, at.z)};
    }
    return std::move(model_);
  }

 private:
  void AddScene() {
    const Json& root = file_.root();
    if (!root.contains("scenes")) {
      const std::size_t count = root.contains("nodes") && root["nodes"].is_array() ? root["nodes"].size() : 0;
      const std::set<std::uint64_t> children = count > 0 ? Children(root["nodes"]) : std::set<std::uint64_t>();
      for (std::size_t i = 0; i < count && file_.ok(); ++i)
        if (!children.contains(i)) AddNode(i, Frame(), 0);
      return;
    }
    AddNodes(file_.At("scenes", file_.Number(root, "scene").value_or(0)), "nodes", Frame(), 0);
  }

  /// The indices of the nodes that have a parent. In a file without scenes, all other nodes are shown with their
  /// children.
  static std::set<std::uint64_t> Children(const Json& nodes) {
    std::set<std::uint64_t> children;
    for (const Json& node : nodes) {
      if (!node.is_object() || !node.contains("children") || !node["children"].is_array()) continue;
      for (const Json& child : node["children"])
        if (child.is_number_unsigned()) children.insert(child.get<std::uint64_t>());
    }
    return children;
  }

  void AddNodes(const Json& owner, const char* member, const Frame& frame, int depth) {
    const auto found = owner.find(member);
    if (found == owner.end() || !found->is_array()) return;
    for (const Json& child : *found) {
      if (!child.is_number_unsigned()) file_.Fail(std::string("\"") + member + "\" has something that is not a number");
      if (!file_.ok()) return;
      AddNode(child.get<std::uint64_t>(), frame, depth);
    }
  }

  void AddNode(std::uint64_t index, const Frame& above, int depth) {
    if (depth > kDeepestNode || ++nodes_ > kMostNodes)
      return file_.Fail("its nodes are nested in a circle, too deep or too many");
    const Json& node = file_.At("nodes", index);
    const Frame frame = above * FrameOf(node);
    if (const auto mesh = file_.Number(node, "mesh")) AddMesh(*mesh, frame);
    AddNodes(node, "children", frame, depth + 1);
  }

  Frame FrameOf(const Json& node) {
    if (const auto m = file_.Floats(node, "matrix", 16); m.size() == 16)
      return {{m[0], m[1], m[2]}, {m[4], m[5], m[6]}, {m[8], m[9], m[10]}, {m[12], m[13], m[14]}};
    Frame frame;
    if (const auto turn = file_.Floats(node, "rotation", 4); turn.size() == 4) {
      const float length = std::hypot(std::hypot(turn[0], turn[1]), std::hypot(turn[2], turn[3]));
      if (length > 0) {
        const world::Quat q{turn[3] / length, turn[0] / length, turn[1] / length, turn[2] / length};
        frame = {Rotate(q, frame.x), Rotate(q, frame.y), Rotate(q, frame.z), {}};
      }
    }
    if (const auto scale = file_.Floats(node, "scale", 3); scale.size() == 3)
      frame = {frame.x * scale[0], frame.y * scale[1], frame.z * scale[2], {}};
    if (const auto place = file_.Floats(node, "translation", 3); place.size() == 3)
      frame.place = {place[0], place[1], place[2]};
    return frame;
  }

  void AddMesh(std::uint64_t index, const Frame& frame) {
    const Json& mesh = file_.At("meshes", index);
    const auto primitives = mesh.find("primitives");
    if (primitives == mesh.end() || !primitives->is_array()) return;
    for (const Json& primitive : *primitives) {
      if (primitive.is_object()) AddPrimitive(primitive, frame);
      if (!file_.ok()) return;
    }
  }

  void AddPrimitive(const Json& primitive, const Frame& frame) {
    constexpr std::uint64_t kTriangles = 4, kStrip = 5, kFan = 6;
    const std::uint64_t mode = file_.Number(primitive, "mode").value_or(kTriangles);
    if (mode < kTriangles || mode > kFan) return;  // Points and lines.
    const Json& attributes = primitive.contains("attributes") ? primitive["attributes"] : file_.root();
    const auto values = [&](const std::string& name) -> GltfFile::Values {
      const auto accessor = file_.Number(attributes, name.c_str());
      return accessor ? file_.FloatsOf(*accessor) : GltfFile::Values{};
    };
    const GltfFile::Values positions = values("POSITION");
    if (file_.ok() && (positions.width != 3 || positions.count == 0)) file_.Fail("a mesh has no positions");
    const Paint paint = PaintOf(primitive);
    const GltfFile::Values normals = values("NORMAL"), colors = values("COLOR_0"), places = values(paint.set);
    std::vector<std::uint32_t> listed;
    if (const auto accessor = file_.Number(primitive, "indices")) {
      listed = file_.IndicesOf(*accessor);
    } else {
      for (std::uint32_t i = 0; i < positions.count; ++i) listed.push_back(i);
    }
    if (!file_.ok()) return;
    if (std::ranges::any_of(listed, [&](std::uint32_t index) { return index >= positions.count; }))
      return file_.Fail("a triangle has a corner that is not there");
    const std::vector<std::uint32_t> triangles = Triangles(listed, mode == kStrip, mode == kFan);
    const bool has_normals = normals.width == 3 && normals.count == positions.count;
    if (model_.corners.size() + (has_normals ? positions.count : triangles.size()) > kMostCorners ||
        model_.indices.size() + triangles.size() > kMostIndices)
      return file_.Fail("it has more than " + std::to_string(kMostCorners) + " corners or " +
                        std::to_string(kMostIndices / 3) + " triangles: make it simpler");

    const auto corner = [&](std::size_t i) {
      Corner made;
      const auto vector = [i](const GltfFile::Values& from) {
        return Vec3{from.numbers[3 * i], from.numbers[3 * i + 1], from.numbers[3 * i + 2]};
      };
      made.position = frame.Placed(vector(positions));
      if (has_normals) made.normal = frame.TurnedNormal(vector(normals));
      Light light = paint.factor;
      if (places.width == 2 && i < places.count) light = paint.At(places.numbers[2 * i], places.numbers[2 * i + 1]);
      if (colors.width >= 3 && i < colors.count) {
        light.red *= colors.numbers[colors.width * i];
        light.green *= colors.numbers[colors.width * i + 1];
        light.blue *= colors.numbers[colors.width * i + 2];
      }
      made.red = ToShown(light.red);
      made.green = ToShown(light.green);
      made.blue = ToShown(light.blue);
      const float far = std::max({std::abs(made.position.x), std::abs(made.position.y), std::abs(made.position.z)});
      if (!(far < kFarthest_m)) file_.Fail("it is larger than 100 km");
      return made;
    };
    AddTriangles(triangles, positions.count, has_normals, frame.Determinant() < 0, corner);
  }

  template <typename MakeCorner>
  void AddTriangles(const std::vector<std::uint32_t>& triangles, std::size_t count, bool has_normals, bool is_mirrored,
                    const MakeCorner& corner) {
    const auto base = static_cast<std::uint32_t>(model_.corners.size());
    if (has_normals)
      for (std::size_t i = 0; i < count; ++i) model_.corners.push_back(corner(i));
    for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) {
      std::array<std::uint32_t, 3> at{triangles[i], triangles[i + 1], triangles[i + 2]};
      if (is_mirrored) std::swap(at[1], at[2]);
      if (has_normals) {
        for (const std::uint32_t index : at) model_.indices.push_back(base + index);
        continue;
      }
      // Without normals each triangle is flat.
      std::array<Corner, 3> corners{corner(at[0]), corner(at[1]), corner(at[2])};
      const Vec3 normal =
          Normalized(Cross(corners[1].position - corners[0].position, corners[2].position - corners[0].position));
      for (Corner& made : corners) {
        made.normal = normal;
        model_.indices.push_back(static_cast<std::uint32_t>(model_.corners.size()));
        model_.corners.push_back(made);
      }
    }
  }

  static std::vector<std::uint32_t> Triangles(const std::vector<std::uint32_t>& listed, bool is_strip, bool is_fan) {
    std::vector<std::uint32_t> triangles;
    if (!is_strip && !is_fan) {
      triangles = listed;
      triangles.resize(triangles.size() / 3 * 3);
      return triangles;
    }
    for (std::size_t i = 0; i + 2 < listed.size(); ++i) {
      const bool is_odd = is_strip && i % 2 == 1;
      triangles.push_back(is_fan ? listed[0] : listed[i]);
      triangles.push_back(is_odd ? listed[i + 2] : listed[i + 1]);
      triangles.push_back(is_odd ? listed[i + 1] : listed[i + 2]);
    }
    return triangles;
  }

  Paint PaintOf(const Json& primitive) {
    Paint paint;
    const auto material = file_.Number(primitive, "material");
    if (!material) return paint;
    const Json& from = file_.At("materials", *material);
    const auto surface = from.find("pbrMetallicRoughness");
    if (surface == from.end() || !surface->is_object()) return paint;
    if (const auto factor = file_.Floats(*surface, "baseColorFactor", 4); factor.size() >= 3)
      paint.factor = {factor[0], factor[1], factor[2]};
    const auto texture = surface->find("baseColorTexture");
    if (texture == surface->end() || !texture->is_object()) return paint;
    paint.set = "TEXCOORD_" + std::to_string(file_.Number(*texture, "texCoord").value_or(0));
    const auto index = file_.Number(*texture, "index");
    const auto image = index ? file_.Number(file_.At("textures", *index), "source") : std::nullopt;
    if (image) paint.texture = TextureOf(*image);
    return paint;
  }

  const picture::Pixels* TextureOf(std::uint64_t image) {
    const auto known = textures_.find(image);
    if (known != textures_.end()) return &known->second;
    const std::string bytes = file_.ImageBytes(image);
    picture::PngRead read;
    if (picture::IsJpeg(bytes)) {
      picture::JpegRead jpeg = picture::ReadJpeg(bytes);
      read = {std::move(jpeg.pixels), std::move(jpeg.problem)};
    } else {
      read = picture::ReadPng(bytes);
    }
    if (!read.problem.empty())
      file_.Fail("images[" + std::to_string(image) + "]: " + read.problem + " (textures are PNG or JPEG files)");
    pixels_ += read.pixels.rgba.size() / 4;
    if (file_.ok() && pixels_ > kMostPixels)
      file_.Fail("its textures have more than 16 million pixels: make them smaller");
    if (!file_.ok()) return nullptr;
    return &textures_.emplace(image, std::move(read.pixels)).first->second;
  }

  GltfFile file_;
  Model model_;
  std::map<std::uint64_t, picture::Pixels> textures_;
  std::size_t pixels_ = 0;
  int nodes_ = 0;
};

}  // namespace

Result<Model> ReadGltf(std::string_view file, const ReadNeighbour& neighbour) {
  return ModelReader(file, neighbour).Read();
}

}  // namespace soarbox::model
