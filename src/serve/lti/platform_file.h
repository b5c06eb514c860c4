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
  std::string auth_url;                  ///< Where a browser proves who sits at it.
  std::string token_url, jwks_url;       ///< Where this server gets access tokens and the platform's keys.
  std::string audience;                  ///< Of our assertions at token_url; usually the same address.
  std::vector<std::string> deployments;  ///< Ids of those that are accepted.
};

/// What the file of `soarbox serve --lti FILE` says (docs/lti.md).
struct PlatformFile {
  std::string url;  ///< Of this server, as browsers reach it: "https://soar.example", without a slash at the end.
  std::vector<Platform> platforms;

  /// The platform with this issuer and client id; null: none. An empty client id fits if the issuer has one platform.
  const Platform* Find(std::string_view issuer, std::string_view client_id) const;
};

/// Reads the JSON file. The error names the file, the platform and the field.
Result<PlatformFile> ReadPlatformFile(const std::filesystem::path& file);

}  // namespace soarbox::lti
