// SPDX-License-Identifier: BSD-2-Clause
#include "serve/lti/web_address.h"

#include <algorithm>

#include "bytes/percent_code.h"

namespace soarbox::lti {
namespace {

std::string FormDecoded(std::string_view text) {
  std::string spaced(text);
  std::ranges::replace(spaced, '+', ' ');
  return PercentDecoded(spaced);
}

bool IsWordCharacter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

std::string FormEncoded(std::string_view text) {
  std::string encoded;
  for (const char c : text) {
    if (IsWordCharacter(c) || c == '-' || c == '.' || c == '_' || c == '~')
      encoded += c;
    else
      AppendPercentCode(encoded, c);
  }
  return encoded;
}

}  // namespace

std::string WebAddress::origin() const {
  const std::string name = host.find(':') == std::string::npos ? host : "[" + host + "]";
  const bool is_usual = port == (is_secure ? "443" : "80");
  return (is_secure ? "https://" : "http://") + name + (is_usual ? "" : ":" + port);
}

std::optional<WebAddress> ReadWebAddress(std::string_view text) {
  constexpr std::size_t kMostBytes = 4096;
  WebAddress address;
  address.is_secure = text.starts_with("https://");
  if (!address.is_secure && !text.starts_with("http://")) return std::nullopt;
  if (text.size() > kMostBytes ||
      !std::ranges::all_of(text, [](char c) { return c > ' ' && c < '\x7f' && c != '"' && c != '\\'; }))
    return std::nullopt;
  text.remove_prefix(address.is_secure ? 8 : 7);
  text = text.substr(0, text.find('#'));
  const std::size_t end = std::min(text.find_first_of("/?"), text.size());
  std::string_view name = text.substr(0, end);
  address.path = std::string(text.substr(end));
  if (!address.path.starts_with('/')) address.path.insert(0, "/");
  address.port = address.is_secure ? "443" : "80";
  std::size_t colon = name.rfind(':');
  if (name.starts_with('[')) {
    const std::size_t closed = name.find(']');
    if (closed == std::string_view::npos) return std::nullopt;
    address.host = std::string(name.substr(1, closed - 1));
    colon = closed + 1 < name.size() && name[closed + 1] == ':' ? closed + 1 : std::string_view::npos;
    if (colon == std::string_view::npos && closed + 1 != name.size()) return std::nullopt;
  } else {
    address.host = std::string(name.substr(0, colon));
  }
  if (colon != std::string_view::npos) {
    address.port = std::string(name.substr(colon + 1));
    if (address.port.empty() || address.port.size() > 5 ||
        !std::ranges::all_of(address.port, [](char c) { return c >= '0' && c <= '9'; }))
      return std::nullopt;
  }
  const bool is_name = !address.host.empty() && std::ranges::all_of(address.host, [&](char c) {
    return IsWordCharacter(c) || c == '-' || c == '.' || (c == ':' && name.starts_with('['));
  });
  return is_name ? std::optional(address) : std::nullopt;
}

bool IsPrivate(const WebAddress& address) {
  return address.is_secure || address.host == "localhost" || address.host == "127.0.0.1" || address.host == "::1";
}

FormFields ReadForm(std::string_view text) {
  constexpr std::size_t kMostFields = 100;
  FormFields fields;
  while (!text.empty() && fields.size() < kMostFields) {
    const std::size_t end = std::min(text.find('&'), text.size());
    const std::string_view pair = text.substr(0, end);
    const std::size_t equals = std::min(pair.find('='), pair.size());
    if (!pair.empty())
      fields.emplace_back(FormDecoded(pair.substr(0, equals)),
                          FormDecoded(pair.substr(std::min(equals + 1, pair.size()))));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return fields;
}

std::string WriteForm(const FormFields& fields) {
  std::string text;
  for (const auto& [name, value] : fields)
    text += (text.empty() ? "" : "&") + FormEncoded(name) + "=" + FormEncoded(value);
  return text;
}

std::string FieldOf(const FormFields& fields, std::string_view name) {
  const auto found = std::ranges::find(fields, name, [](const auto& field) { return std::string_view(field.first); });
  return found == fields.end() ? std::string() : found->second;
}

std::string HtmlText(std::string_view text) {
  std::string html;
  for (const char c : text) switch (c) {
      case '&':
        html += "&amp;";
        break;
      case '<':
        html += "&lt;";
        break;
      case '>':
        html += "&gt;";
        break;
      case '"':
        html += "&quot;";
        break;
      case '\'':
        html += "&#39;";
        break;
      default:
        html += c;
    }
  return html;
}

}  // namespace soarbox::lti
