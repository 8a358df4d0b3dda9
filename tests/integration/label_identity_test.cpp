// SPDX-License-Identifier: BSD-3-Clause
// Must show: what comes over DDS is, bit for bit, what `cleave segment` writes for the same files.
#include <gtest/gtest.h>
#include <pcl/io/pcd_io.h>

#include <algorithm>
#include <fstream>

#include "tests/integration/support/daemons.hpp"
#include "tests/integration/support/roudi_fixture.hpp"

namespace cleave::test {
namespace {

namespace fs = std::filesystem;
using Labels = std::vector<std::uint16_t>;

// The label field of a PCD that `cleave segment` wrote.
Labels labels_of_file(const fs::path& file) {
  pcl::PCLPointCloud2 cloud;
  Labels labels;
  if (pcl::io::loadPCDFile(file.string(), cloud) != 0) return labels;
  const auto field = std::find_if(cloud.fields.begin(), cloud.fields.end(),
                                  [](const auto& f) { return f.name == "label"; });
  if (field == cloud.fields.end()) return labels;
  for (std::size_t i = 0; i < std::size_t{cloud.width} * cloud.height; ++i) {
    std::uint32_t label = 0;
    std::memcpy(&label, &cloud.data[i * cloud.point_step + field->offset], sizeof label);
    labels.push_back(static_cast<std::uint16_t>(label));
  }
  return labels;
}

Labels labels_of_recording(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary | std::ios::ate);
  if (!stream) return {};
  Labels labels(static_cast<std::size_t>(stream.tellg()) / sizeof(std::uint16_t));
  stream.seekg(0);
  stream.read(reinterpret_cast<char*>(labels.data()),
              static_cast<std::streamsize>(labels.size() * sizeof(std::uint16_t)));
  return labels;
}

// In the order in which the grabber reads them: by number.
std::vector<fs::path> scenes_in_order(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) files.push_back(entry.path());
  std::sort(files.begin(), files.end(), [](const fs::path& a, const fs::path& b) {
    return ::strverscmp(a.c_str(), b.c_str()) < 0;
  });
  return files;
}

std::vector<Labels> segment_offline(const std::vector<fs::path>& scenes, const Daemons& daemons) {
  const TemporaryFolder folder;
  std::vector<Labels> all;
  for (const fs::path& scene : scenes) {
    const fs::path out = folder.path() / scene.filename();
    Process segment = daemons.run("cleave", {"segment", scene.string(), out.string()});
    EXPECT_EQ(segment.wait(), 0) << segment.log();
    all.push_back(labels_of_file(out));
  }
  return all;
}

std::vector<Labels> segment_over_dds(const std::string& scenes, std::size_t count,
                                     const std::string& workers, const Daemons& daemons) {
  const TemporaryFolder folder;
  Process segmenter = daemons.segmenter({"--lossless", "--workers", workers});
  EXPECT_TRUE(segmenter.logs("ready")) << segmenter.log();
  Process recorder = daemons.run(
      "label_recorder", {"shared", "camera", std::to_string(count), folder.path().string()});
  EXPECT_TRUE(recorder.logs("ready")) << recorder.log();
  Process grabber = daemons.grabber("pcd:" + scenes, {"--lossless"});
  EXPECT_EQ(recorder.wait(std::chrono::minutes(3)), 0) << recorder.log() << segmenter.log();
  EXPECT_EQ(grabber.wait(), 0) << grabber.log();
  std::vector<Labels> all;
  for (std::size_t id = 1; id <= count; ++id) {
    all.push_back(labels_of_recording(folder.path() / (std::to_string(id) + ".labels")));
  }
  return all;
}

TEST(LabelsOverDds, EqualWhatCleaveSegmentWritesWith1And2And4WorkersTwice) {
  const std::string scenes = learn_scenes();
  if (scenes.empty()) GTEST_SKIP() << no_scenes;
  const RouDi roudi;
  const Daemons daemons(8, true);
  const std::vector<fs::path> files = scenes_in_order(scenes);
  const std::vector<Labels> offline = segment_offline(files, daemons);
  for (const char* workers : {"1", "2", "4"}) {
    for (int run = 1; run <= 2; ++run) {
      const std::vector<Labels> over_dds = segment_over_dds(scenes, files.size(), workers, daemons);
      for (std::size_t i = 0; i < files.size(); ++i) {
        EXPECT_FALSE(offline[i].empty()) << files[i];
        EXPECT_TRUE(over_dds[i] == offline[i])
            << files[i] << " differs with " << workers << " workers in run " << run;
      }
    }
  }
}

}  // namespace
}  // namespace cleave::test
