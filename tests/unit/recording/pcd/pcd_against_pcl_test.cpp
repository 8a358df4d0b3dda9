// SPDX-License-Identifier: BSD-3-Clause
// PCL's reader as the oracle: files of random fields, types and encodings hold the same values for
// both, whoever wrote them.
#include <gtest/gtest.h>
#include <pcl/PCLPointCloud2.h>
#include <pcl/console/print.h>
#include <pcl/io/pcd_io.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <random>
#include <sstream>

#include "recording/pcd/writer.hpp"
#include "tests/unit/recording/pcd/pcd_files.hpp"

namespace cleave::recording {
namespace {

struct Kind {
  char type;
  std::uint32_t size;
};

constexpr std::array<Kind, 10> kinds = {{{'I', 1},
                                         {'U', 1},
                                         {'I', 2},
                                         {'U', 2},
                                         {'I', 4},
                                         {'U', 4},
                                         {'I', 8},
                                         {'U', 8},
                                         {'F', 4},
                                         {'F', 8}}};

// Every field of the header holds the same bytes, but that one NaN is as good as another.
void expect_same_values(const PcdCloud& ours, const pcl::PCLPointCloud2& pcls) {
  ASSERT_EQ(ours.header().width, pcls.width);
  ASSERT_EQ(ours.header().height, pcls.height);
  const std::size_t step = ours.header().point_bytes();
  for (const auto& theirs : pcls.fields) {
    if (theirs.name == "_") continue;
    const auto field = ours.header().find(theirs.name);
    ASSERT_TRUE(field) << theirs.name;
    const PcdField& description = ours.header().fields[*field];
    const std::size_t offset = ours.header().offset_of(*field);
    for (std::size_t i = 0; i < ours.header().points(); ++i) {
      for (std::uint32_t c = 0; c < description.count; ++c) {
        const std::uint8_t* a = &ours.data()[i * step + offset + c * description.size];
        const std::uint8_t* b =
            &pcls.data[i * pcls.point_step + theirs.offset + c * description.size];
        double x = 0, y = 0;
        if (description.type == 'F' && description.size == 8) {
          std::memcpy(&x, a, 8);
          std::memcpy(&y, b, 8);
        } else if (description.type == 'F') {
          float f = 0, g = 0;
          std::memcpy(&f, a, 4);
          std::memcpy(&g, b, 4);
          x = static_cast<double>(f);
          y = static_cast<double>(g);
        }
        if (std::isnan(x) && std::isnan(y)) continue;
        ASSERT_EQ(std::memcmp(a, b, description.size), 0)
            << theirs.name << " of point " << i << ": " << x << " and " << y;
      }
    }
  }
}

// False where the points cannot be made smaller, on which PCL gives up.
bool pcl_packs(const std::filesystem::path& file, const pcl::PCLPointCloud2& cloud) {
  try {
    return pcl::PCDWriter().writeBinaryCompressed(file.string(), cloud) == 0;
  } catch (const pcl::IOException&) {
    return false;
  }
}

class AgainstPcl : public testing::TestWithParam<int> {
 protected:
  AgainstPcl() { pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS); }

  static std::string word(Kind kind, std::mt19937& random) {
    std::ostringstream text;
    text.precision(17);
    const std::uint64_t bits = std::uint64_t{random()} << 32U | random();
    // Of whole numbers in text, PCL 1.13 reads all but a file's first by way of a double.
    const unsigned shift = std::max(64 - 8 * kind.size, 12U);
    if (kind.type == 'U') text << (bits >> shift);
    if (kind.type == 'I') text << (static_cast<std::int64_t>(bits) >> shift);
    if (kind.type == 'F') {
      const double value =
          std::ldexp(static_cast<double>(random()), static_cast<int>(random() % 60) - 60) *
          (random() % 2 == 0 ? -1 : 1);
      if (random() % 20 == 0) return "nan";
      const auto single = static_cast<float>(value);  // PCL rounds most text twice
      text << (kind.size == sizeof single ? static_cast<double>(single) : value);
    }
    return text.str();
  }

  // x, y, z among other fields, in any order, of any kind.
  static PcdText random_text(std::mt19937& random) {
    std::vector<std::string> names = {"x", "y", "z"};
    for (std::size_t i = 0, more = random() % 5; i < more; ++i) {
      names.push_back(random() % 3 == 0 ? "_" : "f" + std::to_string(i));
    }
    std::shuffle(names.begin(), names.end(), random);
    PcdText pcd{"", "", "", "", std::to_string(1 + random() % 9), std::to_string(1 + random() % 4)};
    pcd.points = std::to_string(std::stoi(pcd.width) * std::stoi(pcd.height));
    std::vector<Kind> columns;
    for (const std::string& name : names) {
      const Kind kind = kinds[random() % kinds.size()];
      const std::size_t count = name.size() == 1 && name != "_" ? 1 : 1 + random() % 3;
      pcd.fields += " " + name;
      pcd.size += " " + std::to_string(kind.size);
      pcd.type += std::string(" ") + kind.type;
      pcd.count += " " + std::to_string(count);
      columns.insert(columns.end(), count, kind);
    }
    pcd.data = "";
    for (int i = 0; i < std::stoi(pcd.points); ++i) {
      for (const Kind kind : columns) pcd.data += word(kind, random) + " ";
      pcd.data.back() = '\n';
    }
    return pcd;
  }
};

TEST_P(AgainstPcl, AFileHoldsTheSameValues) {
  const TestFolder folder;
  std::mt19937 random(static_cast<unsigned>(GetParam()));
  for (int i = 0; i < 100; ++i) {
    const std::string content = to_file(random_text(random));
    const auto text = folder.write("text.pcd", content);
    pcl::PCLPointCloud2 cloud;
    ASSERT_EQ(pcl::PCDReader().read(text.string(), cloud), 0) << content;
    expect_same_values(PcdCloud::read(text), cloud);
    if (HasFatalFailure()) FAIL() << content;

    // PCL drops padding when it writes, but not what it takes in a point.
    const auto bytes = folder.path() / "bytes.pcd";
    const auto packed = folder.path() / "packed.pcd";
    ASSERT_EQ(pcl::PCDWriter().writeBinary(bytes.string(), cloud), 0);
    expect_same_values(PcdCloud::read(bytes), cloud);
    if (HasFatalFailure()) FAIL() << content;
    if (pcl_packs(packed, cloud)) {
      expect_same_values(PcdCloud::read(packed), cloud);
      if (HasFatalFailure()) FAIL() << content;
    }

    // And PCL reads what we write, in both encodings.
    const PcdCloud ours = PcdCloud::read(bytes);
    write_pcd(folder.path() / "ours.pcd", ours);
    write_pcd(folder.path() / "ours_packed.pcd", PcdCloud::read(text));
    for (const char* const name : {"ours.pcd", "ours_packed.pcd"}) {
      pcl::PCLPointCloud2 again;
      ASSERT_EQ(pcl::PCDReader().read((folder.path() / name).string(), again), 0) << content;
      expect_same_values(ours, again);
      if (HasFatalFailure()) FAIL() << name << '\n' << content;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, AgainstPcl, testing::Range(1, 6));

}  // namespace
}  // namespace cleave::recording
