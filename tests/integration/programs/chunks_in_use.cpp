// SPDX-License-Identifier: BSD-3-Clause
// Prints how many chunks are in use in RouDi's pools of label maps and clouds, as RouDi itself
// tells once a second. A program, because RouDi ends with itself whoever asks it.
#include <chrono>
#include <cstdint>
#include <iceoryx_posh/popo/subscriber.hpp>
#include <iceoryx_posh/roudi/introspection_types.hpp>
#include <iceoryx_posh/runtime/posh_runtime.hpp>
#include <iostream>
#include <thread>

int main() {
  using Pools = iox::roudi::MemPoolIntrospectionInfoContainer;
  constexpr std::uint32_t labels = 655'360, cloud = 3'690'496;  // as in config/roudi.toml
  iox::runtime::PoshRuntime::initRuntime("chunks_in_use");
  iox::popo::Subscriber<Pools> subscriber(iox::roudi::IntrospectionMempoolService);
  for (int i = 0; i < 100; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    bool told = false;
    std::uint32_t used = 0;
    subscriber.take().and_then([&](const auto& segments) {
      told = true;
      for (const auto& segment : *segments) {
        for (const auto& pool : segment.m_mempoolInfo) {
          const std::uint32_t size = pool.m_chunkPayloadSize;
          if (size == labels || size == cloud) used += pool.m_usedChunks;
        }
      }
    });
    if (told) {
      std::cout << used << '\n';
      return 0;
    }
  }
  std::cerr << "RouDi tells nothing\n";
  return 1;
}
