// SPDX-License-Identifier: BSD-2-Clause
#include "script/script_asset.h"

#include <lua.hpp>
#include <string>

#include "diagnostics/problem.h"
#include "model/gltf.h"
#include "picture/png_reader.h"
#include "script/bind_arguments.h"
#include "script/binding.h"
#include "script/lua_machine.h"
#include "script/script_path.h"
#include "world/asset_store.h"
#include "world/wav_file.h"

namespace soarbox::script {
namespace {

using MakeKey = Result<std::string> (*)(ScriptContext& context, const ScriptPath& path, std::string_view name,
                                        std::string content);

Result<std::string> Kept(std::string_view name, std::string content, const std::string& why_not) {
  if (!why_not.empty()) return NewProblem(std::string(name) + ": " + why_not);
  return world::KeepAsset(name, std::move(content));
}

Result<std::string> ImageKey(ScriptContext&, const ScriptPath&, std::string_view name, std::string content) {
  const std::string why = picture::ReadPng(content).problem;
  return Kept(name, std::move(content), why);
}

Result<std::string> SoundKey(ScriptContext&, const ScriptPath&, std::string_view name, std::string content) {
  const std::string why = world::WhyNoWav(content);
  return Kept(name, std::move(content), why);
}

Result<std::string> ModelKey(ScriptContext& context, const ScriptPath& path, std::string_view name,
                             std::string content) {
  const std::size_t slash = name.rfind('/');
  const std::string folder(slash == std::string_view::npos ? "" : name.substr(0, slash + 1));
  Result<model::Model> read = model::ReadGltf(content, [&](std::string_view neighbour) {
    return path.ReadBytes(folder + std::string(neighbour), "model", world::kLargestAsset);
  });
  if (!read) return NewProblem(std::string(name) + ": " + read.error().message);
  const world::MeshBounds bounds{read->min, read->max};
  std::string key = model::KeepModel(name, std::move(*read));
  context.world.catalog().AddMesh(key, bounds);
  return key;
}

/// Pushes the reason if the file cannot be used, and returns null.
const std::string* FindOrRead(lua_State* state, std::string_view name, const char* kind, MakeKey make) {
  ScriptContext& context = ContextOf(state);
  if (const auto known = context.assets.find(name); known != context.assets.end()) return &known->second;
  LuaMachine& machine = LuaMachine::Of(state);
  const auto refuse = [&](const Diagnostic& error) {
    lua_pushfstring(state, "%s%s%s", error.message.c_str(), error.hint.empty() ? "" : ": ", error.hint.c_str());
    return nullptr;
  };
  if (context.assets.size() >= kMostAssets)
    return refuse(
        NewProblem("a world uses at most " + std::to_string(kMostAssets) + " files of images, models and sounds"));
  Result<std::string> content = machine.path().ReadBytes(name, kind, world::kLargestAsset);
  if (!content) return refuse(content.error());
  machine.Charge(content->size());
  const Result<std::string> key = make(context, machine.path(), name, std::move(*content));
  if (!key) return refuse(key.error());
  return &context.assets.emplace(std::string(name), *key).first->second;
}

std::string_view FileArgument(lua_State* state, int index, const char* kind, MakeKey make) {
  const std::string* const key = FindOrRead(state, TextArgument(state, index), kind, make);
  // No C++ string is alive here when the error is raised.
  if (key == nullptr) {
    luaL_where(state, 1);
    lua_insert(state, -2);
    lua_concat(state, 2);
    lua_error(state);
    return {};
  }
  return *key;
}

}  // namespace

std::string_view ImageArgument(lua_State* state, int index) {
  return FileArgument(state, index, "image", ImageKey);
}

std::string_view SoundArgument(lua_State* state, int index) {
  return FileArgument(state, index, "sound", SoundKey);
}

std::string_view MeshArgument(lua_State* state, int index) {
  const std::string_view name = TextArgument(state, index);
  return model::IsModelName(name) ? FileArgument(state, index, "model", ModelKey) : name;
}

}  // namespace soarbox::script
