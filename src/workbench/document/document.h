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

#include "debugger/syntax.h"
#include "workbench/panel_id.h"
#include "workbench/requests.h"

namespace soarbox::workbench::document {

/// What a panel shows, without colors, sizes or positions. The window, the page and the text renderer each draw it.
///
/// Rows and foldable parts have keys that stay the same from one document to the next. Renderers keep what the user has
/// set by these keys: filters, sorting, what is unfolded, scroll positions. A document holds requests and no code.

/// What a text means. Each renderer has one color or style for it.
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
  kTag,     ///< A word on a tinted ground; with an action a small button.
};
std::string_view WordOf(Role role);

/// What happens when the user presses something: a request, and the panel that then comes to the front.
struct Action {
  Request request;
  std::optional<PanelId> panel = std::nullopt;
};

/// A piece of text.
struct Span {
  std::string text;
  Role role = Role::kPlain;
  std::optional<Action> action = std::nullopt;       ///< It is a link.
  std::string hint = {};                             ///< Shown over it.
  std::optional<std::uint64_t> tick = std::nullopt;  ///< Instead of a text: the time of this tick, which leads there.
};
using Spans = std::vector<Span>;

struct Paragraph {
  enum class Style : std::uint8_t { kText, kHeading, kTitle, kEmpty } style = Style::kText;
  Spans spans;
  std::string hint = {};
};

/// A text in a fixed font. With `tokens` it is Soar code.
struct Code {
  std::string text;
  std::vector<debugger::Token> tokens = {};
};

struct Button {
  std::string label;
  std::optional<Action> action;
  std::string hint = {};
  std::optional<bool> is_on = std::nullopt;  ///< It is a toggle.
  bool is_enabled = true;
  std::string copies = {};  ///< Instead of an action: this text goes to the clipboard.
};

/// A field of a form. Its value becomes the field `name` of the form's request.
struct Field {
  enum class Kind : std::uint8_t { kLine, kChoice, kCheck, kSuggested } kind = Kind::kLine;
  std::string name;
  std::string label;
  std::string placeholder = {};
  std::string value = {};  ///< To begin with.
  std::vector<std::pair<std::string, std::string>> options =
      {};                  ///< Values and labels. kCheck: off, then on; kSuggested: what a line may be.
  bool is_needed = false;  ///< Without a value nothing is sent.
};

/// Fields that are sent together by a button or by Enter.
struct Form {
  std::string key;
  Action action;  ///< With the fields' values in its request.
  std::vector<Field> fields;
  std::string button;        ///< Empty: none, the fields send while the user types.
  std::string hint = {};     ///< Of the button.
  std::string refusal = {};  ///< Why it cannot be sent now; empty: it can.
  bool clears = false;       ///< Its fields are empty again once it was sent.
  bool repeats = false;      ///< Several are sent one after another: its line keeps the keyboard.
};

/// An action of the rows of a table or tree: a request, one field of which is a row's key or one of its arguments.
struct RowAction {
  Action action;
  std::string_view field = {};  ///< Of the request.
  std::size_t argument = 0;  ///< 0: the row's key; n: its n-th argument. A row that has none of it has no such action.
};

struct Column {
  std::string title;
  bool is_number = false;
  bool is_wide = false;  ///< Left out where the panel is narrow.
  bool wraps = false;    ///< Its texts may take several lines.
  std::string hint = {};
};

struct Cell {
  Spans spans;
  std::optional<double> number = std::nullopt;  ///< What the column is sorted by.
  std::optional<double> bar = std::nullopt;     ///< -1 to 1: how long a bar behind the text is.
};

/// A body's color and sign before the first cell.
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
  int depth = 0;                             ///< Deeper rows belong to the row above them.
  bool folds = false, is_open = false;       ///< Its deeper rows can be folded; whether they are shown to begin with.
  std::uint32_t groups = ~std::uint32_t{0};  ///< A bit for each of the table's groups that it belongs to.
  bool is_chosen = false;
};

struct Table {
  std::string key;
  std::vector<Column> columns;
  std::vector<TableRow> rows;
  std::string caption = {};
  std::optional<RowAction> press = std::nullopt;
  std::string filter = {};                             ///< The label of a field that filters rows; empty: none.
  std::vector<std::string> groups = {};                ///< The user chooses one of them; the first one to begin with.
  std::pair<std::string, std::string> none_fits = {};  ///< What is said if no row passes the filter.
  bool is_sortable = false;
  bool has_heads = true;
};

struct TreeRow {
  std::string key;
  Spans spans;
  std::vector<std::string> arguments = {};
  std::vector<TreeRow> below = {};
  bool folds = false;    ///< It has rows below, whether they are in the document or not.
  bool is_open = false;  ///< To begin with; of a tree with an `unfold` action: now.
};

struct Tree {
  std::string key, label;
  std::vector<TreeRow> rows;
  std::optional<RowAction> press = std::nullopt;
  std::optional<RowAction> unfold = std::nullopt;  ///< The desk keeps what is unfolded.
  std::string filter = {};
};

struct Curve {
  std::string name;
  std::vector<std::pair<double, double>> points = {};  ///< Ticks and values.
};

/// Curves over the time of the run.
struct Plot {
  std::string key, title;
  std::vector<Curve> curves;
  std::string value = {};  ///< The newest value, or why there is none.
  std::string range = {};  ///< The least and the greatest value.
  bool is_stepped = false;
  std::optional<Button> button = std::nullopt;
};

/// Numbered things from left to right, the first one is 1. A click or a drag chooses one.
struct Strip {
  std::string key, label;  ///< What a number stands for: "Episode".
  std::size_t count = 0;
  std::size_t chosen = 0;  ///< 0: none.
  std::vector<std::size_t> marks;
  std::string mark;  ///< What the marked ones are.
  RowAction press;   ///< With the number as the key.
};

/// A part with a heading.
struct Section {
  std::string key;
  Spans title;
  Nodes nodes;
  std::optional<bool> unfolds = std::nullopt;  ///< It can be folded; whether it is open to begin with.
  bool is_story = false;                       ///< All about one thing, over the list that it is from.
};

/// Buttons, forms and texts one after another.
struct Line {
  Nodes nodes;
};

/// Pages of which one is shown.
struct Tabs {
  struct Page {
    std::string title, hint;
    Nodes nodes;
  };
  std::string key;
  std::vector<Page> pages;
  std::size_t first = 0;    ///< Shown until the user chooses.
  std::string reason = {};  ///< When it becomes another one, the first page is shown again; empty: no reason.
};

/// Parts side by side.
struct Columns {
  std::vector<Section> parts;
};

/// Names and what they stand for.
struct Facts {
  std::vector<std::pair<std::string, Spans>> rows;
};

struct Node {
  std::variant<Paragraph, Code, Line, Button, Form, Table, Tree, Plot, Strip, Section, Tabs, Columns, Facts> is;
  template <typename Kind>
  Node(Kind kind) : is(std::move(kind)) {}  // NOLINT: a node is made from what it is.
};

}  // namespace soarbox::workbench::document
