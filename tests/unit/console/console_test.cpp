// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <limits>
#include <sstream>

#include "console/json.hpp"
#include "console/live_line.hpp"
#include "console/percentiles.hpp"
#include "console/progress_bar.hpp"
#include "console/table.hpp"

namespace cleave {
namespace {

TEST(Table, AlignsTextLeftAndFiguresRightWithoutTrailingBlanks) {
  Table table({{"name", Align::left}, {"points", Align::right}, {"note", Align::left}});
  table.add_row({"a", "7", ""});
  table.add_row({"longer", "12345678", "x"});
  EXPECT_EQ(table.to_string(),
            "name      points  note\n"
            "a              7\n"
            "longer  12345678  x\n");
}

TEST(Table, CountsCodePointsNotBytes) {
  Table table({{"name", Align::left}, {"n", Align::left}});
  table.add_row({"Küche", "1"});
  table.add_row({"abcde", "2"});
  EXPECT_EQ(table.to_string(), "name   n\nKüche  1\nabcde  2\n");
}

TEST(Table, RefusesARowWithAnotherNumberOfCells) {
  Table table({{"one", Align::left}});
  EXPECT_THROW(table.add_row({"a", "b"}), std::invalid_argument);
}

TEST(Table, LetsNoForeignTextDriveTheTerminal) {
  Table table({{"name", Align::left}});
  table.add_row({"\x1b[2Jevil\n"});
  EXPECT_EQ(table.to_string(), "name\n?[2Jevil?\n");
}

TEST(LiveLine, RewritesOneLineOnATerminalAndCutsItToTheWindow) {
  std::ostringstream out;
  {
    LiveLine line(out, 5);
    line.show("abcdefgh");
    line.show("xy");
  }
  EXPECT_EQ(out.str(), "\rabcd\x1b[K\rxy\x1b[K\n");
}

TEST(LiveLine, PrintsPlainLinesElsewhere) {
  std::ostringstream out;
  {
    LiveLine line(out, 0);
    line.show("first");
    line.show("second");
  }
  EXPECT_EQ(out.str(), "first\nsecond\n");
}

TEST(Spread, IsMeanMinAndMaxAndZeroOfNothing) {
  const Spread values = spread({2, -1, 5});
  EXPECT_DOUBLE_EQ(values.mean, 2);
  EXPECT_DOUBLE_EQ(values.min, -1);
  EXPECT_DOUBLE_EQ(values.max, 5);
  EXPECT_DOUBLE_EQ(spread({}).mean, 0);
}

TEST(ProgressBar, IsSilentWhereThereIsNoTerminal) {
  std::ostringstream out;
  { ProgressBar(out, 0).show(5, 10); }
  EXPECT_EQ(out.str(), "");
}

TEST(ProgressBar, FillsWithWhatIsDoneAndVanishes) {
  std::ostringstream out;
  { ProgressBar(out, 18).show(5, 10); }
  EXPECT_EQ(out.str(), "\r[#####.....] 5/10\x1b[K\r\x1b[K");
}

TEST(Percentiles, AreMeasuredValuesByNearestRank) {
  std::vector<double> values;
  for (int i = 200; i >= 1; --i) values.push_back(i);
  const Percentiles p = percentiles(values);
  EXPECT_EQ(p.median, 100);
  EXPECT_EQ(p.p90, 180);
  EXPECT_EQ(p.p99, 198);
  EXPECT_EQ(percentiles({5}).p99, 5);
  EXPECT_EQ(percentiles({}).median, 0);
}

TEST(RecentValues, ForgetsTheOldest) {
  RecentValues values(3);
  for (const double value : {100.0, 100.0, 1.0, 2.0, 3.0}) values.add(value);
  EXPECT_EQ(values.percentiles().p99, 3);
  EXPECT_EQ(values.percentiles().median, 2);
}

TEST(Json, IsOneLineWithKeysInOrderWhateverTheTextIs) {
  const Json json = {{"z", "bad \xff byte"},
                     {"a", std::numeric_limits<double>::quiet_NaN()},
                     {"decimal", decimal(0.3F)}};
  EXPECT_EQ(one_line(json), "{\"z\":\"bad \xef\xbf\xbd byte\",\"a\":null,\"decimal\":0.3}");
}

}  // namespace
}  // namespace cleave
