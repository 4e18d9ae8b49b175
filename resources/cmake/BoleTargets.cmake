# The targets behind the verbs of ./do that are neither build nor test.
find_program(BOLE_CLANG_FORMAT NAMES clang-format clang-format-14)
find_program(BOLE_RUN_CLANG_TIDY NAMES run-clang-tidy run-clang-tidy-14)

set(patterns "")
foreach(folder IN ITEMS app modules tests)
  foreach(suffix IN ITEMS h cpp cxx)
    list(APPEND patterns ${CMAKE_SOURCE_DIR}/${folder}/*.${suffix})
  endforeach()
endforeach()
file(GLOB_RECURSE bole_sources CONFIGURE_DEPENDS ${patterns})
if(BOLE_CLANG_FORMAT)
  add_custom_target(format COMMAND ${BOLE_CLANG_FORMAT} -i ${bole_sources} VERBATIM COMMENT "Formatting")
endif()

# lint: format is checked, then clang-tidy on our own sources (generated wrapper code left out). The compile commands are GCC's: clang-tidy
# does not know all of its warnings.
if(BOLE_CLANG_FORMAT AND BOLE_RUN_CLANG_TIDY)
  add_custom_target(
    lint
    COMMAND ${BOLE_CLANG_FORMAT} --dry-run -Werror ${bole_sources}
    COMMAND ${BOLE_RUN_CLANG_TIDY} -quiet -p ${CMAKE_BINARY_DIR} -extra-arg=-Wno-unknown-warning-option "${CMAKE_SOURCE_DIR}/(app|modules)/.*\\.(cpp|cxx)$"
    VERBATIM USES_TERMINAL)
endif()

if(TARGET bole AND BOLE_VTK)
  add_custom_target(docs COMMAND bole stages --markdown --out ${CMAKE_SOURCE_DIR}/docs/stages VERBATIM COMMENT "Printing docs/stages")

  # demo: a small plot from packets to report, results in out/demo.
  set(demo ${CMAKE_SOURCE_DIR}/out/demo)
  add_custom_target(
    demo
    COMMAND bole simulate --plot demo --seed 1 --out ${demo}/scan
    COMMAND bole run ${CMAKE_SOURCE_DIR}/pipelines/forest_plot.json --out ${demo} --set scan.file=${demo}/scan/walk.pcap --set reference_trees.file=${demo}/scan/trees.csv
            --set reference_path.file=${demo}/scan/trajectory.tum --set plot.width=16 --set plot.length=16
    VERBATIM USES_TERMINAL)
endif()

# bench: every benchmark program after the other.
get_property(benchmarks GLOBAL PROPERTY BOLE_BENCHMARKS)
set(commands "")
foreach(name IN LISTS benchmarks)
  list(APPEND commands COMMAND ${name} --benchmark_min_time=0.2)
endforeach()
if(benchmarks)
  add_custom_target(bench ${commands} DEPENDS ${benchmarks} VERBATIM USES_TERMINAL)
endif()
