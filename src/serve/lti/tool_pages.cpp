// SPDX-License-Identifier: BSD-2-Clause
#include "serve/lti/tool_pages.h"

#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "diagnostics/json_text.h"
#include "serve/lti/web_address.h"
#include "serve/random_id.h"

namespace soarbox::lti {
namespace {

using PageJson = nlohmann::ordered_json;

constexpr const char* kStyle =
    "body{font:16px/1.5 system-ui,sans-serif;max-width:40em;margin:3em auto;padding:0 1em;color-scheme:light dark}"
    "form{margin:.3em 0}button{font:inherit;padding:.35em .8em;text-align:left;width:100%;cursor:pointer}";

/// A link to a lesson, as a platform adds it to a course.
PageJson ItemFor(const serve::Lesson& lesson, const std::string& url) {
  return {{"type", "ltiResourceLink"},
          {"title", lesson.title},
          {"url", url + "/lti/launch?" + WriteForm({{"lesson", lesson.name}})},
          {"custom", {{"lesson", lesson.name}}},
          {"lineItem", {{"scoreMaximum", 1}, {"label", lesson.title}, {"resourceId", lesson.name}}}};
}

}  // namespace

ToolPages::ToolPages(const PlatformFile& file) : url_(file.url) {
  std::set<std::string> origins;
  for (const Platform& platform : file.platforms)
    for (const std::string& each : {platform.issuer, platform.auth_url})
      if (const std::optional<WebAddress> address = ReadWebAddress(each)) origins.insert(address->origin());
  for (const std::string& origin : origins) framed_by_ += " " + origin;
}

serve::WebResponse ToolPages::Page(int status, const std::string& title, const std::string& html,
                                   const std::string& form_action) const {
  serve::WebResponse response;
  response.status = status;
  response.type = "text/html; charset=utf-8";
  response.body =
      "<!doctype html><html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
      "content=\"width=device-width\"><title>" +
      HtmlText(title) + " - Soarbox</title><style>" + kStyle + "</style></head><body><main><h1>" + HtmlText(title) +
      "</h1>" + html + "</main></body></html>\n";
  const std::string also = form_action == "'none'" ? "" : " " + form_action;
  response.headers = {
      {"Cache-Control", "no-store"},
      {"Content-Security-Policy", "default-src 'none'; style-src 'unsafe-inline'; base-uri 'none'; form-action " +
                                      form_action + "; frame-ancestors 'self'" + framed_by_ + also}};
  return response;
}

serve::WebResponse ToolPages::Trouble(int status, const std::string& problem, const std::string& hint) const {
  const std::string html =
      "<p>" + HtmlText(problem) + ".</p>" + (hint.empty() ? "" : "<p>What to do: " + HtmlText(hint) + ".</p>");
  return Page(status, "This link does not open", html, "'none'");
}

serve::WebResponse ToolPages::Choice(const Platform& platform, const Launch& launch,
                                     const std::vector<serve::Lesson>& lessons, std::int64_t now_s,
                                     const std::function<std::string(const std::string&)>& sign) const {
  constexpr std::int64_t kLasts_s = 3600;
  const std::string tool = "https://purl.imsglobal.org/spec/lti/claim/",
                    deep = "https://purl.imsglobal.org/spec/lti-dl/claim/";
  const auto form = [&](const std::string& text, PageJson items) {
    PageJson claims = {{"iss", platform.client_id},
                       {"aud", platform.issuer},
                       {"iat", now_s},
                       {"exp", now_s + kLasts_s},
                       {"nonce", serve::NewId()},
                       {tool + "deployment_id", launch.deployment},
                       {tool + "message_type", "LtiDeepLinkingResponse"},
                       {tool + "version", "1.3.0"},
                       {deep + "content_items", std::move(items)}};
    if (!launch.data.empty()) claims[deep + "data"] = launch.data;
    return "<form method=\"post\" action=\"" + HtmlText(launch.return_url) +
           "\"><input type=\"hidden\" name=\"JWT\" value=\"" + sign(JsonText(claims)) + "\"><button>" + HtmlText(text) +
           "</button></form>";
  };
  std::string html = "<p>The lesson is added to your course. Learners open it there, and their grades go back.</p>",
              course;
  PageJson all = PageJson::array();
  for (const serve::Lesson& lesson : lessons) {
    if (lesson.course != course) html += "<h2>" + HtmlText(lesson.course) + "</h2>";
    course = lesson.course;
    html += form(lesson.title, PageJson::array({ItemFor(lesson, url_)}));
    all.push_back(ItemFor(lesson, url_));
  }
  if (launch.may_choose_many) html += "<h2>All</h2>" + form("All lessons, each as a link of its own", std::move(all));
  const std::optional<WebAddress> address = ReadWebAddress(launch.return_url);
  return Page(200, "Choose a lesson", html, address ? address->origin() : "'none'");
}

serve::WebResponse ToolPages::CanvasConfiguration() const {
  const PageJson placements = {{{"placement", "assignment_selection"},
                                {"message_type", "LtiDeepLinkingRequest"},
                                {"target_link_uri", url_ + "/lti/launch"}},
                               {{"placement", "link_selection"},
                                {"message_type", "LtiDeepLinkingRequest"},
                                {"target_link_uri", url_ + "/lti/launch"}}};
  PageJson extension = {
      {"platform", "canvas.instructure.com"},
      {"privacy_level", "name_only"},
      {"settings", {{"platform", "canvas.instructure.com"}, {"text", "Soarbox"}, {"placements", placements}}}};
  return serve::Good({{"title", "Soarbox"},
                      {"description", "Lessons in which people learn to write Soar agents"},
                      {"target_link_uri", url_ + "/lti/launch"},
                      {"oidc_initiation_url", url_ + "/lti/login"},
                      {"public_jwk_url", url_ + "/lti/jwks"},
                      {"scopes", PageJson::array({"https://purl.imsglobal.org/spec/lti-ags/scope/score"})},
                      {"extensions", PageJson::array({std::move(extension)})}});
}

serve::WebResponse ToolPages::Redirect(const std::string& url) {
  serve::WebResponse response;
  response.status = 303;
  response.headers = {{"Location", url}, {"Cache-Control", "no-store"}};
  response.type = "text/plain";
  return response;
}

}  // namespace soarbox::lti
