// SPDX-License-Identifier: BSD-2-Clause
#include "script/script_path.h"

#include <algorithm>
#include <fstream>
#include <optional>
#include <sstream>

#include "diagnostics/lower_case.h"
#include "diagnostics/plain_text.h"

namespace soarbox::script {
namespace {

namespace fs = std::filesystem;

bool LeadsOutside(const fs::path& name) {
  return name.is_absolute() || std::any_of(name.begin(), name.end(), [](const fs::path& part) { return part == ".."; });
}

/// Returns the names of everything in a folder, sorted, so that the result does not depend on the file system.
std::vector<std::string> FileNames(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error))
    names.push_back(it->path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

std::optional<fs::path> FindIn(const fs::path& folder, const fs::path& name) {
  std::error_code error;
  if (fs::is_regular_file(folder / name, error)) return folder / name;
  const fs::path parent = folder / name.parent_path();
  const std::string wanted = LowerCase(name.filename().string());
  for (const std::string& candidate : FileNames(parent))
    if (LowerCase(candidate) == wanted && fs::is_regular_file(parent / candidate, error)) return parent / candidate;
  return std::nullopt;
}

constexpr std::size_t kLongestName = 1000;
/// Maximum size of a script.
constexpr std::size_t kLargestScript = 8 << 20;

/// Describes what is at a path instead of a file; empty if nothing is there.
std::string OtherThan(const fs::path& place) {
  std::error_code error;
  const fs::file_status status = fs::symlink_status(place, error);
  if (error || !fs::exists(status)) return {};
  if (fs::is_symlink(status) && !fs::exists(place, error)) return "a link that leads nowhere";
  return fs::is_directory(place, error) ? "a folder" : "no plain file";
}

std::string WithArticle(const std::string& noun) {
  return (noun.starts_with('i') ? "an " : "a ") + noun;
}

bool MentionsTick(std::string_view content) {
  return content.find("Agent_Tick") != std::string_view::npos;
}

}  // namespace

bool ScriptPath::LinksOutside(const fs::path& file) const {
  std::error_code error;
  const fs::path inside = fs::canonical(file, error);
  if (error) return true;
  return std::none_of(folders_.begin(), folders_.end(), [&](const fs::path& folder) {
    const fs::path above = fs::canonical(folder, error);
    return !error && std::mismatch(above.begin(), above.end(), inside.begin(), inside.end()).first == above.end();
  });
}

Result<fs::path> ScriptPath::Locate(std::string_view name, const std::string& kind, std::uintmax_t largest) const {
  Diagnostic error;
  if (name.size() > kLongestName) {
    error.message = WithArticle(kind) + "'s name has " + std::to_string(kLongestName) + " bytes at most";
    return error;
  }
  error.file = std::string(name);
  if (name.empty() || name.find('\0') != std::string_view::npos || LeadsOutside(fs::path(name))) {
    error.message = WithArticle(kind) + " is named relative to the scenario's folder, without \"..\"";
    return error;
  }
  std::optional<fs::path> found;
  for (const fs::path& folder : folders_) {
    found = FindIn(folder, fs::path(name));
    if (found) break;
  }
  if (found && LinksOutside(*found)) {
    error.message = "this " + kind + " is a link that leads out of the scenario's folder";
    return error;
  }
  for (const fs::path& folder : folders_) {
    if (found) break;
    if (const std::string other = OtherThan(folder / fs::path(name)); !other.empty()) {
      error.message = "the " + kind + " \"" + std::string(name) + "\" is " + other;
      return error;
    }
  }
  if (!found) {
    error.message = "no such " + kind + " file: \"" + std::string(name) + "\"";
    std::vector<std::string> names;
    std::string searched;
    const fs::path below = fs::path(name).parent_path();
    for (const fs::path& folder : folders_) {
      for (const std::string& candidate : FileNames(folder / below)) names.push_back((below / candidate).string());
      searched += (searched.empty() ? "" : ", ") + folder.string();
    }
    std::string_view near = Suggest(name, {names.begin(), names.end()});
    const auto whole = std::ranges::find(names, std::string(name) + ".lua");  // The extension was left out.
    if (whole != names.end()) near = *whole;
    error.hint = near.empty() ? "searched in " + searched : "did you mean \"" + std::string(near) + "\"?";
    return error;
  }
  std::error_code unknown;
  if (const std::uintmax_t size = fs::file_size(*found, unknown); !unknown && size > largest) {
    error.message =
        "the " + kind + " \"" + std::string(name) + "\" is too large: " + std::to_string(size >> 20) + " MB";
    return error;
  }
  return *found;
}

Result<std::string> ScriptPath::ReadBytes(std::string_view name, const std::string& kind,
                                          std::uintmax_t largest) const {
  const Result<fs::path> found = Locate(name, kind, largest);
  if (!found) return found.error();
  std::ifstream file(*found, std::ios::binary);
  std::ostringstream content;
  content << file.rdbuf();
  if (file) return std::move(content).str();
  Diagnostic error;
  error.file = std::string(name);
  error.message = "cannot read " + found->string();
  return error;
}

Result<const ScriptSource*> ScriptPath::Load(std::string_view name) {
  if (const auto it = cache_.find(name); it != cache_.end()) return &it->second;

  const Result<fs::path> found = Locate(name, "script", kLargestScript);
  if (!found) return found.error();
  Diagnostic error;
  error.file = std::string(name);
  std::ifstream file(*found, std::ios::binary);
  std::ostringstream content;
  content << file.rdbuf();
  if (!file) {
    error.message = "cannot read script file " + found->string();
    return error;
  }
  if (const std::string why = WhyNoPlainText(content.view()); !why.empty()) {
    error.message = "the script \"" + std::string(name) + "\" cannot be read: " + why;
    return error;
  }
  ScriptSource source{std::string(name), found->string(), std::move(content).str()};
  source.has_tick = MentionsTick(source.content);
  return &cache_.emplace(std::string(name), std::move(source)).first->second;
}

void ScriptPath::Replace(std::string_view name, std::string_view content) {
  const auto it = cache_.find(name);
  if (it == cache_.end() || it->second.content == content) return;
  it->second.content = content;
  it->second.has_tick = MentionsTick(content);
  it->second.compiled.clear();
}

bool ScriptPath::HasTick(std::string_view name) const {
  const auto it = cache_.find(name);
  return it != cache_.end() && it->second.has_tick;
}

std::string ScriptPath::LineOf(std::string_view name, int line) const {
  const auto it = cache_.find(name);
  if (it == cache_.end() || line < 1) return {};
  std::string_view rest = it->second.content;
  for (; line > 1; --line) {
    const std::size_t end = rest.find('\n');
    if (end == std::string_view::npos) return {};
    rest.remove_prefix(end + 1);
  }
  std::string text(rest.substr(0, rest.find('\n')));
  if (!text.empty() && text.back() == '\r') text.pop_back();
  return text;
}

std::string ScriptPath::PathOf(std::string_view name) const {
  const auto it = cache_.find(name);
  return it == cache_.end() ? std::string(name) : it->second.path;
}

}  // namespace soarbox::script
