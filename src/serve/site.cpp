// SPDX-License-Identifier: BSD-2-Clause
#include "serve/site.h"

#include <arpa/inet.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "bytes/percent_code.h"
#include "diagnostics/json_text.h"
#include "diagnostics/problem.h"
#include "diagnostics/read_text.h"
#include "serve/random_id.h"

namespace soarbox::serve {
namespace {

using Json = nlohmann::ordered_json;

/// Splits a path at slashes and decodes the parts; an encoded slash does not split.
std::vector<std::string> PartsOf(std::string_view target) {
  target = target.substr(0, target.find_first_of("?#"));
  std::vector<std::string> parts;
  for (std::size_t at = target.starts_with('/') ? 1 : 0; at < target.size();) {
    const std::size_t end = std::min(target.find('/', at), target.size());
    parts.push_back(PercentDecoded(target.substr(at, end - at)));
    at = end + 1;
  }
  return parts;
}

std::string QueryOf(std::string_view target, std::string_view name) {
  const std::size_t query = target.find('?');
  if (query == std::string_view::npos) return {};
  target = target.substr(query + 1);
  while (!target.empty()) {
    const std::size_t end = std::min(target.find('&'), target.size());
    const std::string_view pair = target.substr(0, end);
    if (pair.starts_with(name) && pair.substr(name.size()).starts_with('='))
      return PercentDecoded(pair.substr(name.size() + 1));
    target.remove_prefix(std::min(end + 1, target.size()));
  }
  return {};
}

/// "example.org" of "example.org:8080", "::1" of "[::1]:8080".
std::string_view NameOfHost(std::string_view host) {
  if (host.starts_with('[')) return host.substr(1, host.find(']') - 1);
  return host.substr(0, host.find(':'));
}

bool IsNumber(std::string_view host) {
  in_addr four;
  in6_addr six;
  const std::string name(host);
  return inet_pton(AF_INET, name.c_str(), &four) == 1 || inet_pton(AF_INET6, name.c_str(), &six) == 1;
}

}  // namespace

Result<std::unique_ptr<Site>> Site::Make(boost::asio::io_context& io, Settings settings,
                                         std::unique_ptr<const Catalog> catalog) {
  Result<StaticFiles> files = StaticFiles::Read(settings.page);
  if (!files) return files.error();
  std::error_code error;
  std::filesystem::create_directories(settings.state / "places", error);
  // The names of the folders of places are secrets.
  for (const std::filesystem::path& folder : {settings.state, settings.state / "places"})
    if (!error) std::filesystem::permissions(folder, std::filesystem::perms::owner_all, error);
  if (error)
    return ProblemIn(settings.state, "the server cannot keep places here: " + error.message(),
                     "name another folder with --state");
  std::unique_ptr<Site> site(new Site(io, std::move(settings), std::move(catalog), std::move(*files)));
  if (!site->settings_.class_list.empty()) {
    Result<ClassList> list = ClassList::Read(site->settings_.class_list, site->settings_.state, site->places_);
    if (!list) return list.error();
    site->class_ = std::move(*list);
    Result<ClassDesk> desk = ClassDesk::Read(site->DeskFile());
    if (!desk) return desk.error();
    site->desk_ = std::move(*desk);
  }
  if (!site->settings_.lti.empty()) {
    Result<std::unique_ptr<lti::Tool>> tool =
        lti::Tool::Make({io, site->work_, site->settings_, *site->catalog_, site->places_});
    if (!tool) return tool.error();
    site->lti_ = std::move(*tool);
    site->settings_.hosts.push_back(site->lti_->host());
  }
  Result<std::unique_ptr<Arena>> arena = Arena::Make(io, site->work_, site->settings_, site->catalog_->Games());
  if (!arena) return arena.error();
  site->arena_ = std::move(*arena);
  return site;
}

bool Site::IsOurHost(std::string_view host) const {
  const std::string_view name = NameOfHost(host);
  // Refuses other names, because of DNS rebinding: if the name of another site resolves to this address, its pages send
  // that name.
  return IsNumber(name) || name == "localhost" || std::ranges::find(settings_.hosts, name) != settings_.hosts.end();
}

bool Site::IsWelcome(const WebRequest& request, WebResponse& refusal) {
  if (!IsOurHost(request.host)) {
    refusal = Refusal(421, "this server does not have the name that your browser used",
                      "the server's administrator can add the name with --host");
    return false;
  }
  if (!request.origin.empty()) {
    const std::size_t begin = request.origin.find("://");
    if (begin == std::string::npos || std::string_view(request.origin).substr(begin + 3) != request.host) {
      refusal = Refusal(403, "this request comes from a page of another site");
      return false;
    }
  }
  return HasToken(request, refusal);
}

bool Site::IsOver(std::map<std::string, Count>& counts, const std::string& address, std::size_t most,
                  std::chrono::seconds window) {
  constexpr std::size_t kMostAddresses = 10'000;
  const auto now = Clock::now();
  if (counts.size() > kMostAddresses)
    std::erase_if(counts, [&](const auto& each) { return now - each.second.since > window; });
  const auto found = counts.find(address);
  if (found == counts.end()) return false;
  if (now - found->second.since > window) {
    counts.erase(found);
    return false;
  }
  return found->second.count >= most;
}

bool Site::HasToken(const WebRequest& request, WebResponse& refusal) {
  if (settings_.token.empty()) return true;
  constexpr std::string_view kBearer = "Bearer ", kProtocol = "soarbox.";
  std::string given;
  if (request.authorization.starts_with(kBearer)) given = request.authorization.substr(kBearer.size());
  if (request.protocols.starts_with(kProtocol)) given = request.protocols.substr(kProtocol.size());
  // The right token is never refused, because others at the same address may have tried wrong ones.
  if (SameSecret(given, settings_.token)) return true;
  const auto most = static_cast<std::size_t>(settings_.limits.wrong_tokens_per_minute);
  if (IsOver(wrong_tokens_, request.address, most, std::chrono::seconds(60))) {
    refusal = Refusal(429, "too many wrong tokens came from your address", "wait a minute");
    return false;
  }
  if (!given.empty()) {
    Count& count = wrong_tokens_[request.address];
    if (count.count++ == 0) count.since = Clock::now();
  }
  refusal = Refusal(401, given.empty() ? "this server needs a token" : "this token is not the right one",
                    "open the whole address that the server has printed, with #token=... at its end");
  return false;
}

WebResponse Site::Page(const WebRequest& request, std::string_view path) const {
  const StaticFiles::File* file = files_.Find(path);
  if (file == nullptr) return Refusal(404, "there is no such page here");
  WebResponse response;
  response.type = file->type;
  response.headers = {{"ETag", file->tag}, {"Cache-Control", "no-cache"}, {"Vary", "Accept-Encoding"}};
  if (request.tag == file->tag) {
    response.status = 304;
    return response;
  }
  const bool is_gzipped = request.takes_gzip && !file->gzipped.empty();
  if (is_gzipped) response.headers.emplace_back("Content-Encoding", "gzip");
  response.body = is_gzipped ? file->gzipped : file->bytes;
  return response;
}

void Site::Answer(const WebRequest& request, std::function<void(WebResponse)> done) {
  const std::vector<std::string> parts = PartsOf(request.target);
  if (!parts.empty() && parts.front() == "api") {
    WebResponse refusal;
    if (!IsWelcome(request, refusal)) return done(std::move(refusal));
    return AnswerApi(request, parts, [done = std::move(done)](WebResponse response) {
      response.headers.emplace_back("Cache-Control", "no-store");
      done(std::move(response));
    });
  }
  if (parts.size() == 2 && parts.front() == "lti") return AnswerPlatform(request, parts, std::move(done));
  if (request.method != "GET" && request.method != "HEAD") return done(Refusal(405, "a page can only be read"));
  const std::string first = parts.empty() ? "" : parts.front();
  if (parts.size() == 1 && (first == "embed" || first == "embed.js")) return done(Embedded(request, first));
  const bool is_page = parts.empty() || (parts.size() == 2 && (first == "p" || first == "class" || first == "w"));
  done(Page(request, is_page ? "index.html" : JoinedFrom(parts, 0)));
}

void Site::AnswerPlatform(const WebRequest& request, const std::vector<std::string>& parts, Done done) {
  constexpr double kPoints = 2;
  if (lti_ == nullptr)
    return done(Refusal(404, "no learning platform may open lessons here",
                        "the server's administrator can name platforms with --lti FILE"));
  if (!IsOurHost(request.host)) return done(Refusal(421, "this server does not have the name that your browser used"));
  if (!address_costs_.MayBegin(request.address))
    return done(Refusal(429, "you ask for more than this server allows", "wait a moment"));
  address_costs_.Charge(request.address, kPoints);
  lti_->Answer(request, parts[1], std::move(done));
}

std::string Site::LearnerOf(std::string_view place) const {
  std::string name = class_.NameOf(place);
  if (name.empty() && lti_ != nullptr) name = lti_->NameOf(place);
  return name;
}

const ClassList* Site::ClassOf(std::string_view key) const {
  if (class_.IsKey(key)) return &class_;
  return lti_ == nullptr ? nullptr : lti_->FindByKey(key);
}

WebResponse Site::Embedded(const WebRequest& request, const std::string& what) const {
  if (settings_.embedders.empty())
    return Refusal(404, "this server lets no other site show its worlds",
                   "the server's administrator can name sites: --embed https://your.site.example");
  WebResponse response = Page(request, what == "embed" ? "index.html" : "assets/embed.js");
  if (what == "embed.js") {
    response.headers.emplace_back("Cross-Origin-Resource-Policy", "cross-origin");
    return response;
  }
  for (const std::string& site : settings_.embedders)
    response.framed_by += (response.framed_by.empty() ? "" : " ") + site;
  return response;
}

bool Site::MayBegin(const std::string& place, const std::string& address) {
  // All learners of a class may have the same address, so their costs count only for their places.
  return place_costs_.MayBegin(place) && (!LearnerOf(place).empty() || address_costs_.MayBegin(address));
}

void Site::Charge(const std::string& place, const std::string& address, double points) {
  if (!place.empty()) place_costs_.Charge(place, points);
  if (LearnerOf(place).empty()) address_costs_.Charge(address, points);
}

void Site::AnswerApi(const WebRequest& request, const std::vector<std::string>& parts, Done done) {
  if (parts.size() == 2 && parts[1] == "places") {
    if (request.method != "POST") return done(Refusal(405, "a place is made by POST"));
    return NewPlace(request, std::move(done));
  }
  if (parts.size() >= 3 && parts[1] == "class") return AnswerClass(request, parts, std::move(done));
  if (parts.size() == 3 && parts[1] == "w") return AnswerWatch(parts[2], std::move(done));
  if (parts.size() < 3 || parts[1] != "p") return done(Refusal(404, "there is nothing of this name"));
  AnswerPlace(request, parts, std::move(done));
}

void Site::NewPlace(const WebRequest& request, Done done) {
  if (IsOver(new_places_, request.address, settings_.limits.places_per_hour, std::chrono::hours(1)))
    return done(Refusal(429, "too many new places were made from your address",
                        "wait an hour, or use a link that you have kept"));
  Count& count = new_places_[request.address];
  if (count.count++ == 0) count.since = Clock::now();
  Do(
      request.address,
      [this] {
        const Result<Place> place = places_.New();
        return place ? Good({{"place", place->id()}}) : Refusal(507, place.error());
      },
      std::move(done));
}

void Site::Do(const std::string& line, std::function<WebResponse()> job, Done done) {
  const auto response =
      std::make_shared<WebResponse>(Refusal(500, "the server could not do this", "try again in a moment"));
  work_.Do(
      line, [response, job = std::move(job)] { *response = job(); },
      [response, done = std::move(done)] { done(std::move(*response)); });
}

void Site::AnswerPlace(const WebRequest& request, const std::vector<std::string>& parts, Done done) {
  const std::string& id = parts[2];
  if (!IsId(id)) return done(Refusal(404, places_.Find(id).error()));
  // Limits the jobs of a place, so that it cannot fill the queue with many connections.
  constexpr std::size_t kMostWaiting = 16;
  if (!MayBegin(id, request.address) || work_.Waiting(id) >= kMostWaiting) {
    WebResponse refusal = Refusal(429, "you ask for more than this server allows", "wait a moment");
    refusal.headers.emplace_back("Retry-After", "2");
    return done(std::move(refusal));
  }
  const auto session = sessions_.find(id);
  const auto asked = std::make_shared<PlaceRequest>(
      PlaceRequest{request.method,
                   parts,
                   request.body,
                   {LearnerOf(id), settings_.opens, session != sessions_.end() && session->second->is_running()}});
  Charge(id, request.address, CostBefore(*asked));
  const std::string what = parts.size() > 3 ? parts[3] : "";
  if (what == "hand" || what == "notes" || what == "arena") return AnswerLearner(request, parts, std::move(done));
  if (what == "watch") return AnswerWatchLink(request, id, std::move(done));
  Do(
      id,
      [this, asked] {
        Result<Place> place = places_.Find(asked->parts[2]);
        return place ? AnswerFromPlace(*asked, *place, *catalog_, settings_.limits) : Refusal(404, place.error());
      },
      [this, asked, id, address = request.address, done = std::move(done)](WebResponse response) {
        Charge(id, address, CostAfter(*asked, response));
        done(std::move(response));
      });
}

Result<void> Site::MayStart(const Session& session) const {
  std::size_t all = 0, of_address = 0;
  const auto is_of_class = [&](const Session& each) { return !LearnerOf(each.place().id()).empty(); };
  for (const auto& [id, each] : sessions_) {
    if (!each->is_running()) continue;
    ++all;
    if (each->address() == session.address() && !is_of_class(*each)) ++of_address;
  }
  if (all >= settings_.limits.sessions)
    return NewProblem(
        "this server already runs the maximum number of worlds (" + std::to_string(settings_.limits.sessions) + ")",
        "try again in some minutes");
  // All learners of a class may have the same address.
  if (of_address >= settings_.limits.sessions_per_address && !is_of_class(session))
    return NewProblem("your address already runs the maximum number of worlds (" +
                          std::to_string(settings_.limits.sessions_per_address) + ")",
                      "close one of them, or try again in some minutes");
  return {};
}

std::shared_ptr<Session> Site::SessionOf(const Place& place, const std::string& address) {
  const auto found = sessions_.find(place.id());
  if (found != sessions_.end()) return found->second;
  // A new session has no run yet. MayStart is checked when it starts one.
  auto session =
      std::make_shared<Session>(io_, work_, settings_, place, [this](const Session& each) { return MayStart(each); });
  session->set_address(address);
  if (!LearnerOf(place.id()).empty()) session->SetGreeting([this, id = place.id()] { return desk_.MessageFor(id); });
  return sessions_.emplace(place.id(), std::move(session)).first->second;
}

void Site::Admit(const WebRequest& request, std::function<void(Admission)> done) {
  Admission admission;
  const auto refuse = [&](WebResponse refusal) {
    admission.refusal = std::move(refusal);
    done(std::move(admission));
  };
  const std::vector<std::string> parts = PartsOf(request.target);
  const bool by_link = parts.size() == 4 && parts[1] == "w";
  const bool may_ask = parts.size() == 4 && parts[3] == "run" && !by_link,
             watches = parts.size() == 4 && parts[3] == "watch";
  if (parts.size() != 4 || parts[0] != "api" || (parts[1] != "p" && !by_link) || !(may_ask || watches))
    return refuse(Refusal(404, "there is no run of this name"));
  if (WebResponse refusal; !IsWelcome(request, refusal)) return refuse(std::move(refusal));
  if (!IsId(parts[2])) return refuse(Refusal(404, places_.Find(parts[2]).error()));
  if (watches && !by_link && ClassOf(QueryOf(request.target, "key")) == nullptr)
    return refuse(Refusal(403, "only the teacher of the class may watch", "use a link of the class's table"));
  admission.may_ask = may_ask;
  admission.address = request.address;
  constexpr std::size_t kMostTabBytes = 40;
  admission.tab = QueryOf(request.target, "tab").substr(0, kMostTabBytes);
  if (!request.protocols.empty()) admission.protocol = request.protocols.substr(0, request.protocols.find(','));
  const auto place = std::make_shared<Result<Place>>(NewProblem("not looked for"));
  work_.Do(
      parts[2],
      [this, place, id = parts[2], by_link] {
        const Result<std::string> found = by_link ? watch_links_.PlaceOf(id) : Result<std::string>(id);
        *place = found ? places_.Find(*found) : Result<Place>(found.error());
      },
      [this, place, admission = std::move(admission), done = std::move(done)]() mutable {
        if (!*place) {
          admission.refusal = Refusal(404, place->error());
          return done(std::move(admission));
        }
        const bool is_new = !sessions_.contains((*place)->id());
        admission.session = SessionOf(**place, admission.address);
        // Refuses the connection if no run could be started. The page tries again later.
        if (const Result<void> may = is_new ? MayStart(*admission.session) : Result<void>(); !may) {
          sessions_.erase((*place)->id());
          admission.session = nullptr;
          admission.refusal = Refusal(503, may.error());
        }
        was_visited_ |= admission.session != nullptr;
        done(std::move(admission));
      });
}

void Site::CleanUp() {
  std::vector<std::string> kept;
  for (auto& [id, session] : sessions_) {
    session->EndIfIdle();
    // Updates since when the learner's rules have had an error.
    if (!LearnerOf(id).empty()) session->Standing();
  }
  std::erase_if(sessions_, [](const auto& each) { return !each.second->is_running() && each.second->viewers() == 0; });
  for (const auto& [id, session] : sessions_) kept.push_back(id);
  for (const ClassList::Learner& learner : class_.learners()) kept.push_back(learner.place);
  if (lti_ != nullptr) {
    std::vector<std::string> running;
    for (const auto& [id, session] : sessions_)
      if (session->is_running()) running.push_back(id);
    lti_->CleanUp(running);
    for (std::string& place : lti_->Places()) kept.push_back(std::move(place));
  }
  if (work_.Waiting("clean-up") > 0) return;
  work_.Do(
      "clean-up", [this, kept = std::move(kept)] { places_.RemoveOlderThan(settings_.limits.kept_days, kept); }, [] {});
}

bool Site::WasLeft() const {
  return was_visited_ && std::ranges::all_of(sessions_, [](const auto& each) { return each.second->viewers() == 0; });
}

void Site::EndAll(const std::string& why) {
  for (auto& [id, session] : sessions_) session->End(why);
}

}  // namespace soarbox::serve
