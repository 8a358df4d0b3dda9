# SPDX-License-Identifier: BSD-3-Clause
# One place for how every target of ours is compiled.
set(CLEAVE_SANITIZE "" CACHE STRING "Sanitizers for every target, e.g. address,undefined or thread")

# With paths relative to the checkout, what one checkout compiled serves every other.
find_program(CCACHE ccache)
if(CCACHE)
  cmake_path(SET checkout NORMALIZE "${CMAKE_CURRENT_LIST_DIR}/../..")
  set(CMAKE_CXX_COMPILER_LAUNCHER
    ${CMAKE_COMMAND} -E env "CCACHE_BASEDIR=${checkout}" "${CCACHE}")
  set(CMAKE_C_COMPILER_LAUNCHER "${CMAKE_CXX_COMPILER_LAUNCHER}")
  add_compile_options("-ffile-prefix-map=${checkout}=.")
endif()

# cleave_compile_options(target): C++20, warnings as errors (a newer compiler's are let pass by
# `cmake --compile-no-warning-as-error`), and floating point that gives the same labels everywhere:
# contraction to fused multiply-add would make them depend on the machine.
function(cleave_compile_options target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF POSITION_INDEPENDENT_CODE ON
    COMPILE_WARNING_AS_ERROR ON)
  # -Wrestrict is wrong about std::string's operator+ in GCC 12 (GCC bug 105651).
  target_compile_options(${target} PRIVATE
    -Wall -Wextra -Wconversion -Wno-restrict -ffp-contract=off)
  # Sources that are compiled a dozen at a time: what stands in a nameless namespace is nobody else's
  # all the same.
  if(CMAKE_UNITY_BUILD)
    target_compile_options(${target} PRIVATE -Wno-subobject-linkage)
  endif()
  if(CLEAVE_SANITIZE)
    target_compile_options(${target} PUBLIC
      -fsanitize=${CLEAVE_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
    target_link_options(${target} PUBLIC -fsanitize=${CLEAVE_SANITIZE})
    # Eigen aligns by hand under the address sanitizer only; what PCL's library then frees is no
    # pointer of malloc's.
    target_compile_definitions(${target} PUBLIC EIGEN_MALLOC_ALREADY_ALIGNED=1)
  endif()
endfunction()

# cleave_library(name SOURCES...): a static library named cleave_<name>, usable as cleave::<name>.
function(cleave_library name)
  add_library(cleave_${name} STATIC ${ARGN})
  add_library(cleave::${name} ALIAS cleave_${name})
  cleave_compile_options(cleave_${name})
endfunction()

# cleave_program(name SOURCES...): an executable in bin/.
function(cleave_program name)
  add_executable(${name} ${ARGN})
  cleave_compile_options(${name})
endfunction()

# cleave_c_program(name SOURCES... [LIBRARIES targets...]): an executable in bin/, in C11, compiled as
# warily as a user's may be; against the C interface, or other libraries.
function(cleave_c_program name)
  cmake_parse_arguments(ARG "" "" "LIBRARIES" ${ARGN})
  if(NOT ARG_LIBRARIES)
    set(ARG_LIBRARIES cleave::c)
  endif()
  add_executable(${name} ${ARG_UNPARSED_ARGUMENTS})
  set_target_properties(${name} PROPERTIES
    C_STANDARD 11 C_STANDARD_REQUIRED ON C_EXTENSIONS OFF COMPILE_WARNING_AS_ERROR ON)
  target_compile_options(${name} PRIVATE -Wall -Wextra -Wpedantic -Wstrict-prototypes)
  target_link_libraries(${name} PRIVATE ${ARG_LIBRARIES})
endfunction()
