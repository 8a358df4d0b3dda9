// SPDX-License-Identifier: BSD-3-Clause
#include "recording/frames/header_message.hpp"

#include "idl/fields.hpp"
#include "recording/cdr/cdr_fields.hpp"

namespace cleave::recording {

void write_header(CdrWriter& cdr, const FrameHeader& header) {
  fields::header(CdrFieldWriter{cdr}, header);
}

FrameHeader read_header(CdrReader& cdr, const LackingFields& lacking) {
  FrameHeader header;
  fields::header(CdrFieldReader{cdr, {lacking, fields::HeaderFields::type}}, header);
  check_capacity(header);
  return header;
}

void check_capacity(const FrameHeader& header) {
  if (header.points() <= capacity_points) return;
  throw DataError("a frame has " + std::to_string(header.width) + " x " +
                  std::to_string(header.height) + " points, more than the stream carries");
}

}  // namespace cleave::recording
