// SPDX-License-Identifier: BSD-2-Clause
#include "model/model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>

#include "model/gltf.h"
#include "picture/png.h"
#include "world/animation/pose.h"

namespace soarbox::model {
namespace {

const ReadNeighbour kAlone = [](std::string_view name) -> Result<std::string> {
  Diagnostic error;
  error.message = "no such file: " + std::string(name);
  return error;
};

std::string Floats(std::initializer_list<float> numbers) {
  std::string bytes(numbers.size() * sizeof(float), '\0');
  std::memcpy(bytes.data(), numbers.begin(), bytes.size());
  return bytes;
}

std::string Word(std::uint32_t number) {
  std::string bytes;
  for (int i = 0; i < 4; ++i) bytes += static_cast<char>(number >> (8 * i) & 0xff);
  return bytes;
}

std::string Glb(std::string json, std::string binary) {
  while (json.size() % 4 != 0) json += ' ';
  while (binary.size() % 4 != 0) binary += '\0';
  const auto size = [](const std::string& part) { return Word(static_cast<std::uint32_t>(part.size())); };
  const std::string chunks = size(json) + "JSON" + json + size(binary) + std::string("BIN\0", 4) + binary;
  return "glTF" + Word(2) + Word(static_cast<std::uint32_t>(12 + chunks.size())) + chunks;
}

/// A triangle of three corners without normals.
const std::string kTriangle = Floats({0, 0, 0, 1, 0, 0, 0, 1, 0});
std::string TriangleJson(const std::string& more = {}, const std::string& node = R"("mesh": 0)") {
  return R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{)" + node +
         R"(}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "material": 0}]}],
             "buffers": [{"byteLength": 36}], "bufferViews": [{"buffer": 0, "byteLength": 36}],
             "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
             "materials": [{"pbrMetallicRoughness": {"baseColorFactor": [1, 0, 0.2, 1]}}])" +
         more + "}";
}

std::string ProblemOf(std::string_view file) {
  const Result<Model> read = ReadGltf(file, kAlone);
  return read ? "" : read.error().message;
}

TEST(Gltf, ATriangleHasItsColourAndANormalOfItsOwn) {
  const Result<Model> read = ReadGltf(Glb(TriangleJson(), kTriangle), kAlone);
  ASSERT_TRUE(read) << read.error().message;
  ASSERT_EQ(read->corners.size(), 3u);
  EXPECT_EQ(read->indices, (std::vector<std::uint32_t>{0, 1, 2}));
  EXPECT_EQ(read->corners[0].normal, (world::Vec3{0, 0, 1}));
  EXPECT_FLOAT_EQ(read->corners[0].red, 1);
  EXPECT_FLOAT_EQ(read->corners[0].green, 0);
  EXPECT_NEAR(read->corners[0].blue, 0.481, 0.001);
  EXPECT_EQ(read->max, (world::Vec3{1, 1, 0}));
}

TEST(Gltf, NodesTurnScaleAndMove) {
  const Result<Model> read =
      ReadGltf(Glb(TriangleJson("", R"("mesh": 0, "translation": [0, 5, 0], "scale": [2, 2, -2])"), kTriangle), kAlone);
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->min, (world::Vec3{0, 5, 0}));
  EXPECT_EQ(read->max, (world::Vec3{2, 7, 0}));
  // Mirrored: the corners go round the other way.
  EXPECT_EQ(read->corners[1].position, (world::Vec3{0, 7, 0}));
}

/// A triangle with an image as its texture, sampled near its left and right side.
std::string Textured(const std::string& image) {
  const std::string places = Floats({0.1f, 0, 0.9f, 0, 0.1f, 0});
  const std::string json =
      R"({"asset": {"version": "2.0"}, "nodes": [{"mesh": 0}],
          "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "material": 0}]}],
          "buffers": [{"byteLength": )" +
      std::to_string(60 + image.size()) +
      R"(}], "bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 24},
                             {"buffer": 0, "byteOffset": 60, "byteLength": )" +
      std::to_string(image.size()) +
      R"(}], "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
                           {"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC2"}],
          "images": [{"bufferView": 2}], "textures": [{"source": 0}],
          "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}]})";
  return Glb(json, kTriangle + places + image);
}

