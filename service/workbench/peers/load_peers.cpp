// SPDX-License-Identifier: BSD-3-Clause
#include "workbench/peers/load_peers.hpp"

#include <dlfcn.h>

#include <filesystem>
#include <stdexcept>
#include <string>

#include "workbench/peers/module.hpp"

namespace cleave::peers {
namespace {

[[noreturn]] void refuse(const std::string& module) {
  const char* const reason = dlerror();
  throw std::runtime_error("PCL's methods cannot be loaded from " + module + ": " +
                           (reason != nullptr ? reason : "unknown error") +
                           "; build the target cleave, and keep the file beside the program");
}

// It stays loaded until the program ends.
template <class Function>
Function* find(const char* name) {
  const std::string module =
      std::filesystem::read_symlink("/proc/self/exe").parent_path() / "libcleave_peers.so";
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
