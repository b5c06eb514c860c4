// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <memory>
#include <span>
#include <string>

#include "cli/result.h"
#include "sml/server/connection.h"
#include "sml/wire/element.h"
#include "sml/wire/message.h"

namespace soarbox::server {

/// Adds a command line's answer to a response: text, or elements.
void AddLineResult(wire::Message& response, const cli::CommandResult& result, bool structured);
/// The response <sml> of a structured answer, for clients in this process.
std::shared_ptr<const wire::Element> StructuredDocument(const cli::CommandResult& result);
/// The text of a failed command line, and every error with file, line and column that the text does not show.
std::string ErrorDetails(const cli::CommandResult& result);
/// What a command line that succeeded warns of: traps in rules that it loaded. Empty for nearly all.
std::string Warnings(const cli::CommandResult& result);
/// The <command> of an input message, as an event shows it.
wire::Element InputReceivedCommand(HostedAgent& agent, std::span<const InputWme> wmes);
std::shared_ptr<const wire::Element> InputReceivedDocument(HostedAgent& agent, std::span<const InputWme> wmes);

}  // namespace soarbox::server
