// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "serve/lti/launch.h"
#include "serve/lti/platform_file.h"
#include "serve/place_answers.h"
#include "serve/server_settings.h"

namespace soarbox::lti {

/// The pages of this server that a person sees on the way from a platform. Platforms may show them in a frame.
class ToolPages {
 public:
  explicit ToolPages(const PlatformFile& file);

  /// Says what went wrong.
  serve::WebResponse Trouble(int status, const std::string& problem, const std::string& hint = {}) const;
  /// Lets a teacher choose a lesson for a course (Deep Linking). `sign` makes a token of claims.
  serve::WebResponse Choice(const Platform& platform, const Launch& launch, const std::vector<serve::Lesson>& lessons,
                            std::int64_t now_s, const std::function<std::string(const std::string&)>& sign) const;
  /// What Canvas reads when an administrator registers this server by its address.
  serve::WebResponse CanvasConfiguration() const;
  static serve::WebResponse Redirect(const std::string& url);

 private:
  serve::WebResponse Page(int status, const std::string& title, const std::string& html,
                          const std::string& form_action) const;

  std::string url_, framed_by_;
};

}  // namespace soarbox::lti
