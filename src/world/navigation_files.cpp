// SPDX-License-Identifier: BSD-2-Clause
#include "world/navigation_files.h"

#include <Recast.h>
#include <unistd.h>

#include <array>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>

#include "diagnostics/read_text.h"
#include "world/navigation_store.h"
#include "world/shared_navigation.h"
#include "world/state_hash.h"

#ifdef __linux__
#include <dlfcn.h>
#endif

namespace soarbox::world {
namespace {

namespace fs = std::filesystem;
using Triangle = std::array<Vec3, 3>;

/// Number of files. A mesh replaces another one if their sources are equal modulo this number.
constexpr std::uint64_t kFiles = 64;
/// Larger meshes are not stored.
constexpr std::size_t kMostBytes = std::size_t{16} << 20;

/// The beginning of a file. The tile and the triangles follow.
struct Head {
  std::array<char, 8> magic{'s', 'o', 'a', 'r', 'n', 'a', 'v', '1'};
  std::uint64_t builder = 0;  ///< Identifies the program and its version of Recast.
  std::uint64_t source = 0;
  std::uint64_t tile_bytes = 0, triangles = 0;
  std::uint64_t check = 0;  ///< Hash of the following bytes.
};

struct Place {
  fs::path folder;  ///< Empty: nothing is stored.
  std::uint64_t builder = 0;
};

Place& ThePlace() {
  static Place place;
  return place;
}

fs::path FileOf(std::uint64_t source) {
  return ThePlace().folder / (std::to_string(source % kFiles) + ".mesh");
}

/// Adds the Recast library to a hash, because another version may build another mesh.
void AddRecast([[maybe_unused]] StateHash& hash) {
#ifdef __linux__
  Dl_info library{};
  if (dladdr(reinterpret_cast<void*>(&rcBuildRegions), &library) == 0 || library.dli_fname == nullptr) return;
  std::error_code error;
  hash.Add(static_cast<std::uint64_t>(fs::file_size(library.dli_fname, error)));
  hash.Add(static_cast<std::uint64_t>(fs::last_write_time(library.dli_fname, error).time_since_epoch().count()));
#endif
}

}  // namespace

void KeepNavigation(const fs::path& folder, std::string_view program) {
  StateHash hash;
  hash.Add(program);
  AddRecast(hash);
  ThePlace() = {folder, hash.value()};
}

std::optional<BuiltNavigation> FindKeptNavigation(std::uint64_t source) {
  if (ThePlace().folder.empty()) return std::nullopt;
  const std::optional<std::string> file = ReadText(FileOf(source));
  Head head;
  if (!file || file->size() < sizeof head || file->size() > sizeof head + kMostBytes) return std::nullopt;
  const Head expected;
  std::memcpy(&head, file->data(), sizeof head);
  const std::string_view data = std::string_view(*file).substr(sizeof head);
  if (head.magic != expected.magic || head.builder != ThePlace().builder || head.source != source ||
      head.tile_bytes > data.size() || head.triangles > data.size() / sizeof(Triangle) ||
      head.tile_bytes + head.triangles * sizeof(Triangle) != data.size() || head.check != CheckOfNavigation(data))
    return std::nullopt;
  return CopyNavigation(data, head.tile_bytes);
}

void KeepBuiltNavigation(std::uint64_t source, const BuiltNavigation& built) {
  if (ThePlace().folder.empty() || built.tile == nullptr) return;
  const auto tile_bytes = static_cast<std::size_t>(built.tile_size);
  std::string data(reinterpret_cast<const char*>(built.tile), tile_bytes);
  data.append(reinterpret_cast<const char*>(built.triangles.data()), built.triangles.size() * sizeof(Triangle));
  if (data.size() > kMostBytes) return;
  Head head;
  head.builder = ThePlace().builder;
  head.source = source;
  head.tile_bytes = tile_bytes;
  head.triangles = built.triangles.size();
  head.check = CheckOfNavigation(data);
  std::error_code error;
  fs::create_directories(ThePlace().folder, error);
  // Two programs may write at the same time: each writes a separate file, and the last one is kept.
  const fs::path whole = FileOf(source), half = fs::path(whole).concat("." + std::to_string(getpid()));
  std::ofstream out(half, std::ios::binary);
  out.write(reinterpret_cast<const char*>(&head), sizeof head);
  out.write(data.data(), static_cast<std::streamsize>(data.size()));
  out.close();
  if (out) fs::rename(half, whole, error);
  if (!out || error) fs::remove(half, error);
}

}  // namespace soarbox::world
