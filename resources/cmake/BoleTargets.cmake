# The targets behind the verbs of ./do that are neither build nor test.
find_package(Python3 REQUIRED COMPONENTS Interpreter)

# lint: format and clang-tidy on the sources that git tracks; generated code (VTK wrappers) is none of them.
set(lint ${Python3_EXECUTABLE} ${CMAKE_SOURCE_DIR}/tests/rules/lint.py --build ${CMAKE_BINARY_DIR})
add_custom_target(format COMMAND ${lint} --format VERBATIM COMMENT "Formatting")
add_custom_target(lint COMMAND ${lint} VERBATIM USES_TERMINAL)

if(TARGET bole AND BOLE_VTK)
  add_custom_target(docs COMMAND bole stages --markdown --out ${CMAKE_SOURCE_DIR}/docs/stages VERBATIM COMMENT "Printing docs/stages")

  # demo: a small plot from packets to report, results in out/demo. The bark of the simulated trees is known: 1 mm of mean relief.
  set(demo ${CMAKE_SOURCE_DIR}/out/demo)
  add_custom_target(
    demo
    COMMAND bole simulate --plot demo --seed 1 --out ${demo}/scan
    COMMAND bole run ${CMAKE_SOURCE_DIR}/pipelines/forest_plot.json --out ${demo} --set scan.file=${demo}/scan/walk.pcap --set reference_trees.file=${demo}/scan/trees.csv
            --set reference_path.file=${demo}/scan/trajectory.tum --set plot.width=16 --set plot.length=16 --set stems.bark_relief=0.001
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
