// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/particle_lines.h"

#include <algorithm>

#include "viewer/noise.h"

namespace soarbox::viewer {
namespace {

using world::Vec3;

constexpr float kBurst_s = 0.7f;  // How long sparks glow.

void AddStreak(const world::ParticleSnapshot& bullet, std::vector<world::LineSnapshot>& lines) {
  const Vec3 half = Rotate(bullet.orientation, {0, 0, 0.15f});
  lines.push_back({bullet.position - half, bullet.position + half, {1.0f, 0.86f, 0.45f, 1}});
}

void AddSparks(const world::ParticleSnapshot& burst, float age_s, std::vector<world::LineSnapshot>& lines) {
  constexpr int kSparks = 26;
  constexpr float kFall = -2.5f, kTail_s = 0.05f;
  const Vec3 out = burst.has_direction ? world::Normalized(burst.direction) : Rotate(burst.orientation, {0, 0, -1});
  const float fade = 1 - age_s / kBurst_s;
  for (int i = 0; i < kSparks; ++i) {
    const auto random = [&](int n) { return LatticeValue(static_cast<int>(burst.id), i, n, 4711) * 2 - 1; };
    const Vec3 velocity = (out + Vec3{random(0), random(1), random(2)} * 0.8f) * (1.6f + 1.1f * random(3));
    const auto place = [&](float t) { return burst.position + velocity * t + Vec3{0, kFall * t * t / 2, 0}; };
    lines.push_back(
        {place(std::max(0.0f, age_s - kTail_s)), place(age_s + 0.01f), {1.0f, 0.75f + 0.2f * random(4), 0.35f, fade}});
  }
}

}  // namespace

void ParticleLines::AddLines(const world::SceneSnapshot& scene, std::vector<world::LineSnapshot>& lines) {
  ++calls_;
  for (const world::ParticleSnapshot& particle : scene.particles) {
    const auto [entry, is_new] = starts_.try_emplace(particle.id);
    Start& start = entry->second;
    if (is_new || start.restarts != particle.restarts || start.time_s > scene.time_s) {
      start.restarts = particle.restarts;
      start.time_s = scene.time_s;
    }
    start.seen = calls_;
    if (!particle.visible) continue;
    const auto age_s = static_cast<float>(scene.time_s - start.time_s);
    if (particle.effect == "Bullet")
      AddStreak(particle, lines);
    else if (particle.effect == "BulletImpact" && age_s < kBurst_s)
      AddSparks(particle, age_s, lines);
  }
  std::erase_if(starts_, [this](const auto& entry) { return entry.second.seen != calls_; });
}

}  // namespace soarbox::viewer
