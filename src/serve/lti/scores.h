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

/// What lets this server use the services of a platform, until then.
struct AccessToken {
  std::string text;  ///< Empty: none.
  std::int64_t ends_s = 0;
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
    kLater,    ///< The platform or the network fails; try again.
    kRefused,  ///< The platform does not want it; trying again is of no use.
  };
  How how = How::kDone;
  std::string trouble = {};
};

/// "2026-11-29T22:00:00.000Z".
std::string TimeText(std::int64_t ms_since_1970);

/// Sends scores to a platform, one after another, and gets an access token before if `token` has ended. Waits for the
/// answers: call it on a thread that may. After a failure of the network the rest is not tried.
std::vector<Sent> SendScores(const Platform& platform, AccessToken& token, const std::vector<Score>& scores,
                             const Sign& sign, const std::function<std::int64_t()>& now_s,
                             const std::atomic<bool>& stop);

}  // namespace soarbox::lti
