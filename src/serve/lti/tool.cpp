// SPDX-License-Identifier: BSD-2-Clause
#include "serve/lti/tool.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <fstream>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "diagnostics/problem.h"
#include "serve/lti/book.h"
#include "serve/lti/jwt.h"
#include "serve/lti/launch.h"
#include "serve/lti/login_state.h"
#include "serve/lti/platform_file.h"
#include "serve/lti/rsa_key.h"
#include "serve/lti/scores.h"
#include "serve/lti/tool_keys.h"
#include "serve/lti/tool_pages.h"
#include "serve/lti/web_address.h"
#include "serve/lti/web_client.h"
#include "serve/random_id.h"
#include "serve/site.h"
#include "serve/work.h"

namespace soarbox::lti {
namespace {

namespace fs = std::filesystem;
using serve::WebRequest;
using serve::WebResponse;

constexpr std::size_t kMostFormBytes = 128u << 10, kMostWaiting = 64, kScoresAtOnce = 20;
/// Limits of requests for a platform's keys: this many in quick succession, then one per minute.
constexpr double kFetches = 3, kFetchesPer_s = 1.0 / 60;

std::int64_t NowMs() {
  return std::chrono::duration_cast<std::chrono::milliseconds>(std::chrono::system_clock::now().time_since_epoch())
      .count();
}

std::int64_t NowS() {
  return NowMs() / 1000;
}

/// Writes a file of secrets atomically.
bool WriteSecret(const fs::path& file, const std::string& text) {
  const fs::path part = fs::path(file) += ".part";
  std::error_code error;
  {
    std::ofstream out(part, std::ios::binary);
    fs::permissions(part, fs::perms::owner_read | fs::perms::owner_write, error);
    out << text;
    if (!out.flush()) return false;
  }
  fs::rename(part, file, error);
  return !error;
}

class PlatformTool final : public Tool {
 public:
  PlatformTool(const Uses& uses, PlatformFile file, Book book, ToolKeys keys)
      : io_(uses.io),
        work_(uses.work),
        settings_(uses.settings),
        catalog_(uses.catalog),
        places_(uses.places),
        file_(std::move(file)),
        pages_(file_),
        book_(std::move(book)),
        keys_(std::move(keys)),
        lessons_(catalog_.Lessons()),
        secret_(serve::NewId() + serve::NewId()),
        remotes_(file_.platforms.size()),
        network_(io_) {
    // Checks all places again, in case the server was killed before it sent their newest scores.
    for (const Book::Link& link : book_.links()) looked_.insert(link.place);
  }
  ~PlatformTool() override { stop_ = true; }

  void Answer(const WebRequest& request, const std::string& what, Done done) override {
    const bool reads = request.method == "GET" || request.method == "HEAD";
    if (what == "jwks" && reads) {
      WebResponse response;
      response.body = keys_.PublicSet();
      response.headers.emplace_back("Cache-Control", "max-age=3600");
      return done(std::move(response));
    }
    if (what == "canvas.json" && reads) return done(pages_.CanvasConfiguration());
    if (request.body.size() > kMostFormBytes) return done(pages_.Trouble(413, "this message is too long"));
    if (what == "login" && (reads || request.method == "POST")) return done(Login(request));
    if (what == "launch" && request.method == "POST") return Launched(request, std::move(done));
    if (what == "launch" && reads)
      return done(
          pages_.Trouble(405, "this address works only as a link in a course of a learning platform", "open it there"));
    done(pages_.Trouble(404, "there is nothing at this address"));
  }

  void CleanUp(const std::vector<std::string>& running) override {
    RenewKeys();
    LookAtProgress(running);
    SendScoresNow();
  }

  std::string host() const override {
    const std::optional<WebAddress> address = ReadWebAddress(file_.url);
    return address ? address->host : "";
  }
  std::string NameOf(std::string_view place) const override { return book_.NameOf(place); }
  const serve::ClassList* FindByKey(std::string_view key) const override { return book_.FindByKey(key); }
  std::vector<std::string> Places() const override {
    std::vector<std::string> places;
    for (const Book::Course& course : book_.courses())
      for (const auto& [subject, place] : course.places) places.push_back(place);
    return places;
  }
  ScoreCount ScoresOf(const serve::ClassList& course) const override {
    ScoreCount count;
    for (const Book::Link& link : book_.links()) {
      if (course.NameOf(link.place).empty()) continue;
      count.sent += link.state == Book::ScoreState::kSent ? 1 : 0;
      count.waiting += link.state == Book::ScoreState::kWaits ? 1 : 0;
      count.refused += link.state == Book::ScoreState::kRefused ? 1 : 0;
      if (link.state != Book::ScoreState::kSent && !link.trouble.empty()) count.trouble = link.trouble;
    }
    return count;
  }

