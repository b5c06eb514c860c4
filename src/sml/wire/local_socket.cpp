// SPDX-License-Identifier: BSD-2-Clause
#include "sml/wire/local_socket.h"

#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstdlib>

namespace soarbox::wire {

namespace {

std::optional<std::pair<unsigned long long, unsigned long long>> IdentityOf(const std::string& path) {
  struct stat found {};
  if (lstat(path.c_str(), &found) != 0 || !S_ISSOCK(found.st_mode)) return std::nullopt;
  return std::pair<unsigned long long, unsigned long long>(found.st_dev, found.st_ino);
}

/// Whether it is a folder of this user that no other user can access.
bool IsPrivateFolder(const std::string& path) {
  struct stat found {};
  if (lstat(path.c_str(), &found) != 0) return false;
  return S_ISDIR(found.st_mode) && found.st_uid == geteuid() && (found.st_mode & 077) == 0;
}

}  // namespace

std::string LocalSocketPath(long long port) {
  const char* home = std::getenv("HOME");
  if (home == nullptr || *home != '/') return {};
  std::string path = std::string(home) + "/.soartmp/" + std::to_string(port);
  if (path.size() >= sizeof(sockaddr_un::sun_path)) path.clear();
  return path;
}

bool LocalSocketFile::Prepare(const std::string& path) {
  const std::string folder = path.substr(0, path.rfind('/'));
  mkdir(folder.c_str(), 0700);
  if (!IsPrivateFolder(folder)) return false;
  struct stat found {};
  if (lstat(path.c_str(), &found) != 0) return true;
  // Only sockets are removed: any other file may be important.
  return S_ISSOCK(found.st_mode) && unlink(path.c_str()) == 0;
}

LocalSocketFile::LocalSocketFile(std::string path) : path_(std::move(path)), identity_(IdentityOf(path_)) {}

LocalSocketFile::~LocalSocketFile() {
  if (identity_ && IdentityOf(path_) == identity_) unlink(path_.c_str());
}

}  // namespace soarbox::wire
