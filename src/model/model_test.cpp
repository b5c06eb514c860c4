// SPDX-License-Identifier: BSD-2-Clause
#include "model/model.h"

#include <gtest/gtest.h>

#include <cstring>
#include <fstream>
#include <iterator>

#include "model/gltf.h"
#include "picture/png.h"

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
