// SPDX-License-Identifier: BSD-2-Clause
#include "world/sound_board.h"

#include <algorithm>

namespace soarbox::world {

void SoundBoard::Play(std::string_view file, double now_s, float volume, std::optional<Vec3> position) {
  std::erase_if(sounds_, [now_s](const SoundSnapshot& sound) { return sound.time_s + kSoundStays_s < now_s; });
  if (sounds_.size() >= kMostSounds) sounds_.erase(sounds_.begin());
  SoundSnapshot& sound = sounds_.emplace_back();
  sound.id = next_++;
  sound.file = file;
  sound.time_s = now_s;
  sound.volume = std::clamp(volume, 0.0f, 1.0f);
  sound.in_world = position.has_value();
  sound.position = position.value_or(Vec3{});
}

void SoundBoard::FillSnapshot(SceneSnapshot& snapshot) const {
  snapshot.sounds.clear();
  for (const SoundSnapshot& sound : sounds_)
    if (sound.time_s + kSoundStays_s >= snapshot.time_s) snapshot.sounds.push_back(sound);
}

}  // namespace soarbox::world
