// SPDX-License-Identifier: BSD-3-Clause
#include "recording/frames/cloud_messages.hpp"

#include <cstring>
#include <span>

#include "recording/frames/header_message.hpp"

namespace cleave::recording {

Bytes cloud_message(const CloudMessage& cloud) {
  CdrWriter cdr;
  write_header(cdr, cloud.header);
  cdr.number(static_cast<std::uint32_t>(cloud.projection));
  cdr.numbers(std::span<const std::uint8_t>(cloud.correction));
  return cdr.bytes();
}

CloudMessage read_cloud_message(ByteView message, const LackingFields& lacking) {
  CdrReader cdr(message);
  CloudMessage cloud;
  cloud.header = read_header(cdr, lacking);
  cloud.projection = static_cast<Projection>(cdr.number<std::uint32_t>());
  const ByteView correction = cdr.numbers<std::uint8_t>();
  cloud.correction.resize(correction.size());
  if (!correction.empty()) {
    std::memcpy(cloud.correction.data(), correction.data(), correction.size());
  }
  return cloud;
}

}  // namespace cleave::recording
