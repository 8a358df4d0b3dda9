// SPDX-License-Identifier: BSD-3-Clause
// LZF, the compression of binary_compressed PCD files.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace cleave::recording {

// `plain` as an LZF block, of which lzf_decompress() makes `plain` again; empty if that is not
// smaller than `plain`. The same bytes give the same block: liblzf's own lzf_compress(), as Debian
// builds it, does not promise that, for it begins with whatever the stack holds.
[[nodiscard]] std::vector<std::uint8_t> lzf_compressed(std::span<const std::uint8_t> plain);

}  // namespace cleave::recording
