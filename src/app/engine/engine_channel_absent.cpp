// SPDX-License-Identifier: BSD-2-Clause
// For systems without sockets (WebAssembly): the other end is the JavaScript that runs the engine. It calls
// soarbox_take() for each request, and the engine calls its function soarboxFrame(kind, bytes) for each frame.
#include <emscripten.h>

#include <cstdlib>
#include <filesystem>
#include <utility>

#include "app/engine/engine_channel.h"

namespace soarbox::app {
namespace {

std::vector<std::string>& Taken() {
  static std::vector<std::string> taken;
  return taken;
}

}  // namespace

// clang-format off
EM_JS(bool, SoarboxHasListener, (), { return typeof Module["soarboxFrame"] === "function"; });
EM_JS(void, SoarboxFrame, (int kind, const char* bytes, int length), {
  const begin = bytes >>> 0;
  Module["soarboxFrame"](String.fromCharCode(kind), HEAPU8.slice(begin, begin + length));
});
// clang-format on

extern "C" {
/// A request for the engine, as JSON.
EMSCRIPTEN_KEEPALIVE void soarbox_take(const char* text) {
  Taken().emplace_back(text);
}
}

EngineChannel::EngineChannel(int socket) : socket_(socket), is_open_(SoarboxHasListener()) {
  Taken().clear();
  // The request with which a server reports that there is one page.
  Taken().emplace_back(R"({"request":"presence","pages":1})");
}

EngineChannel::~EngineChannel() = default;

std::vector<std::string> EngineChannel::Receive(int) {
  return std::exchange(Taken(), {});
}

bool EngineChannel::SendScene(std::string_view block, bool is_full) {
  Send(is_full ? serve::FrameKind::kFull : serve::FrameKind::kScene, block);
  return true;
}

void EngineChannel::Send(serve::FrameKind kind, std::string_view bytes) {
  if (is_open_) SoarboxFrame(static_cast<int>(kind), bytes.data(), static_cast<int>(bytes.size()));
}

}  // namespace soarbox::app
