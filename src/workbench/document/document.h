// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "debugger/console.h"
#include "debugger/syntax.h"
#include "workbench/checks.h"
#include "workbench/panel_id.h"
#include "workbench/requests.h"

namespace soarbox::workbench::document {

/// The description of a panel without colours, sizes or positions. The window, the page and the text renderer each draw
/// it.
///
/// Rows and foldable parts have keys that stay the same from one document to the next. Renderers use the keys to keep
/// what the user has set: filters, sorting, unfolded rows, scroll positions. A document contains requests but no code.

/// The meaning of a text. Each renderer has one color or style for it.
enum class Role : std::uint8_t {
  kPlain,
  kStrong,
  kQuiet,
  kCode,
  kGood,
  kWarn,
  kBad,
  kNew,     ///< Added in this tick.
  kGone,    ///< Removed in this tick.
  kNumber,  ///< Also commands.
  kObject,  ///< An identifier of working memory, or a variable.
  kName,    ///< An attribute, or the name of a rule.
  kTag,     ///< A word on a tinted background; with an action, a small button.
};
std::string_view WordOf(Role role);

/// The effect of a click: a request, and the panel that then comes to the front.
struct Action {
  Request request;
  std::optional<PanelId> panel = std::nullopt;
};

/// A piece of text.
struct Span {
  std::string text;
  Role role = Role::kPlain;
  std::optional<Action> action = std::nullopt;       ///< The text is a link.
  std::string hint = {};                             ///< Tooltip.
  std::optional<std::uint64_t> tick = std::nullopt;  ///< If set, the time of this tick replaces the text; a click goes
                                                     ///< to the tick.
};
using Spans = std::vector<Span>;

struct Paragraph {
  enum class Style : std::uint8_t { kText, kHeading, kTitle, kEmpty } style = Style::kText;
  Spans spans;
  std::string hint = {};
};

/// A text in a monospaced font. With `tokens` it is Soar code.
struct Code {
  std::string text;
  std::vector<debugger::Token> tokens = {};
};

struct Button {
  std::string label;
  std::optional<Action> action;
  std::string hint = {};
  std::optional<bool> is_on = std::nullopt;  ///< If set, the button is a toggle.
  bool is_enabled = true;
  bool is_main = false;     ///< The most likely next thing to do.
  std::string copies = {};  ///< If not empty: the button has no action and copies this text to the clipboard.
};

/// What a command line needs besides its text. Its requests get the typed text in their field `line`.
struct CommandLine {
  Action complete;                  ///< Asks for completions, when the Tab key is pressed.
  Action keep;                      ///< Stores a text that is not sent.
  std::string completed_line = {};  ///< The line for which completions were last requested.
  debugger::Completion found = {};  ///< The completions of that line.
};

/// A field of a form. Its value is stored in the field `name` of the form's request.
struct Field {
  /// kCommand: a line with a history (arrow keys) and completion (Tab).
  enum class Kind : std::uint8_t { kLine, kChoice, kCheck, kSuggested, kCommand } kind = Kind::kLine;
  std::string name;
  std::string label;
  std::string placeholder = {};
  std::string value = {};  ///< Initial value.
  std::vector<std::pair<std::string, std::string>> options =
      {};                  ///< Values and labels. kCheck: off, then on; kSuggested: suggestions for the line.
  bool is_needed = false;  ///< The form is not sent while the field is empty.
  std::optional<CommandLine> command = std::nullopt;  ///< Of kCommand.
  std::string prompt = {};  ///< Of kCommand: drawn before the field; the label is then for screen readers only.
};

/// Fields that are sent together, by a button or by Enter.
struct Form {
  std::string key;
  Action action;  ///< Its request gets the values of the fields.
  std::vector<Field> fields;
  std::string button;        ///< Label of the button; empty: no button, and the form is sent while the user types.
  std::string hint = {};     ///< Tooltip of the button.
  std::string refusal = {};  ///< Why the form cannot be sent now; empty if it can.
  bool clears = false;       ///< Sending it clears its fields.
  bool repeats = false;      ///< Users send it several times in a row: the field keeps the keyboard focus.
};

/// The action of a click on a row of a table or tree. One field of its request is set to the row's key, or to one of
/// the row's arguments.
struct RowAction {
  Action action;
  std::string_view field = {};  ///< The field of the request.
  std::size_t argument = 0;     ///< 0: the row's key; n: its n-th argument. Rows without that argument have no action.
  std::string hint = {};        ///< Tooltip of rows of a tree.
};

struct Column {
  std::string title;
  bool is_number = false;
  bool is_wide = false;  ///< Hidden if the panel is narrow.
  bool wraps = false;    ///< Its texts may wrap.
  std::string hint = {};
};

struct Cell {
  Spans spans;
  std::optional<double> number = std::nullopt;  ///< The column is sorted by this number.
  std::optional<double> bar = std::nullopt;     ///< -1 to 1: length of a bar in the background.
};

/// The color and symbol of a body, drawn before the first cell.
struct BodySign {
  std::string team, kind;
  bool is_foreign = false;
};

struct Node;
using Nodes = std::vector<Node>;

struct TableRow {
  std::string key;
  std::vector<Cell> cells;
  std::string hint = {};
  std::vector<std::string> arguments = {};
  std::optional<BodySign> sign = std::nullopt;
  int depth = 0;                             ///< A deeper row belongs to the row above it.
  bool folds = false, is_open = false;       ///< Whether deeper rows can be folded, and whether they are initially
                                             ///< shown.
  std::uint32_t groups = ~std::uint32_t{0};  ///< A bit for each group of the table that the row belongs to.
  bool is_chosen = false;
};

struct Table {
  std::string key;
  std::vector<Column> columns;
  std::vector<TableRow> rows = {};
  std::string caption = {};
  std::optional<RowAction> press = std::nullopt;
  std::string filter = {};               ///< The label of a field that filters rows; empty: no field.
  std::vector<std::string> groups = {};  ///< The user chooses one of them; initially the first.
  std::string groups_hint = "Which rows are shown";
  std::pair<std::string, std::string> none_fits = {};  ///< The text if no row passes the filter.
  bool is_sortable = false;
  bool has_heads = true;

