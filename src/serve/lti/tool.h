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

/// Numbers of scores of a course by their state.
struct ScoreCount {
  int sent = 0, waiting = 0, refused = 0;
  std::string trouble = {};  ///< Why a score waits or was refused, for one of these.
};

/// Lets learning platforms open lessons on this server, and sends them scores: the tool's side of LTI 1.3 with
/// Assignment and Grade Services and Deep Linking (docs/lti.md). Used only on the thread of `io`.
class Tool {
 public:
  struct Uses {
    boost::asio::io_context& io;
    serve::Work& work;  ///< For the disk.
    const serve::Settings& settings;
    const serve::Catalog& catalog;
    serve::Places& places;
  };
  /// Reads the file that the settings name, and the data in the state folder. Fails if one of them is invalid, or if
  /// this program was built without LTI.
  static Result<std::unique_ptr<Tool>> Make(const Uses& uses);
  Tool() = default;
  virtual ~Tool() = default;
  Tool(const Tool&) = delete;
  Tool& operator=(const Tool&) = delete;

  using Done = std::function<void(serve::WebResponse)>;
  /// Answers a request for /lti/`what`. The request is not trusted.
  virtual void Answer(const serve::WebRequest& request, const std::string& what, Done done) = 0;
  /// Call it every few seconds. `running`: the places that have a run. Reads the progress of learners whose places have
  /// a run, or had one or were opened since the last call; sends scores; renews keys.
  virtual void CleanUp(const std::vector<std::string>& running) = 0;

  /// The host name of the server's address in the file.
  virtual std::string host() const = 0;
  /// The learner who owns this place; empty: no learner of a platform owns it.
  virtual std::string NameOf(std::string_view place) const = 0;
  /// The learners of the course with this key of its teachers; null: there is none.
  virtual const serve::ClassList* FindByKey(std::string_view key) const = 0;
  virtual std::vector<std::string> Places() const = 0;
  virtual ScoreCount ScoresOf(const serve::ClassList& course) const = 0;
};

}  // namespace soarbox::lti
