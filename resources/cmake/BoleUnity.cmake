# Unity builds: the files of a folder are compiled as one. Most of the time of a file goes into the headers of VTK, Qt and Eigen, which are
# then read once a folder. Names in anonymous namespaces must differ within a folder, as they should for its readers.
option(BOLE_UNITY "Compile the files of a folder together, where a target allows it" ON)

# bole_unity(TARGET [BATCH n]): one unit per first folder below the target's; with BATCH units of n files instead, for targets
# whose files lie in one folder.
function(bole_unity target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "BATCH" "")
  if(NOT BOLE_UNITY)
    return()
  endif()
  if(arg_BATCH)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${arg_BATCH})
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  get_target_property(sources ${target} SOURCES)
  foreach(source IN LISTS sources)
    cmake_path(RELATIVE_PATH source BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} OUTPUT_VARIABLE relative)
    if(relative MATCHES "^([^./][^/]*)/.*\\.cpp$")
      set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${CMAKE_MATCH_1})
    endif()
  endforeach()
endfunction()
