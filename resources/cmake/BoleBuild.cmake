# How every target of Bole is built: standard, warnings, sanitizers, folders, and the functions that declare modules.
include(GNUInstallDirs)

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/bin")
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/lib")
set(CMAKE_ARCHIVE_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/lib")
# An installation has the layout of the Debian packages under every prefix, and its parts find one another wherever it is moved.
# The libraries are private to Bole, so they have a folder of their own.
set(BOLE_INSTALL_LIBRARY_DIR "lib/${CMAKE_LIBRARY_ARCHITECTURE}/bole")
set(BOLE_INSTALL_PYTHON_DIR lib/python3/dist-packages)
file(RELATIVE_PATH BOLE_LIBRARIES_FROM_BIN "/prefix/${CMAKE_INSTALL_BINDIR}" "/prefix/${BOLE_INSTALL_LIBRARY_DIR}")
file(RELATIVE_PATH BOLE_LIBRARIES_FROM_PYTHON "/prefix/${BOLE_INSTALL_PYTHON_DIR}/bole" "/prefix/${BOLE_INSTALL_LIBRARY_DIR}")
file(RELATIVE_PATH BOLE_ENGINE_FROM_PYTHON "/prefix/${BOLE_INSTALL_PYTHON_DIR}/bole" "/prefix/${CMAKE_INSTALL_DATADIR}/bole/python")
file(RELATIVE_PATH BOLE_PROGRAM_FROM_PYTHON "/prefix/${BOLE_INSTALL_PYTHON_DIR}/bole" "/prefix/${CMAKE_INSTALL_BINDIR}/bole")
file(RELATIVE_PATH BOLE_RESOURCES_FROM_LIBRARIES "/prefix/${BOLE_INSTALL_LIBRARY_DIR}" "/prefix/${CMAKE_INSTALL_DATADIR}/bole/resources")
set(CMAKE_INSTALL_RPATH "$ORIGIN")
if(BOLE_ARCH MATCHES "^x86-64-v")
  # In a package, libraries of this level lie in glibc-hwcaps/<level>/, two folders below those for all processors.
  list(APPEND CMAKE_INSTALL_RPATH "$ORIGIN/../..")
endif()
# What an installation rule belongs to when it does not say so: the package bole.
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME program)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()

include(BoleUnity)

find_program(BOLE_LLD ld.lld)
if(BOLE_LLD)
  add_link_options(-fuse-ld=lld)
endif()

find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(TBB REQUIRED)
find_package(fmt REQUIRED)
find_package(spdlog REQUIRED)
find_package(nlohmann_json REQUIRED)

# What our own sources are compiled with; foreign and generated code (VTK wrappers) is not held to it.
add_library(bole_build INTERFACE)
set(shadowing -Wshadow)
if(BOLE_UNITY)
  # A local name may be that of a constant in a neighbour's anonymous namespace, and a type of such a namespace a member of a class
  # that its .cpp file alone defines. Clang cannot tell the first from one local name that hides another; GCC reads the same sources.
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    set(shadowing -Wshadow=local -Wno-subobject-linkage)
  else()
    set(shadowing "")
  endif()
endif()
target_compile_options(bole_build INTERFACE -Wall -Wextra -Wpedantic ${shadowing} -Wnon-virtual-dtor $<$<BOOL:${BOLE_WARNINGS_AS_ERRORS}>:-Werror>)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  # GCC 12 sees overlapping copies in plain std::string additions (GCC bug 105651), and dangling or overflowing accesses in vectors that it inlined.
  target_compile_options(bole_build INTERFACE -Wno-restrict -Wno-array-bounds -Wno-stringop-overflow -Wno-stringop-overread)
