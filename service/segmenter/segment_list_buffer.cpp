#include "segmenter/segment_list_buffer.hpp"

#include <algorithm>
#include <iterator>

namespace cleave::service {
namespace {

cleave_v1_Point message_of(const Eigen::Vector3f& v) {
  return {v.x(), v.y(), v.z()};
}

cleave_v1_Quaternion message_of(const Eigen::Quaternionf& q) {
  return {q.x(), q.y(), q.z(), q.w()};
}

SegmentMessage message_of(const segmentation::Segment& segment) {
  const segmentation::ImageRectangle& image = segment.rectangle;
  SegmentMessage message{};
  message.label = segment.label;
  message.point_count = segment.point_count;
  message.centroid = message_of(segment.centroid);
  message.mean_normal = message_of(segment.mean_normal);
  message.box = {message_of(segment.box.centre), message_of(segment.box.orientation),
                 message_of(segment.box.extent)};
  message.rectangle = {image.left, image.top, image.right, image.bottom};
  message.planarity = segment.planarity;
  return message;
}

BorderMessage message_of(const segmentation::Border& border) {
  const bool concave = border.kind == segmentation::BorderKind::concave;
  return {border.first, border.second,
          concave ? cleave_v1_BORDER_CONCAVE : cleave_v1_BORDER_CONVEX};
}

// Points the C sequence at the vector's elements.
template <class Sequence, class Message>
void lend(Sequence& sequence, std::vector<Message>& messages) {
  sequence._length = static_cast<std::uint32_t>(messages.size());
  sequence._maximum = sequence._length;
  sequence._buffer = messages.data();
  sequence._release = false;
}

}  // namespace

void SegmentListBuffer::fill(const segmentation::Segmentation& segmentation) {
  const auto convert = [](const auto& part) { return message_of(part); };
  segments_.clear();
  borders_.clear();
  std::transform(segmentation.segments.begin(), segmentation.segments.end(),
                 std::back_inserter(segments_), convert);
  std::transform(segmentation.borders.begin(), segmentation.borders.end(),
                 std::back_inserter(borders_), convert);
  lend(list_.segments, segments_);
  lend(list_.borders, borders_);
}

}  // namespace cleave::service
