// SPDX-License-Identifier: BSD-3-Clause
#include "libcleave/internal/cdr_stream.hpp"

#include <dds/dds.h>
#include <dds/ddsi/ddsi_cdrstream.h>
#include <dds/ddsi/q_protocol.h>

#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>

namespace cleave {
namespace {

// "CDR, little endian", and no options. A big-endian one has a 0 for the 1.
constexpr std::array encapsulation = {std::byte{0}, std::byte{1}, std::byte{0}, std::byte{0}};
constexpr std::size_t most_padding = 3;  // RTPS fills payloads up to multiples of 4

[[noreturn]] void refuse(const dds_topic_descriptor_t* type, const std::string& why) {
  throw CdrError("these bytes are no " + std::string(type->m_typename) + ": " + why);
}

bool is_little_endian(const dds_topic_descriptor_t* type, std::span<const std::byte> bytes) {
  if (bytes.size() < encapsulation.size()) {
    refuse(type, std::to_string(bytes.size()) + " bytes are fewer than an encapsulation has");
  }
  if (bytes[0] != std::byte{0} || bytes[1] > std::byte{1}) {
    refuse(type, "the encapsulation is not that of XCDR1");
  }
  return bytes[1] == std::byte{1};
}

struct Output {
  explicit Output(std::uint32_t room) { dds_ostreamLE_init(&stream, room, CDR_ENC_VERSION_1); }
  ~Output() { dds_ostreamLE_fini(&stream); }
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;
  dds_ostreamLE_t stream{};
};

}  // namespace

RawSample decode_cdr(const dds_topic_descriptor_t* type, std::span<const std::byte> bytes) {
  const bool little_endian = is_little_endian(type, bytes);
  const std::span<const std::byte> body = bytes.subspan(encapsulation.size());
  if (body.size() > std::numeric_limits<std::uint32_t>::max()) refuse(type, "more than 4 GiB");
  const auto size = static_cast<std::uint32_t>(body.size());

  // Normalising swaps bytes in place and holds every length, text and enumerator against what is
  // there; what it has passed is read without a check.
  std::vector<std::byte> native(body.begin(), body.end());  // aligned as operator new aligns
  std::uint32_t end = 0;
  const bool swap = little_endian != (std::endian::native == std::endian::little);
  if (size == 0 || dds_stream_normalize_data(reinterpret_cast<char*>(native.data()), &end, size,
                                             swap, CDR_ENC_VERSION_1, type->m_ops) == nullptr) {
    refuse(type, "they are cut off, or a length, a text or an enumerator in them is wrong");
  }
  if (size - end > most_padding) {
    refuse(type, std::to_string(size - end) + " bytes follow its end");
  }
  void* const sample = dds_alloc(type->m_size);  // zeroed, as deserialisation needs it
  RawSample owner(nullptr, sample, sample, type);
  dds_istream_t stream;
  dds_istream_init(&stream, size, native.data(), CDR_ENC_VERSION_1);
  (void)dds_stream_read(&stream, static_cast<char*>(sample), type->m_ops);
  dds_istream_fini(&stream);
  return owner;
}

std::vector<std::byte> encode_cdr(const dds_topic_descriptor_t* type, const void* sample) {
  Output output(type->m_size);
  if (dds_stream_writeLE(&output.stream, static_cast<const char*>(sample), type->m_ops) ==
      nullptr) {
    throw CdrError("a sample cannot be a " + std::string(type->m_typename) +
                   ": an enumerator in it is none");
  }
  const auto body = std::as_bytes(std::span(output.stream.x.m_buffer, output.stream.x.m_index));
  std::vector<std::byte> bytes;
  bytes.reserve(encapsulation.size() + body.size());
  bytes.insert(bytes.end(), encapsulation.begin(), encapsulation.end());
  bytes.insert(bytes.end(), body.begin(), body.end());
  return bytes;
}

}  // namespace cleave
