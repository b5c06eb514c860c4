// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "explain/memory_facts.h"
#include "mind/inspection_facts.h"
#include "workbench/contents.h"
#include "workbench/document/document.h"

namespace soarbox::workbench::document {

// Builders for parts that the documents of several panels share.

Node Text(std::string text, Role role = Role::kPlain);
Node Text(Spans spans);
/// "Sent: 12"
Node Named(const std::string& name, std::string value, Role role = Role::kPlain);
Node Heading(std::string text, std::string hint = {});
/// The text of an empty panel: what is missing, and what to do about it.
Node Empty(std::string what, std::string advice = {});

Span Quiet(std::string text);
Span Time(std::uint64_t tick);
/// A link to the rule in the panel Rules.
Span RuleLink(const std::string& rule, Role role = Role::kName);
/// A link that selects the agent.
Span AgentLink(const std::string& agent);
/// The tooltip of links to elements.
inline constexpr const char* kElementHint = "Which rule made it, and which rules test it";
/// A link to the element in the panel Memory: "(S1 ^io I1)".
Span ElementLink(const mind::ElementFact& element);
/// A link to the file: opens it in the panel Edit if it can be edited there, else in the user's editor.
Span FileLink(const Contents& contents, const std::string& file, int line, std::string text);
Action AskWhy(WhyRequest::About about, std::string what);

/// "(S1 ^io I1 +)"
std::string ElementText(const mind::ElementFact& element);
/// "move-to (O3)"
std::string NamedAs(const std::string& name, const std::string& id);
/// "1 match", "2 matches"
std::string Count(std::uint64_t count, std::string_view one, std::string_view many);
/// Removes the zeros at the end of a number's fraction: "39.5" for "39.500000". Returns other texts unchanged.
std::string ShortNumber(std::string_view text);
/// "0:01.20"
std::string ClockText(double seconds);
/// The value with at most `digits` significant digits.
std::string Rounded(double value, int digits = 4);
/// Whether the text is a number.
bool IsNumber(std::string_view text);

Cell TextCell(std::string text, Role role = Role::kPlain);
Cell NumberCell(double value, std::string text, Role role = Role::kPlain);
Cell CountCell(std::uint64_t count);
Cell TimeCell(std::uint64_t tick);
/// A small button.
Cell ButtonCell(std::string label, Request request, std::string hint);
/// The label of buttons that remove something.
inline constexpr const char* kRemove = "\xc3\x97";

/// The table, or the text of an empty panel if the table has no rows.
Node OrEmpty(Table table, std::string what, std::string advice = {});
/// A form with one line. Without a button it is sent while the user types.
Form LineForm(std::string key, Request request, Field line, std::string button = {});

/// If the selected agent's mind cannot be shown: nodes that say why, and what to do. Nothing if it can.
std::optional<Nodes> WithoutMind(const Contents& contents);
/// For a recorded mind: adds a note that the data come from the recording. Adds nothing for a live run.
void NoteRecorded(const Contents& contents, Nodes& nodes);
/// A tree of reasons that is initially unfolded to depth `open_to`.
Tree ReasonTree(const Contents& contents, const debugger::WhyNode& root, int open_to = 3);
/// Toggles for the agents whose minds are shown side by side.
Line BesideLine(const Contents& contents);

}  // namespace soarbox::workbench::document
