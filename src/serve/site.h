// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <boost/asio/io_context.hpp>
#include <chrono>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "serve/class_list.h"
#include "serve/session.h"
#include "serve/settings.h"
#include "serve/static_files.h"

namespace soarbox::serve {

/// A request over HTTP, as far as the site needs it. All of it comes from strangers.
struct WebRequest {
  std::string method, target;
  std::string host, origin, authorization, protocols, tag;
  bool takes_gzip = false;
  std::string body;
  std::string address;  ///< Who asks.
};
struct WebResponse {
  int status = 200;
  std::string type = "application/json";
  std::string body;
  std::vector<std::pair<std::string, std::string>> headers;
};

/// What a server offers, whatever the transport: places, files, the class, runs. One thread.
class Site {
 public:
  static Result<std::unique_ptr<Site>> Make(boost::asio::io_context& io, Settings settings,
                                            std::unique_ptr<const Catalog> catalog);

  WebResponse Answer(const WebRequest& request);

  /// Whether a page may see the run that it asks for.
  struct Admission {
    std::shared_ptr<Session> session;  ///< Null: it may not; then the response says why.
    bool may_ask = false;
    std::string protocol;  ///< Which the server has to name; empty: none.
    WebResponse refusal;
  };
  Admission Admit(const WebRequest& request);

  /// Call it once in a while: removes what nobody needs any more.
  void CleanUp();
  /// Whether a page was there and none is any more.
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
        places_(settings_.state / "places", settings_.limits.place) {}

  /// Refuses what comes from no page of this server, or from somebody who may not use it, and says why.
  bool IsWelcome(const WebRequest& request, WebResponse& refusal);
  bool HasToken(const WebRequest& request, WebResponse& refusal);
  bool IsOurHost(std::string_view host) const;
  WebResponse Page(const WebRequest& request, std::string_view path) const;
  WebResponse AnswerApi(const WebRequest& request, const std::vector<std::string>& parts);
  WebResponse NewPlace(const WebRequest& request);
  WebResponse AnswerPlace(const WebRequest& request, Place& place, const std::vector<std::string>& parts);
  WebResponse About(const Place& place) const;
  WebResponse Table(bool as_csv) const;
  std::shared_ptr<Session> SessionOf(const Place& place);

  boost::asio::io_context& io_;
  Settings settings_;
  std::unique_ptr<const Catalog> catalog_;
  StaticFiles files_;
  Places places_;
  ClassList class_;
  bool was_visited_ = false;
  std::map<std::string, std::shared_ptr<Session>, std::less<>> sessions_;  ///< By place.
  /// How often an address did something in the window that began then.
  struct Count {
    Clock::time_point since;
    std::size_t count = 0;
  };
  bool IsOver(std::map<std::string, Count>& counts, const std::string& address, std::size_t most,
              std::chrono::seconds window);
  std::map<std::string, Count> wrong_tokens_, new_places_;
};

}  // namespace soarbox::serve
