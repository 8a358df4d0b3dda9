// SPDX-License-Identifier: BSD-3-Clause
#include "cleave/stream/find_sensor.hpp"

#include <stdexcept>

#include "cleave/stream/nobody_answers.hpp"
#include "cleave/stream/status_reader.hpp"
#include "console/table.hpp"

namespace cleave::client {

std::string only_sensor(const std::set<std::string>& sensors) {
  if (sensors.size() == 1) return *sensors.begin();
  std::string names;
  for (const std::string& sensor : sensors) names += " " + printable(sensor);
  throw std::runtime_error("there are several sensors:" + names + "; choose one with --sensor");
}

std::string find_sensor(Stream& stream, Shutdown& shutdown, const std::string& wanted,
                        std::chrono::milliseconds patience) {
  if (!wanted.empty()) return wanted;
  StatusReader statuses(stream);
  std::set<std::string> sensors;
  for (const NodeReport& report : statuses.collect(shutdown, patience)) {
    sensors.insert(report.sensor);
  }
  if (sensors.empty()) throw std::runtime_error(nobody_answers(stream));
  return only_sensor(sensors);
}

}  // namespace cleave::client
