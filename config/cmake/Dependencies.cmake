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

find_path(OPENNI2_INCLUDE_DIR OpenNI.h PATH_SUFFIXES openni2)
find_library(OPENNI2_LIBRARY OpenNI2)
cleave_require(OPENNI2_INCLUDE_DIR "OpenNI2" libopenni2-dev)
cleave_require(OPENNI2_LIBRARY "OpenNI2" libopenni2-dev)
add_library(cleave_openni2 INTERFACE)
target_include_directories(cleave_openni2 SYSTEM INTERFACE "${OPENNI2_INCLUDE_DIR}")
target_link_libraries(cleave_openni2 INTERFACE "${OPENNI2_LIBRARY}")

find_path(AMD_INCLUDE_DIR amd.h PATH_SUFFIXES suitesparse)
find_library(AMD_LIBRARY amd)
cleave_require(AMD_INCLUDE_DIR "AMD" libsuitesparse-dev)
cleave_require(AMD_LIBRARY "AMD" libsuitesparse-dev)
add_library(cleave_amd INTERFACE)
target_include_directories(cleave_amd SYSTEM INTERFACE "${AMD_INCLUDE_DIR}")
target_link_libraries(cleave_amd INTERFACE "${AMD_LIBRARY}")

find_path(ZSTD_INCLUDE_DIR zstd.h)
find_library(ZSTD_LIBRARY zstd)
cleave_require(ZSTD_INCLUDE_DIR "zstd" libzstd-dev)
cleave_require(ZSTD_LIBRARY "zstd" libzstd-dev)
add_library(cleave_zstd INTERFACE)
target_include_directories(cleave_zstd SYSTEM INTERFACE "${ZSTD_INCLUDE_DIR}")
target_link_libraries(cleave_zstd INTERFACE "${ZSTD_LIBRARY}")

find_path(LZF_INCLUDE_DIR liblzf/lzf.h)
find_library(LZF_LIBRARY lzf)
cleave_require(LZF_INCLUDE_DIR "LZF" liblzf-dev)
cleave_require(LZF_LIBRARY "LZF" liblzf-dev)
add_library(cleave_lzf INTERFACE)
target_include_directories(cleave_lzf SYSTEM INTERFACE "${LZF_INCLUDE_DIR}")
target_link_libraries(cleave_lzf INTERFACE "${LZF_LIBRARY}")

find_path(LZ4_INCLUDE_DIR lz4frame.h)
find_library(LZ4_LIBRARY lz4)
cleave_require(LZ4_INCLUDE_DIR "lz4" liblz4-dev)
cleave_require(LZ4_LIBRARY "lz4" liblz4-dev)
add_library(cleave_lz4 INTERFACE)
target_include_directories(cleave_lz4 SYSTEM INTERFACE "${LZ4_INCLUDE_DIR}")
target_link_libraries(cleave_lz4 INTERFACE "${LZ4_LIBRARY}")

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