 private:
  /// Data about a platform that are kept only in memory.
  struct Remote {
    std::map<std::string, PublicKey, std::less<>> keys;  ///< By their ids.
    bool is_fetching = false, is_sending = false;
    std::string trouble;                         ///< Why the last attempt to read the keys failed; empty if it did not.
    std::vector<std::function<void()>> waiting;  ///< Launches that need a key.
    AccessToken token;
  };
  /// A launch whose token's signature has not been checked.
  struct Pending {
    std::size_t platform = 0;
    Jwt token;
    LoginState state;
    Done done;
  };

  const Platform& PlatformAt(std::size_t index) const { return file_.platforms[index]; }

  WebResponse Login(const WebRequest& request) const {
    const std::size_t query = request.target.find('?');
    const bool is_post = request.method == "POST";
    const FormFields fields =
        ReadForm(is_post                      ? std::string_view(request.body)
                 : query == std::string::npos ? std::string_view()
                                              : std::string_view(request.target).substr(query + 1));
    const std::string issuer = FieldOf(fields, "iss"), hint = FieldOf(fields, "login_hint");
    if (issuer.empty() || hint.empty())
      return pages_.Trouble(400, "this is not a login of a learning platform: it needs iss and login_hint",
                            "open the link in the course again");
    const Platform* const platform = file_.Find(issuer, FieldOf(fields, "client_id"));
    if (platform == nullptr)
      return pages_.Trouble(403, "this server does not know the learning platform " + issuer,
                            "the server's administrator can add its issuer and client id to the file of --lti");
    const std::string target = FieldOf(fields, "target_link_uri");
    const std::optional<WebAddress> address = ReadWebAddress(target);
    if (!target.empty() && (!address || address->origin() != file_.url))
      return pages_.Trouble(400, "the link leads to another server, not to " + file_.url,
                            "correct the tool's address on the platform");
    const LoginState state{serve::NewId(), serve::NewId(), platform->issuer, platform->client_id,
                           NowS() + kLoginLasts_s};
    FormFields asked = {{"scope", "openid"},
                        {"response_type", "id_token"},
                        {"response_mode", "form_post"},
                        {"prompt", "none"},
                        {"client_id", platform->client_id},
                        {"redirect_uri", file_.url + "/lti/launch"},
                        {"login_hint", hint},
                        {"state", WriteLoginState(state, secret_)},
                        {"nonce", state.nonce}};
    if (const std::string message = FieldOf(fields, "lti_message_hint"); !message.empty())
      asked.emplace_back("lti_message_hint", message);
    const char* const joint = platform->auth_url.find('?') == std::string::npos ? "?" : "&";
    WebResponse response = ToolPages::Redirect(platform->auth_url + joint + WriteForm(asked));
    response.status = 302;
    response.headers.emplace_back("Set-Cookie", CookieOf(state));
    return response;
  }

  void Launched(const WebRequest& request, Done done) {
    constexpr const char* kAgain = "open the link in the course again, in a new window; the browser must allow cookies";
    const FormFields fields = ReadForm(request.body);
    const std::optional<LoginState> state = ReadLoginState(FieldOf(fields, "state"), secret_, NowS());
    if (!state)
      return done(pages_.Trouble(403, "this launch did not begin here, or longer than ten minutes ago", kAgain));
    if (!HasCookieOf(*state, request.cookies))
      return done(pages_.Trouble(403, "this launch began in another browser", kAgain));
    const auto found = std::ranges::find_if(file_.platforms, [&](const Platform& each) {
      return each.issuer == state->issuer && each.client_id == state->client_id;
    });
    if (found == file_.platforms.end())
      return done(pages_.Trouble(403, "this server does not know the learning platform any more"));
    if (const std::string error = FieldOf(fields, "error"); !error.empty())
      return done(pages_.Trouble(403,
                                 found->name + " refuses the launch: " + error.substr(0, 100) + " " +
                                     FieldOf(fields, "error_description").substr(0, 200),
                                 "log in to the platform, and open the link again"));
    Result<Jwt> token = ReadJwt(FieldOf(fields, "id_token"));
    if (!token) return done(pages_.Trouble(400, token.error().message, token.error().hint));
    if (token->algorithm != "RS256" || token->key_id.empty())
      return done(pages_.Trouble(403, "the platform's token must be signed with RS256 and name its key"));
    Check({static_cast<std::size_t>(found - file_.platforms.begin()), std::move(*token), *state, std::move(done)},
          true);
  }

