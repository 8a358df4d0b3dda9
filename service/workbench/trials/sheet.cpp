// SPDX-License-Identifier: BSD-3-Clause
#include "workbench/trials/sheet.hpp"

#include <spdlog/fmt/fmt.h>

#include "console/picture/png_file.hpp"
#include "workbench/cloud/points_view.hpp"
#include "workbench/evaluation/partners.hpp"

namespace cleave::workbench {

Sheet::Sheet(const evaluation::LabelledCloud& cloud) : cloud_(cloud) {
  const std::vector<std::uint16_t> none(cloud.size(), 0);
  const auto truth = evaluation::pair_labels(cloud.label, none).truth;
  const DepthImage image = depth_image(points_of(cloud.view()), truth);
  picture_ = side_by_side(depth_picture(image), segment_picture(image));
}

void Sheet::add_result(std::span<const std::uint16_t> found) {
  const auto paired = evaluation::pair_labels(cloud_.label, found);
  const DepthImage truth = depth_image(points_of(cloud_.view()), paired.truth);
  const DepthImage result = depth_image(points_of(cloud_.view()), paired.found);
  picture_ = one_above_other(
      picture_, side_by_side(segment_picture(result), difference_picture(truth, result.label)));
}

void Sheet::write(const std::filesystem::path& file) const {
  write_png(file, picture_);
}

std::string sheet_name(std::size_t index, const std::filesystem::path& scene) {
  return fmt::format("{:03}-{}.png", index, scene.stem().string());
}

}  // namespace cleave::workbench
