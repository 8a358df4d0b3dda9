// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <string>

#include "tests/support/box_scene.hpp"
#include "workbench/evaluation/quality.hpp"
#include "workbench/peers/load_peers.hpp"

namespace cleave::peers {
namespace {

using MakePeer = std::function<std::unique_ptr<Peer>()>;

class APeer : public testing::TestWithParam<MakePeer> {
 protected:
  std::unique_ptr<Peer> peer_ = GetParam()();

  std::vector<std::uint16_t> segment(const evaluation::LabelledCloud& cloud) {
    std::vector<std::uint16_t> labels(cloud.size(), 77);
    peer_->prepare(cloud.view());
    peer_->segment(labels);
    return labels;
  }
};

TEST_P(APeer, TellsTouchingBoxesApart) {
  const evaluation::LabelledCloud scene = tests::render_touching_boxes();

  EXPECT_GT(evaluation::judge(scene.label, segment(scene)).unweighted_covering, 0.9);
}

TEST_P(APeer, GivesNoLabelToWhatIsNoMeasurement) {
  const evaluation::LabelledCloud scene = tests::render_touching_boxes();

  const auto labels = segment(scene);

  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (!std::isnan(scene.xyz[3 * i])) continue;
    ASSERT_EQ(labels[i], 0) << i;
  }
}

TEST_P(APeer, SegmentsOneCloudAfterTheOther) {
  const evaluation::LabelledCloud scene = tests::render_touching_boxes();
  const auto first = segment(scene);

  (void)segment(tests::render_touching_boxes(200, 150));

  // Not always the very same labels: see Peer.
  const std::vector<std::uint32_t> before(first.begin(), first.end());
  EXPECT_GT(evaluation::judge(before, segment(scene)).weighted_covering, 0.9);
}

std::unique_ptr<Peer> tuned_cpc() {
  CpcParameters parameters;
  parameters.lccp = tuned_lccp();  // what it starts from
  return make_pcl_cpc(parameters);
}

std::string name_of(const testing::TestParamInfo<MakePeer>& peer) {
  constexpr std::array names = {"Lccp", "Ssc", "Cpc"};
  return names.at(peer.index);
}

INSTANTIATE_TEST_SUITE_P(Pcl, APeer,
                         testing::Values([] { return make_pcl_lccp(tuned_lccp()); },
                                         [] { return make_pcl_ssc({}); }, tuned_cpc),
                         name_of);

}  // namespace
}  // namespace cleave::peers
