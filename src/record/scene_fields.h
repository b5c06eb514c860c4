// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <tuple>

#include "world/scene_snapshot.h"

namespace soarbox::record {

/// The members of the parts of a scene, in the order in which a recording stores them, without the id of the part. To
/// record a new member of a snapshot, add it at the end of its list and increment the version of the format.
constexpr auto FieldsOf(const world::HungSnapshot&) {
  using T = world::HungSnapshot;
  return std::tuple(&T::on, &T::bone, &T::position, &T::orientation);
}
constexpr auto FieldsOf(const world::DrawableSnapshot&) {
  using T = world::DrawableSnapshot;
  return std::tuple(&T::owner_id, &T::belongs_to_agent, &T::shape, &T::mesh, &T::material, &T::size,
                    &T::texture_repeats, &T::position, &T::orientation, &T::scale, &T::visible, &T::bones,
                    &T::shows_skeleton, &T::hung);
}
constexpr auto FieldsOf(const world::LightSnapshot&) {
  using T = world::LightSnapshot;
  return std::tuple(&T::kind, &T::position, &T::direction, &T::diffuse, &T::specular, &T::range_m, &T::attenuation,
                    &T::casts_shadows);
}
constexpr auto FieldsOf(const world::ParticleSnapshot&) {
  using T = world::ParticleSnapshot;
  return std::tuple(&T::effect, &T::position, &T::orientation, &T::has_direction, &T::direction, &T::restarts,
                    &T::visible);
}
constexpr auto FieldsOf(const world::AgentSnapshot&) {
  using T = world::AgentSnapshot;
  return std::tuple(&T::name, &T::kind, &T::script, &T::position, &T::velocity, &T::forward, &T::radius_m, &T::height_m,
                    &T::health, &T::alive, &T::last_command, &T::failed, &T::team, &T::has_score, &T::score, &T::shown);
}
constexpr auto FieldsOf(const world::UiSnapshot&) {
  using T = world::UiSnapshot;
  return std::tuple(&T::parent_id, &T::layer, &T::x, &T::y, &T::width, &T::height, &T::margin_left, &T::margin_top,
                    &T::visible, &T::has_gradient, &T::gradient_is_vertical, &T::gradient_from, &T::gradient_to,
                    &T::font, &T::text_color, &T::is_markup, &T::text, &T::material, &T::caption,
                    &T::gradient_is_diagonal, &T::in_world, &T::world_position, &T::world_orientation, &T::button,
                    &T::has_bar, &T::bar, &T::bar_color);
}
constexpr auto FieldsOf(const world::SoundSnapshot&) {
  using T = world::SoundSnapshot;
  return std::tuple(&T::file, &T::time_s, &T::volume, &T::in_world, &T::position);
}
/// The members of the scene itself.
constexpr auto FieldsOf(const world::SceneSnapshot&) {
  using T = world::SceneSnapshot;
  return std::tuple(&T::time_s, &T::markup_palette, &T::ambient, &T::sky, &T::sky_rotation_deg, &T::camera_moves,
                    &T::camera, &T::camera_is_fixed);
}
constexpr auto FieldsOf(const world::CameraSnapshot&) {
  using T = world::CameraSnapshot;
  return std::tuple(&T::position, &T::orientation, &T::vertical_fov_deg);
}
constexpr auto FieldsOf(const world::LineSnapshot&) {
  using T = world::LineSnapshot;
  return std::tuple(&T::from, &T::to, &T::color);
}
constexpr auto FieldsOf(const world::CircleSnapshot&) {
  using T = world::CircleSnapshot;
  return std::tuple(&T::center, &T::radius_m, &T::color);
}
constexpr auto FieldsOf(const world::TriangleSnapshot&) {
  using T = world::TriangleSnapshot;
  return std::tuple(&T::a, &T::b, &T::c, &T::color);
}

}  // namespace soarbox::record
