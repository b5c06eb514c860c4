// SPDX-License-Identifier: BSD-2-Clause
#include "script/script_error.h"

#include <algorithm>
#include <charconv>
#include <lua.hpp>
#include <string_view>
#include <vector>

#include "script/lua_hints.h"
#include "script/lua_text.h"
#include "script/script_path.h"

namespace soarbox::script {
namespace {

constexpr int kTracebackLimit = 20;

/// Chunk names are "@" and the file's name; other names are chunks that a script created from a string.
std::string FileOf(const lua_Debug& frame) {
  return frame.source && frame.source[0] == '@' ? std::string(frame.source + 1) : std::string(frame.short_src);
}

/// Splits "place:line: text", where `place` is the chunk's name as shortened by Lua. Returns false if there is no
/// place.
bool SplitPlace(std::string_view message, std::string_view& place, int& line, std::string_view& text) {
  for (std::size_t colon = message.find(':'); colon != std::string_view::npos; colon = message.find(':', colon + 1)) {
    const char* begin = message.data() + colon + 1;
    const char* end = message.data() + message.size();
    const auto [after, error] = std::from_chars(begin, end, line);
    if (error != std::errc{} || after == end || *after != ':') continue;
    place = message.substr(0, colon);
    text = message.substr(static_cast<std::size_t>(after - message.data()) + 1);
    if (text.starts_with(' ')) text.remove_prefix(1);
    return true;
  }
  return false;
}

void AppendFrame(std::string& text, const lua_Debug& frame) {
  text += "  ";
  if (frame.currentline > 0) {
    text += FileOf(frame) + ":" + std::to_string(frame.currentline) + ": ";
  } else if (*frame.what == 'C') {
    text += "[C]: ";
  } else {
    text += FileOf(frame) + ": ";
  }
  if (frame.name) {
    text += std::string("in function '") + frame.name + "'";
  } else if (*frame.what == 'm') {
    text += "in the main chunk";
  } else if (*frame.what == 'C') {
    text += "in a built-in function";
  } else {
    text += "in the function at line " + std::to_string(frame.linedefined);
  }
  text += "\n";
}

}  // namespace

std::string Traceback(lua_State* state) {
  std::string text;
  lua_Debug frame;
  std::vector<lua_Debug> frames;
  for (int level = 1; lua_getstack(state, level, &frame) == 1; ++level) {
    lua_getinfo(state, "Snl", &frame);
    frames.push_back(frame);
    if (level > 10'000) break;
  }
  // The outermost calls are our own, around the script; they do not help the user.
  while (!frames.empty() && *frames.back().what == 'C') frames.pop_back();
  const std::size_t count = frames.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (count > kTracebackLimit && i == kTracebackLimit / 2) {
      const std::size_t skipped = count - kTracebackLimit;
      text += "  ... " + std::to_string(skipped) + " more calls ...\n";
      i += skipped - 1;
      continue;
    }
    AppendFrame(text, frames[i]);
  }
  return text;
}

std::string Format(const ScriptError& error) {
  std::string text = Format(error.diagnostic);
  if (!error.traceback.empty()) text += "   called from:\n" + error.traceback;
  return text;
}

std::string CallersIn(std::string_view traceback) {
  constexpr int kMostCallers = 8;
  std::string callers;
  int count = 0;
  while (!traceback.empty()) {
    const std::size_t end = std::min(traceback.find('\n'), traceback.size());
    std::string_view line = traceback.substr(0, end);
    traceback.remove_prefix(std::min(end + 1, traceback.size()));
    line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
    if (line.starts_with("[C]")) continue;
    if (++count == 1) continue;
    if (count > kMostCallers + 1) return callers + ", ...";
    std::string caller(line);
    const std::size_t place_end = line.find(": in ");
    if (place_end != std::string_view::npos) {
      std::string_view where = line.substr(place_end + 5);
      if (where.starts_with("function '") && where.ends_with('\'')) where = where.substr(10, where.size() - 11);
      caller = std::string(line.substr(0, place_end)) + " (" + std::string(where) + ")";
    }
    callers += (callers.empty() ? "called from " : ", ") + caller;
  }
  return callers;
}

void LocateCaller(lua_State* state, std::string& file, int& line) {
  lua_Debug frame;
  for (int level = 0; lua_getstack(state, level, &frame) == 1; ++level) {
    lua_getinfo(state, "Sl", &frame);
    if (frame.currentline <= 0) continue;
    file = FileOf(frame);
    line = frame.currentline;
    return;
  }
}

ScriptError DescribeMessage(std::string_view message, std::string_view script_name, const ScriptPath& path) {
  ScriptError error;
  Diagnostic& diagnostic = error.diagnostic;
  diagnostic.file = std::string(script_name);
  std::string_view place, text;
  int line = 0;
  if (SplitPlace(message, place, line, text)) {
    // Lua shortens long names ("...end/of/name.lua"). If it is the script's name, the complete name is used.
    const std::string_view end_of_place = place.starts_with("...") ? place.substr(3) : place;
    if (!script_name.ends_with(end_of_place)) diagnostic.file = std::string(place);
    diagnostic.line = line;
    message = text;
  }
  diagnostic.message = std::string(message);
  diagnostic.excerpt = path.LineOf(diagnostic.file, diagnostic.line);
  diagnostic.hint = HintForLua(diagnostic.message, diagnostic.excerpt);
  diagnostic.file = path.PathOf(diagnostic.file);
  return error;
}

ScriptError DescribeError(lua_State* state, const ScriptPath& path) {
  std::string file;
  int line = 0;
  LocateCaller(state, file, line);

  const std::string message = DisplayText(state, -1);
  ScriptError error = DescribeMessage(message, file, path);
  if (error.diagnostic.line == 0 && line > 0) {
    error.diagnostic.line = line;
    error.diagnostic.excerpt = path.LineOf(file, line);
    if (error.diagnostic.hint.empty())
      error.diagnostic.hint = HintForLua(error.diagnostic.message, error.diagnostic.excerpt);
  }
  error.traceback = Traceback(state);
  return error;
}

}  // namespace soarbox::script
