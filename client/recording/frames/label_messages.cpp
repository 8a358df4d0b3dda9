// SPDX-License-Identifier: BSD-3-Clause
#include "recording/frames/label_messages.hpp"

#include "recording/frames/header_message.hpp"

namespace cleave::recording {

Bytes labels_message(const Labels& labels) {
  CdrWriter cdr;
  write_header(cdr, labels.header);
  cdr.number(labels.cloud_publication_time_ns);
  return cdr.bytes();
}

Labels read_labels_message(ByteView message, const LackingFields& lacking) {
  CdrReader cdr(message);
  Labels labels;
  labels.header = read_header(cdr, lacking);
  labels.cloud_publication_time_ns = cdr.number<std::int64_t>();
  return labels;
}

}  // namespace cleave::recording
