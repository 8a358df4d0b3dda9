// SPDX-License-Identifier: BSD-3-Clause
// Records the depth of a camera with OpenNI2's own recorder, and what it recorded to RAW: of every
// frame its time stamp (8 bytes) and its pixels. Ends without taking OpenNI2 apart, whose recorder
// and driver race then. Usage: oni_recorder URI OUT.oni RAW FRAMES (0 = until it is killed)
#include <OpenNI.h>
#include <unistd.h>

#include <fstream>
#include <iostream>
#include <string>

namespace {

void require(openni::Status status, const char* what) {
  if (status == openni::STATUS_OK) return;
  std::cerr << what << ": " << openni::OpenNI::getExtendedError() << std::endl;
  ::_exit(1);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 5) return 2;
  std::ofstream raw(argv[3], std::ios::binary);
  const int wanted = std::stoi(argv[4]);
  require(openni::OpenNI::initialize(), "initialize");
  openni::Device device;
  require(device.open(argv[1]), "open");
  openni::VideoStream stream;
  require(stream.create(device, openni::SENSOR_DEPTH), "create");
  openni::Recorder recorder;
  require(recorder.create(argv[2]), "recorder");
  require(recorder.attach(stream), "attach");
  require(recorder.start(), "record");
  require(stream.start(), "start");
  for (int i = 0; wanted == 0 || i < wanted; ++i) {
    openni::VideoFrameRef frame;
    require(stream.readFrame(&frame), "read");
    const std::uint64_t timestamp_us = frame.getTimestamp();
    raw.write(reinterpret_cast<const char*>(&timestamp_us), sizeof timestamp_us);
    raw.write(static_cast<const char*>(frame.getData()), frame.getDataSize());
    raw.flush();
  }
  stream.stop();
  recorder.stop();
  recorder.destroy();  // returns when the file is complete
  ::_exit(raw ? 0 : 1);
}
