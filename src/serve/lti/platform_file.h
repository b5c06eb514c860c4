// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/result.h"

namespace soarbox::lti {

/// A learning platform, such as a Moodle, in which Soarbox is registered as a tool.
struct Platform {
  std::string name;                      ///< For people.
  std::string issuer, client_id;         ///< Together they identify a registration.
  std::string auth_url;                  ///< Address to which browsers are sent to log in.
  std::string token_url, jwks_url;       ///< Addresses for access tokens, and for the platform's public keys.
  std::string audience;                  ///< Audience of the assertions sent to token_url; usually the same address.
  std::vector<std::string> deployments;  ///< Ids of the deployments that are accepted.
};

/// The contents of the file of `soarbox serve --lti FILE` (docs/lti.md).
struct PlatformFile {
  std::string url;  ///< Address of this server for browsers: "https://soar.example", without a slash at the end.
  std::vector<Platform> platforms;

  /// The platform with this issuer and client id; null if there is none. An empty client id matches any, but the result
  /// is null if the issuer has several platforms.
  const Platform* Find(std::string_view issuer, std::string_view client_id) const;
};

/// Reads the JSON file. The error names the file, the platform and the field.
Result<PlatformFile> ReadPlatformFile(const std::filesystem::path& file);

}  // namespace soarbox::lti
