// SPDX-License-Identifier: BSD-3-Clause
#include "libcleave/internal/roudi/roudi_access.hpp"

#include <grp.h>
#include <gtest/gtest.h>
#include <pwd.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

#include "tests/support/temporary_folder.hpp"
#include "tests/unit/libcleave/listening_socket.hpp"

namespace cleave {
namespace {

// A folder with the files of a RouDi that runs as this process's user, who is made an ordinary one
// where the tests run as root: root may do everything.
class RouDiAccess : public testing::Test {
 protected:
  RouDiAccess() {
    if (::geteuid() == 0) {
      const passwd* const nobody = ::getpwnam("nobody");
      group_before_ = ::getegid();
      if (::setegid(nobody->pw_gid) == 0) was_root_ = ::seteuid(nobody->pw_uid) == 0;
    }
    folder_.emplace();
    std::filesystem::create_directory(place_.memory = folder_->path() / "shm");
    place_.socket = folder_->path() / "roudi";
    socket_.emplace(place_.socket);
    add_memory("iceoryx_mgmt");
    add_memory(::getgrgid(::getegid())->gr_name);
  }
  ~RouDiAccess() override { become_root(); }

  void become_root() {
    if (was_root_) (void)(::seteuid(0) == 0 && ::setegid(group_before_) == 0);
  }
  void add_memory(const std::string& name) const { std::ofstream(place_.memory / name) << "x"; }

  std::optional<tests::TemporaryFolder> folder_;
  RouDiPlace place_;

 private:
  std::optional<test::ListeningSocket> socket_;
  bool was_root_ = false;
  gid_t group_before_ = 0;

 protected:
  [[nodiscard]] bool was_root() const { return was_root_; }
  void stop_listening() { socket_.reset(); }
};

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST_F(RouDiAccess, IsFreeWhereRouDiRunsAsTheSameUser) {
  EXPECT_EQ(obstacle_to_roudi(place_), "");
  EXPECT_TRUE(may_write_to_roudi(place_));
}

TEST_F(RouDiAccess, NamesAMissingRouDiAndTheCommandThatStartsIt) {
  stop_listening();  // its socket file stays, as after a crash
  EXPECT_PRED2(holds, obstacle_to_roudi(place_), "no RouDi answers at " + place_.socket.string());
  EXPECT_PRED2(holds, obstacle_to_roudi(place_), "iox-roudi -m off -c config/roudi.toml");
  std::filesystem::remove(place_.socket);
  EXPECT_PRED2(holds, obstacle_to_roudi(place_), "no RouDi answers at " + place_.socket.string());
}

TEST_F(RouDiAccess, NamesTheOtherUserThatRouDiRunsAs) {
  if (!was_root()) GTEST_SKIP() << "only root may give a file to another user";
  become_root();
  ASSERT_EQ(::chown(place_.socket.c_str(), 1, 1), 0);
  const std::string to_root = obstacle_to_roudi(place_);  // it cannot answer us
  ASSERT_EQ(::seteuid(::getpwnam("nobody")->pw_uid), 0);
  const std::string to_nobody = obstacle_to_roudi(place_);
  EXPECT_PRED2(holds, to_root, "RouDi runs as user 'daemon', which keeps user 'root' out");
  EXPECT_PRED2(holds, to_nobody, "RouDi runs as user 'daemon', which keeps user 'nobody' out");
}

TEST_F(RouDiAccess, NamesASocketWithoutRights) {
  std::filesystem::permissions(place_.socket, std::filesystem::perms::none);
  EXPECT_PRED2(holds, obstacle_to_roudi(place_),
               place_.socket.string() + " may not be used by user");
  EXPECT_PRED2(holds, obstacle_to_roudi(place_), "mode 0000");
}

TEST_F(RouDiAccess, NamesMemoryWithoutRights) {
  std::filesystem::permissions(place_.memory / "iceoryx_mgmt", std::filesystem::perms::none);
  EXPECT_PRED2(holds, obstacle_to_roudi(place_), "iceoryx_mgmt may not be used by user");
}

TEST_F(RouDiAccess, SaysThatTheMemoryIsElsewhere) {
  std::filesystem::remove(place_.memory / "iceoryx_mgmt");
  EXPECT_PRED2(holds, obstacle_to_roudi(place_), "its memory is not in " + place_.memory.string());
}

TEST_F(RouDiAccess, SaysThatNoSegmentIsOfAGroupOfOurs) {
  std::filesystem::remove(place_.memory / ::getgrgid(::getegid())->gr_name);
  EXPECT_PRED2(holds, obstacle_to_roudi(place_), "belong to no group of user");
  EXPECT_FALSE(may_write_to_roudi(place_));
}

TEST_F(RouDiAccess, MayBeToReadAlone) {
  std::filesystem::remove(place_.memory / ::getgrgid(::getegid())->gr_name);
  add_memory("daemon");  // another group's, and its list lets us read
  EXPECT_EQ(obstacle_to_roudi(place_), "");
  EXPECT_FALSE(may_write_to_roudi(place_));
}

}  // namespace
}  // namespace cleave
