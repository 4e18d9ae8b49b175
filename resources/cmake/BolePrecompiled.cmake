# Precompiled headers: reading Eigen and the standard library takes longer than compiling most of our files. Only foreign headers
# are in them, so a change of ours never rebuilds them. A set per kind of target, since GCC takes one only with equal flags.
option(BOLE_PRECOMPILED_HEADERS "Precompile the headers of Eigen and the standard library" ON)

set(bole_precompiled <algorithm> <array> <cmath> <cstdint> <filesystem> <functional> <limits> <map> <memory> <numbers> <numeric> <optional>
                     <span> <stop_token> <string> <string_view> <variant> <vector> <Eigen/Core> <Eigen/Geometry> <fmt/format.h>
                     <nlohmann/json.hpp>)
file(WRITE ${CMAKE_BINARY_DIR}/generated/precompiled.cpp "// Carries the precompiled headers of bole_precompiled_*.\nint main() { return 0; }\n")

# bole_precompile(TARGET [TEST] [OWN] [HEADERS header...]): takes the precompiled headers that fit a library, a program, or a TEST (with
# GoogleMock's). Targets with options of their own that change code (-fno-math-errno) give OWN, those with further headers give
# HEADERS: they get a set for themselves.
function(bole_precompile target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "OWN;TEST" "" "HEADERS")
  if(NOT BOLE_PRECOMPILED_HEADERS)
    return()
  endif()
  if(arg_OWN OR arg_HEADERS)
    target_precompile_headers(${target} PRIVATE ${bole_precompiled} ${arg_HEADERS})
    return()
  endif()
  get_target_property(type ${target} TYPE)
  set(kind library)
  if(arg_TEST)
    set(kind test)
  elseif(type STREQUAL "EXECUTABLE")
    set(kind program)
  endif()
  set(carrier bole_precompiled_${kind})
  if(NOT TARGET ${carrier})
    if(kind STREQUAL "library")
      add_library(${carrier} STATIC EXCLUDE_FROM_ALL ${CMAKE_BINARY_DIR}/generated/precompiled.cpp)
    else()
      add_executable(${carrier} EXCLUDE_FROM_ALL ${CMAKE_BINARY_DIR}/generated/precompiled.cpp)
    endif()
    target_link_libraries(${carrier} PRIVATE Eigen3::Eigen nlohmann_json::nlohmann_json bole_build)
    target_precompile_headers(${carrier} PRIVATE ${bole_precompiled})
    if(kind STREQUAL "test")
      target_link_libraries(${carrier} PRIVATE GTest::gmock_main)
      target_precompile_headers(${carrier} PRIVATE <gtest/gtest.h> <gmock/gmock.h>)
    endif()
  endif()
  target_precompile_headers(${target} REUSE_FROM ${carrier})
endfunction()
