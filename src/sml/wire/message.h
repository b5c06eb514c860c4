// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "diagnostics/result.h"
#include "sml/wire/element.h"

namespace soarbox::wire {

/// The version that stands in every message and that `version` answers.
inline constexpr std::string_view kSmlVersion = "9.6.3";

/// A call that Soar 9.6.3 does not have: what files that are loaded for an agent may read. Its folders, one a line, and
/// the mark on command lines for which that holds.
inline constexpr const char* kFenceCall = "soarbox_fence";
inline constexpr const char* kFenceFolders = "folders";
inline constexpr const char* kFenced = "fenced";

/// A call that Soar 9.6.3 does not have: what clients did to the agents (sml/server/client_log.h), from a byte on. The
/// answer is a part of the log; an empty one: there is no more at present. An error: no log is kept, or it has ended.
inline constexpr const char* kLogCall = "soarbox_log";
inline constexpr const char* kLogFrom = "from";

enum class DocType : std::uint8_t { kCall, kResponse, kNotify };

/// A document: a call, the response to one, or a notice that nobody answers.
struct Message {
  DocType type = DocType::kCall;
  std::string id;   ///< The sender's number, as text.
  std::string ack;  ///< Of a response: the id of the call.
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
/// Adds the result and the error that a failed call gives; `code` may be empty.
void AddError(Message& response, std::string_view text, std::string_view code = {});

/// Puts doctype, id, ack and version into the root and writes the document.
std::string ToDocument(const Message& message);
/// Reads a document. An error for text that is not XML, or whose root is not <sml> with a doctype.
Result<Message> ReadMessage(std::string_view document);

/// A number in the shortest form that reads back as the same number, as `%g` with 16 digits prints it: 0, 100, 50.25,
/// 1e-10.
std::string ShortDouble(double value);
/// A number with six decimals, as the kernel sends it.
std::string FixedDouble(double value);

}  // namespace soarbox::wire
