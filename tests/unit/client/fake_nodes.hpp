// SPDX-License-Identifier: BSD-3-Clause
// A grabber and a segmenter that publish small frames on the network path, without either program.
#pragma once

#include <chrono>
#include <string>
#include <thread>

#include "libcleave/status.hpp"
#include "libcleave/writer.hpp"
#include "reports.hpp"

namespace cleave::client {

class FakeNodes {
 public:
  FakeNodes(Stream& stream, const std::string& sensor)
      : sensor_(sensor),
        clouds_(stream, sensor),
        label_maps_(stream, sensor),
        lists_(stream, sensor),
        statuses_(stream) {}

  [[nodiscard]] bool lists_are_read() const { return lists_.matched_readers() > 0; }
  [[nodiscard]] bool clouds_are_read() const { return clouds_.matched_readers() > 0; }

  // An organised cloud of 4 x 3 points at 1 m, its labels (all 1) and a list of one segment.
  void publish_frame() {
    const FrameHeader header = next_header();
    publish_cloud(header);
    publish_labels(header);
    SegmentMessage segment{};
    segment.label = 1;
    segment.point_count = 12;
    SegmentList list{};
    list.header = header;
    list.cloud_publication_time_ns = header.publication_time_ns;
    list.segments = {1, 1, &segment, false};
    (void)lists_.publish(list);
    std::this_thread::sleep_for(std::chrono::milliseconds(20));  // nobody's history overflows
  }

  void publish_statuses(NodeState grabber_state) {
    publish(grabber(grabber_state, frame_id_), "grabber/");
    publish(segmenter({.out = frame_id_}), "segmenter/");
  }

 private:
  FrameHeader next_header() {
    FrameHeader header{};
    header.frame_id = ++frame_id_;
    header.width = 4;
    header.height = 3;
    header.publication_time_ns = monotonic_now_ns();
    (void)set_name(header.sensor, sensor_);
    return header;
  }
  void publish_cloud(const FrameHeader& header) {
    auto cloud = clouds_.loan();
    (*cloud)->header = header;
    for (std::size_t i = 0; i < 36; ++i) (*cloud)->xyz[i] = 1;
    (void)clouds_.publish(std::move(*cloud));
  }
  void publish_labels(const FrameHeader& header) {
    auto labels = label_maps_.loan();
    (*labels)->header = header;
    for (std::size_t i = 0; i < 12; ++i) (*labels)->label[i] = 1;
    (void)label_maps_.publish(std::move(*labels));
  }
  void publish(NodeReport report, const std::string& role) {
    report.node = role + sensor_;
    report.sensor = sensor_;
    statuses_.publish(report);
  }

  std::string sensor_;
  Writer<DepthCloud> clouds_;
  Writer<LabelMap> label_maps_;
  Writer<SegmentList> lists_;
  StatusPublisher statuses_;
  std::uint64_t frame_id_ = 0;
};

}  // namespace cleave::client
