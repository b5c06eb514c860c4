// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/result.h"

namespace soarbox::serve {

/// A file of a place, with "/" between folders.
struct PlaceFile {
  std::string path;
  std::uintmax_t bytes = 0;
};
struct PlaceRecording {
  std::string name;
  std::uintmax_t bytes = 0;
  std::int64_t when_s = 0;  ///< Since 1970, when it was written last.
};

/// How much a place may hold.
struct PlaceLimits {
  std::size_t files = 256;
  std::size_t folders = 256;
  std::uintmax_t bytes = 4u << 20;  ///< Of all files together; recordings have limits of their own.
};

/// Where one person works: files, progress of lessons, drafts and recordings, below one folder. Whoever knows its id
/// may do all that can be done there. Paths come from strangers: they can name nothing outside.
class Place {
 public:
  Place(std::string id, std::filesystem::path root, PlaceLimits limits);

  const std::string& id() const { return id_; }
  /// All that belongs to it is below this folder.
  const std::filesystem::path& root() const { return root_; }
  /// The person's own files: what a process that works for the place has for its home.
  std::filesystem::path home() const { return root_ / "home"; }
  /// What programs note for the person: $XDG_STATE_HOME of such a process.
  std::filesystem::path state() const { return root_ / "state"; }

  std::vector<PlaceFile> Files() const { return Look().files; }
  std::vector<PlaceRecording> Recordings() const;
  Result<std::string> Read(std::string_view path) const;
  /// Writes it whole, then puts it in its place.
  Result<void> Write(std::string_view path, std::string_view bytes);
  /// Removes a file, and the folders that are empty without it.
  Result<void> Remove(std::string_view path);
  /// A recording by its name alone; the error says that there is none.
  Result<std::filesystem::path> FindRecording(std::string_view name) const;

  /// All files as a zip archive, and the files of such an archive, which take the place of those of the same names.
  Result<std::string> Zip() const;
  Result<std::size_t> Unzip(std::string_view archive);

 private:
  struct Contents {
    std::vector<PlaceFile> files;
    std::vector<std::string> folders;  ///< With "/" between them, sorted.
  };
  Contents Look() const;
  /// Whether there is room for all of these at once.
  Result<void> HasRoomFor(const std::vector<PlaceFile>& wanted) const;
  /// Where files lie until they are complete. On the disk of the place, but outside of what a person sees.
  std::filesystem::path parts() const { return root_ / "parts"; }
  /// Below home; the error says what is wrong with the path.
  Result<std::filesystem::path> Find(std::string_view path) const;

  std::string id_;
  std::filesystem::path root_;
  PlaceLimits limits_;
};

/// All places below a folder.
class Places {
 public:
  Places(std::filesystem::path folder, PlaceLimits limits) : folder_(std::move(folder)), limits_(limits) {}

  Result<Place> New();
  /// The error says that no place has this id. Counts as a visit.
  Result<Place> Find(std::string_view id) const;
  /// Removes those that nobody has visited for so many days, but for those that are named.
  void RemoveOlderThan(int days, const std::vector<std::string>& kept) const;

 private:
  std::filesystem::path folder_;
  PlaceLimits limits_;
};

}  // namespace soarbox::serve
