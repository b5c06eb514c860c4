// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "diagnostics/result.h"

namespace soarbox::record {

/// A value of a table; the first alternative is an empty cell.
using Cell = std::variant<std::monostate, double, std::int64_t, std::string>;

struct Column {
  std::string name;
  const char* type = " REAL";  ///< For SQL; empty: as each cell is.
};
inline constexpr const char *kText = " TEXT", *kWhole = " INTEGER";

/// Where tables go row by row, so that no table needs to fit into memory.
class TableSink {
 public:
  virtual ~TableSink() = default;
  /// Begins a table; they are numbered from 0 in this order.
  virtual Result<void> Begin(const std::string& table, const std::vector<Column>& columns) = 0;
  /// Adds a row with a cell for each column.
  virtual Result<void> Add(std::size_t table, const std::vector<Cell>& row) = 0;
  /// Completes all tables. What was written before counts only after this.
  virtual Result<void> Finish() = 0;
};

/// Names and values that tables come with.
using Metadata = std::vector<std::pair<std::string, std::string>>;

}  // namespace soarbox::record
