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
#include "model/gltf_rig.h"
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

struct MadeCorner {
  Corner shown;
  CornerSkin skin;
};

/// Places the corners of one mesh, and attaches them to joints.
struct CornerMover {
  Frame in_model;      ///< Of a model that does not move: from the space of the mesh to the model.
  bool moves = false;  ///< The model moves, and what follows is used.
  GltfRig::Binding binding;
  GltfFile::Values joints, weights;  ///< Four for each corner; empty if one joint moves the mesh.

  bool IsMirrored() const {
    return moves ? (AtRest(JointsOf(0)) * binding.to_skin).Determinant() < 0 : in_model.Determinant() < 0;
  }

  MadeCorner Move(std::size_t i, Vec3 position, Vec3 normal) const {
    MadeCorner made;
    if (!moves) {
      made.shown.position = in_model.Placed(position);
      made.shown.normal = in_model.TurnedNormal(normal);
      return made;
    }
    made.skin = JointsOf(i);
    const Frame rest = AtRest(made.skin);
    made.skin.position = binding.to_skin.Placed(position);
    made.skin.normal = binding.to_skin.TurnedNormal(normal);
    made.shown.position = rest.Placed(made.skin.position);
    made.shown.normal = rest.TurnedNormal(made.skin.normal);
    // Renderers multiply normals by cofactors, which mirrors them with the corners.
    if (rest.Determinant() < 0) made.skin.normal = -made.skin.normal;
    for (std::uint8_t& joint : made.skin.joints) joint = binding.joints[joint];
    return made;
  }

 private:
  /// The joints of a corner by their index in the skin.
  CornerSkin JointsOf(std::size_t i) const {
    CornerSkin skin;
    skin.weights[0] = 1;
    if (i >= joints.count) return skin;
    std::array<float, 4> shares{};
    float sum = 0;
    for (std::size_t k = 0; k < shares.size(); ++k) sum += shares[k] = std::max(weights.numbers[4 * i + k], 0.0f);
    if (!(sum > 1e-6f) || !std::isfinite(sum)) return skin;
    for (std::size_t k = 0; k < shares.size(); ++k) {
      skin.joints[k] = static_cast<std::uint8_t>(joints.numbers[4 * i + k]);
      skin.weights[k] = shares[k] / sum;
    }
    return skin;
  }

  Frame AtRest(const CornerSkin& skin) const {
    Frame sum{{}, {}, {}, {}};
    for (std::size_t k = 0; k < skin.joints.size(); ++k) {
      const Frame& rest = binding.rest[skin.joints[k]];
      sum.x += rest.x * skin.weights[k];
      sum.y += rest.y * skin.weights[k];
      sum.z += rest.z * skin.weights[k];
      sum.place += rest.place * skin.weights[k];
    }
    return sum;
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
    const std::vector<std::uint64_t> roots = Roots();
    for (const std::uint64_t root : roots)
      if (file_.ok()) CheckNode(root, 0);
    if (file_.ok()) rig_.Read(roots);
    for (const std::uint64_t root : roots)
      if (file_.ok()) AddNode(root, {});
  }

