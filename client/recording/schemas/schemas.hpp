// SPDX-License-Identifier: BSD-3-Clause
// The schemas that recordings carry, as text.
#pragma once

#include <string>

namespace cleave::recording {

extern const std::string image_schema;         // sensor_msgs/msg/Image, ros2msg
extern const std::string camera_info_schema;   // sensor_msgs/msg/CameraInfo, ros2msg
extern const std::string point_cloud_schema;   // sensor_msgs/msg/PointCloud2, ros2msg
extern const std::string contract_schema;      // idl/cleave_v1.idl, omgidl
extern const std::string recording_schema;     // the contract and recording.idl, omgidl
extern const std::string scene_update_schema;  // foxglove::SceneUpdate, omgidl

}  // namespace cleave::recording
