# SPDX-License-Identifier: BSD-3-Clause
# Run by `cmake --install`: configuration, and the units that name it and the programs, by the prefix
# that is being installed to. The system's own has its configuration in /etc, any other below itself.
if(CMAKE_INSTALL_PREFIX STREQUAL "/usr")
  set(etc /etc/cleave)
else()
  set(etc "${CMAKE_INSTALL_PREFIX}/etc/cleave")
endif()
set(bin "${CMAKE_INSTALL_PREFIX}/bin")

file(INSTALL DESTINATION "${etc}" TYPE FILE FILES
  "${configuration}/grabber.yaml" "${configuration}/segmenter.yaml"
  "${configuration}/roudi.toml" "${configuration}/roudi-large.toml")
file(GLOB units "${configuration}/systemd/*.service.in")
foreach(unit ${units})
  cmake_path(GET unit STEM LAST_ONLY name)
  configure_file("${unit}" "${scratch}/${name}" @ONLY)
  file(INSTALL DESTINATION "${CMAKE_INSTALL_PREFIX}/lib/systemd/system" TYPE FILE
    FILES "${scratch}/${name}")
endforeach()
file(INSTALL DESTINATION "${CMAKE_INSTALL_PREFIX}/lib/sysusers.d" TYPE FILE
  FILES "${configuration}/systemd/cleave.conf")
file(INSTALL DESTINATION "${CMAKE_INSTALL_PREFIX}/lib/udev/rules.d" TYPE FILE
  FILES "${configuration}/systemd/59-cleave.rules")