  /// The nodes of the default scene that have no parent.
  std::vector<std::uint64_t> Roots() {
    const Json& root = file_.root();
    if (root.contains("scenes")) return NodesOf(file_.At("scenes", file_.Number(root, "scene").value_or(0)), "nodes");
    const std::size_t count = root.contains("nodes") && root["nodes"].is_array() ? root["nodes"].size() : 0;
    const std::set<std::uint64_t> children = count > 0 ? Children(root["nodes"]) : std::set<std::uint64_t>();
    std::vector<std::uint64_t> roots;
    for (std::size_t i = 0; i < count; ++i)
      if (!children.contains(i)) roots.push_back(i);
    return roots;
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

  std::vector<std::uint64_t> NodesOf(const Json& owner, const char* member) {
    std::vector<std::uint64_t> nodes;
    const auto found = owner.find(member);
    if (found == owner.end() || !found->is_array()) return nodes;
    for (const Json& child : *found) {
      if (!child.is_number_unsigned()) {
        file_.Fail(std::string("\"") + member + "\" has something that is not a number");
        return {};
      }
      nodes.push_back(child.get<std::uint64_t>());
    }
    return nodes;
  }

  void CheckNode(std::uint64_t index, int depth) {
    if (depth > kDeepestNode || ++nodes_ > kMostNodes)
      return file_.Fail("its nodes are nested in a circle, too deep or too many");
    for (const std::uint64_t child : NodesOf(file_.At("nodes", index), "children")) {
      if (!file_.ok()) return;
      CheckNode(child, depth + 1);
    }
  }

  /// Where a node is.
  struct Spot {
    Frame in_model;
    std::optional<std::uint16_t> bone;  ///< The bone that carries it, if any.
    Frame in_bone;                      ///< Relative to the bone, or else to the model.
  };

  void AddNode(std::uint64_t index, const Spot& above) {
    const Json& node = file_.At("nodes", index);
    const Frame frame = FrameOfNode(file_, node);
    Spot spot{above.in_model * frame, above.bone, above.in_bone * frame};
    if (const auto bone = rig_.BoneOf(index)) spot = {spot.in_model, bone, {}};
    if (const auto mesh = file_.Number(node, "mesh")) AddMesh(*mesh, spot, file_.Number(node, "skin"));
    for (const std::uint64_t child : NodesOf(node, "children"))
      if (file_.ok()) AddNode(child, spot);
  }

  void AddMesh(std::uint64_t index, const Spot& spot, std::optional<std::uint64_t> skin) {
    const Json& mesh = file_.At("meshes", index);
    const auto primitives = mesh.find("primitives");
    if (primitives == mesh.end() || !primitives->is_array()) return;
    for (const Json& primitive : *primitives) {
      if (primitive.is_object()) AddPrimitive(primitive, spot, skin);
      if (!file_.ok()) return;
    }
  }

  void AddPrimitive(const Json& primitive, const Spot& spot, std::optional<std::uint64_t> skin) {
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

    const auto vector = [](const GltfFile::Values& from, std::size_t i) {
      return Vec3{from.numbers[3 * i], from.numbers[3 * i + 1], from.numbers[3 * i + 2]};
    };
    const CornerMover mover = MoverOf(attributes, spot, skin, positions.count);
    if (!file_.ok()) return;
    const auto corner = [&](std::size_t i) {
      MadeCorner made = mover.Move(i, vector(positions, i), has_normals ? vector(normals, i) : Vec3{});
      Light light = paint.factor;
      if (places.width == 2 && i < places.count) light = paint.At(places.numbers[2 * i], places.numbers[2 * i + 1]);
      if (colors.width >= 3 && i < colors.count) {
        light.red *= colors.numbers[colors.width * i];
        light.green *= colors.numbers[colors.width * i + 1];
        light.blue *= colors.numbers[colors.width * i + 2];
      }
      made.shown.red = ToShown(light.red);
      made.shown.green = ToShown(light.green);
      made.shown.blue = ToShown(light.blue);
      const auto is_near = [](Vec3 at) {
        // Also false if a coordinate is not a number.
        return std::abs(at.x) < kFarthest_m && std::abs(at.y) < kFarthest_m && std::abs(at.z) < kFarthest_m;
      };
      if (!is_near(made.shown.position) || !is_near(made.skin.position)) file_.Fail("it is larger than 100 km");
      return made;
    };
    AddTriangles(triangles, positions.count, has_normals, mover.IsMirrored(), corner);
  }

  /// Reads the joints of a mesh; for a model that does not move, nothing.
  CornerMover MoverOf(const Json& attributes, const Spot& spot, std::optional<std::uint64_t> skin,
                      std::size_t corners) {
    CornerMover mover;
    mover.in_model = spot.in_model;
    mover.moves = rig_.moves();
    if (!mover.moves) return mover;
    const auto joints = skin ? file_.Number(attributes, "JOINTS_0") : std::nullopt;
    if (!joints) {
      mover.binding = rig_.BindBone(spot.bone, spot.in_bone);
      return mover;
    }
    mover.binding = rig_.BindSkin(*skin);
    mover.joints = file_.FloatsOf(*joints);
    if (const auto weights = file_.Number(attributes, "WEIGHTS_0")) mover.weights = file_.FloatsOf(*weights);
    if (!file_.ok()) return mover;
    if (mover.joints.width != 4 || mover.weights.width != 4 || mover.joints.count < corners ||
        mover.weights.count < corners)
      file_.Fail("a mesh with a skin does not have four joints and weights for each corner");
    const auto most = static_cast<float>(mover.binding.joints.size());
    for (const float joint : mover.joints.numbers)
      if (!(joint >= 0 && joint < most)) file_.Fail("a mesh refers to a joint that its skin does not have");
    return mover;
  }

  void Push(const MadeCorner& made) {
    model_.corners.push_back(made.shown);
    if (rig_.moves()) model_.skins.push_back(made.skin);
  }

  template <typename MakeCorner>
  void AddTriangles(const std::vector<std::uint32_t>& triangles, std::size_t count, bool has_normals, bool is_mirrored,
                    const MakeCorner& corner) {
    const auto base = static_cast<std::uint32_t>(model_.corners.size());
    if (has_normals)
      for (std::size_t i = 0; i < count; ++i) Push(corner(i));
    for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) {
      std::array<std::uint32_t, 3> at{triangles[i], triangles[i + 1], triangles[i + 2]};
      if (is_mirrored) std::swap(at[1], at[2]);
      if (has_normals) {
        for (const std::uint32_t index : at) model_.indices.push_back(base + index);
        continue;
      }
      // Without normals each triangle is flat.
      std::array<MadeCorner, 3> corners{corner(at[0]), corner(at[1]), corner(at[2])};
      const auto flat = [&](auto place) {
        return Normalized(Cross(place(corners[1]) - place(corners[0]), place(corners[2]) - place(corners[0])));
      };
      const Vec3 normal = flat([](const MadeCorner&made) { return made.shown.position; }),
                 in_skin = flat([](const MadeCorner&made) { return made.skin.position; });
      for (MadeCorner& made : corners) {
        made.shown.normal = normal;
        made.skin.normal = in_skin;
        model_.indices.push_back(static_cast<std::uint32_t>(model_.corners.size()));
        Push(made);
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
  GltfRig rig_{file_, model_};
  std::map<std::uint64_t, picture::Pixels> textures_;
  std::size_t pixels_ = 0;
  int nodes_ = 0;
};

}  // namespace

Result<Model> ReadGltf(std::string_view file, const ReadNeighbour& neighbour) {
  return ModelReader(file, neighbour).Read();
}

}  // namespace soarbox::model