  TableRow& Add(std::string row, std::vector<Cell> cells) {
    return rows.emplace_back(TableRow{std::move(row), std::move(cells)});
  }
};

struct TreeRow {
  std::string key;
  Spans spans;
  std::vector<std::string> arguments = {};
  std::vector<TreeRow> below = {};
  bool folds = false;    ///< It has rows below it, although the document may not contain them.
  bool is_open = false;  ///< Initial state; in a tree with an `unfold` action, the present state.
};

struct Tree {
  std::string key, label;
  std::vector<TreeRow> rows;
  std::optional<RowAction> press = std::nullopt;
  std::optional<RowAction> unfold = std::nullopt;  ///< If set, the desk stores which rows are unfolded.
  std::string filter = {};
};

struct Curve {
  std::string name;
  std::vector<std::pair<double, double>> points = {};  ///< Tick and value.
};

/// Curves over the time of the run.
struct Plot {
  std::string key, title;
  std::vector<Curve> curves;
  std::string value = {};  ///< The newest value, or why there is none.
  std::string range = {};  ///< The minimum and the maximum.
  bool is_stepped = false;
  std::optional<Button> button = std::nullopt;
};

/// A row of numbered boxes from left to right, starting at 1. A click or a drag selects one.
struct Strip {
  std::string key, label;  ///< `label` is the meaning of a number: "Episode".
  std::size_t count = 0;
  std::size_t chosen = 0;  ///< The selected number; 0: none.
  std::vector<std::size_t> marks;
  std::string mark;  ///< The meaning of a mark.
  RowAction press;   ///< The number is used as the key.
};

/// A list of requirements, each with its present result.
struct Checklist {
  struct Item {
    std::string key;
    CheckResult result = CheckResult::kOpen;
    std::string says;  ///< The result in words.
    Spans spans;
    Spans below = {};  ///< In a line of its own.
    std::string hint = {};
  };
  std::vector<Item> items;
};
std::string_view WordOf(CheckResult result);

/// Lines that a run or a user appends. The newest line is visible, unless the user has scrolled to an earlier one. When
/// the user sends a command line of the same document, the newest line becomes visible again.
struct Transcript {
  std::string key, label;
  Spans lines;              ///< One span for each line.
  std::uint64_t count = 0;  ///< Changes when a line is appended.
};

/// A text with a bar: `value` of `of` are done.
struct Progress {
  std::string text;
  std::size_t value = 0, of = 0;
};

/// A part of a document with a heading. Nothing is drawn if it has neither a title nor nodes.
struct Section {
  std::string key;  ///< Its first word is the same in all documents of the panel.
  Spans title;
  Nodes nodes;
  std::optional<bool> unfolds = std::nullopt;  ///< If set, the section can be folded, and the value says whether it is
                                               ///< initially open.
  bool is_story = false;                       ///< It shows the details of an item, above the list that contains the
                                               ///< item.
  std::optional<Role> box = std::nullopt;  ///< If set, the section is set off from the rest, in the color of this role.
  /// What the user waits for. When this text changes to another that is not empty, renderers scroll to the section. The
  /// page also brings the panel to the front.
  std::optional<std::string> news = std::nullopt;
};

/// Buttons, forms and texts in one line.
struct Line {
  Nodes nodes;
};

/// A line of buttons and forms at the lower edge of the panel, which stays visible while the rest scrolls. The last
/// node of a document.
struct Actions {
  Nodes nodes;
};

/// Several pages, of which one is shown.
struct Tabs {
  struct Page {
    std::string title, hint;
    Nodes nodes;
  };
  std::string key;
  std::vector<Page> pages;
  std::size_t first = 0;    ///< The page that is shown until the user selects one.
  std::string reason = {};  ///< When this text changes, renderers show the page `first` again.
};

/// Sections side by side.
struct Columns {
  std::vector<Section> parts;
};

struct Node {
  std::variant<Paragraph, Code, Line, Button, Form, Table, Tree, Plot, Strip, Checklist, Progress, Transcript, Section,
               Actions, Tabs, Columns>
      is;
  template <typename Kind>
  Node(Kind kind) : is(std::move(kind)) {}  // NOLINT: parts are converted to nodes implicitly.
};

}  // namespace soarbox::workbench::document
