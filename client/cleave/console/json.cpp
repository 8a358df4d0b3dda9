#include "cleave/console/json.hpp"

namespace cleave::client {

Json json_of(const Percentiles& percentiles) {
  return {{"median", percentiles.median}, {"p90", percentiles.p90}, {"p99", percentiles.p99}};
}

std::string one_line(const Json& object) {
  return object.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace cleave::client
