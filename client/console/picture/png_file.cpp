// SPDX-License-Identifier: BSD-3-Clause
#include "console/picture/png_file.hpp"

#include <png.h>

#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "recording/replace_file.hpp"

namespace cleave {
namespace {

static_assert(sizeof(Rgb) == 3, "a picture's pixels are handed to libpng as they are");

png_image description_of(const Picture& picture) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = picture.width;
  image.height = picture.height;
  image.format = PNG_FORMAT_RGB;
  return image;
}

}  // namespace

void write_png(const std::filesystem::path& file, const Picture& picture) {
  png_image image = description_of(picture);
  // libpng's simplified writer cannot say beforehand how long the file will be, only a bound.
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::vector<std::uint8_t> encoded(size);
  if (png_image_write_to_memory(&image, encoded.data(), &size, 0, picture.pixels.data(), 0,
                                nullptr) == 0) {
    throw std::runtime_error(file.string() + ": a picture of " + std::to_string(picture.width) +
                             " x " + std::to_string(picture.height) +
                             " pixels cannot be written as PNG: " + image.message);
  }
  encoded.resize(size);
  recording::replace_file(file, {std::as_bytes(std::span(encoded))});
}

}  // namespace cleave
