// SPDX-License-Identifier: BSD-2-Clause
#include "serve/place.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <map>
#include <set>
#include <system_error>
#include <utility>

#include "diagnostics/problem.h"
#include "diagnostics/read_text.h"
#include "serve/random_id.h"
#include "serve/zip.h"

namespace soarbox::serve {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostPathBytes = 200, kMostFolderDepth = 8;

std::int64_t SecondsOf(const fs::path& path) {
  std::error_code error;
  const fs::file_time_type when = fs::last_write_time(path, error);
  if (error) return 0;
  const auto system = std::chrono::file_clock::to_sys(when);
  return std::chrono::duration_cast<std::chrono::seconds>(system.time_since_epoch()).count();
}

bool IsName(std::string_view name) {
  return !name.empty() && name.front() != '.' && std::ranges::none_of(name, [](char c) {
    return static_cast<unsigned char>(c) < ' ' || c == '\\' || c == '/' || c == '\x7f';
  });
}

/// Whether the file, or one of the folders between `from` and it, is a symbolic link.
bool GoesThroughLink(const fs::path& from, const fs::path& file) {
  std::error_code error;
  fs::path at = from;
  for (const fs::path& part : file.lexically_relative(from)) {
    at /= part;
    if (fs::is_symlink(fs::symlink_status(at, error))) return true;
  }
  return false;
}

/// Writes a file with an unguessable name into the folder and returns its path. `is_synced`: the bytes are on the disk.
Result<fs::path> WritePart(const fs::path& folder, std::string_view bytes, bool is_synced) {
  std::error_code error;
  fs::create_directories(folder, error);
  fs::path part = folder / NewId();
  const int out = open(part.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, 0600);
  std::size_t written = 0;
  while (out >= 0 && written < bytes.size()) {
    const ssize_t put = write(out, bytes.data() + written, bytes.size() - written);
    if (put < 0 && errno == EINTR) continue;
    if (put <= 0) break;
    written += static_cast<std::size_t>(put);
  }
  const bool is_complete = out >= 0 && written == bytes.size() && (!is_synced || fsync(out) == 0);
  const int cause = errno;
  if (out >= 0) close(out);
  if (is_complete) return part;
  fs::remove(part, error);
  return NewProblem(std::string("the server cannot write: ") + std::strerror(cause),
                    "what was there before is still there; try again later");
}

Result<void> PutInPlace(const fs::path& part, const fs::path& file) {
  std::error_code error, ignored;
  fs::create_directories(file.parent_path(), error);
  if (!error) fs::rename(part, file, error);
  if (!error) return {};
  fs::remove(part, ignored);
  return NewProblem("the server cannot write " + file.filename().string() + ": " + error.message(),
                    "what was there before is still there; try again later");
}

/// Writes all pending data of the file system that contains this folder to the disk. Faster than fsync for many files.
void SyncAll(const fs::path& folder) {
  const int at = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (at < 0) return;
  syncfs(at);
  close(at);
}

/// Removes partial files that a killed server has left.
void RemoveOldParts(const fs::path& folder) {
  std::error_code error, ignored;
  const fs::file_time_type oldest = fs::file_time_type::clock::now() - std::chrono::hours(1);
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error))
    if (fs::last_write_time(it->path(), ignored) < oldest && !ignored) fs::remove(it->path(), ignored);
}

}  // namespace

Place::Place(std::string id, fs::path root, PlaceLimits limits)
    : id_(std::move(id)), root_(std::move(root)), limits_(limits) {}

Result<fs::path> Place::Find(std::string_view path) const {
  const auto refuse = [&](const char* why) {
    return NewProblem(std::string("this is not a name for a file here: ") + why,
                      "names have no dot at the beginning; / stands between folders");
  };
  if (path.empty() || path.size() > kMostPathBytes) return refuse("it is empty or too long");
  fs::path file = home();
  std::size_t depth = 0;
  for (std::size_t at = 0; at <= path.size();) {
    const std::size_t end = std::min(path.find('/', at), path.size());
    const std::string_view name = path.substr(at, end - at);
    if (!IsName(name) || ++depth > kMostFolderDepth) return refuse("a part of it cannot be used");
    file /= name;
    at = end + 1;
  }
  if (GoesThroughLink(home(), file)) return refuse("it leads out of the place");
  return file;
}

