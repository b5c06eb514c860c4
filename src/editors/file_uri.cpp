// SPDX-License-Identifier: BSD-2-Clause
#include "editors/file_uri.h"

#include <cctype>

#include "bytes/percent_code.h"

namespace soarbox::editors {
std::filesystem::path PathOfUri(std::string_view uri) {
  constexpr std::string_view kScheme = "file://";
  if (!uri.starts_with(kScheme)) return {};
  uri.remove_prefix(kScheme.size());
  const std::size_t slash = uri.find('/');  // A host may precede it.
  if (slash == std::string_view::npos) return {};
  uri.remove_prefix(slash);
  const std::string path = PercentDecoded(uri);
  if (path.find('\0') != std::string::npos) return {};
  return std::filesystem::path(path).lexically_normal();
}

std::string UriOf(const std::filesystem::path& path) {
  std::string uri = "file://";
  for (const char c : path.string()) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80 && (std::isalnum(byte) != 0 || std::string_view("/-_.~*+").find(c) != std::string_view::npos)) {
      uri += c;
    } else {
      AppendPercentCode(uri, c);
    }
  }
  return uri;
}

}  // namespace soarbox::editors
