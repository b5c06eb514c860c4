// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string>

#include "diagnostics/result.h"
#include "serve/lti/platform_file.h"

namespace soarbox::lti {

/// The data that a platform sends when a user follows one of its links to Soarbox (LTI 1.3), after all checks.
struct Launch {
  std::string deployment;            ///< Id of the deployment of Soarbox on the platform.
  std::string subject;               ///< The platform's id of the person.
  std::string name;                  ///< Name of the person; empty if the platform does not share it.
  std::string course, course_title;  ///< Id and title of the course; empty if the link is in no course.
  bool is_teacher = false;           ///< The person teaches in this course.
  std::string lesson, world;         ///< From the link's custom parameters `lesson` and `world`, or its address.
  std::string line_item;             ///< Address for scores; empty if the platform accepts none.
  bool chooses = false;              ///< The person is to choose a lesson for the course (Deep Linking).
  std::string return_url, data;      ///< For Deep Linking: the address for the choice, and data to send back with it.
  bool may_choose_many = false;
};

/// Checks the claims of a token with a valid signature: issuer, audience, time, nonce, deployment, version and kind of
/// message. `nonce`: the one that this server sent; `now_s`: seconds since 1970. The error says which check failed.
Result<Launch> ReadLaunch(const std::string& claims, const Platform& platform, const std::string& nonce,
                          std::int64_t now_s);

}  // namespace soarbox::lti
