// SPDX-License-Identifier: BSD-3-Clause
#include "recording/frames/segment_list_message.hpp"

#include "idl/fields.hpp"
#include "recording/cdr/cdr_fields.hpp"
#include "recording/frames/header_message.hpp"

namespace cleave::recording {

Bytes segment_list_message(const SegmentList& list) {
  CdrWriter cdr;
  fields::segment_list(CdrFieldWriter{cdr}, list);
  return cdr.bytes();
}

SegmentList read_segment_list(ByteView message, const LackingFields& lacking) {
  CdrReader cdr(message);
  SegmentList list;
  fields::segment_list(CdrFieldReader{cdr, {lacking, fields::SegmentListFields::type}}, list);
  check_capacity(list.header);
  return list;
}

}  // namespace cleave::recording
