# SPDX-License-Identifier: BSD-3-Clause
# What an installation holds, by component: runtime (the daemons, their configuration and units),
# tools (the command line), workbench (what segments offline; the only one that needs PCL), client
# (the shared library), dev (headers, static libraries, CMake and pkg-config files) and python, whose
# rules are in client/python. All of it finds the rest from where it lies itself, so a prefix may be
# chosen when it is installed, and moved afterwards.
set(private lib/cleave)  # where companion.cpp looks for what comes with a program
set(headers include/cleave)

# All that it takes: `cmake --build --preset release --target installation`.
add_custom_target(installation DEPENDS cleave cleave-c cleave-grabber cleave-render
  cleave-segmenter cleave-workbench)
if(TARGET pages)
  add_dependencies(installation pages)
endif()

install(TARGETS cleave-grabber cleave-segmenter DESTINATION bin COMPONENT runtime)
install(TARGETS cleave cleave-render DESTINATION bin COMPONENT tools)
install(TARGETS cleave-workbench DESTINATION bin COMPONENT workbench)
install(TARGETS cleave_peers_module DESTINATION "${private}" COMPONENT workbench)

# The system's OpenNI2 with our driver beside its own: sensor/driver/OpenNI2Drivers.cmake.
set_property(TARGET cleave-grabber PROPERTY INSTALL_RPATH "$ORIGIN/../${private}/openni2")
install(TARGETS cleave_synthetic_driver DESTINATION "${private}/openni2/OpenNI2/Drivers"
  COMPONENT runtime)
install(DIRECTORY "${CMAKE_RUNTIME_OUTPUT_DIRECTORY}/openni2" DESTINATION "${private}" COMPONENT runtime
  PATTERN "libCleaveSynthetic.so.0" EXCLUDE)

# Configuration and units name places, which are known when the prefix is.
set(configuration "${PROJECT_SOURCE_DIR}/config")
install(CODE "set(configuration \"${configuration}\")\nset(scratch \"${PROJECT_BINARY_DIR}/units\")"
  COMPONENT runtime)
install(SCRIPT "${CMAKE_CURRENT_LIST_DIR}/InstallConfiguration.cmake" COMPONENT runtime)

# Libraries for clients, each with what it is made of. What a checkout includes from its folders, a
# client includes from one.
function(cleave_install_library export name target includes)
  foreach(kind INTERFACE_INCLUDE_DIRECTORIES INTERFACE_SYSTEM_INCLUDE_DIRECTORIES)
    get_target_property(folders ${target} ${kind})
    if(folders)
      set_property(TARGET ${target} PROPERTY ${kind} "$<BUILD_INTERFACE:${folders}>")
    endif()
  endforeach()
  set_property(TARGET ${target} PROPERTY EXPORT_NAME ${name})
  install(TARGETS ${target} EXPORT ${export}
    ARCHIVE DESTINATION lib COMPONENT dev
    LIBRARY DESTINATION lib COMPONENT client NAMELINK_COMPONENT dev
    INCLUDES DESTINATION "${includes}")
endfunction()
set_property(TARGET cleave_libcleave PROPERTY OUTPUT_NAME cleave)
foreach(part client:cleave_libcleave process:cleave_process depth:cleave_depth idl:cleave_idl
             contract:cleave_contract)
  string(REPLACE ":" ";" part "${part}")
  cleave_install_library(client ${part} "${headers}")
endforeach()
cleave_install_library(segmentation segmentation cleave_segmentation "${headers}")
cleave_install_library(c c cleave-c include)

function(cleave_install_headers root folder)
  install(DIRECTORY "${PROJECT_SOURCE_DIR}/${root}/${folder}" DESTINATION "${headers}" COMPONENT dev
    FILES_MATCHING PATTERN "*.hpp" PATTERN golden EXCLUDE)
endfunction()
cleave_install_headers(. idl)
cleave_install_headers(client libcleave)
cleave_install_headers(service segmentation)
install(FILES "${PROJECT_BINARY_DIR}/idl/generated/cleave_v1.h" DESTINATION "${headers}"
  COMPONENT dev)
install(FILES client/c/cleave.h DESTINATION include COMPONENT dev)
install(FILES idl/cleave_v1.idl DESTINATION share/cleave COMPONENT dev)

# find_package(cleave), and pkg-config.
include(CMakePackageConfigHelpers)
set(cmake_files lib/cmake/cleave)
configure_package_config_file(config/cmake/cleaveConfig.cmake.in
  "${PROJECT_BINARY_DIR}/cmake/cleaveConfig.cmake" INSTALL_DESTINATION "${cmake_files}"
  NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file("${PROJECT_BINARY_DIR}/cmake/cleaveConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/cmake/cleaveConfig.cmake"
  "${PROJECT_BINARY_DIR}/cmake/cleaveConfigVersion.cmake"
  DESTINATION "${cmake_files}" COMPONENT dev)
foreach(export client segmentation c)
  install(EXPORT ${export} NAMESPACE cleave:: FILE cleave-${export}.cmake
    DESTINATION "${cmake_files}" COMPONENT dev)
endforeach()
foreach(library cleave cleave-segmentation cleave-c)
  configure_file(config/cmake/${library}.pc.in "${PROJECT_BINARY_DIR}/cmake/${library}.pc" @ONLY)
  install(FILES "${PROJECT_BINARY_DIR}/cmake/${library}.pc" DESTINATION share/pkgconfig COMPONENT dev)
endforeach()
