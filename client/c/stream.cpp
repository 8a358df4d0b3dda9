// SPDX-License-Identifier: BSD-3-Clause
#include "libcleave/stream.hpp"

#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>

#include "c/cleave.h"
#include "c/errors.hpp"
#include "c/handles.hpp"
#include "idl/interface_name.hpp"
#include "libcleave/process/logging.hpp"

namespace cleave::c {
namespace {

StreamOptions stream_options(const cleave_options& options) {
  StreamOptions result = with_environment({});
  if (options.domain > 99 || options.domain < -1) {
    throw std::invalid_argument("domain " + std::to_string(options.domain) +
                                " is not from 0 to 99, nor -1 for that of the environment");
  }
  if (options.domain >= 0) result.domain = static_cast<std::uint32_t>(options.domain);
  result.shared_memory = options.shared_memory != 0;
  if (options.interface == nullptr) return result;
  if (!is_interface_name(options.interface)) {
    throw std::invalid_argument("'" + std::string(options.interface) +
                                "' is no name or address of a network interface");
  }
  result.public_interface = options.interface;
  return result;
}

// The process's stream, while anything of it is open.
std::shared_ptr<Stream> join(const StreamOptions& options) {
  static std::mutex mutex;  // guards the other two
  static std::weak_ptr<Stream> joined;
  static bool logs = false;
  const std::lock_guard lock(mutex);
  if (!joined.expired()) {
    throw std::runtime_error(
        "this process has a stream already: use that one, or close it and all that was opened or "
        "taken from it");
  }
  if (!logs) init_logging("cleave");
  logs = true;
  auto stream = std::make_shared<Stream>(options);
  joined = stream;
  return stream;
}

}  // namespace
}  // namespace cleave::c

cleave_result cleave_open(const cleave_options* options, cleave_stream** stream) {
  return cleave::c::guarded([&] {
    cleave_stream*& result = cleave::c::given(stream, "stream");
    const cleave_options none{-1, 1, nullptr};
    result = new cleave_stream{
        cleave::c::join(cleave::c::stream_options(options != nullptr ? *options : none))};
    return CLEAVE_OK;
  });
}

void cleave_close(cleave_stream* stream) {
  delete stream;
}

int cleave_uses_shared_memory(const cleave_stream* stream, const char** reason) {
  if (stream == nullptr) return 0;
  if (reason != nullptr) *reason = stream->stream->transport_reason().c_str();
  return stream->stream->transport() == cleave::Transport::shared_memory ? 1 : 0;
}
