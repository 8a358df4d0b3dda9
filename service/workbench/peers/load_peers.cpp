// SPDX-License-Identifier: BSD-3-Clause
#include "workbench/peers/load_peers.hpp"

#include <dlfcn.h>

#include <filesystem>
#include <stdexcept>
#include <string>

#include "libcleave/process/companion.hpp"
#include "workbench/peers/module.hpp"

namespace cleave::peers {
namespace {

[[noreturn]] void refuse(const std::filesystem::path& module) {
  const char* const reason = dlerror();
  throw std::runtime_error("PCL's methods cannot be loaded from " + module.string() + ": " +
                           (reason != nullptr ? reason : "unknown error"));
}

// It stays loaded until the program ends.
template <class Function>
Function* find(const char* name) {
  const std::filesystem::path module =
      companion("libcleave_peers.so",
                "it holds PCL's methods: install the package cleave-workbench, or build the target "
                "cleave_peers_module");
  void* const library = dlopen(module.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) refuse(module);
  void* const function = dlsym(library, name);
  if (function == nullptr) refuse(module);
  return reinterpret_cast<Function*>(function);
}

}  // namespace

LccpParameters tuned_lccp() {
  LccpParameters parameters;
  parameters.concavity_tolerance_deg = 20;
  parameters.k_factor = 0;
  return parameters;
}

std::unique_ptr<Peer> make_pcl_lccp(const LccpParameters& parameters) {
  return std::unique_ptr<Peer>(
      find<decltype(cleave_new_pcl_lccp)>("cleave_new_pcl_lccp")(parameters));
}

std::unique_ptr<Peer> make_pcl_cpc(const CpcParameters& parameters) {
  return std::unique_ptr<Peer>(
      find<decltype(cleave_new_pcl_cpc)>("cleave_new_pcl_cpc")(parameters));
}

std::unique_ptr<Peer> make_pcl_ssc(const segmentation::Options& options,
                                   const SupervoxelParameters& supervoxels) {
  return std::unique_ptr<Peer>(
      find<decltype(cleave_new_pcl_ssc)>("cleave_new_pcl_ssc")(options, supervoxels));
}

}  // namespace cleave::peers
