// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/sound_player.h"

#include <SDL.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "world/asset_store.h"

namespace soarbox::viewer {
namespace {

constexpr int kRate = 44'100, kChannels = 2;
constexpr float kFullVolume_m = 5;
constexpr std::size_t kMostVoices = 32;

/// Converts a WAV file to samples of the device's rate, left and right alternating. Empty if it cannot be read.
std::vector<float> SamplesOf(const std::string& file) {
  std::vector<float> samples;
  SDL_AudioSpec spec;
  Uint8* bytes = nullptr;
  Uint32 length = 0;
  SDL_RWops* const source = SDL_RWFromConstMem(file.data(), static_cast<int>(file.size()));
  if (source == nullptr || SDL_LoadWAV_RW(source, 1, &spec, &bytes, &length) == nullptr) return samples;
  SDL_AudioStream* const stream =
      SDL_NewAudioStream(spec.format, spec.channels, spec.freq, AUDIO_F32SYS, kChannels, kRate);
  if (stream != nullptr && SDL_AudioStreamPut(stream, bytes, static_cast<int>(length)) == 0 &&
      SDL_AudioStreamFlush(stream) == 0) {
    samples.resize(static_cast<std::size_t>(SDL_AudioStreamAvailable(stream)) / sizeof(float));
    SDL_AudioStreamGet(stream, samples.data(), static_cast<int>(samples.size() * sizeof(float)));
  }
  if (stream != nullptr) SDL_FreeAudioStream(stream);
  SDL_FreeWAV(bytes);
  return samples;
}

}  // namespace

Heard HeardAt(const world::SoundSnapshot& sound, const world::CameraSnapshot& ear) {
  if (!sound.in_world) return {sound.volume, sound.volume};
  const world::Vec3 way = sound.position - ear.position;
  const float away = world::Length(way);
  const float loud = sound.volume * std::min(1.0f, kFullVolume_m / std::max(away, 1e-3f));
  const float side = away < 1e-3f ? 0 : Dot(way, Rotate(ear.orientation, {1, 0, 0})) / away;
  return {loud * std::min(1.0f, 1 - side), loud * std::min(1.0f, 1 + side)};
}

/// The audio device and the sounds that it is playing. The device's thread calls Mix.
struct SoundPlayer::Device {
  struct Voice {
    const std::vector<float>* samples = nullptr;
    std::size_t at = 0;
    Heard heard;
  };

  Device() {
    if (SDL_InitSubSystem(SDL_INIT_AUDIO) != 0) return;
    has_audio = true;
    SDL_AudioSpec wanted{};
    wanted.freq = kRate;
    wanted.format = AUDIO_F32SYS;
    wanted.channels = kChannels;
    wanted.samples = 1024;
    wanted.callback = [](void* self, Uint8* out, int bytes) {
      static_cast<Device*>(self)->Mix(reinterpret_cast<float*>(out), static_cast<std::size_t>(bytes) / sizeof(float));
    };
    wanted.userdata = this;
    id = SDL_OpenAudioDevice(nullptr, 0, &wanted, nullptr, 0);
    if (id != 0) SDL_PauseAudioDevice(id, 0);
  }
  ~Device() {
    if (id != 0) SDL_CloseAudioDevice(id);
    if (has_audio) SDL_QuitSubSystem(SDL_INIT_AUDIO);
  }
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;

  void Mix(float* out, std::size_t count) {
    std::fill(out, out + count, 0.0f);
    for (Voice& voice : voices) {
      const std::size_t left = std::min(count, voice.samples->size() - voice.at);
      for (std::size_t i = 0; i + 1 < left; i += 2) {
        out[i] += (*voice.samples)[voice.at + i] * voice.heard.left;
        out[i + 1] += (*voice.samples)[voice.at + i + 1] * voice.heard.right;
      }
      voice.at += left;
    }
    std::erase_if(voices, [](const Voice& voice) { return voice.at >= voice.samples->size(); });
    for (std::size_t i = 0; i < count; ++i) out[i] = std::clamp(out[i], -1.0f, 1.0f);
  }

  void Begin(const std::string& key, Heard heard) {
    if (id == 0) return;
    const auto [known, is_new] = samples.try_emplace(key);
    if (is_new)
      if (const auto file = world::FindAsset(key); file != nullptr) known->second = SamplesOf(*file);
    if (known->second.empty()) return;
    SDL_LockAudioDevice(id);
    if (voices.size() >= kMostVoices) voices.erase(voices.begin());
    voices.push_back({&known->second, 0, heard});
    SDL_UnlockAudioDevice(id);
  }

  bool has_audio = false;
  SDL_AudioDeviceID id = 0;
  std::map<std::string, std::vector<float>> samples;  ///< By key. Entries never change.
  std::vector<Voice> voices;                          ///< Guarded by the device's lock.
};

SoundPlayer::SoundPlayer() = default;
SoundPlayer::~SoundPlayer() = default;

void SoundPlayer::Take(const world::SceneSnapshot& scene, const world::CameraSnapshot& ear, bool is_live) {
  const std::uint32_t newest = scene.sounds.empty() ? last_.value_or(0) : scene.sounds.back().id;
  const std::optional<std::uint32_t> before = std::exchange(last_, newest);
  if (!before || newest <= *before || !is_live) return;
  if (device_ == nullptr) device_ = std::make_unique<Device>();
  for (const world::SoundSnapshot& sound : scene.sounds)
    if (sound.id > *before) device_->Begin(sound.file, HeardAt(sound, ear));
}

}  // namespace soarbox::viewer
