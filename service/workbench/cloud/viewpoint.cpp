// SPDX-License-Identifier: BSD-3-Clause
#include "workbench/cloud/viewpoint.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "workbench/cloud/parse_number.hpp"

namespace cleave::workbench {
namespace {

constexpr std::size_t position_numbers = 3;
constexpr std::size_t pose_numbers = 7;

// Empty where something is no finite number.
std::vector<double> numbers_in(std::string_view text, char separator) {
  std::vector<double> numbers;
  while (true) {
    const std::string_view word = text.substr(0, text.find(separator));
    const auto number = parse_number<double>(word);
    if (!number || !std::isfinite(*number)) return {};
    numbers.push_back(*number);
    if (word.size() == text.size()) return numbers;
    text.remove_prefix(word.size() + 1);
  }
}

// Nothing for a quaternion that turns nowhere: its length is 0.
std::optional<segmentation::SensorPose> pose_from(const std::vector<double>& numbers) {
  segmentation::SensorPose pose;
  std::copy_n(numbers.begin(), position_numbers, pose.position_m.begin());
  if (numbers.size() < pose_numbers) return pose;
  std::copy_n(numbers.begin() + position_numbers, pose.orientation.size(),
              pose.orientation.begin());
  double squared_length = 0;
  for (const double q : pose.orientation) squared_length += q * q;
  constexpr double nothing = 1e-12;
  if (!(squared_length > nothing) || !std::isfinite(squared_length)) return std::nullopt;
  return pose;
}

}  // namespace

segmentation::SensorPose parse_viewpoint(std::string_view text) {
  const std::vector<double> numbers = numbers_in(text, ',');
  const bool right_count = numbers.size() == position_numbers || numbers.size() == pose_numbers;
  const auto pose = right_count ? pose_from(numbers) : std::nullopt;
  if (pose) return *pose;
  throw ViewpointError("--viewpoint " + std::string(text) +
                       ": expected X,Y,Z in metres, or X,Y,Z,QW,QX,QY,QZ with a quaternion that "
                       "is not 0");
}

}  // namespace cleave::workbench
