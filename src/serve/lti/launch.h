// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string>

#include "diagnostics/result.h"
#include "serve/lti/platform_file.h"

namespace soarbox::lti {

/// The data that a platform sends when a user follows one of its links to Soarbox (LTI 1.3), after all checks.
struct Launch {
  std::string deployment;            ///< Of Soarbox on the platform.
  std::string subject;               ///< The person, by the platform's id.
  std::string name;                  ///< Empty: the platform does not share it.
  std::string course, course_title;  ///< The course by its id; empty: the link is in none.
  bool is_teacher = false;           ///< Of this course.
  std::string lesson, world;         ///< From the link's custom parameters `lesson` and `world`, or its address.
  std::string line_item;             ///< Where scores go; empty: the platform wants none.
  bool chooses = false;              ///< A teacher chooses a lesson (deep linking).
  std::string return_url, data;      ///< Where the choice goes, and what goes back with it.
  bool may_choose_many = false;
};

/// Checks the claims of a token whose signature is right: issuer, audience, time, nonce, deployment, version and kind
/// of message. `nonce` is the one that was sent, `now_s` seconds since 1970. The error says which check failed.
Result<Launch> ReadLaunch(const std::string& claims, const Platform& platform, const std::string& nonce,
                          std::int64_t now_s);

}  // namespace soarbox::lti
