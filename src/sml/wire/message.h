// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "diagnostics/result.h"
#include "sml/wire/element.h"

namespace soarbox::wire {

/// The version in every message and in the response to `version`.
inline constexpr std::string_view kSmlVersion = "9.6.3";

/// A call that Soar 9.6.3 does not have: it sets the folders that files loaded for an agent may read, one per line.
/// kFenced marks command lines to which this restriction applies.
inline constexpr const char* kFenceCall = "soarbox_fence";
inline constexpr const char* kFenceFolders = "folders";
inline constexpr const char* kFenced = "fenced";

/// A call that Soar 9.6.3 does not have: it requests what clients did to the agents (sml/server/client_log.h), from a
/// byte on. The response contains a part of the log; it is empty if there is nothing new. The response is an error if
/// no log is kept.
inline constexpr const char* kLogCall = "soarbox_log";
inline constexpr const char* kLogFrom = "from";
/// The response if the log has ended. Escaped text of a log never contains these characters.
inline constexpr const char* kLogEnded = "\\ended";

enum class DocType : std::uint8_t { kCall, kResponse, kNotify };

/// A document: a call, a response, or a notification without a response.
struct Message {
  DocType type = DocType::kCall;
  std::string id;   ///< The sender's number, as text.
  std::string ack;  ///< For a response: the id of the call.
  Element root;     ///< <sml>; its children are the contents.

  const Element* Command() const { return root.Child("command"); }
  const Element* ResultTag() const { return root.Child("result"); }
  const Element* ErrorTag() const { return root.Child("error"); }
};

/// A call without contents; add <command> to root.
Message MakeCall(std::string_view command);
Message MakeResponse(std::string_view ack);
/// Adds <result output="raw">text</result>.
void AddRawResult(Message& response, std::string_view text);
/// Adds the result and the error of a failed call; `code` may be empty.
void AddError(Message& response, std::string_view text, std::string_view code = {});

/// Adds doctype, id, ack and version to the root and returns the document as text.
std::string ToDocument(const Message& message);
/// Parses a document. Returns an error if the text is not XML, or if its root is not <sml> with a doctype.
Result<Message> ReadMessage(std::string_view document);

/// A number in the shortest form that is read back as the same number, formatted like `%g` with 16 digits: 0, 100,
/// 50.25, 1e-10.
std::string ShortDouble(double value);
/// A number with six decimals, the form in which the kernel sends it.
std::string FixedDouble(double value);

}  // namespace soarbox::wire
