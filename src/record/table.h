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

/// A cell of a table. The first alternative is an empty cell.
using Cell = std::variant<std::monostate, double, std::int64_t, std::string>;

struct Column {
  std::string name;
  const char* type = " REAL";  ///< SQL type of the column, after a space; empty if the cells have different types.
};
inline constexpr const char *kText = " TEXT", *kWhole = " INTEGER";

/// Receives tables row by row, so that no table has to fit into memory.
class TableSink {
 public:
  virtual ~TableSink() = default;
  /// Begins a table. Tables are numbered from 0 in this order.
  virtual Result<void> Begin(const std::string& table, const std::vector<Column>& columns) = 0;
  /// Adds a row with a cell for each column.
  virtual Result<void> Add(std::size_t table, const std::vector<Cell>& row) = 0;
  /// Completes all tables. The output is valid only after this call.
  virtual Result<void> Finish() = 0;
};

/// Additional names and values that are stored with the tables.
using Metadata = std::vector<std::pair<std::string, std::string>>;

}  // namespace soarbox::record
