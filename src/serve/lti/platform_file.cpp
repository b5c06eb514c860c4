// SPDX-License-Identifier: BSD-2-Clause
#include "serve/lti/platform_file.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <optional>

#include "diagnostics/problem.h"
#include "diagnostics/read_text.h"
#include "serve/lti/web_address.h"

namespace soarbox::lti {
namespace {

namespace fs = std::filesystem;
using PlatformJson = nlohmann::ordered_json;

constexpr const char* kSeePage = "docs/lti.md has an example";
constexpr std::size_t kMostPlatforms = 100, kMostFieldBytes = 1000;

/// The line of a byte of a text, from 1.
int LineAt(const std::string& text, std::size_t byte) {
  return 1 + static_cast<int>(std::count(
                 text.begin(), text.begin() + static_cast<std::ptrdiff_t>(std::min(byte, text.size())), '\n'));
}

/// Reads fields of an object and stores the first error.
class FieldReader {
 public:
  FieldReader(const PlatformJson& json, std::string where, const fs::path& file)
      : json_(json), where_(std::move(where)), file_(file) {}

  std::string Text(const char* field, bool is_required = true) {
    const auto found = json_.find(field);
    if (found == json_.end()) {
      if (is_required) Note(std::string("needs the field '") + field + "'");
      return {};
    }
    if (!found->is_string() || found->get_ref<const std::string&>().empty() ||
        found->get_ref<const std::string&>().size() > kMostFieldBytes) {
      Note(std::string("needs a text for '") + field + "'");
      return {};
    }
    return found->get<std::string>();
  }
  std::string Url(const char* field, bool is_required = true) {
    std::string text = Text(field, is_required);
    if (text.empty()) return text;
    const std::optional<WebAddress> address = ReadWebAddress(text);
    if (!address)
      Note("needs an address of the web for '" + std::string(field) + "', not " + text);
    else if (!IsPrivate(*address))
      Note("needs https:// for '" + std::string(field) +
           "': anybody on the way could read and change what is sent to " + text);
    return text;
  }
  /// Reports the first field that is not in `known`.
  void Finish(std::initializer_list<std::string_view> known) {
    for (const auto& [name, value] : json_.items())
      if (std::ranges::find(known, std::string_view(name)) == known.end()) Note("has the unknown field '" + name + "'");
  }
  void Note(const std::string& problem) {
    if (!problem_) problem_ = ProblemIn(file_, where_ + " " + problem, kSeePage);
  }
  const std::optional<Diagnostic>& problem() const { return problem_; }

 private:
  const PlatformJson& json_;
  std::string where_;
  const fs::path& file_;
  std::optional<Diagnostic> problem_;
};

Result<Platform> ReadPlatform(const PlatformJson& json, int number, const fs::path& file) {
  const std::string where = "platform " + std::to_string(number);
  if (!json.is_object()) return ProblemIn(file, where + " is not an object with fields", kSeePage);
  FieldReader reader(json, where, file);
  Platform platform;
  platform.name = reader.Text("name");
  platform.issuer = reader.Text("issuer");
  platform.client_id = reader.Text("client_id");
  platform.auth_url = reader.Url("auth_url");
  platform.token_url = reader.Url("token_url");
  platform.jwks_url = reader.Url("jwks_url");
  platform.audience = reader.Text("audience", false);
  if (platform.audience.empty()) platform.audience = platform.token_url;
  const auto deployments = json.find("deployments");
  if (deployments == json.end() || !deployments->is_array() || deployments->empty()) {
    reader.Note("needs a list of ids for 'deployments'");
  } else {
    for (const PlatformJson& each : *deployments) {
      if (!each.is_string()) reader.Note("needs texts in 'deployments': write numbers as \"1\"");
      platform.deployments.push_back(each.is_string() ? each.get<std::string>() : "");
    }
  }
  reader.Finish({"name", "issuer", "client_id", "auth_url", "token_url", "jwks_url", "audience", "deployments"});
  if (reader.problem()) return *reader.problem();
  return platform;
}

}  // namespace

const Platform* PlatformFile::Find(std::string_view issuer, std::string_view client_id) const {
  const Platform* found = nullptr;
  for (const Platform& each : platforms) {
    if (each.issuer != issuer || (!client_id.empty() && each.client_id != client_id)) continue;
    if (found != nullptr) return nullptr;
    found = &each;
  }
  return found;
}

Result<PlatformFile> ReadPlatformFile(const fs::path& file) {
  const std::optional<std::string> text = ReadText(file);
  if (!text) return ProblemIn(file, "this list of learning platforms cannot be read", kSeePage);
  PlatformJson json;
  try {
    json = PlatformJson::parse(*text);
  } catch (const PlatformJson::parse_error& error) {
    Diagnostic problem = ProblemIn(file, "this is not JSON", kSeePage);
    problem.line = LineAt(*text, error.byte > 0 ? error.byte - 1 : 0);
    return problem;
  }
  if (!json.is_object())
    return ProblemIn(file, "this list of learning platforms is not an object with fields", kSeePage);
  FieldReader reader(json, "this list of learning platforms", file);
  PlatformFile list;
  list.url = reader.Url("url");
  while (list.url.ends_with('/')) list.url.pop_back();
  const auto platforms = json.find("platforms");
  if (platforms == json.end() || !platforms->is_array() || platforms->empty() || platforms->size() > kMostPlatforms)
    reader.Note("needs 1 to 100 platforms in 'platforms'");
  reader.Finish({"url", "platforms"});
  if (const std::optional<WebAddress> address = ReadWebAddress(list.url); address && address->origin() != list.url)
    reader.Note("needs the server's address without a path for 'url': " + address->origin());
  if (reader.problem()) return *reader.problem();
  for (const PlatformJson& each : *platforms) {
    Result<Platform> platform = ReadPlatform(each, static_cast<int>(list.platforms.size()) + 1, file);
    if (!platform) return platform.error();
    if (list.Find(platform->issuer, platform->client_id) != nullptr)
      return ProblemIn(
          file,
          "platform " + std::to_string(list.platforms.size() + 1) + " has the issuer and the client id of another",
          kSeePage);
    list.platforms.push_back(std::move(*platform));
  }
  return list;
}

}  // namespace soarbox::lti
