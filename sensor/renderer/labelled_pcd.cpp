// SPDX-License-Identifier: BSD-3-Clause
#include "sensor/renderer/labelled_pcd.hpp"

#include "recording/pcd/writer.hpp"

namespace cleave::render {

void write_labelled_pcd(const std::filesystem::path& file, const LabelledDepth& image,
                        const Intrinsics& intrinsics) {
  auto cloud =
      recording::PcdCloud::of_points(to_points(image, intrinsics), image.width, image.height,
                                     recording::PcdEncoding::binary_compressed);
  cloud.set_labels(image.label);
  recording::write_pcd(file, cloud);
}

}  // namespace cleave::render
