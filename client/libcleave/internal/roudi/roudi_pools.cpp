// SPDX-License-Identifier: BSD-3-Clause
#include <cstdint>
#include <exception>
#include <functional>
#include <iceoryx_hoofs/error_handling/error_handling.hpp>
#include <string>

// These lack it.
extern "C" {
#include <iceoryx_binding_c/publisher.h>
}
#include <dds/ddsi/ddsi_shm_transport.h>

#include "libcleave/internal/roudi/roudi_access.hpp"
#include "libcleave/internal/roudi/roudi_post.hpp"
#include "libcleave/types.hpp"

namespace cleave {
namespace {

// iceoryx aborts the process when no pool has chunks that are large enough. Here it is asked
// whether one has: that answer is noted, and whatever else goes wrong ends the process as it always
// does.
class PoolQuestion {
 public:
  [[nodiscard]] bool fits(std::uint32_t bytes) {
    const auto handler = iox::ErrorHandler::setTemporaryErrorHandler(note_);
    iox_pub_storage_t storage;
    iox_pub_options_t options;
    iox_pub_options_init(&options);
    options.offerOnCreate = false;
    iox_pub_t const publisher = iox_pub_init(&storage, "cleave", "pools", "question", &options);
    void* chunk = nullptr;
    const auto result = iox_pub_loan_aligned_chunk_with_user_header(
        publisher, &chunk, bytes, alignment, sizeof(iceoryx_header_t), alignment);
    if (result == AllocationResult_SUCCESS) iox_pub_release_chunk(publisher, chunk);
    iox_pub_deinit(publisher);
    return !too_large_;
  }

 private:
  static constexpr std::uint32_t alignment = 8;  // Cyclone's, of the sample and of its header

  bool too_large_ = false;
  iox::HandlerFunction note_ = [this](iox::Error error, const std::function<void()>& /*callback*/,
                                      iox::ErrorLevel level) {
    if (error == iox::Error::kMEPOO__MEMPOOL_GETCHUNK_CHUNK_IS_TOO_LARGE ||
        error == iox::Error::kMEPOO__MEMPOOL_GETCHUNK_CHUNK_WITHOUT_MEMPOOL) {
      too_large_ = true;
    } else if (level == iox::ErrorLevel::FATAL) {
      std::terminate();
    }
  };
};

}  // namespace

std::string obstacle_of_pools(std::uint32_t bytes) {
  join_roudi();
  if (PoolQuestion().fits(bytes)) return {};
  return "RouDi's pools have no chunks of " + std::to_string(bytes) +
         " bytes: start it with `iox-roudi -m off -c config/" +
         (bytes > sizeof(DepthCloud) ? "roudi-large.toml`" : "roudi.toml`");
}

}  // namespace cleave
