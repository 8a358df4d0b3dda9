# SPDX-License-Identifier: BSD-3-Clause
# Debian's OpenNI2 looks for drivers in OpenNI2/Drivers beside the place it was loaded from, and
# nowhere else. openni2/ beside the programs is such a place: the system's library and camera drivers
# by symbolic link, and our synthetic camera. An installation has it in lib/cleave.
set(CLEAVE_OPENNI2_DIR "${CMAKE_RUNTIME_OUTPUT_DIRECTORY}/openni2")
set(CLEAVE_OPENNI2_DRIVER_DIR "${CLEAVE_OPENNI2_DIR}/OpenNI2/Drivers")

file(REAL_PATH "${openni2_LIBRARY}" openni2_library)
cmake_path(GET openni2_library PARENT_PATH openni2_system_dir)
file(MAKE_DIRECTORY "${CLEAVE_OPENNI2_DRIVER_DIR}")
file(CREATE_LINK "${openni2_library}" "${CLEAVE_OPENNI2_DIR}/libOpenNI2.so.0" SYMBOLIC)
# Not libOniFile.so.0, which plays recordings: client/recording/oni/README.md says why.
foreach(driver libPS1080.so.0 libPSLink.so.0)
  set(system_driver "${openni2_system_dir}/OpenNI2/Drivers/${driver}")
  if(NOT EXISTS "${system_driver}")
    message(FATAL_ERROR "${system_driver} was not found. It is in Debian's libopenni2-0:\n"
      "  apt-get install libopenni2-0")
  endif()
  file(CREATE_LINK "${system_driver}" "${CLEAVE_OPENNI2_DRIVER_DIR}/${driver}" SYMBOLIC)
endforeach()

# cleave_use_openni2(target): links OpenNI2 such that the target, a program in bin/, finds real
# cameras and the synthetic camera without any environment variable.
function(cleave_use_openni2 target)
  target_link_libraries(${target} PRIVATE cleave_openni2)
  set_property(TARGET ${target} APPEND PROPERTY BUILD_RPATH
    "$ORIGIN/openni2" "$ORIGIN/../lib/cleave/openni2")
  add_dependencies(${target} cleave_synthetic_driver)
  if(CLEAVE_SANITIZE)
    target_sources(${target} PRIVATE "${PROJECT_SOURCE_DIR}/sensor/driver/openni2_sanitizers.cpp")
  endif()
endfunction()
