// SPDX-License-Identifier: BSD-2-Clause
// Passes arbitrary bytes to the readers of a world's files: models (glTF), images (PNG, JPEG) and sounds (WAV). Results
// must be within their limits.
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "model/gltf.h"
#include "picture/jpeg_reader.h"
#include "picture/png_reader.h"
#include "world/animation/pose.h"
#include "world/wav_file.h"

namespace {

/// Computes the pose of each animation at its end.
void CheckMovement(const soarbox::model::Model& model) {
  if (!model.moves()) return;
  if (model.skins.size() != model.corners.size()) std::abort();
  for (const soarbox::model::CornerSkin& skin : model.skins)
    for (const std::uint8_t joint : skin.joints)
      if (joint >= model.joints.size()) std::abort();
  for (std::uint32_t clip = 0; clip < model.rig.clips.size(); ++clip) {
    soarbox::world::Pose pose;
    pose.rig = &model.rig;
    pose.parts = {{clip, model.rig.clips[clip].length_s(), 1}};
    pose.played = 1;
    std::vector<soarbox::world::BonePose> bones;
    pose.WorkOut(bones);
    if (FramesOfJoints(model, bones).size() != model.joints.size()) std::abort();
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view file(reinterpret_cast<const char*>(data), size);
  using soarbox::Result;
  const Result<soarbox::model::Model> model =
      soarbox::model::ReadGltf(file, [&](std::string_view) -> Result<std::string> { return std::string(file); });
  if (model) {
    if (model->corners.size() > soarbox::model::kMostCorners) std::abort();
    for (const std::uint32_t index : model->indices)
      if (index >= model->corners.size()) std::abort();
    CheckMovement(*model);
  }
  const soarbox::picture::PngRead image = soarbox::picture::ReadPng(file);
  const auto pixels = static_cast<std::size_t>(image.pixels.width) * static_cast<std::size_t>(image.pixels.height);
  if (image.problem.empty() && image.pixels.rgba.size() != 4 * pixels) std::abort();
  const soarbox::picture::JpegRead photo = soarbox::picture::ReadJpeg(file);
  const auto dots = static_cast<std::size_t>(photo.pixels.width) * static_cast<std::size_t>(photo.pixels.height);
  if (photo.problem.empty() && photo.pixels.rgba.size() != 4 * dots) std::abort();
  return soarbox::world::WhyNoWav(file).size() > 200 ? std::abort(), 0 : 0;
}