TEST(Gltf, ATextureIsSampledAtTheCorners) {
  picture::Image image(2, 1, {0, 0, 0, 1});
  image.At(1, 0)[1] = 255;
  const Result<Model> read = ReadGltf(Textured(picture::PngOf(image)), kAlone);
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_FLOAT_EQ(read->corners[0].green, 0);
  EXPECT_NEAR(read->corners[1].green, 1, 0.001);
}

TEST(Gltf, ATextureMayBeAJpegFile) {
  std::ifstream in(std::string(SOARBOX_SOURCE_DIR) + "/tests/picture/progressive.jpg", std::ios::binary);
  const std::string jpeg{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  const Result<Model> read = ReadGltf(Textured(jpeg), kAlone);
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_LT(read->corners[0].red, 0.1f);
  EXPECT_GT(read->corners[1].red, 0.6f);
  EXPECT_EQ(ProblemOf(Textured(jpeg.substr(0, 300))),
            "images[0]: the file ends within a segment (textures are PNG or JPEG files)");
  EXPECT_EQ(ProblemOf(Textured("no image")), "images[0]: this is not a PNG file (textures are PNG or JPEG files)");
}

TEST(Gltf, ABufferMayBeAFileBesideTheModel) {
  std::string json = TriangleJson();
  json.replace(json.find(R"({"byteLength": 36})"), 18, R"({"byteLength": 36, "uri": "the%20triangle.bin"})");
  std::string asked;
  const Result<Model> read = ReadGltf(json, [&](std::string_view name) -> Result<std::string> {
    asked = name;
    return kTriangle;
  });
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(asked, "the triangle.bin");
  EXPECT_EQ(ProblemOf(json), "buffers[0]: no such file: the triangle.bin");
}

TEST(Gltf, WhatIsWrongIsNamed) {
  EXPECT_EQ(ProblemOf(""), "it is not a glTF file: neither .glb nor JSON");
  EXPECT_EQ(ProblemOf("glTF"), "the file is cut off");
  EXPECT_EQ(ProblemOf("{}"), "it is not a model of glTF version 2");
  EXPECT_EQ(ProblemOf(R"({"asset": {"version": "2.0"}})"), "it has no triangles");
  const std::string whole = Glb(TriangleJson(), kTriangle);
  EXPECT_EQ(ProblemOf(whole.substr(0, whole.size() - 1)), "the file is cut off");
  EXPECT_EQ(ProblemOf(Glb(TriangleJson(), kTriangle.substr(4))), "buffers[0] is shorter than its \"byteLength\"");
  EXPECT_EQ(
      ProblemOf(Glb(TriangleJson(R"(, "extensionsRequired": ["KHR_draco_mesh_compression"])"), kTriangle)),
      "it requires the extension KHR_draco_mesh_compression, which is not supported: export it without this extension");
  EXPECT_EQ(ProblemOf(Glb(TriangleJson("", R"("children": [0])"), kTriangle)),
            "its nodes are nested in a circle, too deep or too many");
  EXPECT_EQ(ProblemOf(Glb(TriangleJson("", R"("mesh": 7)"), kTriangle)),
            "there is no meshes[7], which something refers to");
  std::string many = TriangleJson();
  many.replace(many.find(R"("count": 3)"), 10, R"("count": 4)");
  EXPECT_EQ(ProblemOf(Glb(many, kTriangle)), "accessors[0] lies outside of its buffer view");
  std::string remote = TriangleJson();
  remote.replace(remote.find(R"({"byteLength": 36})"), 18, R"({"byteLength": 36, "uri": "https://example.org/a"})");
  EXPECT_EQ(ProblemOf(remote), "buffers[0] is not beside the model: https://example.org/a");
  std::string nan = kTriangle;
  nan[3] = nan[2] = '\xff';
  EXPECT_EQ(ProblemOf(Glb(TriangleJson(), nan)), "accessors[0] has something that is not a finite number");
}

TEST(Gltf, NoBytesOfAFileThatIsCutOffOrChangedAreReadBeyondItsEnd) {
  const std::string whole = Glb(TriangleJson(), kTriangle);
  for (std::size_t length = 0; length < whole.size(); ++length) EXPECT_NE(ProblemOf(whole.substr(0, length)), "");
  for (std::size_t at = 0; at < whole.size(); ++at) {
    for (const char other : {'\0', '9', '\xff'}) {
      std::string changed = whole;
      changed[at] = other;
      if (const Result<Model> read = ReadGltf(changed, kAlone))
        for (const std::uint32_t index : read->indices) ASSERT_LT(index, read->corners.size());
    }
  }
}

/// Bytes of an accessor's data, collected one after the other.
class Parts {
 public:
  /// Adds values and returns the accessor as JSON.
  std::string Add(const std::string& bytes, std::size_t count, const std::string& type, int component = 5126,
                  const std::string& more = {}) {
    views_ += std::string(views_.empty() ? "" : ",") + R"({"buffer": 0, "byteOffset": )" + std::to_string(all_.size()) +
              R"(, "byteLength": )" + std::to_string(bytes.size()) + "}";
    accessors_ += std::string(accessors_.empty() ? "" : ",") + R"({"bufferView": )" + std::to_string(count_) +
                  R"(, "componentType": )" + std::to_string(component) + R"(, "count": )" + std::to_string(count) +
                  R"(, "type": ")" + type + R"(")" + more + "}";
    all_ += bytes;
    while (all_.size() % 4 != 0) all_ += '\0';
    return std::to_string(count_++);
  }
  std::string Json() const {
    return R"("buffers": [{"byteLength": )" + std::to_string(all_.size()) + R"(}], "bufferViews": [)" + views_ +
           R"(], "accessors": [)" + accessors_ + "]";
  }
  const std::string& bytes() const { return all_; }

 private:
  std::string all_, views_, accessors_;
  int count_ = 0;
};

/// What a test changes in ArmFile.
struct Arm {
  std::string armature;  ///< More of the node above the joints.
  float bind_scale = 1;  ///< The skin is modelled in this many units per metre.
  std::string times_kind = "LINEAR";
  int weight_of_fourth = 0;
  bool splines = false;
  std::string joints = "[1, 2]";
  std::initializer_list<float> times = {0, 1};
  std::string node_of_animation = "2";
};

/// A triangle on an arm of two joints, one metre apart along x. Its corners belong to the shoulder, to both joints, and
/// to the elbow. The animation "bend" turns the elbow by 90 degrees about z within a second, and "grow" makes the
/// shoulder twice as large in one step at 1 s.
std::string ArmFile(const Arm& arm = {}) {
  Parts parts;
  const float u = arm.bind_scale;
  const std::string positions = parts.Add(Floats({0, 0, 0, u, 0, 0, 2 * u, 0, 0}), 3, "VEC3");
  const std::string normals = parts.Add(Floats({0, 0, 1, 0, 0, 1, 0, 0, 1}), 3, "VEC3");
  const std::string joints = parts.Add(std::string("\0\0\0\0\0\1\0\0\1\0\0\0", 12), 3, "VEC4", 5121);
  const auto last = static_cast<char>(arm.weight_of_fourth);
  const std::string weights = parts.Add(std::string("\xff\0\0", 3) + last + std::string("\x80\x80\0\0\xff\0\0\0", 8), 3,
                                        "VEC4", 5121, R"(, "normalized": true)");
  const float s = 1 / u;
  const std::string inverse = parts.Add(
      Floats({s, 0, 0, 0, 0, s, 0, 0, 0, 0, s, 0, 0, 0, 0, 1, s, 0, 0, 0, 0, s, 0, 0, 0, 0, s, 0, -1, 0, 0, 1}), 2,
      "MAT4");
  const std::string times = parts.Add(Floats(arm.times), arm.times.size(), "SCALAR");
  constexpr float kHalf = 0.70710678f;
  const std::string turns =
      arm.splines ? parts.Add(Floats({9, 9, 9, 9, 0, 0, 0, 1, 9, 9, 9, 9, 9, 9, 9, 9, 0, 0, kHalf, kHalf, 9, 9, 9, 9}),
                              6, "VEC4")
                  : parts.Add(Floats({0, 0, 0, 1, 0, 0, kHalf, kHalf}), 2, "VEC4");
  const std::string sizes = parts.Add(Floats({1, 1, 1, 2, 2, 2}), 2, "VEC3");
  const std::string json =
      R"({"asset": {"version": "2.0"}, "scenes": [{"nodes": [0, 3]}], "nodes": [{"name": "armature", "children": [1])" +
      arm.armature + R"(}, {"name": "shoulder", "children": [2]}, {"name": "elbow", "translation": [1, 0, 0]},
          {"mesh": 0, "skin": 0}],
          "meshes": [{"primitives": [{"attributes": {"POSITION": )" +
      positions + R"(, "NORMAL": )" + normals + R"(, "JOINTS_0": )" + joints + R"(, "WEIGHTS_0": )" + weights +
      R"(}}]}], "skins": [{"joints": )" + arm.joints + R"(, "inverseBindMatrices": )" + inverse + R"(}],
          "animations": [{"name": "bend", "channels": [{"sampler": 0, "target": {"node": )" +
      arm.node_of_animation + R"(, "path": "rotation"}}],
          "samplers": [{"input": )" +
      times + R"(, "output": )" + turns + R"(, "interpolation": ")" + arm.times_kind + R"("}]},
          {"name": "grow", "channels": [{"sampler": 0, "target": {"node": 1, "path": "scale"}},
                                        {"sampler": 9, "target": {"node": 1, "path": "weights"}}],
          "samplers": [{"input": )" +
      times + R"(, "output": )" + sizes + R"(, "interpolation": "STEP"}]}], )" + parts.Json() + "}";
  return Glb(json, parts.bytes());
}

/// Positions of the corners in an animation of the model; rounded to mm.
std::vector<world::Vec3> CornersAt(const Model& model, const char* animation, float time_s) {
  // As in a world, where the rig has the name of its model.
  world::Rig rig = model.rig;
  rig.model = "model.gltf";
  world::Pose pose;
  pose.rig = &rig;
  pose.parts = {{static_cast<std::uint32_t>(model.rig.FindClip(animation)), time_s, 1}};
  pose.played = 1;
  std::vector<world::BonePose> bones;
  pose.WorkOut(bones);
  const std::vector<Frame> joints = FramesOfJoints(model, bones);
  std::vector<world::Vec3> corners;
  const auto rounded = [](float value) { return std::round(value * 1000) / 1000 + 0.0f; };
  for (const CornerSkin& skin : model.skins) {
    world::Vec3 at;
    for (std::size_t k = 0; k < 4; ++k) at += skin.weights[k] * joints[skin.joints[k]].Placed(skin.position);
    corners.push_back({rounded(at.x), rounded(at.y), rounded(at.z)});
  }
  return corners;
}

using Corners = std::vector<world::Vec3>;

TEST(GltfSkin, ALongNameIsCutBetweenLetters) {
  const std::string letters(99, 'a');
  const Result<Model> read = ReadGltf(ArmFile({.armature = R"(, "name": ")" + letters + "ä\""}), kAlone);
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->rig.BoneNames().front(), letters);
}

TEST(GltfSkin, JointsMoveTheirCornersByWeight) {
  const Result<Model> read = ReadGltf(ArmFile(), kAlone);
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->rig.BoneNames(), (std::vector<std::string_view>{"armature", "shoulder", "elbow"}));
  EXPECT_EQ(read->rig.ClipNames(), (std::vector<std::string_view>{"bend", "grow"}));
  EXPECT_FLOAT_EQ(read->rig.clips[0].length_s(), 1);
  EXPECT_EQ(read->max, (world::Vec3{2, 0, 0}));
  EXPECT_EQ(CornersAt(*read, "bend", 0), (Corners{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}));
  EXPECT_EQ(CornersAt(*read, "bend", 1), (Corners{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}));
  EXPECT_EQ(CornersAt(*read, "bend", 0.5f), (Corners{{0, 0, 0}, {1, 0, 0}, {1.707f, 0.707f, 0}}));
  // In steps: the earlier value holds until the next one.
  EXPECT_EQ(CornersAt(*read, "grow", 0.9f), (Corners{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}));
  EXPECT_EQ(CornersAt(*read, "grow", 1), (Corners{{0, 0, 0}, {2, 0, 0}, {4, 0, 0}}));
}

TEST(GltfSkin, SplinesAreReadAsLinesBetweenTheirValues) {
  const Result<Model> read = ReadGltf(ArmFile({.times_kind = "CUBICSPLINE", .splines = true}), kAlone);
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(CornersAt(*read, "bend", 0.5f), (Corners{{0, 0, 0}, {1, 0, 0}, {1.707f, 0.707f, 0}}));
}

TEST(GltfSkin, UnitsOfTheSkinAndTheNodesAboveItDoNotMatter) {
  // A skin in centimetres, below a node that makes it smaller and moves it up.
  const Result<Model> read = ReadGltf(
      ArmFile({.armature = R"(, "scale": [0.5, 0.5, 0.5], "translation": [0, 3, 0])", .bind_scale = 100}), kAlone);
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_NEAR(read->max.x, 1, 1e-5);
  EXPECT_NEAR(read->max.y, 3, 1e-5);
  EXPECT_EQ(CornersAt(*read, "bend", 1), (Corners{{0, 3, 0}, {0.5f, 3, 0}, {0.5f, 3.5f, 0}}));
  // Corners are stored in the size of the model.
  EXPECT_NEAR(read->skins[2].position.x, 1, 1e-5);
}

TEST(GltfSkin, WeightsAreDividedByTheirSum) {
  const Result<Model> read = ReadGltf(ArmFile({.weight_of_fourth = 255}), kAlone);
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_FLOAT_EQ(read->skins[0].weights[0], 0.5f);
  EXPECT_FLOAT_EQ(read->skins[0].weights[3], 0.5f);
}

TEST(GltfSkin, ANodeWithoutASkinMovesItsMesh) {
  Parts parts;
  const std::string times = parts.Add(Floats({0.5f, 2.5f}), 2, "SCALAR"),
                    places = parts.Add(Floats({0, 0, 0, 0, 4, 0}), 2, "VEC3"),
                    positions = parts.Add(kTriangle, 3, "VEC3");
  const std::string json =
      R"({"asset": {"version": "2.0"}, "nodes": [{"children": [1]}, {"mesh": 0, "scale": [1, 1, -1]}, {"mesh": 0}],
      "meshes": [{"primitives": [{"attributes": {"POSITION": )" +
      positions + R"(}}]}],
      "animations": [{"channels": [{"sampler": 0, "target": {"node": 0, "path": "translation"}}],
                      "samplers": [{"input": )" +
      times + R"(, "output": )" + places + R"(}]},
                     {"channels": [{"sampler": 0, "target": {"node": 0, "path": "weights"}}]}], )" +
      parts.Json() + "}";
  const Result<Model> read = ReadGltf(Glb(json, parts.bytes()), kAlone);
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->rig.BoneNames(), (std::vector<std::string_view>{"node 0"}));
  EXPECT_EQ(read->rig.ClipNames(), (std::vector<std::string_view>{"animation 0"}));
  EXPECT_FLOAT_EQ(read->rig.clips[0].length_s(), 2.5f);
  // The first mesh is mirrored, so its corners go round the other way. The second one is still.
  EXPECT_EQ(CornersAt(*read, "animation 0", 1.5f),
            (Corners{{0, 2, 0}, {0, 3, 0}, {1, 2, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_EQ(read->corners[0].normal, (world::Vec3{0, 0, -1}));
  EXPECT_EQ(read->skins[0].normal, (world::Vec3{0, 0, -1}));
}

TEST(GltfSkin, WhatIsWrongIsNamed) {
  EXPECT_EQ(ProblemOf(ArmFile({.joints = "[1]"})), "a mesh refers to a joint that its skin does not have");
  EXPECT_EQ(ProblemOf(ArmFile({.joints = "[]"})), "skins[0] has no joints");
  EXPECT_EQ(ProblemOf(ArmFile({.joints = "[1, 7]"})), "skins[0] has a joint that is not a node of the scene");
  EXPECT_EQ(ProblemOf(ArmFile({.joints = "[1, 2, 0]"})), "skins[0] has fewer inverse bind matrices than joints");
  EXPECT_EQ(ProblemOf(ArmFile({.times_kind = "WIGGLY"})),
            "animations[0].channels[0] has the interpolation WIGGLY, which is not supported");
  EXPECT_EQ(ProblemOf(ArmFile({.times_kind = "CUBICSPLINE"})),
            "animations[0].channels[0] has 2 values of 4 numbers for 2 times");
  EXPECT_EQ(ProblemOf(ArmFile({.times = {1, 1}})),
            "animations[0].channels[0] has times that do not ascend within 0 to 3600 s");
  // Animations of nodes that are not shown are left out.
  const Result<Model> read = ReadGltf(ArmFile({.node_of_animation = "99"}), kAlone);
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->rig.ClipNames(), (std::vector<std::string_view>{"grow"}));
}

TEST(GltfSkin, NoBytesOfAFileThatIsCutOffOrChangedAreReadBeyondItsEnd) {
  const std::string whole = ArmFile();
  for (std::size_t at = 0; at < whole.size(); ++at) {
    for (const char other : {'\0', '9', '\xff'}) {
      std::string changed = whole;
      changed[at] = other;
      const Result<Model> read = ReadGltf(changed, kAlone);
      if (!read) continue;
      ASSERT_TRUE(read->skins.empty() || read->skins.size() == read->corners.size());
      for (const CornerSkin& skin : read->skins)
        for (const std::uint8_t joint : skin.joints) ASSERT_LT(joint, read->joints.size());
      for (const Joint& joint : read->joints)
        ASSERT_TRUE(joint.bone == Joint::kStill || joint.bone < read->rig.skeleton.bones().size());
    }
  }
}

TEST(Models, ThatMoveHaveTheirRigsStored) {
  Result<Model> read = ReadGltf(ArmFile(), kAlone);
  ASSERT_TRUE(read);
  const std::string key = KeepModel("arm.glb", *read);
  const world::Rig* const rig = world::RigOfMesh(key);
  ASSERT_NE(rig, nullptr);
  EXPECT_EQ(rig->model, key);
  EXPECT_EQ(rig->ClipNames().size(), 2u);
  // The same file under another name has a rig of its own.
  EXPECT_NE(world::RigOfMesh(KeepModel("copy.glb", *read)), rig);
  // Another animation makes another model, though the triangles are the same.
  read = ReadGltf(ArmFile({.times = {0, 2}}), kAlone);
  ASSERT_TRUE(read);
  EXPECT_NE(KeepModel("arm.glb", *read), key);
}

TEST(Models, AreFoundByTheirTriangles) {
  const Result<Model> read = ReadGltf(Glb(TriangleJson(), kTriangle), kAlone);
  ASSERT_TRUE(read);
  const std::string key = KeepModel("a/triangle.glb", *read);
  EXPECT_TRUE(key.starts_with("a/triangle.glb#")) << key;
  EXPECT_EQ(KeepModel("a/triangle.glb", *read), key);
  ASSERT_NE(FindModel(key), nullptr);
  EXPECT_EQ(FindModel(key)->corners.size(), 3u);
  EXPECT_EQ(FindModel("a/triangle.glb"), nullptr);
  EXPECT_EQ(FindModel("a/triangle.glb#0000000000000000"), nullptr);
}

}  // namespace
}  // namespace soarbox::model
