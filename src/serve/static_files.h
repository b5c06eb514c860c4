// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include "diagnostics/result.h"

namespace soarbox::serve {

/// The files of the built page. They are read and compressed once.
class StaticFiles {
 public:
  struct File {
    std::string type;  ///< "text/css; charset=utf-8"
    std::string bytes;
    std::string gzipped;  ///< Empty if compression does not make it smaller.
    std::string tag;      ///< Changes with the content.
  };
  /// Fails if the page was not built.
  static Result<StaticFiles> Read(const std::filesystem::path& folder);
  /// Finds a file by its path relative to the folder, "assets/page.js"; null if there is none.
  const File* Find(std::string_view path) const;

 private:
  std::map<std::string, File, std::less<>> files_;
};

}  // namespace soarbox::serve
