// SPDX-License-Identifier: BSD-2-Clause
#include "serve/static_files.h"

#include <functional>
#include <system_error>
#include <utility>

#include "diagnostics/problem.h"
#include "diagnostics/read_text.h"
#include "serve/zip.h"

namespace soarbox::serve {
namespace {

namespace fs = std::filesystem;

std::string TypeOf(const std::string& extension) {
  static const std::map<std::string, std::string> kTypes = {
      {".html", "text/html; charset=utf-8"},
      {".js", "text/javascript; charset=utf-8"},
      {".css", "text/css; charset=utf-8"},
      {".json", "application/json"},
      {".svg", "image/svg+xml"},
      {".png", "image/png"},
      {".glb", "model/gltf-binary"},
      {".woff2", "font/woff2"},
      {".txt", "text/plain; charset=utf-8"},
  };
  const auto found = kTypes.find(extension);
  return found != kTypes.end() ? found->second : "application/octet-stream";
}

}  // namespace

Result<StaticFiles> StaticFiles::Read(const fs::path& folder) {
  StaticFiles read;
  std::error_code error;
  for (fs::recursive_directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    std::error_code ignored;
    if (!it->is_regular_file(ignored)) continue;
    std::optional<std::string> bytes = ReadText(it->path());
    if (!bytes) continue;
    File file;
    file.type = TypeOf(it->path().extension().string());
    file.tag = "\"" + std::to_string(std::hash<std::string>{}(*bytes)) + "\"";
    file.gzipped = Deflate(*bytes, DeflateAs::kGzip);
    if (file.gzipped.size() >= bytes->size()) file.gzipped.clear();
    file.bytes = *std::move(bytes);
    read.files_.emplace(it->path().lexically_relative(folder).generic_string(), std::move(file));
  }
  if (read.Find("index.html") == nullptr)
    return ProblemIn(folder, "the page is not built",
                     "in the source folder, ./dev serve builds it and starts the server, and ./dev package packs it");
  return read;
}

const StaticFiles::File* StaticFiles::Find(std::string_view path) const {
  const auto found = files_.find(path);
  return found == files_.end() ? nullptr : &found->second;
}

}  // namespace soarbox::serve