Place::Contents Place::Look() const {
  Contents contents;
  std::error_code error;
  for (fs::recursive_directory_iterator it(home(), error), end; !error && it != end; it.increment(error)) {
    const std::string name = it->path().filename().string();
    if (name.starts_with('.')) {
      it.disable_recursion_pending();
      continue;
    }
    std::error_code ignored;
    const std::string path = it->path().lexically_relative(home()).generic_string();
    if (!it->is_symlink(ignored) && it->is_regular_file(ignored))
      contents.files.push_back({path, it->file_size(ignored)});
    if (!it->is_symlink(ignored) && it->is_directory(ignored)) contents.folders.push_back(path);
    // Stops at far more files than a place may contain. Something else must have created them.
    if (contents.files.size() + contents.folders.size() > 4 * (limits_.files + limits_.folders)) break;
  }
  std::ranges::sort(contents.files, {}, &PlaceFile::path);
  std::ranges::sort(contents.folders);
  return contents;
}

Result<void> Place::HasRoomFor(const std::vector<PlaceFile>& wanted) const {
  const Contents there = Look();
  std::map<std::string, std::uintmax_t> files;
  std::set<std::string> folders(there.folders.begin(), there.folders.end());
  for (const PlaceFile& file : there.files) files[file.path] = file.bytes;
  for (const PlaceFile& file : wanted) {
    files[file.path] = file.bytes;
    for (std::size_t at = file.path.find('/'); at != std::string::npos; at = file.path.find('/', at + 1))
      folders.insert(file.path.substr(0, at));
  }
  std::uintmax_t sum = 0;
  for (const auto& [path, bytes] : files) sum += bytes;
  if (sum <= limits_.bytes && files.size() <= limits_.files && folders.size() <= limits_.folders) return {};
  return NewProblem("there is no room for this file: a place holds " + std::to_string(limits_.files) + " files, " +
                        std::to_string(limits_.folders) + " folders and " + std::to_string(limits_.bytes >> 20) + " MB",
                    "remove what you do not need");
}

std::vector<PlaceRecording> Place::Recordings() const {
  std::vector<PlaceRecording> recordings;
  std::error_code error;
  for (fs::directory_iterator it(state() / "soarbox" / "recordings", error), end; !error && it != end;
       it.increment(error)) {
    std::error_code ignored;
    if (it->path().extension() == ".soarrec" && it->is_regular_file(ignored))
      recordings.push_back({it->path().filename().string(), it->file_size(ignored), SecondsOf(it->path())});
  }
  std::ranges::sort(recordings, {}, &PlaceRecording::name);
  return recordings;
}

Result<fs::path> Place::FindRecording(std::string_view name) const {
  for (const PlaceRecording& recording : Recordings())
    if (recording.name == name) return state() / "soarbox" / "recordings" / recording.name;
  return NewProblem("there is no recording '" + std::string(name) + "' here");
}

Result<std::string> Place::Read(std::string_view path) const {
  const Result<fs::path> file = Find(path);
  if (!file) return file.error();
  std::optional<std::string> text = ReadText(*file);
  if (!text) return NewProblem("there is no file '" + std::string(path) + "' here");
  return *std::move(text);
}

Result<void> Place::Write(std::string_view path, std::string_view bytes) {
  const Result<fs::path> file = Find(path);
  if (!file) return file.error();
  if (const Result<void> room = HasRoomFor({{std::string(path), bytes.size()}}); !room) return room;
  std::error_code error;
  if (fs::is_directory(*file, error)) return NewProblem("there is a folder of this name");
  RemoveOldParts(parts());
  const Result<fs::path> part = WritePart(parts(), bytes, true);
  return part ? PutInPlace(*part, *file) : part.error();
}

