// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <boost/asio/io_context.hpp>
#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "serve/class_desk.h"
#include "serve/class_list.h"
#include "serve/class_tournaments.h"
#include "serve/lti/tool.h"
#include "serve/page_session.h"
#include "serve/place_answers.h"
#include "serve/server_settings.h"
#include "serve/static_files.h"
#include "serve/watch_links.h"
#include "serve/work.h"

namespace soarbox::serve {

/// An HTTP request, reduced to what the site needs. All fields come from untrusted clients.
struct WebRequest {
  std::string method, target;
  std::string host, origin, authorization, protocols, tag, cookies;
  bool takes_gzip = false;
  std::string body;
  std::string address;  ///< Address of the client.
};
/// What a server offers, independent of the transport: places, files, the class, runs. It belongs to one thread. Slow
/// work is done on other threads (work.h), and the answer comes later.
class Site {
 public:
  static Result<std::unique_ptr<Site>> Make(boost::asio::io_context& io, Settings settings,
                                            std::unique_ptr<const Catalog> catalog);

  using Done = std::function<void(WebResponse)>;
  void Answer(const WebRequest& request, Done done);
  /// Whether a place and an address may cause more work now. Charge records what they have caused (Costs in work.h).
  bool MayBegin(const std::string& place, const std::string& address);
  void Charge(const std::string& place, const std::string& address, double points);

  /// The result of a page's request to connect to a run.
  struct Admission {
    std::shared_ptr<Session> session;  ///< Null if it is refused; `refusal` then contains the response.
    bool may_ask = false;
    std::string protocol;  ///< The protocol that the server must name; empty: none.
    std::string address, tab = {};
    WebResponse refusal;
  };
  void Admit(const WebRequest& request, std::function<void(Admission)> done);

  /// Removes expired data. Call it periodically.
  void CleanUp();
  /// Whether a page was connected and none is any more.
  bool WasLeft() const;
  void EndAll(const std::string& why);
  const Settings& settings() const { return settings_; }
  const ClassList& learners() const { return class_; }

 private:
  using Clock = std::chrono::steady_clock;
  Site(boost::asio::io_context& io, Settings settings, std::unique_ptr<const Catalog> catalog, StaticFiles files)
      : io_(io),
        settings_(std::move(settings)),
        catalog_(std::move(catalog)),
        files_(std::move(files)),
        places_(settings_.state / "places", settings_.limits.place),
        watch_links_(settings_.state / "watch"),
        work_(io) {}

  /// Returns false, with a response, if the request does not come from a page of this server, or from an unauthorized
  /// user.
  bool IsWelcome(const WebRequest& request, WebResponse& refusal);
  bool HasToken(const WebRequest& request, WebResponse& refusal);
  bool IsOurHost(std::string_view host) const;
  WebResponse Page(const WebRequest& request, std::string_view path) const;
  void AnswerApi(const WebRequest& request, const std::vector<std::string>& parts, Done done);
  void NewPlace(const WebRequest& request, Done done);
  void AnswerPlace(const WebRequest& request, const std::vector<std::string>& parts, Done done);
  /// `what`: "embed" for the page to be shown in a frame of another site; "embed.js" for the script that such a site
  /// includes.
  WebResponse Embedded(const WebRequest& request, const std::string& what) const;
  /// Answers a request for /lti/.
  void AnswerPlatform(const WebRequest& request, const std::vector<std::string>& parts, Done done);
  /// The name of the learner of a class or course who owns this place; empty: it has no owner.
  std::string LearnerOf(std::string_view place) const;
  /// The class or course whose teachers have this key; null: there is none.
  const ClassList* ClassOf(std::string_view key) const;
  /// Answers requests that need the key of a class (site_class.cpp).
  void AnswerClass(const WebRequest& request, const std::vector<std::string>& parts, Done done);
  void AnswerTable(const ClassList& list, const std::string& form, Done done);
  /// Answers requests of a learner about the raised hand, read messages and the arena.
  void AnswerLearner(const WebRequest& request, const std::vector<std::string>& parts, Done done);
  void HandIn(const std::string& game, const std::string& place, const std::string& body, Done done);
  WebResponse WriteNote(const ClassList& list, const std::string& body);
  std::filesystem::path DeskFile() const { return settings_.state / "class_desk.json"; }
  void SaveDesk();
  /// Sends the present messages and hand to the learner's pages.
  void GreetAgain(const std::string& place);
  /// AnswerWatchLink creates the link with which others can watch a place's run; AnswerWatch resolves such a link.
  void AnswerWatchLink(const WebRequest& request, const std::string& place, Done done);
  void AnswerWatch(const std::string& link, Done done);
  /// Executes a job on a thread of the pool, after the earlier jobs of the same line.
  void Do(const std::string& line, std::function<WebResponse()> job, Done done);
  /// What a user of the class does now, by place.
  struct Doing {
    std::string what;
    bool is_watched = false;
    Activity::Standing standing = {};
    std::optional<std::int64_t> hand_since = {};
    std::vector<ClassDesk::Note> notes = {};
  };
  WebResponse Table(const ClassList& list, const lti::ScoreCount& scores,
                    const std::map<std::string, Doing>& doing) const;
  WebResponse TableAsCsv(const ClassList& list, bool is_long) const;
  std::shared_ptr<Session> SessionOf(const Place& place, const std::string& address);
  Result<void> MayStart(const Session& session) const;

  boost::asio::io_context& io_;
  Settings settings_;
  std::unique_ptr<const Catalog> catalog_;
  StaticFiles files_;
  Places places_;
  WatchLinks watch_links_;
  ClassList class_;
  ClassDesk desk_;
  bool was_visited_ = false;
  std::map<std::string, std::shared_ptr<Session>, std::less<>> sessions_;  ///< By place.
  /// Number of times that an address did something since `since`.
  struct Count {
    Clock::time_point since;
    std::size_t count = 0;
  };
  bool IsOver(std::map<std::string, Count>& counts, const std::string& address, std::size_t most,
              std::chrono::seconds window);
  std::map<std::string, Count> wrong_tokens_, new_places_;
  // Limits of processor time: a tenth of a core per place, half a core per address.
  Costs place_costs_{100, 1'000}, address_costs_{500, 5'000};
  std::unique_ptr<Arena> arena_;
  std::unique_ptr<lti::Tool> lti_;  ///< Null: no learning platform may open lessons here.
  Work work_;                       ///< Last: its jobs use all of the above.
};

}  // namespace soarbox::serve
