// SPDX-License-Identifier: BSD-3-Clause
#include "console/table.hpp"

#include <algorithm>
#include <stdexcept>

namespace cleave {
namespace {

constexpr std::size_t gap_columns = 2;

// Code points, which is what a terminal shows as columns for the text that we print.
std::size_t displayed_width(std::string_view text) {
  const auto begins_code_point = [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
  };
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), begins_code_point));
}

}  // namespace

std::string printable(std::string_view text) {
  std::string result(text);
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; };
  std::replace_if(result.begin(), result.end(), is_control, '?');
  return result;
}

void Table::add_row(std::vector<std::string> cells) {
  if (cells.size() != columns_.size()) {
    throw std::invalid_argument("a table row has " + std::to_string(cells.size()) +
                                " cells, the table has " + std::to_string(columns_.size()) +
                                " columns");
  }
  for (std::string& cell : cells) cell = printable(cell);
  rows_.push_back(std::move(cells));
}

std::string Table::to_string() const {
  std::vector<std::string> titles;
  std::vector<std::size_t> widths;
  for (std::size_t c = 0; c < columns_.size(); ++c) {
    titles.push_back(columns_[c].title);
    widths.push_back(displayed_width(columns_[c].title));
    for (const auto& row : rows_) widths[c] = std::max(widths[c], displayed_width(row[c]));
  }

  std::string text;
  const auto append_line = [&](const std::vector<std::string>& cells) {
    std::string line;
    for (std::size_t c = 0; c < cells.size(); ++c) {
      const std::string padding(widths[c] - displayed_width(cells[c]), ' ');
      if (c > 0) line.append(gap_columns, ' ');
      line += columns_[c].align == Align::left ? cells[c] + padding : padding + cells[c];
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + '\n';
  };
  append_line(titles);
  for (const auto& row : rows_) append_line(row);
  return text;
}

}  // namespace cleave