Result<void> Place::Remove(std::string_view path) {
  const Result<fs::path> file = Find(path);
  if (!file) return file.error();
  std::error_code error;
  if (!fs::is_regular_file(*file, error) || !fs::remove(*file, error))
    return NewProblem("there is no file '" + std::string(path) + "' here");
  // A folder that is not empty cannot be removed, which ends the loop.
  for (fs::path folder = file->parent_path(); folder != home() && rmdir(folder.c_str()) == 0;)
    folder = folder.parent_path();
  return {};
}

Result<std::string> Place::Zip() const {
  std::vector<ZipEntry> entries;
  for (const PlaceFile& file : Files()) {
    Result<std::string> bytes = Read(file.path);
    if (!bytes) return bytes.error();
    entries.push_back({file.path, *std::move(bytes)});
  }
  return Result<std::string>(WriteZip(entries));
}

Result<std::size_t> Place::Unzip(std::string_view archive) {
  Result<std::vector<ZipEntry>> entries = ReadZip(archive, limits_.files, limits_.bytes);
  if (!entries) return entries.error();
  // All names are checked before anything is written.
  for (const ZipEntry& entry : *entries)
    if (const Result<fs::path> file = Find(entry.path); !file)
      return ProblemIn(entry.path, file.error().message, file.error().hint);
  std::vector<PlaceFile> wanted;
  for (const ZipEntry& entry : *entries) wanted.push_back({entry.path, entry.bytes.size()});
  if (const Result<void> room = HasRoomFor(wanted); !room) return room.error();
  RemoveOldParts(parts());
  std::vector<fs::path> written;
  Result<void> result;
  for (const ZipEntry& entry : *entries) {
    Result<fs::path> part = WritePart(parts(), entry.bytes, false);
    if (!part) {
      result = ProblemIn(entry.path, part.error().message, part.error().hint);
      break;
    }
    written.push_back(*std::move(part));
  }
  if (result) SyncAll(parts());
  // Each file is completely on the disk before it replaces another one.
  for (std::size_t i = 0; i < written.size(); ++i) {
    std::error_code ignored;
    const ZipEntry& entry = (*entries)[i];
    if (!result) {
      fs::remove(written[i], ignored);
    } else if (const Result<void> put = PutInPlace(written[i], *Find(entry.path)); !put) {
      result = ProblemIn(entry.path, put.error().message, put.error().hint);
    }
  }
  if (!result) return result.error();
  return entries->size();
}

Result<Place> Places::New() {
  const std::string id = NewId();
  std::error_code error;
  fs::create_directories(folder_ / id / "home", error);
  if (!error) fs::create_directories(folder_ / id / "state", error);
  if (error)
    return NewProblem("the server cannot make a place for you: " + error.message(), "ask the server's administrator");
  fs::permissions(folder_ / id, fs::perms::owner_all, error);
  return Place(id, folder_ / id, limits_);
}

Result<Place> Places::Find(std::string_view id) const {
  std::error_code error;
  // The id is the secret. The time that the file system takes for a lookup does not help to guess it.
  if (!IsId(id) || !fs::is_directory(folder_ / id / "home", error))
    return NewProblem("there is no such place: it was never made, or was not visited for too long",
                      "open this server's first page to get a new one");
  fs::last_write_time(folder_ / id, fs::file_time_type::clock::now(), error);
  return Place(std::string(id), folder_ / id, limits_);
}

void Places::RemoveOlderThan(int days, const std::vector<std::string>& kept) const {
  std::error_code error;
  const fs::file_time_type oldest = fs::file_time_type::clock::now() - std::chrono::hours(24) * days;
  std::vector<fs::path> old;
  for (fs::directory_iterator it(folder_, error), end; !error && it != end; it.increment(error)) {
    std::error_code ignored;
    const std::string id = it->path().filename().string();
    if (IsId(id) && std::ranges::find(kept, id) == kept.end() && fs::last_write_time(it->path(), ignored) < oldest &&
        !ignored)
      old.push_back(it->path());
  }
  for (const fs::path& place : old) fs::remove_all(place, error);
}

}  // namespace soarbox::serve