endif()
if(BOLE_ARCH AND CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  target_compile_options(bole_build INTERFACE -march=${BOLE_ARCH})
endif()
# Wider vectors must not change Eigen's alignment, or objects shared with PCL and Ceres, which are built for the baseline, would be laid out differently.
set(BOLE_EIGEN_LAYOUT EIGEN_MAX_ALIGN_BYTES=16)
if(NOT BOLE_ARCH)
  # With wider vectors Eigen takes memory by an allocator of its own whatever that says, for the baseline it takes malloc. In the packages libraries of both kinds
  # give matrices to one another, and what one takes the other frees.
  list(APPEND BOLE_EIGEN_LAYOUT EIGEN_MALLOC_ALREADY_ALIGNED=0)
endif()
target_compile_definitions(bole_build INTERFACE ${BOLE_EIGEN_LAYOUT})
# Each library keeps its own copies of the functions that take memory.
target_link_options(bole_build INTERFACE "$<$<STREQUAL:$<TARGET_PROPERTY:TYPE>,SHARED_LIBRARY>:LINKER:--version-script=${CMAKE_CURRENT_LIST_DIR}/own_eigen_memory.map>")
target_link_libraries(bole_build INTERFACE fmt::fmt) # all agree on how it is linked, since it is in the precompiled headers
if(BOLE_SANITIZE)
  # Without the second a finding of the undefined-behaviour sanitizer is printed and the test passes.
  add_compile_options(-fsanitize=${BOLE_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${BOLE_SANITIZE})
endif()

if(BOLE_FUZZ)
  # The modules report which branches an input takes; without that a fuzzer is blind.
  add_compile_options(-fsanitize=fuzzer-no-link)
endif()

include(BolePrecompiled)

# bole_module(NAME [DEPENDS module...] [PUBLIC target...] [PRIVATE target...] [SOURCES file...] [OPTIONS option...] [STAGES])
#   A shared library bole_NAME from modules/NAME/*.cpp and modules/NAME/core/**/*.cpp (stages.cpp and *_stages.cpp apart). Headers are included
#   as "NAME/..." or "NAME/core/...". PUBLIC are libraries seen in headers, PRIVATE those of .cpp files only.
#   SOURCES are files beside those. OPTIONS are compile options of this module alone.
#   STAGES: modules/NAME/stages.cpp defines `void bole::NAME::register_stages(pipeline::StageRegistry&)`; it goes into bole_stages,
#   and modules/NAME/*_stages.cpp with it.
function(bole_module name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "STAGES" "" "DEPENDS;PUBLIC;PRIVATE;SOURCES;OPTIONS")
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  file(GLOB_RECURSE core_sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/core/*.cpp)
  list(APPEND sources ${core_sources})
  list(FILTER sources EXCLUDE REGEX "[/_]stages\\.cpp$")
  list(APPEND sources ${arg_SOURCES})
  add_library(bole_${name} SHARED ${sources})
  add_library(bole::${name} ALIAS bole_${name})
  target_include_directories(bole_${name} PUBLIC $<BUILD_INTERFACE:${CMAKE_SOURCE_DIR}/modules>)
  list(TRANSFORM arg_DEPENDS PREPEND bole::)
  target_link_libraries(bole_${name} PUBLIC Eigen3::Eigen ${arg_DEPENDS} ${arg_PUBLIC} PRIVATE ${arg_PRIVATE} $<BUILD_INTERFACE:bole_build>)
  # Headers of ours use Eigen: whoever includes them must agree on its alignment.
  target_compile_definitions(bole_${name} PUBLIC ${BOLE_EIGEN_LAYOUT})
  if(arg_OPTIONS)
    target_compile_options(bole_${name} PRIVATE ${arg_OPTIONS})
    bole_precompile(bole_${name} OWN)
  else()
    bole_precompile(bole_${name})
  endif()
  bole_unity(bole_${name})
  install(TARGETS bole_${name} LIBRARY DESTINATION ${BOLE_INSTALL_LIBRARY_DIR})
  if(arg_STAGES)
    set_property(GLOBAL APPEND PROPERTY BOLE_STAGE_MODULES ${name})
  endif()
endfunction()

# The library bole_stages: stages.cpp of every module that has one, and register_all_stages().
function(bole_stages_library)
  get_property(names GLOBAL PROPERTY BOLE_STAGE_MODULES)
  set(declarations "")
  set(calls "")
  set(sources "")
  set(modules "")
  foreach(name IN LISTS names)
    string(APPEND declarations "namespace bole::${name} {\nvoid register_stages(pipeline::StageRegistry&);\n}\n")
    string(APPEND calls "  if (registry.first_time(\"${name}\")) ${name}::register_stages(registry);\n")
    file(GLOB stage_sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/modules/${name}/*stages.cpp)
    list(APPEND sources ${stage_sources})
    list(APPEND modules bole::${name})
  endforeach()
  configure_file(${CMAKE_SOURCE_DIR}/resources/cmake/register_all_stages.cpp.in ${CMAKE_BINARY_DIR}/generated/register_all_stages.cpp @ONLY)
  add_library(bole_stages SHARED ${sources} ${CMAKE_BINARY_DIR}/generated/register_all_stages.cpp)
  add_library(bole::stages ALIAS bole_stages)
  target_link_libraries(bole_stages PUBLIC bole::pipeline PRIVATE ${modules} $<BUILD_INTERFACE:bole_build>)
  bole_precompile(bole_stages)
  bole_unity(bole_stages DEPTH 0)
  install(TARGETS bole_stages LIBRARY DESTINATION ${BOLE_INSTALL_LIBRARY_DIR})
endfunction()

# bole_tests(NAME [LINK target...]) : one GoogleTest program from the *_test.cpp (and *Test.cxx) of this folder; each case is a ctest.
function(bole_tests name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "LINK")
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*_test.cpp ${CMAKE_CURRENT_SOURCE_DIR}/*Test.cxx)
  if(NOT sources)
    return()
  endif()
  add_executable(${name}_tests ${sources})
  target_include_directories(${name}_tests PRIVATE ${CMAKE_SOURCE_DIR}/tests)
  target_link_libraries(${name}_tests PRIVATE ${arg_LINK} GTest::gmock_main bole_build)
  target_compile_definitions(${name}_tests PRIVATE BOLE_SOURCE_DIR="${CMAKE_SOURCE_DIR}" BOLE_SHARED_DATA_DIR="${CMAKE_SOURCE_DIR}/../shared/data")
  bole_precompile(${name}_tests TEST)
  bole_unity(${name}_tests)
  # Two builds that are tested at once must not write into the same files.
  set(files ${CMAKE_BINARY_DIR}/tests/tmp)
  file(MAKE_DIRECTORY ${files})
  set(limit_s 300)
  if(BOLE_SANITIZE) # some five times slower
    set(limit_s 1500)
  endif()
  gtest_discover_tests(${name}_tests TEST_PREFIX ${name}. DISCOVERY_MODE PRE_TEST PROPERTIES TIMEOUT ${limit_s} ENVIRONMENT "TMPDIR=${files};TEST_TMPDIR=${files}")
endfunction()

# bole_benchmark(NAME [LINK target...]) : a Google Benchmark program from NAME.cpp, run by `./do bench`.
function(bole_benchmark name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "LINK")
  add_executable(${name} ${name}.cpp)
  target_include_directories(${name} PRIVATE ${CMAKE_SOURCE_DIR}/tests)
  target_link_libraries(${name} PRIVATE ${arg_LINK} benchmark::benchmark_main bole_build)
  target_compile_definitions(${name} PRIVATE BOLE_SOURCE_DIR="${CMAKE_SOURCE_DIR}" BOLE_SHARED_DATA_DIR="${CMAKE_SOURCE_DIR}/../shared/data")
  set_property(GLOBAL APPEND PROPERTY BOLE_BENCHMARKS ${name})
endfunction()

# bole_note_version(NAME VERSION): listed by `bole version` and in reports.
function(bole_note_version name version)
  set_property(GLOBAL APPEND PROPERTY BOLE_LIBRARY_VERSIONS "${name} ${version}")
endfunction()

# Called once all modules are known.
function(bole_write_versions)
  get_property(versions GLOBAL PROPERTY BOLE_LIBRARY_VERSIONS)
  list(REMOVE_DUPLICATES versions)
  list(JOIN versions "\\;" joined)
  set_source_files_properties(${CMAKE_SOURCE_DIR}/modules/base/version.cpp TARGET_DIRECTORY bole_base PROPERTIES COMPILE_DEFINITIONS "BOLE_VERSION=\"${PROJECT_VERSION}\";BOLE_LIBRARY_VERSIONS=\"${joined}\"")
endfunction()

bole_note_version(Eigen ${Eigen3_VERSION})
bole_note_version(TBB ${TBB_VERSION})
bole_note_version(fmt ${fmt_VERSION})
