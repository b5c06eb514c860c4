// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/render_engine.h"

#include <SDL.h>
#include <SDL_syswm.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include "diagnostics/problem.h"
#include "viewer/ogre_headers.h"
#include "viewer/scaled_scene.h"
#include "viewer/viewer.h"

namespace soarbox::viewer {
namespace {

constexpr const char* kPictureTexture = "Soarbox/Picture";

Diagnostic Failure(std::string message, std::string hint) {
  return NewProblem(std::move(message), std::move(hint));
}

constexpr const char* kNoDisplayHint =
    "start it from a desktop session, run it without a window (--headless), or put 'xvfb-run -a' before the command";

/// Whether OpenGL runs on the processor. Determined before the window exists, because the number of samples per pixel
/// is fixed when it is created.
bool DrawsInSoftware() {
  bool software = false;
  SDL_Window* window = SDL_CreateWindow("", 0, 0, 16, 16, SDL_WINDOW_OPENGL | SDL_WINDOW_HIDDEN);
  SDL_GLContext context = window != nullptr ? SDL_GL_CreateContext(window) : nullptr;
  if (context != nullptr) {
    constexpr unsigned kRendererName = 0x1F01;  // GL_RENDERER
    using GetString = const unsigned char* (*)(unsigned);
    const auto get_string = reinterpret_cast<GetString>(SDL_GL_GetProcAddress("glGetString"));
    const unsigned char* text = get_string != nullptr ? get_string(kRendererName) : nullptr;
    const std::string name = text != nullptr ? reinterpret_cast<const char*>(text) : "";
    for (const char* processor : {"llvmpipe", "softpipe", "swrast", "Software Rasterizer"}) {
      software = software || name.find(processor) != std::string::npos;
    }
    SDL_GL_DeleteContext(context);
  }
  if (window != nullptr) SDL_DestroyWindow(window);
  return software;
}

}  // namespace

Result<std::unique_ptr<Engine>> Engine::Start(const ViewerOptions& options) {
  if (Ogre::Root::getSingletonPtr() != nullptr)
    return Failure("a window is already open in this process", "close it first");
  std::unique_ptr<Engine> engine(new Engine);
  if (Result<void> opened = engine->OpenWindow(options); !opened) return opened.error();
  try {
    engine->StartOgre(options);
  } catch (const std::exception& error) {
    return Failure(std::string("the renderer cannot start: ") + error.what(),
                   "it needs OpenGL 3.3; 'glxinfo -B' shows what the display offers");
  }
  return engine;
}

std::optional<std::pair<int, int>> RoomOnDisplay() {
  const char* display = std::getenv("DISPLAY");
  if (display == nullptr || *display == '\0') return std::nullopt;
  SDL_SetMainReady();
  SDL_SetHint(SDL_HINT_VIDEODRIVER, "x11");
  SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
  if (SDL_InitSubSystem(SDL_INIT_VIDEO) != 0) return std::nullopt;
  SDL_Rect room;
  const bool is_known = SDL_GetDisplayUsableBounds(0, &room) == 0;
  SDL_QuitSubSystem(SDL_INIT_VIDEO);
  if (!is_known || room.w < 1 || room.h < 1) return std::nullopt;
  return std::pair{room.w, room.h};
}

Result<void> Engine::OpenWindow(const ViewerOptions& options) {
  width_ = window_width_ = options.width;
  height_ = window_height_ = options.height;
  hidden_ = options.hidden;
  if (width_ < 64 || height_ < 64 || width_ > 16384 || height_ > 16384) {
    return Failure("a window of " + std::to_string(width_) + "x" + std::to_string(height_) + " pixels cannot be opened",
                   "choose between 64 and 16384 pixels each way");
  }
  const char* display = std::getenv("DISPLAY");
  if (display == nullptr || *display == '\0') {
    return Failure("there is no display: the environment variable DISPLAY is not set", kNoDisplayHint);
  }
  SDL_SetMainReady();
  SDL_SetHint(SDL_HINT_VIDEODRIVER, "x11");
  SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
  SDL_SetHint(SDL_HINT_VIDEO_X11_NET_WM_BYPASS_COMPOSITOR, "0");
  if (SDL_InitSubSystem(SDL_INIT_VIDEO) != 0) {
    return Failure("the display '" + std::string(display) + "' cannot be opened: " + SDL_GetError(), kNoDisplayHint);
  }
  sdl_started_ = true;
  // Without gamepads the window works, too.
  has_pads_ = !hidden_ && SDL_InitSubSystem(SDL_INIT_GAMECONTROLLER) == 0;
  const Uint32 flags = hidden_ ? SDL_WINDOW_HIDDEN : SDL_WINDOW_SHOWN | SDL_WINDOW_RESIZABLE;
  sdl_window_ =
      SDL_CreateWindow(options.title.c_str(), SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED, width_, height_, flags);
  if (sdl_window_ == nullptr) {
    return Failure("no window can be opened on the display '" + std::string(display) + "': " + SDL_GetError(),
                   kNoDisplayHint);
  }
  return {};
}

void Engine::StartOgre(const ViewerOptions& options) {
  log_ = std::make_unique<Ogre::LogManager>();
  log_->createLog(options.log_file.empty() ? "soarbox-renderer" : options.log_file, true, false,
                  options.log_file.empty());
  root_ = std::make_unique<Ogre::Root>("", "", "");
  root_->loadPlugin(SOARBOX_OGRE_PLUGIN_DIR "/RenderSystem_GL3Plus");
  root_->loadPlugin(SOARBOX_OGRE_PLUGIN_DIR "/Codec_STBI");
  if (root_->getAvailableRenderers().empty()) throw std::runtime_error("no OpenGL render system is installed");
  root_->setRenderSystem(root_->getAvailableRenderers().front());
  root_->initialise(false);
  overlays_ = std::make_unique<Ogre::OverlaySystem>();

  SDL_SysWMinfo info;
  SDL_VERSION(&info.version);
  if (SDL_GetWindowWMInfo(sdl_window_, &info) == SDL_FALSE) throw std::runtime_error(SDL_GetError());
  const auto handle = std::to_string(static_cast<unsigned long>(info.info.x11.window));
  in_software_ = options.detail == Detail::kAuto && !hidden_ && DrawsInSoftware();
  low_detail_ = options.detail == Detail::kLow || in_software_;
  Ogre::NameValuePairList settings{{"parentWindowHandle", handle},
                                   {"vsync", options.vsync && !hidden_ ? "true" : "false"},
                                   {"FSAA", hidden_ || low_detail_ ? "0" : "4"}};
  render_window_ = root_->createRenderWindow(options.title, static_cast<unsigned>(width_),
                                             static_cast<unsigned>(height_), false, &settings);
  render_window_->setAutoUpdated(false);
  if (!root_->getRenderSystem()->getCapabilities()->isShaderProfileSupported("glsl330")) {
    throw std::runtime_error("the display offers less than OpenGL 3.3 (" +
                             root_->getRenderSystem()->getCapabilities()->getDeviceName() + ")");
  }
  // Ogre requires these programs before it draws any shadow, although only stencil shadows use them.
  Ogre::ResourceGroupManager::getSingleton().addResourceLocation(SOARBOX_OGRE_MEDIA_DIR "/ShadowVolume", "FileSystem",
                                                                 Ogre::RGN_INTERNAL);
  Ogre::ResourceGroupManager::getSingleton().initialiseAllResourceGroups();
  Ogre::MaterialManager::getSingleton().setDefaultTextureFiltering(Ogre::TFO_TRILINEAR);

  scene_ = root_->createSceneManager();
  panel_scene_ = root_->createSceneManager();
  panel_scene_->addRenderQueueListener(overlays_.get());
  panel_camera_ = panel_scene_->createCamera("Soarbox/PanelCamera");
  panel_scene_->getRootSceneNode()->attachObject(panel_camera_);
  camera_ = scene_->createCamera("Soarbox/Camera");
  camera_node_ = scene_->getRootSceneNode()->createChildSceneNode();
  camera_node_->attachObject(camera_);
  camera_->setNearClipDistance(0.1f);
  camera_->setFarClipDistance(2000);
  if (hidden_) {
    MakePictureTarget();
  } else {
    AddViewports(*render_window_);
  }
}

void Engine::AddViewports(Ogre::RenderTarget& target) {
  Ogre::Viewport* scene = target.addViewport(camera_, 0);
  scene->setBackgroundColour(Ogre::ColourValue(0.6f, 0.7f, 0.8f));
  scene->setOverlaysEnabled(false);
  Ogre::Viewport* panels = target.addViewport(panel_camera_, 1);
  panels->setClearEveryFrame(false);
  panels->setShadowsEnabled(false);
  panels->setSkiesEnabled(false);
  panels->setOverlaysEnabled(true);
  PlaceViewport(target);
}

void Engine::PlaceViewport(Ogre::RenderTarget& target) {
  const auto width = static_cast<float>(window_width_), height = static_cast<float>(window_height_);
  Ogre::Viewport* picture = target.getViewportByZOrder(0);
  picture->setDimensions(static_cast<float>(x_) / width, static_cast<float>(y_) / height,
                         static_cast<float>(width_) / width, static_cast<float>(height_) / height);
  // The aspect of the picture, not of the scaled texture, whose sides are integers.
  camera_->setAspectRatio(static_cast<float>(width_) / static_cast<float>(height_));
  const bool is_scaled = scaled_ && scale_ < 1;
  picture->setCamera(is_scaled ? &scaled_->camera() : camera_);
  picture->setShadowsEnabled(!is_scaled);
  if (!is_scaled) return;
  const auto scaled = [this](int size) { return std::max(1, static_cast<int>(std::lround(size * scale_))); };
  scaled_->SetSize(scaled(width_), scaled(height_));
}

void Engine::PrepareScaling(Materials& materials) {
  scaled_ = std::make_unique<ScaledScene>(*root_, *camera_, materials, low_detail_ ? 0u : 4u);
}

void Engine::SetScale(double scale) {
  if (scale == scale_) return;
  scale_ = scale;
  if (!hidden_) PlaceViewport(*render_window_);
  if (Ogre::RenderTarget* target = PictureTarget()) PlaceViewport(*target);
}

void Engine::Update(Ogre::RenderTarget& target, bool scene_has_changed) {
  if (scaled_ && scale_ < 1) scaled_->Draw(scene_has_changed);
  target.update(true);
}

Ogre::RenderTarget* Engine::PictureTarget() const {
  const Ogre::TexturePtr texture = Ogre::TextureManager::getSingleton().getByName(kPictureTexture, kGroup);
  return texture ? texture->getBuffer()->getRenderTarget() : nullptr;
}

void Engine::SetPicture(int x, int y, int width, int height) {
  if (x == x_ && y == y_ && width == width_ && height == height_) return;
  x_ = x;
  y_ = y;
  width_ = std::max(1, width);
  height_ = std::max(1, height);
  if (!hidden_) PlaceViewport(*render_window_);
  if (Ogre::RenderTarget* target = PictureTarget()) PlaceViewport(*target);
}

void Engine::MakePictureTarget() {
  Ogre::TexturePtr texture = Ogre::TextureManager::getSingleton().createManual(
      kPictureTexture, kGroup, Ogre::TEX_TYPE_2D, static_cast<unsigned>(window_width_),
      static_cast<unsigned>(window_height_), 0, Ogre::PF_BYTE_RGB, Ogre::TU_RENDERTARGET, nullptr, false,
      low_detail_ ? 0u : 4u);
  Ogre::RenderTarget* target = texture->getBuffer()->getRenderTarget();
  target->setAutoUpdated(false);
  AddViewports(*target);
}

void Engine::DropPictureTarget() {
  if (Ogre::TexturePtr old = Ogre::TextureManager::getSingleton().getByName(kPictureTexture, kGroup)) {
    old->getBuffer()->getRenderTarget()->removeAllViewports();
    Ogre::TextureManager::getSingleton().remove(old);
  }
}

void Engine::Resize(int width, int height) {
  if (hidden_ || (width == window_width_ && height == window_height_) || width < 1 || height < 1) return;
  x_ = y_ = 0;
  width_ = window_width_ = width;
  height_ = window_height_ = height;
  render_window_->resize(static_cast<unsigned>(width), static_cast<unsigned>(height));
  render_window_->windowMovedOrResized();
  PlaceViewport(*render_window_);
}

void Engine::Draw(bool scene_has_changed) {
  if (hidden_) {
    ImGui::Render();
    return;
  }
  root_->_fireFrameStarted();
  Update(*render_window_, scene_has_changed);
  root_->_fireFrameRenderingQueued();
  root_->_fireFrameEnded();
}

void Engine::CountLast(std::size_t& draw_calls, std::size_t& triangles) const {
  draw_calls = triangles = 0;
  const auto add = [&](const Ogre::RenderTarget* target) {
    if (target == nullptr) return;
    draw_calls += target->getStatistics().batchCount;
    triangles += target->getStatistics().triangleCount;
  };
  if (hidden_)
    add(PictureTarget());
  else
    add(render_window_);
  if (scaled_ && scale_ < 1) add(scaled_->target());
  for (std::size_t map = 0; map < 2; ++map) {
    if (const Ogre::TexturePtr& texture = scene_->getShadowTexture(map)) add(texture->getBuffer()->getRenderTarget());
  }
}

bool Engine::HasInput(int milliseconds) const {
  return SDL_WaitEventTimeout(nullptr, milliseconds) != 0;
}

void Engine::WritePicture(const std::filesystem::path& path) {
  if (!hidden_) MakePictureTarget();
  const auto restore = [this] {
    if (!hidden_) DropPictureTarget();
  };
  try {
    const Ogre::TexturePtr texture = Ogre::TextureManager::getSingleton().getByName(kPictureTexture, kGroup);
    Update(*texture->getBuffer()->getRenderTarget(), true);
    Ogre::Image image;
    texture->convertToImage(image);
    image.save(path.string());
  } catch (...) {
    restore();
    throw;
  }
  restore();
  if (!std::filesystem::exists(path)) throw std::runtime_error("nothing was written to " + path.string());
}

Engine::~Engine() {
  if (scene_ != nullptr) {
    panel_scene_->removeRenderQueueListener(overlays_.get());
    DropPictureTarget();
    if (render_window_ != nullptr) render_window_->removeAllViewports();
    scaled_.reset();
    root_->destroySceneManager(scene_);
    root_->destroySceneManager(panel_scene_);
  }
  overlays_.reset();
  root_.reset();
  log_.reset();
  if (sdl_window_ != nullptr) SDL_DestroyWindow(sdl_window_);
  if (has_pads_) SDL_QuitSubSystem(SDL_INIT_GAMECONTROLLER);
  if (sdl_started_) SDL_QuitSubSystem(SDL_INIT_VIDEO);
}

}  // namespace soarbox::viewer
