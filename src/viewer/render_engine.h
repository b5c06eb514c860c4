// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "diagnostics/result.h"

struct SDL_Window;
namespace Ogre {
class Camera;
class ImGuiOverlay;
class LogManager;
class OverlaySystem;
class RenderTarget;
class RenderWindow;
class Root;
class SceneManager;
class SceneNode;
class Viewport;
}  // namespace Ogre

namespace soarbox::viewer {

class Materials;
class ScaledScene;
struct ViewerOptions;

/// Starts SDL (window and input) and Ogre (drawing), and ends them in the right order.
///
/// The render system is selected here in code, because Ogre's own configuration would open a dialog. A hidden window
/// draws into a texture of its size, because it has no pixels of its own.
class Engine {
 public:
  static Result<std::unique_ptr<Engine>> Start(const ViewerOptions& options);
  ~Engine();
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;

  /// Adapts to the window's size. Does nothing if the size is unchanged.
  void Resize(int width, int height);

  /// The part of the window that shows the scene, in px from the top left; initially the entire window. Panels may be
  /// drawn anywhere.
  void SetPicture(int x, int y, int width, int height);

  /// Allows SetScale() to draw the scene smaller than it is shown.
  void PrepareScaling(Materials& materials);
  /// Draws the scene with this fraction of the picture's width and height, 0 to 1, and enlarges it to the picture.
  /// Panels keep their full resolution. Does nothing if the scale is unchanged.
  void SetScale(double scale);
  double scale() const { return scale_; }

  /// Draws a frame to the screen. A hidden window only lays out panels; WritePicture draws. An unchanged scene is drawn
  /// again only if this is needed to draw panels.
  void Draw(bool scene_has_changed = true);
  /// Counts the draw calls and triangles of the last frame, including shadow maps.
  void CountLast(std::size_t& draw_calls, std::size_t& triangles) const;
  /// Whether there is user input that has not been read yet. Waits up to `milliseconds` for it.
  bool HasInput(int milliseconds) const;

  /// Draws a frame into a texture, in the current scale, and writes it as a PNG file. Throws Ogre::Exception, or
  /// std::runtime_error with the path.
  void WritePicture(const std::filesystem::path& path);

  SDL_Window* window() const { return sdl_window_; }
  Ogre::SceneManager& scene() const { return *scene_; }
  Ogre::Camera& camera() const { return *camera_; }
  Ogre::SceneNode& camera_node() const { return *camera_node_; }
  bool low_detail() const { return low_detail_; }
  /// Whether the renderer runs on the processor; known only if the window was opened with Detail::kAuto.
  bool in_software() const { return in_software_; }
  /// Of the part of the window that shows the scene.
  int width() const { return width_; }
  int height() const { return height_; }
  int window_width() const { return window_width_; }
  int window_height() const { return window_height_; }

 private:
  Engine() = default;
  Result<void> OpenWindow(const ViewerOptions& options);
  void StartOgre(const ViewerOptions& options);
  /// Adds a viewport for the scene, and one over it for panels.
  void AddViewports(Ogre::RenderTarget& target);
  void PlaceViewport(Ogre::RenderTarget& target);
  /// Draws the scene to its own texture first if the scale is below 1.
  void Update(Ogre::RenderTarget& target, bool scene_has_changed);
  Ogre::RenderTarget* PictureTarget() const;
  void MakePictureTarget();
  void DropPictureTarget();

  SDL_Window* sdl_window_ = nullptr;
  bool sdl_started_ = false;
  bool has_pads_ = false;
  std::unique_ptr<Ogre::LogManager> log_;
  std::unique_ptr<Ogre::Root> root_;
  std::unique_ptr<Ogre::OverlaySystem> overlays_;
  Ogre::RenderWindow* render_window_ = nullptr;
  Ogre::SceneManager* scene_ = nullptr;
  Ogre::Camera* camera_ = nullptr;
  Ogre::SceneNode* camera_node_ = nullptr;
  Ogre::SceneManager* panel_scene_ = nullptr;  ///< Empty, so that drawing panels does not process the scene again.
  Ogre::Camera* panel_camera_ = nullptr;
  bool hidden_ = false;
  bool low_detail_ = false, in_software_ = false;
  std::unique_ptr<ScaledScene> scaled_;
  double scale_ = 1;
  int x_ = 0, y_ = 0, width_ = 0, height_ = 0;
  int window_width_ = 0, window_height_ = 0;
};

}  // namespace soarbox::viewer
