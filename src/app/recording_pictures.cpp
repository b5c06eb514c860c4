// SPDX-License-Identifier: BSD-2-Clause
#include "app/recording_pictures.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <memory>
#include <optional>
#include <sstream>
#include <system_error>
#include <utility>
#include <vector>

#include "app/exit_codes.h"
#include "app/refuse.h"
#include "app/run_session.h"
#include "diagnostics/problem.h"
#include "picture/gif.h"
#include "picture/png.h"
#include "picture/stroke_font.h"
#include "sweep/plan.h"
#include "viewer/software_picture.h"

namespace soarbox::app {
namespace {

namespace fs = std::filesystem;
using world::Vec3;

constexpr int kWidth_px = 1280, kHeight_px = 720, kVideoWidth_px = 640, kVideoHeight_px = 360;
constexpr double kEvery_s = 1, kVideoEvery_s = 0.1;

Diagnostic Unwritten(const fs::path& file) {
  return ProblemIn(file, "this file cannot be written", "is the disk full, or the folder not yours?");
}

bool IsInstalled(const std::string& program) {
  const char* const path = std::getenv("PATH");
  std::istringstream folders(path != nullptr ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (!folder.empty() && access((fs::path(folder) / program).c_str(), X_OK) == 0) return true;
  return false;
}

/// An animation that is being written.
class Film {
 public:
  virtual ~Film() = default;
  virtual Result<void> Add(const picture::Image& image) = 0;
  virtual Result<void> Finish() = 0;
};

class GifFilm final : public Film {
 public:
  GifFilm(fs::path file, int width, int height, double every_s)
      : file_(std::move(file)),
        out_(file_, std::ios::binary),
        maker_(width, height, std::max(2, static_cast<int>(std::lround(every_s * 100)))) {}
  Result<void> Add(const picture::Image& image) override { return Put(maker_.Add(image)); }
  Result<void> Finish() override { return Put(picture::GifMaker::End()); }

 private:
  Result<void> Put(const std::string& bytes) {
    if ((out_ << bytes).flush()) return {};
    return Unwritten(file_);
  }
  fs::path file_;
  std::ofstream out_;
  picture::GifMaker maker_;
};

/// Passes the pixels of all pictures to ffmpeg, which writes the format of the file's extension.
class FfmpegFilm final : public Film {
 public:
  FfmpegFilm(fs::path file, int width, int height, double every_s) : file_(std::move(file)) {
    std::signal(SIGPIPE, SIG_IGN);  // If ffmpeg ends early, its exit status shows this.
    const std::string command =
        fmt::format("ffmpeg -loglevel error -y -f rawvideo -pix_fmt rgb24 -s {}x{} -r {:.6g} -i - -pix_fmt yuv420p {}",
                    width, height, 1 / every_s, sweep::ShellWord(fs::absolute(file_).string()));
    pipe_ = popen(command.c_str(), "w");
  }
  ~FfmpegFilm() override {
    if (pipe_ != nullptr) pclose(pipe_);
  }
  Result<void> Add(const picture::Image& image) override {
    if (pipe_ != nullptr && std::fwrite(image.rgb.data(), 1, image.rgb.size(), pipe_) == image.rgb.size()) return {};
    return Failed();
  }
  Result<void> Finish() override {
    std::FILE* const pipe = std::exchange(pipe_, nullptr);
    if (pipe != nullptr && pclose(pipe) == 0) return {};
    return Failed();
  }

 private:
  Diagnostic Failed() const {
    return ProblemIn(file_, "ffmpeg made no video", "its own message is above; .gif needs no ffmpeg");
  }
  fs::path file_;
  std::FILE* pipe_ = nullptr;
};

Result<std::unique_ptr<Film>> MakeFilm(const fs::path& file, int width, int height, double every_s) {
  if (file.extension() == ".gif") return std::unique_ptr<Film>(std::make_unique<GifFilm>(file, width, height, every_s));
  if (file.extension().empty())
    return ProblemIn(file, "the name of a video ends with its kind", "clip.gif, or clip.mp4 with ffmpeg");
  if (!IsInstalled("ffmpeg"))
    return ProblemIn(file, "ffmpeg, which makes videos of this kind, is not installed",
                     "install it (Debian: apt install ffmpeg), or name a .gif, which needs nothing else");
  return std::unique_ptr<Film>(std::make_unique<FfmpegFilm>(file, width, height, every_s));
}

/// Returns the positions of the agents in all moments. A camera that shows all of them need not move.
Result<std::vector<Vec3>> PlacesIn(record::Reader& recording, record::TickRange range) {
  std::vector<Vec3> places;
  const Result<void> read = record::ForEachTick(recording, range, [&](const record::TickRecord& record) {
    if (record.tick % 10 != 0 && !places.empty()) return;
    for (const world::AgentSnapshot& agent : record.scene.agents) places.push_back(agent.position);
  });
  if (!read) return read.error();
  return places;
}

/// A camera over an agent's shoulder, or from above for a plan. Nothing if the agent does not exist.
std::optional<viewer::SoftwareCamera> CameraBehind(const world::SceneSnapshot& scene, const std::string& name,
                                                   float aspect, bool is_plan) {
  for (const world::AgentSnapshot& agent : scene.agents) {
    if (agent.name != name) continue;
    constexpr float kAround_m = 8;
    std::vector<Vec3> around;
    for (const float side : {-kAround_m, kAround_m}) around.push_back(agent.position + Vec3{side, 0, side});
    return viewer::CameraOver(around, aspect, is_plan);
  }
  return std::nullopt;
}

viewer::SoftwareCamera CameraOfScene(const world::CameraSnapshot& camera) {
  viewer::SoftwareCamera made;
  made.eye = camera.position;
  made.ahead = Rotate(camera.orientation, Vec3{0, 0, -1});
  made.up = Rotate(camera.orientation, Vec3{0, 1, 0});
  made.vertical_fov_deg = camera.vertical_fov_deg;
  return made;
}

/// Writes the simulated time of a picture.
void WriteTime(picture::Image& image, double time_s) {
  const std::string text = fmt::format("{:.1f} s", time_s);
  constexpr float kHigh_px = 11, kMargin_px = 10;
  const float y = static_cast<float>(image.height) - kMargin_px;
  image.Box(0, y - kHigh_px - kMargin_px, picture::TextWidth(text, kHigh_px) + 2 * kMargin_px,
            kHigh_px + 2 * kMargin_px, {1, 1, 1, 0.75f});
  picture::WriteText(image, kMargin_px, y, kHigh_px, text, {0.08f, 0.09f, 0.10f, 1}, 1.6f);
}

}  // namespace

int DrawPictures(record::Reader& recording, record::TickRange range, const RecordingOptions& options) {
  const bool is_film = !options.video.empty();
  const int width = options.width_px.value_or(is_film ? kVideoWidth_px : kWidth_px) / 2 * 2;
  const int height = options.height_px.value_or(is_film ? kVideoHeight_px : kHeight_px) / 2 * 2;
  const float aspect = static_cast<float>(width) / static_cast<float>(height);
  const double every_s = options.every_s.value_or(is_film ? kVideoEvery_s : kEvery_s),
               step_s = recording.header().step_s;
  const auto every = std::max<std::uint64_t>(1, static_cast<std::uint64_t>(std::llround(every_s / step_s)));
  const std::uint64_t first = std::max(range.first, recording.first_tick()),
                      last = std::min(range.last, recording.last_tick());
  if (first > last) return Refuse(record::NotThere(recording, range.first));
  std::error_code error;
  if (!options.pictures.empty()) fs::create_directories(options.pictures, error);
  if (error) return Refuse(ProblemIn(options.pictures, "this folder cannot be made: " + error.message()));
  std::unique_ptr<Film> film;
  if (is_film) {
    Result<std::unique_ptr<Film>> made = MakeFilm(options.video, width, height, static_cast<double>(every) * step_s);
    if (!made) return Refuse(made.error());
    film = std::move(*made);
  }
  const Result<std::vector<Vec3>> places = PlacesIn(recording, {first, last});
  if (!places) return Refuse(places.error());
  const viewer::SoftwareCamera over = viewer::CameraOver(*places, aspect, options.is_plan);
  viewer::SoftwarePictures pictures(width, height);
  std::size_t count = 0;
  bool was_seen = options.select.empty();
  viewer::SoftwareCamera camera = over;
  for (std::uint64_t tick = first; tick <= last && !WasInterrupted(); tick += every) {
    const Result<const record::TickRecord*> record = recording.At(tick);
    if (!record) return Refuse(record.error());
    const world::SceneSnapshot& scene = (*record)->scene;
    if (scene.camera_is_fixed && !options.is_plan) camera = CameraOfScene(scene.camera);
    if (const auto behind = CameraBehind(scene, options.select, aspect, options.is_plan)) {
      camera = *behind;
      was_seen = true;
    }
    picture::Image image = pictures.Draw(scene, camera);
    WriteTime(image, scene.time_s);
    ++count;
    if (film != nullptr)
      if (const Result<void> added = film->Add(image); !added) return Refuse(added.error());
    if (options.pictures.empty()) continue;
    const fs::path file = options.pictures / fmt::format("tick-{:06}.png", tick);
    if (!(std::ofstream(file, std::ios::binary) << picture::PngOf(image)).flush()) return Refuse(Unwritten(file));
  }
  if (film != nullptr)
    if (const Result<void> finished = film->Finish(); !finished) return Refuse(finished.error());
  if (!was_seen)
    return Refuse("there is no agent '" + options.select + "' in these moments",
                  "soarbox export " + recording.name() + " --csv lists the agents", recording.name());
  const std::string to = options.pictures.empty() ? options.video.string() : options.pictures.string();
  std::cout << fmt::format("{}: {} pictures of {} by {} pixels, one every {:.3g} s\n", to, count, width, height,
                           static_cast<double>(every) * step_s);
  return WasInterrupted() ? 130 : static_cast<int>(kOk);
}

}  // namespace soarbox::app
