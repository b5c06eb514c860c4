// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace soarbox::lti {

/// An address of the web: "https://school.example:8443/lti?id=1".
struct WebAddress {
  bool is_secure = false;  ///< https
  std::string host, port;
  std::string path = "/";  ///< With the query.
  /// "https://school.example:8443", without the usual port.
  std::string origin() const;
};

/// Parses an address. Returns nothing if it has another protocol than http or https, no host, a user name, or
/// characters that are not printable ASCII.
std::optional<WebAddress> ReadWebAddress(std::string_view text);
/// Whether data sent to this address is protected from third parties: https, or this machine.
bool IsPrivate(const WebAddress& address);

/// The fields of a form or a query, "a=1&b=x%20y", decoded, in their order; at most 100.
using FormFields = std::vector<std::pair<std::string, std::string>>;
FormFields ReadForm(std::string_view text);
std::string WriteForm(const FormFields& fields);
/// The value of the first field of this name; empty if there is none.
std::string FieldOf(const FormFields& fields, std::string_view name);
/// Escapes a text for the content or an attribute of an HTML element.
std::string HtmlText(std::string_view text);

}  // namespace soarbox::lti
