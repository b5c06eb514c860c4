// SPDX-License-Identifier: BSD-2-Clause
#include "serve/lti/launch.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "diagnostics/plain_text.h"
#include "diagnostics/problem.h"
#include "serve/lti/web_address.h"

namespace soarbox::lti {
namespace {

using ClaimJson = nlohmann::ordered_json;

constexpr const char* kTool = "https://purl.imsglobal.org/spec/lti/claim/";
constexpr std::int64_t kClocksDiffer_s = 60, kOldest_s = 3600;
constexpr std::size_t kMostIdBytes = 255, kMostNameBytes = 100;

/// A field of an object; null if there is no such field, or if `json` is not an object.
const ClaimJson& FieldIn(const ClaimJson& json, const std::string& name) {
  static const ClaimJson kNull;
  const auto found = json.is_object() ? json.find(name) : json.end();
  return json.is_object() && found != json.end() ? *found : kNull;
}

std::string TextIn(const ClaimJson& json, const std::string& name) {
  const ClaimJson& field = FieldIn(json, name);
  return field.is_string() ? field.get<std::string>() : std::string();
}

/// A field with seconds since 1970; nothing if it is not a number, or negative or above 1e11.
std::optional<std::int64_t> TimeIn(const ClaimJson& json, const char* name) {
  constexpr double kLatest_s = 1e11;
  const ClaimJson& field = FieldIn(json, name);
  if (!field.is_number()) return std::nullopt;
  const double seconds = field.get<double>();
  return std::isfinite(seconds) && seconds >= 0 && seconds < kLatest_s
             ? std::optional(static_cast<std::int64_t>(seconds))
             : std::nullopt;
}

bool Contains(const ClaimJson& list, const std::string& text) {
  return list.is_array() && std::ranges::any_of(list, [&](const ClaimJson& each) {
           return each.is_string() && each.get_ref<const std::string&>() == text;
         });
}

/// The error in the token's issuer, audience, times or nonce; empty if they are valid.
std::string TroubleOfToken(const ClaimJson& claims, const Platform& platform, const std::string& nonce,
                           std::int64_t now_s) {
  if (TextIn(claims, "iss") != platform.issuer) return "it comes from another platform";
  const ClaimJson& audience = FieldIn(claims, "aud");
  const bool is_for_us = audience.is_string() ? audience.get_ref<const std::string&>() == platform.client_id
                                              : Contains(audience, platform.client_id);
  if (!is_for_us) return "it is meant for another tool";
  const bool has_party = claims.contains("azp");
  if ((has_party && TextIn(claims, "azp") != platform.client_id) ||
      (!has_party && audience.is_array() && audience.size() > 1))
    return "it is meant for several tools, and was given to another one";
  const std::optional<std::int64_t> ends = TimeIn(claims, "exp"), begins = TimeIn(claims, "iat");
  if (!ends || !begins) return "it does not say when it begins and ends";
  if (*ends + kClocksDiffer_s < now_s) return "it has expired";
  if (*begins > now_s + kClocksDiffer_s)
    return "it comes from the future: compare the clocks of the platform and of this server";
  if (*begins + kOldest_s < now_s) return "it is too old";
  if (nonce.empty() || TextIn(claims, "nonce") != nonce) return "it does not answer the question of this server";
  return {};
}

/// Whether a role is that of a teacher or administrator of the course.
bool Teaches(const ClaimJson& role) {
  if (!role.is_string()) return false;
  const std::string& text = role.get_ref<const std::string&>();
  constexpr const char* kOfCourse = "http://purl.imsglobal.org/vocab/lis/v2/membership";
  for (const char* const name : {"Instructor", "Administrator"})
    if (text == name || text == std::string(kOfCourse) + "#" + name ||
        text.starts_with(std::string(kOfCourse) + "/" + name + "#"))
      return true;
  return false;
}

/// Shortens a text to kMostNameBytes, between characters. Replaces control characters by blanks, and trims blanks.
std::string ShortName(std::string text) {
  text.resize(Beginning(text, kMostNameBytes).size());
  for (char& c : text)
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = ' ';
  const std::size_t begin = text.find_first_not_of(' ');
  return begin == std::string::npos ? "" : text.substr(begin, text.find_last_not_of(' ') - begin + 1);
}

std::string NameOfPerson(const ClaimJson& claims) {
  std::string name = TextIn(claims, "name");
  if (name.empty()) name = TextIn(claims, "given_name") + " " + TextIn(claims, "family_name");
  return ShortName(std::move(name));
}

/// The address for scores of this link; empty if the platform does not accept scores for it.
std::string LineItemIn(const ClaimJson& claims) {
  const ClaimJson& service = FieldIn(claims, "https://purl.imsglobal.org/spec/lti-ags/claim/endpoint");
  if (!Contains(FieldIn(service, "scope"), "https://purl.imsglobal.org/spec/lti-ags/scope/score")) return {};
  std::string item = TextIn(service, "lineitem");
  const std::optional<WebAddress> address = ReadWebAddress(item);
  return address && IsPrivate(*address) ? item : std::string();
}

Result<void> ReadChoice(const ClaimJson& claims, Launch& launch) {
  const ClaimJson& settings = FieldIn(claims, "https://purl.imsglobal.org/spec/lti-dl/claim/deep_linking_settings");
  launch.chooses = true;
  launch.return_url = TextIn(settings, "deep_link_return_url");
  launch.data = TextIn(settings, "data");
  launch.may_choose_many = FieldIn(settings, "accept_multiple") == true;
  const std::optional<WebAddress> address = ReadWebAddress(launch.return_url);
  if (!address || !IsPrivate(*address))
    return NewProblem("the platform does not say where a chosen lesson is to be sent");
  if (!Contains(FieldIn(settings, "accept_types"), "ltiResourceLink"))
    return NewProblem("the platform takes no links to lessons here", "add an external tool to the course instead");
  return {};
}

}  // namespace

Result<Launch> ReadLaunch(const std::string& text, const Platform& platform, const std::string& nonce,
                          std::int64_t now_s) {
  const ClaimJson claims = ClaimJson::parse(text, nullptr, false);
  if (!claims.is_object()) return NewProblem("the claims of this token are not a JSON object");
  if (const std::string trouble = TroubleOfToken(claims, platform, nonce, now_s); !trouble.empty())
    return NewProblem("the platform's token cannot be used: " + trouble, "open the link in the course again");
  const std::string tool = kTool;
  if (TextIn(claims, tool + "version") != "1.3.0") return NewProblem("the platform does not speak LTI 1.3");
  Launch launch;
  launch.deployment = TextIn(claims, tool + "deployment_id");
  if (launch.deployment.empty() ||
      std::ranges::find(platform.deployments, launch.deployment) == platform.deployments.end())
    return NewProblem(
        "this server does not know the deployment '" + ShortName(launch.deployment) + "' of " + platform.name,
        "the server's administrator can add it to 'deployments' in the file of --lti");
  launch.subject = TextIn(claims, "sub");
  if (launch.subject.empty() || launch.subject.size() > kMostIdBytes)
    return NewProblem("the platform does not say who you are", "log in to the platform");
  launch.name = NameOfPerson(claims);
  const ClaimJson& context = FieldIn(claims, tool + "context");
  launch.course = TextIn(context, "id");
  if (launch.course.size() > kMostIdBytes)
    return NewProblem("the platform's id of the course is longer than 255 bytes");
  launch.course_title = ShortName(TextIn(context, "title"));
  const ClaimJson& roles = FieldIn(claims, tool + "roles");
  launch.is_teacher = roles.is_array() && std::ranges::any_of(roles, Teaches);
  const ClaimJson& custom = FieldIn(claims, tool + "custom");
  const std::string target = TextIn(claims, tool + "target_link_uri");
  const std::size_t query = target.find('?');
  const FormFields fields =
      ReadForm(query == std::string::npos ? std::string_view() : std::string_view(target).substr(query + 1));
  const auto named = [&](const char* field) {
    const std::string text_of = TextIn(custom, field);
    return ShortName(text_of.empty() ? FieldOf(fields, field) : text_of);
  };
  launch.lesson = named("lesson");
  launch.world = named("world");
  launch.line_item = LineItemIn(claims);
  const std::string kind = TextIn(claims, tool + "message_type");
  if (kind == "LtiDeepLinkingRequest") {
    if (const Result<void> read = ReadChoice(claims, launch); !read) return read.error();
  } else if (kind != "LtiResourceLinkRequest") {
    return NewProblem("Soarbox does not know this kind of message: " + ShortName(kind));
  } else if (TextIn(FieldIn(claims, tool + "resource_link"), "id").empty()) {
    return NewProblem("the platform does not say which link was opened");
  }
  return launch;
}

}  // namespace soarbox::lti
