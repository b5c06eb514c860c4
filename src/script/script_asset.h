// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string_view>

struct lua_State;

namespace soarbox::script {

// Files of the world that scripts show or play: images (.png), models (.glb, .gltf) and sounds (.wav). They are
// searched for in the folders of scripts (ScriptPath) and read once in a run. A file that cannot be used is a Lua error
// with its name and the reason.

/// Maximum number of such files in a world.
inline constexpr std::size_t kMostAssets = 256;

/// The key of an image or a sound (world/asset_store.h). Valid until the next call.
std::string_view ImageArgument(lua_State* state, int index);
std::string_view SoundArgument(lua_State* state, int index);

/// The name of a mesh; or, if the argument names a file, the key of its model (model/model.h). The model is then in the
/// world's catalog.
std::string_view MeshArgument(lua_State* state, int index);

}  // namespace soarbox::script
