// SPDX-License-Identifier: BSD-3-Clause
// What a header may look like, and what is refused: with which cause, and in which words.
#include "recording/pcd/header.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include "recording/pcd/cloud.hpp"
#include "tests/unit/recording/pcd/pcd_files.hpp"

namespace cleave::recording {
namespace {

struct Variant {
  const char* name;
  std::string content;
};

std::string name_of_variant(const testing::TestParamInfo<Variant>& info) {
  return info.param.name;
}

// The file of `PcdText` with changes.
template <class Change>
std::string with(Change change) {
  PcdText pcd;
  change(pcd);
  return to_file(pcd);
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) {
    text.replace(at, from.size(), to);
  }
  return text;
}

std::string without_line(const std::string& key) {
  std::string text = to_file({});
  const std::size_t begin = text.find("\n" + key);
  return text.erase(begin, text.find('\n', begin + 1) - begin);
}

const std::string good = to_file({});

// All of these hold the two points 1 2 3 and 4 5 6.
class GoodHeader : public testing::TestWithParam<Variant> {};

TEST_P(GoodHeader, GivesThePoints) {
  const TestFolder folder;
  const PcdCloud cloud = PcdCloud::read(folder.write("a.pcd", GetParam().content));
  EXPECT_EQ(std::vector<float>(cloud.xyz().begin(), cloud.xyz().end()),
            (std::vector<float>{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(cloud.header().points(), 2U);
}

INSTANTIATE_TEST_SUITE_P(
    Variants, GoodHeader,
    testing::Values(
        Variant{"AsPclWritesIt", good}, Variant{"ByteOrderMark", "\xEF\xBB\xBF" + good},
        Variant{"CrLf", replaced(good, "\n", "\r\n")},
        Variant{"CrAlone", replaced(good, "\n", "\r")},
        Variant{"BlanksAround", replaced(good, "\n", " \t\n \t")},
        Variant{"EmptyLines", replaced(good, "\n", "\n\n")},
        Variant{"Tabs", replaced(good, " ", "\t")},
        Variant{"CommentsAnywhere", replaced(good, "\nSIZE", "\n# a comment\n  #another\nSIZE")},
        Variant{"NoLineEndAtTheEnd", good.substr(0, good.size() - 1)},
        Variant{"MoreBehindThePoints", good + "7 8\nwords\n"},
        Variant{"NoVersion", without_line("VERSION")},
        Variant{"Version7", replaced(good, "VERSION 0.7", "VERSION .7")},
        Variant{"Version5", replaced(good, "VERSION 0.7", "VERSION .5")},
        Variant{"NoCount", without_line("COUNT")},
        Variant{"NoViewpoint", without_line("VIEWPOINT")},
        Variant{"NoHeight", without_line("HEIGHT")}, Variant{"NoWidth", without_line("WIDTH")},
        Variant{"NoPoints", without_line("POINTS")},
        Variant{"OnlyPoints", replaced(without_line("WIDTH"), "HEIGHT 1\n", "")},
        Variant{"SizesOf0", replaced(replaced(good, "WIDTH 2", "WIDTH 0"), "HEIGHT 1", "HEIGHT 0")},
        Variant{"Columns", "COLUMNS x y z\nPOINTS 2\nDATA ascii\n1 2 3\n4 5 6\n"},
        Variant{"LowerCaseTypes", with([](PcdText& pcd) { pcd.type = "f f f"; })},
        Variant{"AnotherOrderOfLines",
                "POINTS 2\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nCOUNT 1 1 1\nTYPE F F F\n"
                "SIZE 4 4 4\nFIELDS x y z\nWIDTH 2\nDATA ascii\n1 2 3\n4 5 6\n"},
        Variant{"CommasInViewpoint", with([](PcdText& pcd) { pcd.viewpoint = "0,0,0,1,0,0,0"; })},
        Variant{"AnotherOrderOfFields", with([](PcdText& pcd) {
                  pcd = {"label z y x", "4 8 4 8", "U F F F", "1 1 1 1"};
                  pcd.data = "9 3 2 1\n9 6 5 4\n";
                })},
        Variant{"Padding", with([](PcdText& pcd) {
                  pcd = {"x _ y z _", "4 1 4 4 1", "F U F F U", "1 2 1 1 3"};
                  pcd.data = "1 0 0 2 3 0 0 0\n4 0 0 5 6 0 0 0\n";
                })},
        Variant{"Count0", with([](PcdText& pcd) {
                  pcd = {"x y z _ ring", "4 4 4 1 2", "F F F U U", "1 1 1 0 1"};
                  pcd.data = "1 2 3 7\n4 5 6 8\n";
                })},
        Variant{"WholeNumbersAsCoordinates", with([](PcdText& pcd) {
                  pcd.size = "1 2 8";
                  pcd.type = "U I i";
                })}),
    name_of_variant);

struct Refused {
  const char* name;
  std::string content;
  const char* cause;
  const char* why;
};

std::string name_of_refused(const testing::TestParamInfo<Refused>& info) {
  return info.param.name;
}

class BadHeader : public testing::TestWithParam<Refused> {};

TEST_P(BadHeader, IsRefusedWithCauseAndReason) {
  expect_refused(GetParam().content, GetParam().cause, GetParam().why);
}

template <class Change>
Refused bad(const char* name, const char* why, Change change) {
  return {name, with(change), "bad header", why};
}

INSTANTIATE_TEST_SUITE_P(
    NoPcd, BadHeader,
    testing::Values(Refused{"Empty", "", "not PCD", "is no PCD file"},
                    Refused{"Ply", "ply\nformat ascii 1.0\n", "not PCD", "begins with 'ply'"},
                    Refused{"Ppm", "P6\n640 480\n255\n", "not PCD", "line 1: is no PCD file"},
                    Refused{"Zeros", std::string(1000, '\0'), "not PCD", "is no PCD file"},
                    Refused{"OneLongLine", std::string(3 << 20, 'x'), "not PCD", "is no PCD file"},
                    Refused{"Utf16", std::string("\xFF\xFE#\0", 4), "not PCD", "UTF-16"}),
    name_of_refused);

INSTANTIATE_TEST_SUITE_P(
    Lines, BadHeader,
    testing::Values(
        Refused{"UnknownKeyword", replaced(good, "SIZE", "SIZ"), "bad header",
                "line 4: the header has 'SIZ', which is none of PCD's words"},
        Refused{"EndsEarly", "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\n", "truncated",
                "no line DATA"},
        Refused{"NoDataIn64kB",
                "VERSION 0.7\n" + replaced(std::string(4000, 'x'), "x", "# a comment\n  \t \n"),
                "truncated", "no line DATA in its first 64 kB"},
        Refused{"TwoLinesOfAKind", "FIELDS x y z\nWIDTH 1\nWIDTH 100000000\nDATA ascii\n",
                "bad header", "line 3: the header has two lines WIDTH"},
        Refused{"FieldsAndColumns", "FIELDS x y z\nCOLUMNS x y z\nPOINTS 1\nDATA ascii\n1 2 3\n",
                "bad header", "two lines FIELDS"},
        Refused{"NoSize", without_line("SIZE"), "bad header", "has no SIZE"},
        Refused{"NoType", without_line("TYPE"), "bad header", "has no TYPE"},
        Refused{"NeitherWidthNorPoints", replaced(without_line("WIDTH"), "POINTS 2\n", ""),
                "bad header", "neither WIDTH nor POINTS"},
        bad("NoFields", "has no FIELDS", [](PcdText& pcd) { pcd.fields = ""; }),
        bad("UnknownEncoding", "DATA is 'zip'", [](PcdText& pcd) { pcd.encoding = "zip"; })),
    name_of_refused);

INSTANTIATE_TEST_SUITE_P(
    Fields, BadHeader,
    testing::Values(
        bad("MissingCoordinate", "has no field z of one number a point; its fields are x y i",
            [](PcdText& pcd) { pcd.fields = "x y i"; }),
        bad("CoordinateOfTwoNumbers", "has no field z of one number",
            [](PcdText& pcd) { pcd.count = "1 1 2"; }),
        bad("CoordinateOfCount0", "has no field z of one number",
            [](PcdText& pcd) { pcd.count = "1 1 0"; }),
        bad("TooFewSizes", "3, 2, 3 and 3 entries", [](PcdText& pcd) { pcd.size = "4 4"; }),
        bad("UnknownType", "field z has TYPE Q and SIZE 4",
            [](PcdText& pcd) { pcd.type = "F F Q"; }),
        bad("UnknownSize", "field z has TYPE F and SIZE 3",
            [](PcdText& pcd) { pcd.size = "4 4 3"; }),
        bad("FloatOfOneByte", "field z has TYPE F and SIZE 1",
            [](PcdText& pcd) { pcd.size = "4 4 1"; }),
        bad("HugeCount", "COUNT 4000000000", [](PcdText& pcd) { pcd.count = "1 1 4000000000"; }),
        bad("PointsOfGigabytes", "COUNT 400000000",
            [](PcdText& pcd) {
              pcd = {"x y z blob", "4 4 4 8", "F F F F", "1 1 1 400000000"};
            }),
        bad("NegativeCount", "COUNT is '-1'", [](PcdText& pcd) { pcd.count = "1 1 -1"; }),
        bad("NameTwice", "names the field x twice", [](PcdText& pcd) { pcd.fields = "x y x"; })),
    name_of_refused);

INSTANTIATE_TEST_SUITE_P(
    Sizes, BadHeader,
    testing::Values(
        bad("Disagree", "WIDTH x HEIGHT is 640 x 480 but its POINTS is 2",
            [](PcdText& pcd) {
              pcd.width = "640";
              pcd.height = "480";
            }),
        bad("WordForANumber", "WIDTH is 'two'", [](PcdText& pcd) { pcd.width = "two"; }),
        bad("NegativePoints", "POINTS is '-2'", [](PcdText& pcd) { pcd.points = "-2"; }),
        bad("WidthBeyond64Bits", "WIDTH is '99999999999999999999'",
            [](PcdText& pcd) { pcd.width = "99999999999999999999"; }),
        // 2^33 * 2^31 + 2 overflows to 2 in 64 bits.
        bad("ProductOverflows", "WIDTH is '8589934592'",
            [](PcdText& pcd) {
              pcd.width = "8589934592";
              pcd.height = "2147483648";
            }),
        Refused{"NoPoint", with([](PcdText& pcd) { pcd.width = pcd.points = "0"; }), "no points",
                "holds no point"},
        Refused{"NoPointAtAll",
                with([](PcdText& pcd) { pcd.width = pcd.height = pcd.points = "0"; }), "no points",
                "holds no point"},
        Refused{"HugeText", with([](PcdText& pcd) {
                  pcd.width = pcd.height = "4294967295";
                  pcd.points = "18446744065119617025";
                }),
                "too many points", "the header promises 18446744065119617025 points"},
        Refused{"HugeBinary", with([](PcdText& pcd) {
                  pcd.width = pcd.points = "4000000000";
                  pcd.encoding = "binary";
                }),
                "too many points", "4000000000 points of 12 bytes, more than 1 GiB"}),
    name_of_refused);

INSTANTIATE_TEST_SUITE_P(
    Viewpoints, BadHeader,
    testing::Values(bad("TooFewNumbers", "VIEWPOINT has 4 numbers",
                        [](PcdText& pcd) { pcd.viewpoint = "0 0 0 1"; }),
                    bad("NotANumber", "VIEWPOINT has 'nan'",
                        [](PcdText& pcd) { pcd.viewpoint = "0 0 0 1 0 0 nan"; }),
                    bad("Word", "VIEWPOINT has 'here'",
                        [](PcdText& pcd) { pcd.viewpoint = "here 0 0 1 0 0 0"; })),
    name_of_refused);

std::string cause_of(const std::filesystem::path& file) {
  try {
    (void)PcdCloud::read(file);
  } catch (const PcdError& error) {
    return name_of(error.cause());
  }
  return "";
}

TEST(PcdFile, ThatIsMissingAFolderOrADanglingLinkIsUnreadable) {
  const TestFolder folder;
  EXPECT_EQ(cause_of(folder.path() / "missing.pcd"), "unreadable");
  EXPECT_EQ(cause_of(folder.path()), "unreadable");
  std::filesystem::create_symlink("/nowhere", folder.path() / "link.pcd");
  EXPECT_EQ(cause_of(folder.path() / "link.pcd"), "unreadable");
}

TEST(PcdFile, ThatThisUserMayNotReadIsUnreadable) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may read everything";
  const TestFolder folder;
  const auto file = folder.write("a.pcd", good);
  std::filesystem::permissions(file, std::filesystem::perms::none);
  EXPECT_EQ(cause_of(file), "unreadable");
}

}  // namespace
}  // namespace cleave::recording
