// SPDX-License-Identifier: BSD-3-Clause
// What the interop tests run under node.
#pragma once

#include <filesystem>

namespace cleave::test {

// Installs the packages of `source`/package-lock.json into `folder`, once. A failure fails the
// test.
void install_npm_packages(const std::filesystem::path& source, const std::filesystem::path& folder);

}  // namespace cleave::test
