// SPDX-License-Identifier: BSD-3-Clause
// A bag as ROS 2 writes them, by MCAP's own writer and Foxglove's own serialisation: one depth image,
// three times. Usage: node write_ros_bag.mjs DEPTH BAG WIDTH HEIGHT FX FY CX CY
// DEPTH: uint16 millimetres, row by row, little endian; 0 = no measurement.
import { open, readFile } from "node:fs/promises";
import { McapWriter } from "@mcap/core";
import { FileHandleWritable } from "@mcap/nodejs";
import { parse } from "@foxglove/rosmsg";
import { MessageWriter } from "@foxglove/rosmsg2-serialization";

const line = "=".repeat(80);
const header = `std_msgs/Header header
`;
const common = `
${line}
MSG: std_msgs/Header
builtin_interfaces/Time stamp
string frame_id
${line}
MSG: builtin_interfaces/Time
int32 sec
uint32 nanosec
`;
const definitions = {
  "sensor_msgs/msg/PointCloud2": `${header}uint32 height
uint32 width
sensor_msgs/PointField[] fields
bool is_bigendian
uint32 point_step
uint32 row_step
uint8[] data
bool is_dense${common}${line}
MSG: sensor_msgs/PointField
string name
uint32 offset
uint8 datatype
uint32 count
`,
  "sensor_msgs/msg/Image": `${header}uint32 height
uint32 width
string encoding
uint8 is_bigendian
uint32 step
uint8[] data${common}`,
  "sensor_msgs/msg/CameraInfo": `${header}uint32 height
uint32 width
string distortion_model
float64[] d
float64[9] k
float64[9] r
float64[12] p
uint32 binning_x
uint32 binning_y
sensor_msgs/RegionOfInterest roi${common}${line}
MSG: sensor_msgs/RegionOfInterest
uint32 x_offset
uint32 y_offset
uint32 height
uint32 width
bool do_rectify
`,
  "sensor_msgs/msg/CompressedImage": `${header}string format
uint8[] data${common}`,
};

const [depthFile, bag, ...numbers] = process.argv.slice(2);
const [width, height, fx, fy, cx, cy] = numbers.map(Number);
const depth = new Uint16Array((await readFile(depthFile)).buffer.slice(0, 2 * width * height));
const stamp = { sec: 1_700_000_000, nanosec: 500_000_000 };
const messageHeader = { stamp, frame_id: "camera_depth_optical_frame" };

// x, y, z behind 4 bytes, an rgb behind them, and padding behind every row.
function pointCloud() {
  const [pointStep, rowStep] = [24, 24 * width + 8];
  const view = new DataView(new ArrayBuffer(rowStep * height));
  for (let v = 0; v < height; ++v) {
    for (let u = 0; u < width; ++u) {
      const mm = depth[v * width + u];
      const z = mm === 0 ? NaN : mm * 0.001;
      const at = v * rowStep + u * pointStep + 4;
      view.setFloat32(at, ((u - cx) / fx) * z, true);
      view.setFloat32(at + 4, ((v - cy) / fy) * z, true);
      view.setFloat32(at + 8, z, true);
    }
  }
  const field = (name, offset, datatype) => ({ name, offset, datatype, count: 1 });
  return {
    header: messageHeader, height, width,
    fields: [field("x", 4, 7), field("y", 8, 7), field("z", 12, 7), field("rgb", 16, 7)],
    is_bigendian: false, point_step: pointStep, row_step: rowStep,
    data: new Uint8Array(view.buffer), is_dense: false,
  };
}

function image(encoding, bytes) {
  const data = new Uint8Array(bytes.buffer);
  return { header: messageHeader, height, width, encoding, is_bigendian: 0,
           step: data.length / height, data };
}

const cameraInfo = {
  header: messageHeader, height, width, distortion_model: "plumb_bob", d: [0, 0, 0, 0, 0],
  k: [fx, 0, cx, 0, fy, cy, 0, 0, 1], r: [1, 0, 0, 0, 1, 0, 0, 0, 1],
  p: [fx, 0, cx, 0, 0, fy, cy, 0, 0, 0, 1, 0], binning_x: 0, binning_y: 0,
  roi: { x_offset: 0, y_offset: 0, height: 0, width: 0, do_rectify: false },
};
const metres = Float32Array.from(depth, (mm) => (mm === 0 ? NaN : mm * 0.001));
const messages = [
  ["/camera/depth/camera_info", "sensor_msgs/msg/CameraInfo", cameraInfo],
  ["/camera/depth/image_rect_raw", "sensor_msgs/msg/Image", image("16UC1", depth)],
  ["/camera/depth/points", "sensor_msgs/msg/PointCloud2", pointCloud()],
  ["/zed/depth/depth_registered", "sensor_msgs/msg/Image", image("32FC1", metres)],
  ["/zed/depth/camera_info", "sensor_msgs/msg/CameraInfo", cameraInfo],
  ["/camera/color/image_raw", "sensor_msgs/msg/Image", image("rgb8", new Uint8Array(3 * width * height))],
  ["/camera/depth/compressed", "sensor_msgs/msg/CompressedImage",
   { header: messageHeader, format: "16UC1; compressedDepth png", data: new Uint8Array(20) }],
];

const handle = await open(bag, "w");
const writer = new McapWriter({ writable: new FileHandleWritable(handle) });
await writer.start({ profile: "ros2", library: "cleave's tests" });
const schemas = new Map();
let logTime = 1_700_000_000_600_000_000n;
for (const [topic, type, message] of messages) {
  if (!schemas.has(type)) {
    const data = new TextEncoder().encode(definitions[type]);
    schemas.set(type, await writer.registerSchema({ name: type, encoding: "ros2msg", data }));
  }
  const channelId = await writer.registerChannel({
    schemaId: schemas.get(type), topic, messageEncoding: "cdr", metadata: new Map(),
  });
  const serialised = new MessageWriter(parse(definitions[type], { ros2: true })).writeMessage(message);
  logTime += 1_000_000n;
  await writer.addMessage({ channelId, sequence: 1, logTime, publishTime: logTime, data: serialised });
}
await writer.end();
await handle.close();
