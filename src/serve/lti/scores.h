// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "diagnostics/result.h"
#include "serve/lti/platform_file.h"

namespace soarbox::lti {

/// A token that lets this server use the services of a platform.
struct AccessToken {
  std::string text;         ///< Empty if there is no token.
  std::int64_t ends_s = 0;  ///< When it expires, in seconds since 1970.
};

/// Signs the claims of an assertion; empty: there is no key.
using Sign = std::function<std::string(const std::string& claims)>;

/// One score, for the Assignment and Grade Services.
struct Score {
  std::string line_item, subject, comment;
  bool is_passed = false;
  std::int64_t graded_ms = 0;  ///< Since 1970.
};
struct Sent {
  enum class How : std::uint8_t {
    kDone,
    kLater,    ///< The platform or the network failed: try again later.
    kRefused,  ///< The platform refused it: trying again is useless.
  };
  How how = How::kDone;
  std::string trouble = {};
};

/// "2026-11-29T22:00:00.000Z".
std::string TimeText(std::int64_t ms_since_1970);

/// Sends scores to a platform, one after another. Gets a new access token first if `token` has expired. Blocks until
/// the answers have come. After a failure of the network, the remaining scores are not sent. Returns a result for each
/// score.
std::vector<Sent> SendScores(const Platform& platform, AccessToken& token, const std::vector<Score>& scores,
                             const Sign& sign, const std::function<std::int64_t()>& now_s,
                             const std::atomic<bool>& stop);

}  // namespace soarbox::lti
