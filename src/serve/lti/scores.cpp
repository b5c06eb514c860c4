// SPDX-License-Identifier: BSD-2-Clause
#include "serve/lti/scores.h"

#include <array>
#include <chrono>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "diagnostics/json_text.h"
#include "diagnostics/problem.h"
#include "serve/lti/web_address.h"
#include "serve/lti/web_client.h"
#include "serve/random_id.h"

namespace soarbox::lti {
namespace {

using ScoreJson = nlohmann::ordered_json;

constexpr const char* kScoreScope = "https://purl.imsglobal.org/spec/lti-ags/scope/score";
constexpr int kUnauthorized = 401;

bool IsGood(int status) {
  return status >= 200 && status < 300;
}

/// A short text about an error, from a platform's response.
std::string WordsOf(const ClientResponse& response) {
  constexpr std::size_t kMostBytes = 200;
  const ScoreJson json = ScoreJson::parse(response.body, nullptr, false);
  std::string words;
  for (const char* const field : {"error_description", "error", "message", "title"})
    if (json.is_object() && json.contains(field) && json[field].is_string() && words.empty())
      words = json[field].get<std::string>().substr(0, kMostBytes);
  return "status " + std::to_string(response.status) + (words.empty() ? "" : " (" + words + ")");
}

/// Gets an access token by client credentials (RFC 7523, as the 1EdTech Security Framework asks for it).
Result<AccessToken> Ask(const Platform& platform, const Sign& sign, std::int64_t now_s, const std::atomic<bool>& stop) {
  constexpr std::int64_t kAssertion_s = 300, kUsual_s = 3600, kEarlier_s = 30;
  const ScoreJson claims = {{"iss", platform.client_id},   {"sub", platform.client_id},
                            {"aud", platform.audience},    {"iat", now_s},
                            {"exp", now_s + kAssertion_s}, {"jti", serve::NewId()}};
  const std::string assertion = sign(JsonText(claims));
  if (assertion.empty()) return NewProblem("this server has no key to sign with");
  ClientRequest request;
  request.method = "POST";
  request.url = platform.token_url;
  request.type = "application/x-www-form-urlencoded";
  request.body = WriteForm({{"grant_type", "client_credentials"},
                            {"client_assertion_type", "urn:ietf:params:oauth:client-assertion-type:jwt-bearer"},
                            {"client_assertion", assertion},
                            {"scope", kScoreScope}});
  const Result<ClientResponse> response = Fetch(request, stop);
  if (!response) return response.error();
  if (!IsGood(response->status))
    return NewProblem(platform.name + " gives this server no access to its grades: " + WordsOf(*response));
  const ScoreJson json = ScoreJson::parse(response->body, nullptr, false);
  AccessToken token;
  if (json.is_object() && json.contains("access_token") && json["access_token"].is_string())
    token.text = json["access_token"].get<std::string>();
  // The token becomes part of a header, so it must not contain blanks, control or other special characters.
  for (const char c : token.text)
    if (c <= ' ' || c >= '\x7f') return NewProblem(platform.name + " gave an access token that cannot be used");
  if (token.text.empty()) return NewProblem(platform.name + " answered without an access token");
  std::int64_t lasts_s = kUsual_s;
  if (json.contains("expires_in") && json["expires_in"].is_number_integer())
    lasts_s = json["expires_in"].get<std::int64_t>();
  token.ends_s = now_s + std::min(lasts_s, kUsual_s) - kEarlier_s;
  return token;
}

/// The address of the scores of a line item, whose own address may have a query.
std::string ScoresOf(const std::string& line_item) {
  const std::size_t query = line_item.find('?');
  return line_item.substr(0, query) + "/scores" + (query == std::string::npos ? "" : line_item.substr(query));
}

Result<ClientResponse> Post(const Score& score, const AccessToken& token, const std::atomic<bool>& stop) {
  const ScoreJson json = {{"userId", score.subject},
                          {"scoreGiven", score.is_passed ? 1 : 0},
                          {"scoreMaximum", 1},
                          {"comment", score.comment},
                          {"timestamp", TimeText(score.graded_ms)},
                          {"activityProgress", score.is_passed ? "Completed" : "InProgress"},
                          {"gradingProgress", "FullyGraded"}};
  ClientRequest request;
  request.method = "POST";
  request.url = ScoresOf(score.line_item);
  request.type = "application/vnd.ims.lis.v1.score+json";
  request.body = JsonText(json);
  request.headers = {{"Authorization", "Bearer " + token.text}};
  return Fetch(request, stop);
}

/// Whether the same request may succeed later, after this status.
bool MayChange(int status) {
  constexpr int kTimeout = 408, kTooEarly = 425, kTooMany = 429, kServerError = 500;
  return status >= kServerError || status == kUnauthorized || status == kTimeout || status == kTooEarly ||
         status == kTooMany;
}

}  // namespace

std::string TimeText(std::int64_t ms_since_1970) {
  using std::chrono::milliseconds;
  const std::chrono::sys_time<milliseconds> time{milliseconds(ms_since_1970)};
  const auto day = std::chrono::floor<std::chrono::days>(time);
  const std::chrono::year_month_day date(day);
  const std::chrono::hh_mm_ss<milliseconds> clock(time - day);
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%04d-%02u-%02uT%02d:%02d:%02d.%03dZ", static_cast<int>(date.year()),
                static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()),
                static_cast<int>(clock.hours().count()), static_cast<int>(clock.minutes().count()),
                static_cast<int>(clock.seconds().count()), static_cast<int>(clock.subseconds().count()));
  return text.data();
}

std::vector<Sent> SendScores(const Platform& platform, AccessToken& token, const std::vector<Score>& scores,
                             const Sign& sign, const std::function<std::int64_t()>& now_s,
                             const std::atomic<bool>& stop) {
  std::vector<Sent> sent;
  const auto fail_rest = [&](const std::string& trouble) {
    sent.resize(scores.size(), Sent{Sent::How::kLater, trouble});
    return sent;
  };
  for (const Score& score : scores) {
    // A platform may end a token early, so a second attempt uses a new one.
    for (const bool is_last : {false, true}) {
      if (token.text.empty() || token.ends_s <= now_s()) {
        Result<AccessToken> fresh = Ask(platform, sign, now_s(), stop);
        if (!fresh) return fail_rest(fresh.error().message);
        token = std::move(*fresh);
      }
      const Result<ClientResponse> response = Post(score, token, stop);
      if (!response) return fail_rest(response.error().message);
      if (response->status == kUnauthorized) token = {};
      if (response->status == kUnauthorized && !is_last) continue;
      const std::string trouble = platform.name + " did not take a score: " + WordsOf(*response);
      if (IsGood(response->status))
        sent.push_back({});
      else
        sent.push_back({MayChange(response->status) ? Sent::How::kLater : Sent::How::kRefused, trouble});
      break;
    }
  }
  return sent;
}

}  // namespace soarbox::lti
