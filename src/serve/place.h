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

/// A file of a place, with "/" as the separator.
struct PlaceFile {
  std::string path;
  std::uintmax_t bytes = 0;
};
struct PlaceRecording {
  std::string name;
  std::uintmax_t bytes = 0;
  std::int64_t when_s = 0;  ///< Modification time, in seconds since 1970.
};

/// Limits of a place.
struct PlaceLimits {
  std::size_t files = 256;
  std::size_t folders = 256;
  std::uintmax_t bytes = 4u << 20;  ///< Total size of all files, without recordings, which have their own limits.
};

/// The folder of one user: files, progress in lessons, drafts and recordings. Anyone who has its id may do everything
/// in it. Paths come from untrusted users; they cannot refer to anything outside.
class Place {
 public:
  Place(std::string id, std::filesystem::path root, PlaceLimits limits);

  const std::string& id() const { return id_; }
  /// The folder that contains all its data.
  const std::filesystem::path& root() const { return root_; }
  /// The user's own files. Processes for this place have it as their home.
  std::filesystem::path home() const { return root_ / "home"; }
  /// The state that programs store for the user: $XDG_STATE_HOME of such processes.
  std::filesystem::path state() const { return root_ / "state"; }

  std::vector<PlaceFile> Files() const { return Look().files; }
  std::vector<PlaceRecording> Recordings() const;
  Result<std::string> Read(std::string_view path) const;
  /// Writes a file atomically.
  Result<void> Write(std::string_view path, std::string_view bytes);
  /// Removes a file, and folders that become empty.
  Result<void> Remove(std::string_view path);
  /// The path of a recording by its name. Fails if there is none.
  Result<std::filesystem::path> FindRecording(std::string_view name) const;

  /// Zip returns all files as a zip archive. Unzip adds the files of an archive; they replace files of the same names.
  Result<std::string> Zip() const;
  Result<std::size_t> Unzip(std::string_view archive);

 private:
  struct Contents {
    std::vector<PlaceFile> files;
    std::vector<std::string> folders;  ///< With "/" as the separator, sorted.
  };
  Contents Look() const;
  /// Fails if there is not enough room for all of these files.
  Result<void> HasRoomFor(const std::vector<PlaceFile>& wanted) const;
  /// Folder for incomplete files. On the same disk as the place, but not visible to the user.
  std::filesystem::path parts() const { return root_ / "parts"; }
  /// The path below home. Fails if it is invalid.
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
  /// Fails if there is no place with this id. Counts as a visit.
  Result<Place> Find(std::string_view id) const;
  /// Removes places that were not visited for `days` days, except those in `kept`.
  void RemoveOlderThan(int days, const std::vector<std::string>& kept) const;

 private:
  std::filesystem::path folder_;
  PlaceLimits limits_;
};

}  // namespace soarbox::serve