  /// Checks the signature. If the token's key is not known and `may_fetch` is true, fetches the platform's keys first.
  void Check(Pending pending, bool may_fetch) {
    Remote& remote = remotes_[pending.platform];
    const auto key = remote.keys.find(pending.token.key_id);
    if (key != remote.keys.end()) return CheckWith(key->second, std::move(pending));
    const std::string& name = PlatformAt(pending.platform).name;
    if (!may_fetch || (!remote.is_fetching && !fetches_.MayBegin(KeyOf(pending.platform))))
      return pending.done(remote.trouble.empty()
                              ? pages_.Trouble(403, "the token is signed with a key that " + name + " does not publish",
                                               "try again in a minute")
                              : pages_.Trouble(502, "the keys of " + name + " cannot be read: " + remote.trouble,
                                               "try again in a minute"));
    if (remote.waiting.size() >= kMostWaiting)
      return pending.done(pages_.Trouble(503, "too many launches wait for " + name, "try again in a minute"));
    const std::size_t platform = pending.platform;
    remote.waiting.push_back([this, pending = std::move(pending)] { Check(pending, false); });
    if (!remote.is_fetching) FetchKeys(platform);
  }

  static std::string KeyOf(std::size_t platform) { return std::to_string(platform); }

  void FetchKeys(std::size_t index) {
    remotes_[index].is_fetching = true;
    fetches_.Charge(KeyOf(index), 1);
    using Keys = std::map<std::string, PublicKey, std::less<>>;
    const auto fetched = std::make_shared<Result<Keys>>(NewProblem("the server has no memory left"));
    network_.Do(
        "keys " + KeyOf(index),
        [this, fetched, url = PlatformAt(index).jwks_url] {
          const Result<ClientResponse> response =
              Fetch({.method = "GET", .url = url, .type = {}, .body = {}, .headers = {}}, stop_);
          if (!response) return void(*fetched = response.error());
          const Result<std::vector<WebKey>> set = response->status == 200
                                                      ? ReadKeySet(response->body)
                                                      : NewProblem("status " + std::to_string(response->status));
          if (!set) return void(*fetched = set.error());
          Keys keys;
          for (const WebKey& each : *set)
            if (const std::optional<PublicKey> key = PublicKey::FromNumbers(each.modulus, each.exponent);
                key && !each.id.empty())
              keys.emplace(each.id, *key);
          *fetched = std::move(keys);
        },
        [this, fetched, index] {
          Remote& remote = remotes_[index];
          remote.is_fetching = false;
          remote.trouble = *fetched ? "" : fetched->error().message;
          if (*fetched) remote.keys = std::move(**fetched);
          for (const auto& each : std::exchange(remote.waiting, {})) each();
        });
  }

  void CheckWith(const PublicKey& key, Pending pending) {
    const Platform& platform = PlatformAt(pending.platform);
    const Jwt& token = pending.token;
    if (!key.Verify(token.signed_part, token.signature))
      return pending.done(pages_.Trouble(403, "the signature of the platform's token is wrong"));
    const Result<Launch> launch = ReadLaunch(token.claims, platform, pending.state.nonce, NowS());
    if (!launch) return pending.done(pages_.Trouble(403, launch.error().message, launch.error().hint));
    std::erase_if(used_, [now = NowS()](const auto& each) { return each.second < now; });
    if (!used_.emplace(pending.state.nonce, pending.state.ends_s).second)
      return pending.done(pages_.Trouble(403, "this launch was used before", "open the link in the course again"));
    Open(platform, *launch, std::move(pending.done));
  }

  void Open(const Platform& platform, const Launch& launch, Done done) {
    const auto is_it = [&](const serve::Lesson& lesson) { return lesson.name == launch.lesson; };
    if (!launch.lesson.empty() && std::ranges::none_of(lessons_, is_it))
      return done(pages_.Trouble(404, "there is no lesson called '" + launch.lesson + "'",
                                 "correct the custom parameter 'lesson' of the link; soarbox learn lists the names"));
    if (launch.chooses && !launch.is_teacher)
      return done(pages_.Trouble(403, "only a teacher of the course can choose lessons for it"));
    if (launch.chooses) return Choose(platform, launch, std::move(done));
    if (launch.is_teacher) {
      const std::string key = book_.CourseOf(platform, launch).list.key();
      Save();
      return done(ToolPages::Redirect("/class/" + key + "/" + Fragment({})));
    }
    OpenPlace(platform, launch, std::move(done));
  }

