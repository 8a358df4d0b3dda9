// SPDX-License-Identifier: BSD-3-Clause
// Rows of text in aligned columns.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace cleave {

// Text from elsewhere with its control characters replaced by '?', so that it cannot drive the
// terminal.
[[nodiscard]] std::string printable(std::string_view text);

enum class Align { left, right };

class Table {
 public:
  struct Column {
    std::string title;
    Align align;
  };
  explicit Table(std::vector<Column> columns) : columns_(std::move(columns)) {}

  // One cell a column. Throws std::invalid_argument for any other number of them.
  void add_row(std::vector<std::string> cells);
  [[nodiscard]] std::size_t rows() const { return rows_.size(); }

  // The titles and the rows, a line each, without trailing blanks.
  [[nodiscard]] std::string to_string() const;

 private:
  std::vector<Column> columns_;
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace cleave
