// SPDX-License-Identifier: BSD-2-Clause
#include "script/check_syntax.h"

#include <lua.hpp>
#include <memory>

namespace soarbox::script {

std::optional<Diagnostic> CheckSyntax(std::string_view text, const std::string& file) {
  const std::unique_ptr<lua_State, void (*)(lua_State*)> state(luaL_newstate(), lua_close);
  Diagnostic problem;
  problem.file = file;
  if (state == nullptr) {
    problem.message = "there is no memory to check this script";
    return problem;
  }
  // Text only: a compiled chunk is not a script. The chunk is not run.
  if (luaL_loadbufferx(state.get(), text.data(), text.size(), "=script", "t") == 0) return std::nullopt;
  const char* message = lua_tostring(state.get(), -1);
  std::string words = message != nullptr ? message : "this does not compile";
  // "script:LINE: what"
  const std::size_t first = words.find(':'), second = words.find(':', first + 1);
  if (first != std::string::npos && second != std::string::npos) {
    problem.line = std::atoi(words.c_str() + first + 1);
    words.erase(0, std::min(second + 2, words.size()));
  }
  problem.message = words;
  return problem;
}

}  // namespace soarbox::script
