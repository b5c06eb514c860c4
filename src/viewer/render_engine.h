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

/// Brings up SDL (window and input) and Ogre (drawing), and takes them down in the right order.
///
/// The render system is chosen here, in code: Ogre's own configuration would open a dialog. A hidden window draws into
/// a texture of its size, because a window that is not on the screen has no pixels of its own.
class Engine {
 public:
  static Result<std::unique_ptr<Engine>> Start(const ViewerOptions& options);
  ~Engine();
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;

  /// Follows the window's size. Does nothing if that did not change.
  void Resize(int width, int height);

  /// The scene fills this part of the window, in px from its top left; from the start it fills all of it. Panels may
  /// be drawn anywhere.
  void SetPicture(int x, int y, int width, int height);

  /// The scene may from now on be drawn smaller than it is shown.
  void PrepareScaling(Materials& materials);
  /// The scene is drawn in this share of the picture's width and height, 0 to 1, and brought up to it; panels are not.
  /// Does nothing if that did not change.
  void SetScale(double scale);
  double scale() const { return scale_; }

  /// Draws once, onto the screen. Of a hidden window nobody would see it: only panels are laid out, WritePicture draws.
  /// A scene that has not changed is drawn again only where that is needed to draw panels.
  void Draw(bool scene_has_changed = true);
  /// What the last drawing handed to the renderer, shadow maps included.
  void CountLast(std::size_t& draw_calls, std::size_t& triangles) const;
  /// Whether the user has done something that has not been read yet; waits for it up to `milliseconds`.
  bool HasInput(int milliseconds) const;

  /// Draws once into a texture, in the present scale, and writes it as a PNG. Throws Ogre::Exception, or
  /// std::runtime_error naming the path.
  void WritePicture(const std::filesystem::path& path);

  SDL_Window* window() const { return sdl_window_; }
  Ogre::SceneManager& scene() const { return *scene_; }
  Ogre::Camera& camera() const { return *camera_; }
  Ogre::SceneNode& camera_node() const { return *camera_node_; }
  bool low_detail() const { return low_detail_; }
  /// Whether the processor draws; known only of a window that was opened with Detail::kAuto.
  bool in_software() const { return in_software_; }
  /// Of the part that the scene fills.
  int width() const { return width_; }
  int height() const { return height_; }
  int window_width() const { return window_width_; }
  int window_height() const { return window_height_; }

 private:
  Engine() = default;
  Result<void> OpenWindow(const ViewerOptions& options);
  void StartOgre(const ViewerOptions& options);
  /// One viewport for the scene, and one over it for panels alone.
  void AddViewports(Ogre::RenderTarget& target);
  void PlaceViewport(Ogre::RenderTarget& target);
  /// Draws the scene first if it is drawn smaller.
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
  Ogre::SceneManager* panel_scene_ = nullptr;  ///< Empty: panels are drawn without going through the scene twice.
  Ogre::Camera* panel_camera_ = nullptr;
  bool hidden_ = false;
  bool low_detail_ = false, in_software_ = false;
  std::unique_ptr<ScaledScene> scaled_;
  double scale_ = 1;
  int x_ = 0, y_ = 0, width_ = 0, height_ = 0;
  int window_width_ = 0, window_height_ = 0;
};

}  // namespace soarbox::viewer
