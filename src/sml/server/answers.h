// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <memory>
#include <span>
#include <string>

#include "cli/result_node.h"
#include "sml/server/connection.h"
#include "sml/wire/element.h"
#include "sml/wire/message.h"

namespace soarbox::server {

/// Adds the result of a command line to a response, as text or as elements.
void AddLineResult(wire::Message& response, const cli::CommandResult& result, bool structured);
/// The <sml> of a response with a structured result, for clients in this process.
std::shared_ptr<const wire::Element> StructuredDocument(const cli::CommandResult& result);
/// The output of a failed command line, followed by the errors that it does not show, with file, line and column.
std::string ErrorDetails(const cli::CommandResult& result);
/// The warnings of a successful command line: probable mistakes in rules that it loaded. Usually empty.
std::string Warnings(const cli::CommandResult& result);
/// The <command> of an input message, as an event reports it.
wire::Element InputReceivedCommand(HostedAgent& agent, std::span<const InputWme> wmes);
std::shared_ptr<const wire::Element> InputReceivedDocument(HostedAgent& agent, std::span<const InputWme> wmes);

}  // namespace soarbox::server
