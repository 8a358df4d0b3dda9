// SPDX-License-Identifier: BSD-3-Clause
#include "workbench/bench/bench.hpp"

#include <chrono>
#include <stdexcept>

#include "workbench/bench/allocation_counter.hpp"
#include "workbench/cloud/option_setter.hpp"
#include "workbench/peers/load_peers.hpp"

namespace cleave::workbench {

using evaluation::LabelledCloud;
using evaluation::Quality;
using segmentation::Outcome;

namespace {

using Clock = std::chrono::steady_clock;

double wall_ms_since(Clock::time_point began) {
  return std::chrono::duration<double, std::milli>(Clock::now() - began).count();
}

}  // namespace

Bench::Bench(const BenchPlan& plan) : plan_(plan) {
  for (std::uint32_t i = 0; i < plan.grid_offsets; ++i) {
    segmentation::Options options = plan.options;
    if (plan.grid_offsets > 1) {
      options.voxel.grid_offset = even_grid_offset(i, plan.grid_offsets);
    }
    grids_.push_back({options.voxel.grid_offset, segmentation::Segmenter(options)});
  }
  const auto add = [this](const char* name, std::unique_ptr<peers::Peer> peer) {
    peers_.push_back(std::move(peer));
    result_.peers.emplace_back(name, Record{});
  };
  if (plan.against_pcl) {
    add("pcl_ssc", peers::make_pcl_ssc(plan.options));
    add("pcl_lccp", peers::make_pcl_lccp());
    add("pcl_lccp_tuned", peers::make_pcl_lccp(peers::tuned_lccp()));
  }
}

void Bench::measure(const std::string& name, const LabelledCloud& cloud) {
  labels_.resize(cloud.size());
  warm_up(name, cloud);
  for (std::uint32_t i = 0; i < plan_.repeat; ++i) {
    const bool judged = cloud.labelled() && i == 0;  // all runs give the same labels
    run_peers(cloud, judged);
    for (Grid& grid : grids_) {
      run_ours(grid, cloud);
      if (judged) judge_ours(name, grid, cloud);
    }
  }
  result_.points.push_back(static_cast<double>(cloud.size()));
  result_.segments.push_back(static_cast<double>(segmentation_.segments.size()));
}

void Bench::warm_up(const std::string& name, const LabelledCloud& cloud) {
  for (Grid& grid : grids_) {
    if (grid.segmenter.segment(cloud.view(), labels_, segmentation_) != Outcome::segmented) {
      throw std::runtime_error(name + ": no point has coordinates that are finite and not all 0");
    }
  }
}

void Bench::run_peers(const LabelledCloud& cloud, bool judged) {
  for (std::size_t i = 0; i < peers_.size(); ++i) {
    peers_[i]->prepare(cloud.view());
    Record& record = result_.peers[i].second;
    const auto began = Clock::now();
    const double began_ms = thread_ms();
    peers_[i]->segment(labels_);
    record.run_ms.push_back(thread_ms() - began_ms);
    record.wall_ms.push_back(wall_ms_since(began));
    if (judged) record.qualities.push_back(evaluation::judge(cloud, labels_));
  }
}

void Bench::run_ours(Grid& grid, const LabelledCloud& cloud) {
  const auto began = Clock::now();
  const auto before = allocations_of_this_thread();
  clock_.start();
  (void)grid.segmenter.segment(cloud.view(), labels_, segmentation_, &clock_);
  const auto after = allocations_of_this_thread();
  result_.ours.wall_ms.push_back(wall_ms_since(began));
  if (before && after) result_.allocations.push_back(static_cast<double>(*after - *before));
  result_.times.add(clock_);
  result_.ours.run_ms.push_back(clock_.total_ms());
}

void Bench::judge_ours(const std::string& name, const Grid& grid, const LabelledCloud& cloud) {
  const Quality quality = evaluation::judge(cloud, labels_);
  result_.ours.qualities.push_back(quality);
  if (!plan_.find_collapses || quality.weighted_covering >= collapsed_below) return;
  const double of_thesis = covering_of_thesis(grid.offset, cloud);
  if (of_thesis < thesis_reaches) return;
  result_.collapses.push_back({name, grid.offset, quality.weighted_covering, of_thesis});
}

double Bench::covering_of_thesis(float grid_offset, const LabelledCloud& cloud) {
  segmentation::Options options = segmentation::thesis();
  options.voxel.grid_offset = grid_offset;
  (void)segmentation::Segmenter(options).segment(cloud.view(), labels_, segmentation_);
  return evaluation::judge(cloud, labels_).weighted_covering;
}

}  // namespace cleave::workbench
