// SPDX-License-Identifier: BSD-2-Clause
#include "serve/site.h"

#include <arpa/inet.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "diagnostics/json_text.h"
#include "diagnostics/problem.h"
#include "diagnostics/read_text.h"
#include "serve/random_id.h"

namespace soarbox::serve {
namespace {

using Json = nlohmann::ordered_json;

WebResponse Refusal(int status, const Diagnostic& problem) {
  WebResponse response;
  response.status = status;
  Json json{{"error", problem.message}, {"hint", problem.hint}};
  if (!problem.file.empty()) json["file"] = problem.file;
  response.body = JsonText(json);
  return response;
}

WebResponse Refusal(int status, std::string message, std::string hint = {}) {
  return Refusal(status, NewProblem(std::move(message), std::move(hint)));
}

WebResponse Good(const Json& json) {
  WebResponse response;
  response.body = JsonText(json);
  return response;
}

int HexOf(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

/// "%20" becomes a blank; what is no such code stays.
std::string Decoded(std::string_view text) {
  std::string decoded;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool is_code = text[i] == '%' && i + 2 < text.size() && HexOf(text[i + 1]) >= 0 && HexOf(text[i + 2]) >= 0;
    decoded += is_code ? static_cast<char>(16 * HexOf(text[i + 1]) + HexOf(text[i + 2])) : text[i];
    if (is_code) i += 2;
  }
  return decoded;
}

/// The parts of a path between slashes, decoded; a slash within a part is none any more.
std::vector<std::string> PartsOf(std::string_view target) {
  target = target.substr(0, target.find_first_of("?#"));
  std::vector<std::string> parts;
  for (std::size_t at = target.starts_with('/') ? 1 : 0; at < target.size();) {
    const std::size_t end = std::min(target.find('/', at), target.size());
    parts.push_back(Decoded(target.substr(at, end - at)));
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
      return Decoded(pair.substr(name.size() + 1));
    target.remove_prefix(std::min(end + 1, target.size()));
  }
  return {};
}

std::string JoinedFrom(const std::vector<std::string>& parts, std::size_t first) {
  std::string path;
  for (std::size_t i = first; i < parts.size(); ++i) path += (i == first ? "" : "/") + parts[i];
  return path;
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

/// A cell of a table, quoted; a spreadsheet takes none for a formula.
std::string CsvCell(std::string text) {
  if (!text.empty() && std::string_view("=+-@\t\r").find(text.front()) != std::string_view::npos) text.insert(0, "'");
  std::string cell = "\"";
  for (const char c : text) cell += c == '"' ? std::string("\"\"") : std::string(1, c);
  return cell + "\"";
}

}  // namespace

Result<std::unique_ptr<Site>> Site::Make(boost::asio::io_context& io, Settings settings,
                                         std::unique_ptr<const Catalog> catalog) {
  Result<StaticFiles> files = StaticFiles::Read(settings.page);
  if (!files) return files.error();
  std::error_code error;
  std::filesystem::create_directories(settings.state / "places", error);
  if (error)
    return ProblemIn(settings.state, "the server cannot keep places here: " + error.message(),
                     "name another folder with --state");
  std::unique_ptr<Site> site(new Site(io, std::move(settings), std::move(catalog), std::move(*files)));
  if (!site->settings_.class_list.empty()) {
    Result<ClassList> list = ClassList::Read(site->settings_.class_list, site->settings_.state, site->places_);
    if (!list) return list.error();
    site->class_ = std::move(*list);
  }
  return site;
}

bool Site::IsOurHost(std::string_view host) const {
  const std::string_view name = NameOfHost(host);
  // A foreign page whose name was made to lead here brings its own name along.
  return IsNumber(name) || name == "localhost" || std::ranges::find(settings_.hosts, name) != settings_.hosts.end();
}

bool Site::IsWelcome(const WebRequest& request, WebResponse& refusal) {
  if (!IsOurHost(request.host)) {
    refusal = Refusal(421, "this server does not go by the name that your browser used",
                      "whoever runs it can add the name with --host");
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
  const auto most = static_cast<std::size_t>(settings_.limits.wrong_tokens_per_minute);
  if (IsOver(wrong_tokens_, request.address, most, std::chrono::seconds(60))) {
    refusal = Refusal(429, "too many wrong tokens came from your address", "wait a minute");
    return false;
  }
  constexpr std::string_view kBearer = "Bearer ", kProtocol = "soarbox.";
  std::string given;
  if (request.authorization.starts_with(kBearer)) given = request.authorization.substr(kBearer.size());
  if (request.protocols.starts_with(kProtocol)) given = request.protocols.substr(kProtocol.size());
  if (SameSecret(given, settings_.token)) return true;
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

WebResponse Site::Answer(const WebRequest& request) {
  const std::vector<std::string> parts = PartsOf(request.target);
  if (!parts.empty() && parts.front() == "api") {
    WebResponse refusal;
    if (!IsWelcome(request, refusal)) return refusal;
    WebResponse response = AnswerApi(request, parts);
    response.headers.emplace_back("Cache-Control", "no-store");
    return response;
  }
  if (request.method != "GET" && request.method != "HEAD") return Refusal(405, "a page can only be read");
  const bool is_page = parts.empty() || (parts.size() == 2 && (parts[0] == "p" || parts[0] == "class"));
  return Page(request, is_page ? "index.html" : JoinedFrom(parts, 0));
}

WebResponse Site::AnswerApi(const WebRequest& request, const std::vector<std::string>& parts) {
  if (parts.size() == 2 && parts[1] == "places")
    return request.method == "POST" ? NewPlace(request) : Refusal(405, "a place is made by POST");
  if (parts.size() == 3 && parts[1] == "class") {
    const bool as_csv = parts[2].ends_with(".csv");
    const std::string key = as_csv ? parts[2].substr(0, parts[2].size() - 4) : parts[2];
    return class_.IsKey(key)
               ? Table(as_csv)
               : Refusal(404, "there is no class by this link", "the server printed the link when it began");
  }
  if (parts.size() < 3 || parts[1] != "p") return Refusal(404, "there is nothing of this name");
  Result<Place> place = places_.Find(parts[2]);
  if (!place) return Refusal(404, place.error());
  return AnswerPlace(request, *place, parts);
}

WebResponse Site::NewPlace(const WebRequest& request) {
  if (IsOver(new_places_, request.address, settings_.limits.places_per_hour, std::chrono::hours(1)))
    return Refusal(429, "too many new places were made from your address",
                   "wait an hour, or use a link that you have kept");
  Count& count = new_places_[request.address];
  if (count.count++ == 0) count.since = Clock::now();
  const Result<Place> place = places_.New();
  return place ? Good({{"place", place->id()}}) : Refusal(507, place.error());
}

WebResponse Site::AnswerPlace(const WebRequest& request, Place& place, const std::vector<std::string>& parts) {
  const std::string& method = request.method;
  const std::string what = parts.size() > 3 ? parts[3] : "";
  const std::string path = JoinedFrom(parts, 4);
  const auto done = [](const Result<void>& result) {
    return result ? Good({{"done", true}}) : Refusal(400, result.error());
  };
  if (what.empty() && method == "GET") return About(place);
  if (what == "files" && method == "GET") {
    const Result<std::string> text = place.Read(path);
    if (!text) return Refusal(404, text.error());
    WebResponse response;
    response.type = "text/plain; charset=utf-8";
    response.body = *text;
    return response;
  }
  if (what == "files" && method == "PUT") return done(place.Write(path, request.body));
  if (what == "files" && method == "DELETE") return done(place.Remove(path));
  if (what == "zip" && method == "GET") {
    Result<std::string> zip = place.Zip();
    if (!zip) return Refusal(500, zip.error());
    WebResponse response;
    response.type = "application/zip";
    response.headers.emplace_back("Content-Disposition", "attachment; filename=\"soarbox.zip\"");
    response.body = *std::move(zip);
    return response;
  }
  if (what == "zip" && method == "POST") {
    const Result<std::size_t> count = place.Unzip(request.body);
    return count ? Good({{"files", *count}}) : Refusal(400, count.error());
  }
  if (what == "recordings" && method == "GET") {
    const Result<std::filesystem::path> file = place.FindRecording(path);
    if (!file) return Refusal(404, file.error());
    std::optional<std::string> bytes = ReadText(*file);
    if (!bytes) return Refusal(404, "this recording cannot be read");
    WebResponse response;
    response.type = "application/octet-stream";
    response.headers.emplace_back("Content-Disposition", "attachment; filename=\"run.soarrec\"");
    response.body = *std::move(bytes);
    return response;
  }
  return Refusal(404, "a place has nothing of this name");
}

WebResponse Site::About(const Place& place) const {
  Json lessons = Json::array(), scenarios = Json::array(), files = Json::array(), recordings = Json::array();
  for (const Lesson& lesson : catalog_->Lessons())
    lessons.push_back({{"name", lesson.name},
                       {"title", lesson.title},
                       {"course", lesson.course},
                       {"is_passed", catalog_->ProgressOf(place.state(), lesson.name).is_passed}});
  for (const Catalog::Scenario& scenario : catalog_->Scenarios())
    scenarios.push_back({{"name", scenario.name}, {"about", scenario.about}});
  for (const PlaceFile& file : place.Files()) files.push_back({{"path", file.path}, {"bytes", file.bytes}});
  for (const PlaceRecording& recording : place.Recordings())
    recordings.push_back({{"name", recording.name}, {"bytes", recording.bytes}, {"when", recording.when_s}});
  const auto session = sessions_.find(place.id());
  return Good({{"place", place.id()},
               {"learner", class_.NameOf(place.id())},
               {"opens", settings_.opens},
               {"lessons", std::move(lessons)},
               {"scenarios", std::move(scenarios)},
               {"files", std::move(files)},
               {"recordings", std::move(recordings)},
               {"kept_days", settings_.limits.kept_days},
               {"has_run", session != sessions_.end() && session->second->is_running()}});
}

WebResponse Site::Table(bool as_csv) const {
  const std::vector<Lesson> lessons = catalog_->Lessons();
  Json titles = Json::array(), learners = Json::array();
  std::string csv = "learner";
  for (const Lesson& lesson : lessons) {
    titles.push_back({{"name", lesson.name}, {"title", lesson.title}, {"course", lesson.course}});
    csv += "," + CsvCell(lesson.name + " passed") + "," + CsvCell(lesson.name + " tries") + "," +
           CsvCell(lesson.name + " hints");
  }
  csv += ",last hint\r\n";
  for (const ClassList::Learner& learner : class_.learners()) {
    const Result<Place> place = places_.Find(learner.place);
    if (!place) continue;
    const auto session = sessions_.find(learner.place);
    const bool is_here = session != sessions_.end() && session->second->is_running();
    std::string last_hint;
    bool has_open_hint = false;
    Json done = Json::object();
    csv += CsvCell(learner.name);
    for (const Lesson& lesson : lessons) {
      const Progress progress = catalog_->ProgressOf(place->state(), lesson.name);
      done[lesson.name] = {{"is_done", progress.is_passed}, {"tries", progress.attempts}, {"hints", progress.hints}};
      csv += std::string(",") + (progress.is_passed ? "yes" : "no") + "," + std::to_string(progress.attempts) + "," +
             std::to_string(progress.hints);
      // Of the lesson that is open now, else of the last one that is not passed.
      const bool is_open = is_here && session->second->what() == "lesson:" + lesson.name;
      if (!progress.last_hint.empty() && (is_open || (!has_open_hint && !progress.is_passed)))
        last_hint = progress.last_hint;
      has_open_hint |= is_open && !progress.last_hint.empty();
    }
    csv += "," + CsvCell(last_hint) + "\r\n";
    learners.push_back({{"name", learner.name},
                        {"place_link", "/p/" + learner.place + "/"},
                        {"watch_link", "/p/" + learner.place + "/#watch=" + class_.key()},
                        {"done", std::move(done)},
                        {"last_hint", last_hint},
                        {"doing", is_here ? session->second->what() : ""},
                        {"is_here", is_here && session->second->viewers() > 0}});
  }
  if (!as_csv) return Good({{"lessons", std::move(titles)}, {"learners", std::move(learners)}});
  WebResponse response;
  response.type = "text/csv; charset=utf-8";
  response.headers.emplace_back("Content-Disposition", "attachment; filename=\"class.csv\"");
  response.body = std::move(csv);
  return response;
}

std::shared_ptr<Session> Site::SessionOf(const Place& place) {
  const auto found = sessions_.find(place.id());
  if (found != sessions_.end()) return found->second;
  const auto running = std::ranges::count_if(
      sessions_, [](const auto& each) { return each.second->is_running() || each.second->viewers() > 0; });
  if (static_cast<std::size_t>(running) >= settings_.limits.sessions) return nullptr;
  return sessions_.emplace(place.id(), std::make_shared<Session>(io_, settings_, place)).first->second;
}

Site::Admission Site::Admit(const WebRequest& request) {
  Admission admission;
  const std::vector<std::string> parts = PartsOf(request.target);
  const bool may_ask = parts.size() == 4 && parts[3] == "run", watches = parts.size() == 4 && parts[3] == "watch";
  if (parts.size() != 4 || parts[0] != "api" || parts[1] != "p" || !(may_ask || watches)) {
    admission.refusal = Refusal(404, "there is no run of this name");
    return admission;
  }
  if (!IsWelcome(request, admission.refusal)) return admission;
  const Result<Place> place = places_.Find(parts[2]);
  if (!place) {
    admission.refusal = Refusal(404, place.error());
    return admission;
  }
  if (watches && !class_.IsKey(QueryOf(request.target, "key"))) {
    admission.refusal = Refusal(403, "only the teacher of the class may watch", "use a link of the class's table");
    return admission;
  }
  admission.session = SessionOf(*place);
  if (admission.session == nullptr)
    admission.refusal =
        Refusal(503, "this server runs as many worlds as it may (" + std::to_string(settings_.limits.sessions) + ")",
                "try again in some minutes");
  admission.may_ask = may_ask;
  was_visited_ |= admission.session != nullptr;
  if (!request.protocols.empty()) admission.protocol = request.protocols.substr(0, request.protocols.find(','));
  return admission;
}

void Site::CleanUp() {
  std::vector<std::string> kept;
  for (auto& [id, session] : sessions_) session->EndIfIdle();
  std::erase_if(sessions_, [](const auto& each) { return !each.second->is_running() && each.second->viewers() == 0; });
  for (const auto& [id, session] : sessions_) kept.push_back(id);
  for (const ClassList::Learner& learner : class_.learners()) kept.push_back(learner.place);
  places_.RemoveOlderThan(settings_.limits.kept_days, kept);
}

bool Site::WasLeft() const {
  return was_visited_ && std::ranges::all_of(sessions_, [](const auto& each) { return each.second->viewers() == 0; });
}

void Site::EndAll(const std::string& why) {
  for (auto& [id, session] : sessions_) session->End(why);
}

}  // namespace soarbox::serve
