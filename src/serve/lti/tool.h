// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <boost/asio/io_context.hpp>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/result.h"
#include "serve/class_list.h"
#include "serve/place_answers.h"
#include "serve/server_settings.h"

namespace soarbox::serve {
struct WebRequest;
class Work;
}  // namespace soarbox::serve

namespace soarbox::lti {

/// How scores of a course fare.
struct ScoreCount {
  int sent = 0, waiting = 0, refused = 0;
  std::string trouble = {};  ///< Of one that waits or was refused.
};

/// Lets learning platforms open lessons here, and sends them scores: the tool's side of LTI 1.3 with Assignment and
/// Grade Services and Deep Linking (docs/lti.md). It belongs to the thread of `io`.
class Tool {
 public:
  struct Uses {
    boost::asio::io_context& io;
    serve::Work& work;  ///< For the disk.
    const serve::Settings& settings;
    const serve::Catalog& catalog;
    serve::Places& places;
  };
  /// Reads the file that the settings name, and what is kept in the state folder. The error says what is wrong there,
  /// or that this program was built without LTI.
  static Result<std::unique_ptr<Tool>> Make(const Uses& uses);
  Tool() = default;
  virtual ~Tool() = default;
  Tool(const Tool&) = delete;
  Tool& operator=(const Tool&) = delete;

  using Done = std::function<void(serve::WebResponse)>;
  /// Answers a request for /lti/... All of it comes from strangers.
  virtual void Answer(const serve::WebRequest& request, const std::string& what, Done done) = 0;
  /// Call it every few seconds: reads the progress of learners in these places, sends scores, and renews keys.
  virtual void CleanUp(const std::vector<std::string>& running) = 0;

  /// The name by which browsers reach the server, as the file says.
  virtual std::string host() const = 0;
  /// The learner who owns this place; empty: no learner of a platform owns it.
  virtual std::string NameOf(std::string_view place) const = 0;
  /// The learners of the course with this key of its teachers; null: there is none.
  virtual const serve::ClassList* FindByKey(std::string_view key) const = 0;
  virtual std::vector<std::string> Places() const = 0;
  virtual ScoreCount ScoresOf(const serve::ClassList& course) const = 0;
};

}  // namespace soarbox::lti
