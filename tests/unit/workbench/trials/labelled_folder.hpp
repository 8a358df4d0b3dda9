// SPDX-License-Identifier: BSD-3-Clause
// A folder of small labelled scenes, as a user of `cleave evaluate` has it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tests/support/temporary_folder.hpp"

namespace cleave::workbench {

// scene1.pcd (organised), scene2.pcd (the same points, unorganised) and scene10.pcd (as
// the first, but nothing above the table has a label).
class LabelledFolder {
 public:
  LabelledFolder();

  [[nodiscard]] const std::filesystem::path& path() const { return folder_.path(); }
  [[nodiscard]] std::vector<std::filesystem::path> files() const;
  // A file that claims to be a cloud.
  void add_damaged(const std::string& name) const { (void)folder_.file(name, "VERSION 0.7\n"); }
  // One without the field `label`.
  void add_unlabelled(const std::string& name) const;

 private:
  tests::TemporaryFolder folder_;
};

}  // namespace cleave::workbench