  void Choose(const Platform& platform, const Launch& launch, Done done) {
    const auto response =
        std::make_shared<WebResponse>(pages_.Trouble(500, "the server could not do this", "try again in a moment"));
    work_.Do(
        "lti-choice",
        [this, response, platform, launch, keys = keys_] {
          *response = pages_.Choice(platform, launch, lessons_, NowS(),
                                    [&](const std::string& claims) { return keys.Sign(claims, NowS()); });
        },
        [response, done = std::move(done)] { done(std::move(*response)); });
  }

  void OpenPlace(const Platform& platform, const Launch& launch, Done done) {
    const Book::Course& course = book_.CourseOf(platform, launch);
    const auto known = course.places.find(launch.subject);
    const std::string before = known == course.places.end() ? "" : known->second;
    const auto place = std::make_shared<Result<serve::Place>>(NewProblem("the server could not make a place"));
    work_.Do(
        "lti",
        [this, place, before] {
          if (!before.empty()) *place = places_.Find(before);
          if (!*place) *place = places_.New();
        },
        [this, place, before, platform, launch, done = std::move(done)] {
          if (!*place) return done(pages_.Trouble(507, place->error().message, place->error().hint));
          Book::Course& joined = book_.CourseOf(platform, launch);
          // Meanwhile another launch of the same person may have got a place. Then that place is used.
          const auto found = joined.places.find(launch.subject);
          const bool is_new = found == joined.places.end() || found->second == before;
          const std::string id = is_new ? (*place)->id() : found->second;
          if (found == joined.places.end() || found->second != id) book_.Add(joined, launch.subject, id, launch.name);
          book_.AddLink(platform, launch, id);
          looked_.insert(id);
          Save();
          FormFields fields;
          if (!launch.lesson.empty())
            fields.emplace_back("lesson", launch.lesson);
          else if (!launch.world.empty())
            fields.emplace_back("world", launch.world);
          done(ToolPages::Redirect("/p/" + id + "/" + Fragment(std::move(fields))));
        });
  }

  /// The part of an address that only the browser sees: the server's token, if it has one, and what to open.
  std::string Fragment(FormFields fields) const {
    if (!settings_.token.empty()) fields.insert(fields.begin(), {"token", settings_.token});
    return fields.empty() ? "" : "#" + WriteForm(fields);
  }

  void Save() {
    work_.Do(
        "lti", [file = settings_.state / "lti.json", text = book_.ToText()] { WriteSecret(file, text); }, [] {});
  }

  void RenewKeys() {
    if (!keys_.NeedsRotation(NowS()) || work_.Waiting("lti-keys") > 0) return;
    const auto fresh = std::make_shared<ToolKeys>(keys_);
    const auto is_done = std::make_shared<bool>(false);
    work_.Do(
        "lti-keys",
        [fresh, is_done, file = settings_.state / "lti_keys.json"] {
          *is_done = fresh->Rotate(NowS()) && WriteSecret(file, fresh->ToText());
        },
        [this, fresh, is_done] {
          if (*is_done) keys_ = std::move(*fresh);
        });
  }

  void LookAtProgress(const std::vector<std::string>& running) {
    looked_.insert(running.begin(), running.end());
    if (work_.Waiting("lti-progress") > 0) return;
    struct Look {
      std::string place, line_item, lesson;
      serve::Progress progress;
      bool is_there = false;
    };
    const auto looks = std::make_shared<std::vector<Look>>();
    for (const Book::Link& link : book_.links())
      if (looked_.contains(link.place)) looks->push_back({link.place, link.line_item, link.lesson, {}});
    // Places with a run are checked again after the run has ended.
    looked_ = {running.begin(), running.end()};
    if (looks->empty()) return;
    work_.Do(
        "lti-progress",
        [this, looks] {
          for (Look& look : *looks) {
            const Result<serve::Place> place = places_.Find(look.place);
            look.is_there = place.ok();
            if (place) look.progress = catalog_.ProgressOf(place->state(), look.lesson);
          }
        },
        [this, looks] {
          bool is_new = false;
          for (const Look& look : *looks)
            for (Book::Link& link : book_.links())
              if (look.is_there && link.place == look.place && link.line_item == look.line_item &&
                  link.lesson == look.lesson)
                is_new |= book_.Note(link, look.progress, NowMs());
          if (!is_new) return;
          // Stores scores before they are sent.
          Save();
          SendScoresNow();
        });
  }

