// SPDX-License-Identifier: BSD-3-Clause
// Small frames, and files of them, for the tests of recordings.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "recording/frames/frame.hpp"
#include "recording/mcap/bytes.hpp"
#include "tests/support/temporary_folder.hpp"

namespace cleave::recording {

using tests::TemporaryFolder;

[[nodiscard]] Bytes read_all(const std::filesystem::path& file);
void write_all(const std::filesystem::path& file, ByteView bytes);
// By this process, from whatever files; empty where the kernel does not count.
[[nodiscard]] std::optional<std::uint64_t> bytes_read_so_far();

[[nodiscard]] FrameHeader header(std::uint64_t frame_id, std::uint32_t width, std::uint32_t height);

// Seen by a pinhole camera of the header, in whole millimetres; every fifth point is missing.
[[nodiscard]] Cloud depth_cloud(std::uint64_t frame_id, std::uint32_t width = 32,
                                std::uint32_t height = 24);
// Of no camera; some points are NaN.
[[nodiscard]] Cloud free_cloud(std::uint64_t frame_id, std::uint32_t points = 100);
[[nodiscard]] Labels labels(std::uint64_t frame_id, std::uint32_t width = 32,
                            std::uint32_t height = 24);
[[nodiscard]] SegmentList segment_list(std::uint64_t frame_id);

// Clouds with labels and segments, `count` of each.
void write_frames(const std::filesystem::path& file, std::uint64_t count, std::size_t chunk_bytes);
[[nodiscard]] std::vector<Frame> read_frames(const std::filesystem::path& file);

// Equal to the bit, but that one NaN is as good as another.
[[nodiscard]] bool same_points(const std::vector<float>& a, const std::vector<float>& b);

}  // namespace cleave::recording
