// SPDX-License-Identifier: BSD-3-Clause
// The lists of idl/fields.hpp, and the structs that they visit, against the IDL.
#include "idl/fields.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <set>
#include <string>
#include <type_traits>
#include <vector>

#include "libcleave/status.hpp"
#include "libcleave/types.hpp"
#include "recording/frames/frame.hpp"
#include "tests/unit/idl/idl_file.hpp"

namespace cleave::test {
namespace {

// IDL's name of a C++ number.
template <class Number>
std::string type_of_number() {
  if (std::is_same_v<Number, double>) return "double";
  if (std::is_same_v<Number, float>) return "float";
  const std::string sign = std::is_unsigned_v<Number> ? "unsigned " : "";
  switch (sizeof(Number)) {
    case 2:
      return sign + "short";
    case 4:
      return sign + "long";
    case 8:
      return sign + "long long";
    default:
      return "of no such size";
  }
}

// The type of the contract that a list is of.
std::string type_of(const fields::HeaderFields&) {
  return "FrameHeader";
}
std::string type_of(const fields::PoseFields&) {
  return "Pose3";
}
std::string type_of(const fields::PointFields&) {
  return "Point";
}
std::string type_of(const fields::QuaternionFields&) {
  return "Quaternion";
}
std::string type_of(const fields::ImageRectangleFields&) {
  return "ImageRectangle";
}
std::string type_of(const fields::OrientedBoxFields&) {
  return "OrientedBox";
}
std::string type_of(const fields::SegmentFields&) {
  return "Segment";
}
std::string type_of(const fields::BorderFields&) {
  return "Border";
}
std::string type_of(const fields::SegmentListFields&) {
  return "SegmentList";
}
std::string type_of(const fields::CauseCountFields&) {
  return "CauseCount";
}
std::string type_of(const fields::NodeStatusFields&) {
  return "NodeStatus";
}

// What a list visits, as the IDL would declare it.
struct Declaration {
  std::vector<IdlMember> members;

  template <class Number>
  void number(const char* name, const Number& /*value*/) {
    members.push_back({type_of_number<Number>(), name});
  }
  template <class Enum>
  void choice(const char* name, const Enum& /*value*/) {
    static_assert(sizeof(Enum) == sizeof(std::uint32_t));
    members.push_back({"enum", name});
  }
  template <class Text>
  void text(const char* name, const Text& /*value*/) {
    members.push_back({"string", name});
  }
  template <class List, class Value>
  void group(const char* name, const List& list, const Value& /*value*/) {
    members.push_back({type_of(list), name});
  }
  template <class List, class Values>
  void each(const char* name, const List& list, const Values& /*values*/) {
    members.push_back({"sequence<" + type_of(list) + ">", name});
  }
};

class Fields : public testing::Test {
 protected:
  Fields() {
    for (auto& [type, members] : idl_.structs) {
      for (IdlMember& member : members) {
        if (idl_.enumerations.contains(member.type)) member.type = "enum";
      }
    }
  }

  // That the list, called with a struct, visits all members of the IDL's type and no others, in its
  // order and of its types.
  template <class Struct, class List>
  void expect_as_in_idl(const List& list) {
    Declaration visited;
    const Struct value{};
    list(visited, value);
    EXPECT_EQ(visited.members, idl_.structs.at(type_of(list)));
    listed_.insert(type_of(list));
  }

  IdlFile idl_ = read_contract();
  std::set<std::string> listed_;
};

TEST_F(Fields, AreThoseOfTheIdlInEveryStructOfTheStream) {
  expect_as_in_idl<cleave_v1_FrameHeader>(fields::header);
  expect_as_in_idl<cleave_v1_Pose3>(fields::pose);
  expect_as_in_idl<cleave_v1_Point>(fields::point);
  expect_as_in_idl<cleave_v1_Quaternion>(fields::quaternion);
  expect_as_in_idl<cleave_v1_ImageRectangle>(fields::image_rectangle);
  expect_as_in_idl<cleave_v1_OrientedBox>(fields::oriented_box);
  expect_as_in_idl<cleave_v1_Segment>(fields::segment);
  expect_as_in_idl<cleave_v1_Border>(fields::border);
  expect_as_in_idl<cleave_v1_SegmentList>(fields::segment_list);
  expect_as_in_idl<cleave_v1_CauseCount>(fields::cause_count);
  expect_as_in_idl<cleave_v1_NodeStatus>(fields::node_status);

  // A type without a list: its points or labels are copied as one block.
  const std::set<std::string> bulk = {"DepthCloud", "LabelMap", "LargeDepthCloud", "LargeLabelMap"};
  for (const auto& [type, members] : idl_.structs) {
    EXPECT_NE(listed_.contains(type), bulk.contains(type)) << type;
  }
}

TEST_F(Fields, AreThoseOfTheIdlInEveryStructOfARecording) {
  expect_as_in_idl<recording::FrameHeader>(fields::header);
  expect_as_in_idl<recording::Pose>(fields::pose);
  expect_as_in_idl<recording::Point>(fields::point);
  expect_as_in_idl<recording::Quaternion>(fields::quaternion);
  expect_as_in_idl<recording::ImageRectangle>(fields::image_rectangle);
  expect_as_in_idl<recording::OrientedBox>(fields::oriented_box);
  expect_as_in_idl<recording::Segment>(fields::segment);
  expect_as_in_idl<recording::Border>(fields::border);
  expect_as_in_idl<recording::SegmentList>(fields::segment_list);
}

TEST_F(Fields, AreThoseOfTheIdlInANodesReport) {
  expect_as_in_idl<NodeReport>(fields::node_status);
}

}  // namespace
}  // namespace cleave::test