  void SendScoresNow() {
    for (std::size_t i = 0; i < remotes_.size(); ++i)
      if (!remotes_[i].is_sending) SendScoresTo(i);
  }

  void SendScoresTo(std::size_t index) {
    const Platform& platform = PlatformAt(index);
    struct Batch {
      std::vector<Score> scores;
      std::vector<std::string> places;
      std::vector<Sent> sent;
      AccessToken token;
    };
    const auto batch = std::make_shared<Batch>();
    for (const Book::Link& link : book_.links()) {
      if (link.issuer != platform.issuer || link.client_id != platform.client_id ||
          link.state != Book::ScoreState::kWaits || link.next_s > NowS() || batch->scores.size() == kScoresAtOnce)
        continue;
      batch->scores.push_back({link.line_item, link.subject, link.comment, link.is_passed, link.graded_ms});
      batch->places.push_back(link.place);
    }
    if (batch->scores.empty()) return;
    Remote& remote = remotes_[index];
    remote.is_sending = true;
    batch->token = remote.token;
    network_.Do(
        "scores " + KeyOf(index),
        [this, batch, platform, keys = keys_] {
          const Sign sign = [&](const std::string& claims) { return keys.Sign(claims, NowS()); };
          batch->sent = SendScores(platform, batch->token, batch->scores, sign, NowS, stop_);
        },
        [this, batch, index] {
          remotes_[index].is_sending = false;
          remotes_[index].token = batch->token;
          batch->sent.resize(batch->scores.size(), Sent{Sent::How::kLater, "the server could not send it"});
          for (std::size_t i = 0; i < batch->scores.size(); ++i)
            NoteSent(batch->places[i], batch->scores[i], batch->sent[i]);
          Save();
        });
  }

  void NoteSent(const std::string& place, const Score& score, const Sent& sent) {
    constexpr std::int64_t kFirstPause_s = 5, kLongestPause_s = 600;
    constexpr int kMostDoublings = 7;
    for (Book::Link& link : book_.links()) {
      // Meanwhile a newer score may wait, to which the result does not apply.
      if (link.place != place || link.line_item != score.line_item || link.graded_ms != score.graded_ms) continue;
      link.trouble = sent.trouble;
      if (sent.how == Sent::How::kDone) link.state = Book::ScoreState::kSent;
      if (sent.how == Sent::How::kRefused) link.state = Book::ScoreState::kRefused;
      if (sent.how != Sent::How::kLater) continue;
      link.next_s = NowS() + std::min(kLongestPause_s, kFirstPause_s << std::min(link.failures, kMostDoublings));
      ++link.failures;
    }
  }

  boost::asio::io_context& io_;
  serve::Work& work_;
  const serve::Settings& settings_;
  const serve::Catalog& catalog_;
  serve::Places& places_;
  PlatformFile file_;
  ToolPages pages_;
  Book book_;
  ToolKeys keys_;
  const std::vector<serve::Lesson> lessons_;
  std::string secret_;                        ///< Signs logins. New at each start, so that older logins are invalid.
  std::map<std::string, std::int64_t> used_;  ///< Nonces of launches, with the time at which each expires.
  std::set<std::string> looked_;              ///< Places with progress that the next CleanUp checks.
  std::vector<Remote> remotes_;               ///< In the order of the platforms.
  serve::Costs fetches_{kFetchesPer_s, kFetches};
  std::atomic<bool> stop_ = false;
  serve::Work network_;  ///< Last: its jobs use all of the above, and may wait for platforms.
};

}  // namespace

Result<std::unique_ptr<Tool>> Tool::Make(const Uses& uses) {
  Result<PlatformFile> file = ReadPlatformFile(uses.settings.lti);
  if (!file) return file.error();
  Result<Book> book = Book::Read(uses.settings.state / "lti.json");
  if (!book) return book.error();
  const fs::path key_file = uses.settings.state / "lti_keys.json";
  Result<ToolKeys> keys = ToolKeys::Read(key_file);
  if (!keys) return keys.error();
  if (keys->NeedsRotation(NowS())) {
    if (const Result<void> made = keys->Rotate(NowS()); !made) return made.error();
    if (!WriteSecret(key_file, keys->ToText())) return ProblemIn(key_file, "this file cannot be written");
  }
  return std::unique_ptr<Tool>(new PlatformTool(uses, std::move(*file), std::move(*book), std::move(*keys)));
}

}  // namespace soarbox::lti
