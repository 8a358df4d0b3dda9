# SPDX-License-Identifier: BSD-3-Clause
# Every dependency is a Debian 12 package; a missing one is named with the command that installs it.

# cleave_find(<CMake package> <Debian package> [extra find_package arguments...])
macro(cleave_find package debian_package)
  find_package(${package} ${ARGN} QUIET)
  if(NOT ${package}_FOUND)
    message(FATAL_ERROR
      "${package} was not found. It is in Debian's ${debian_package}:\n"
      "  apt-get install ${debian_package}")
  endif()
endmacro()

cleave_find(CycloneDDS cyclonedds-dev)
cleave_find(iceoryx_hoofs libiceoryx-hoofs-dev)
cleave_find(iceoryx_posh libiceoryx-posh-dev)
cleave_find(iceoryx_binding_c libiceoryx-binding-c-dev)
cleave_find(Eigen3 libeigen3-dev 3.4)
cleave_find(yaml-cpp libyaml-cpp-dev 0.7)
cleave_find(spdlog libspdlog-dev)
cleave_find(CLI11 libcli11-dev)
cleave_find(nlohmann_json nlohmann-json3-dev)
cleave_find(PNG libpng-dev)
cleave_find(ZLIB zlib1g-dev)

# These bring no CMake package in Debian 12, or (PCL) one that drags in VTK and Qt.
macro(cleave_require variable what debian_package)
  if(NOT ${variable})
    message(FATAL_ERROR
      "${what} was not found. It is in Debian's ${debian_package}:\n"
      "  apt-get install ${debian_package}")
  endif()
endmacro()

find_program(IDLC idlc)
cleave_require(IDLC "idlc, the IDL compiler," cyclonedds-tools)

# cleave_library_of(<name> <header> <library> <Debian package> [<header's folder>]): cleave_<name>.
macro(cleave_library_of name header library debian_package)
  find_path(${name}_INCLUDE_DIR ${header} PATH_SUFFIXES ${ARGN})
  find_library(${name}_LIBRARY ${library})
  cleave_require(${name}_INCLUDE_DIR "${header}" ${debian_package})
  cleave_require(${name}_LIBRARY "lib${library}" ${debian_package})
  add_library(cleave_${name} INTERFACE)
  target_include_directories(cleave_${name} SYSTEM INTERFACE "${${name}_INCLUDE_DIR}")
  target_link_libraries(cleave_${name} INTERFACE "${${name}_LIBRARY}")
endmacro()

cleave_library_of(openni2 OpenNI.h OpenNI2 libopenni2-dev openni2)
cleave_library_of(amd amd.h amd libsuitesparse-dev suitesparse)
cleave_library_of(zstd zstd.h zstd libzstd-dev)
cleave_library_of(lzf liblzf/lzf.h lzf liblzf-dev)
cleave_library_of(lz4 lz4frame.h lz4 liblz4-dev)

find_path(PCL_INCLUDE_DIR pcl/point_types.h PATH_SUFFIXES pcl-1.13 pcl-1.14 pcl-1.12)
find_library(PCL_COMMON_LIBRARY pcl_common)
find_library(PCL_IO_LIBRARY pcl_io)
cleave_require(PCL_INCLUDE_DIR "PCL" libpcl-dev)
cleave_require(PCL_COMMON_LIBRARY "PCL" libpcl-dev)
cleave_require(PCL_IO_LIBRARY "PCL" libpcl-dev)
add_library(cleave_pcl_io INTERFACE)
target_include_directories(cleave_pcl_io SYSTEM INTERFACE "${PCL_INCLUDE_DIR}")
target_link_libraries(cleave_pcl_io INTERFACE "${PCL_IO_LIBRARY}" "${PCL_COMMON_LIBRARY}" Eigen3::Eigen)

# What Cleave is compared with.
add_library(cleave_pcl_segmentation INTERFACE)
foreach(part segmentation features search octree kdtree)
  find_library(PCL_${part}_LIBRARY pcl_${part})
  cleave_require(PCL_${part}_LIBRARY "PCL's ${part}" libpcl-dev)
  target_link_libraries(cleave_pcl_segmentation INTERFACE "${PCL_${part}_LIBRARY}")
endforeach()
target_link_libraries(cleave_pcl_segmentation INTERFACE cleave_pcl_io)
