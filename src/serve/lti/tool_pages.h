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

/// The pages that a person sees after opening a link on a platform. Platforms may show them in a frame.
class ToolPages {
 public:
  explicit ToolPages(const PlatformFile& file);

  /// A page that describes a problem.
  serve::WebResponse Trouble(int status, const std::string& problem, const std::string& hint = {}) const;
  /// A page on which a teacher chooses a lesson for a course (Deep Linking). `sign` converts claims to a signed token.
  serve::WebResponse Choice(const Platform& platform, const Launch& launch, const std::vector<serve::Lesson>& lessons,
                            std::int64_t now_s, const std::function<std::string(const std::string&)>& sign) const;
  /// The JSON that Canvas reads when an administrator registers this server by its address.
  serve::WebResponse CanvasConfiguration() const;
  static serve::WebResponse Redirect(const std::string& url);

 private:
  serve::WebResponse Page(int status, const std::string& title, const std::string& html,
                          const std::string& form_action) const;

  std::string url_, framed_by_;
};

}  // namespace soarbox::lti
