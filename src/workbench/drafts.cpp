// SPDX-License-Identifier: BSD-2-Clause
#include "workbench/drafts.h"

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <system_error>

#include "diagnostics/plain_text.h"

namespace soarbox::workbench {
namespace fs = std::filesystem;
namespace {

/// One name for a file, regardless of how its path was written.
std::string NameOfDraft(const fs::path& file) {
  std::error_code error;
  const fs::path whole = fs::weakly_canonical(fs::absolute(file, error), error);
  return error ? file.string() : whole.string();
}

}  // namespace

fs::path Drafts::Folder() {
  const auto set = [](const char* name) -> const char* {
    const char* value = std::getenv(name);
    return value != nullptr && *value != '\0' ? value : nullptr;
  };
  if (const char* state = set("XDG_STATE_HOME")) return fs::path(state) / "soarbox" / "drafts";
  if (const char* home = set("HOME")) return fs::path(home) / ".local" / "state" / "soarbox" / "drafts";
  return {};
}

fs::path Drafts::PlaceOf(const fs::path& file) const {
  std::uint64_t hash = 14695981039346656037u;
  for (const char c : NameOfDraft(file)) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211u;
  char name[32];
  std::snprintf(name, sizeof name, "-%016llx.draft", static_cast<unsigned long long>(hash));
  return folder_ / (std::string(Beginning(file.stem().string(), 60)) + name);
}

Result<void> Drafts::Keep(const fs::path& file, const std::string& text) const {
  if (folder_.empty()) return {};
  const fs::path place = PlaceOf(file);
  const fs::path half = fs::path(place).concat(".new");
  std::error_code error;
  fs::create_directories(folder_, error);
  {
    // The first line is the path of the file.
    std::ofstream out(half, std::ios::binary | std::ios::trunc);
    out << NameOfDraft(file) << '\n' << text;
    if (!out.flush()) error = std::make_error_code(std::errc::io_error);
  }
  if (!error) fs::rename(half, place, error);
  if (!error) return {};
  Diagnostic problem;
  problem.file = place.string();
  problem.message = "what you typed cannot be kept as a draft: " + error.message();
  problem.hint = "save the file before you close the window";
  std::error_code ignored;
  fs::remove(half, ignored);
  return problem;
}

void Drafts::Drop(const fs::path& file) const {
  if (folder_.empty()) return;
  std::error_code ignored;
  fs::remove(PlaceOf(file), ignored);
}

std::optional<std::string> Drafts::Find(const fs::path& file) const {
  if (folder_.empty()) return std::nullopt;
  std::ifstream in(PlaceOf(file), std::ios::binary);
  std::string owner;
  if (!in || !std::getline(in, owner) || owner != NameOfDraft(file)) return std::nullopt;
  std::ostringstream text;
  // A draft can be empty, if the user has deleted everything.
  if (in.peek() != std::ifstream::traits_type::eof()) text << in.rdbuf();
  return text.str();
}

}  // namespace soarbox::workbench
