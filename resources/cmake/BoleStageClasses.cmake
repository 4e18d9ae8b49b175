# The VTK class of every stage is written by the build: modules/NAME/vtk holds vtk.module and one call of
# bole_stage_classes(); the classes follow from the registrations in modules/NAME/*.cpp, which give each stage its name and,
# right after it, the name of its class.

# bole_registered_stages(OUT NAME): the list "stems.measure" "vtkBoleMeasureStems" "stems.edit" ... of a module.
function(bole_registered_stages out name)
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/modules/${name}/*.cpp ${CMAKE_SOURCE_DIR}/modules/${name}/*/*.cpp)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${sources})
  set(stages "")
  foreach(source IN LISTS sources)
    file(READ ${source} text)
    string(REGEX REPLACE "[][;]" " " text "${text}") # they would divide or join the items of a CMake list
    string(REGEX MATCHALL "\"${name}\\.[a-z_]+\"[^\"]*\"vtkBole[A-Za-z0-9]+\"" pairs "${text}")
    foreach(pair IN LISTS pairs)
      string(REGEX MATCH "\"(${name}\\.[a-z_]+)\"[^\"]*\"(vtkBole[A-Za-z0-9]+)\"" found "${pair}")
      list(APPEND stages ${CMAKE_MATCH_1} ${CMAKE_MATCH_2})
    endforeach()
  endforeach()
  if(NOT stages)
    message(FATAL_ERROR "modules/${name} has a folder vtk and registers no stage with a VTK class")
  endif()
  set(${out} ${stages} PARENT_SCOPE)
endfunction()

# bole_stage_classes(NAME VTK_MODULE [REGISTERS HEADER]): the VTK module Bole::VTK_MODULE with a class for every stage of
# modules/NAME. REGISTERS: these stages are not among register_all_stages(); HEADER declares
# bole::NAME::register_stages(), which the first object of a class calls.
function(bole_stage_classes name vtk_module)
  cmake_parse_arguments(PARSE_ARGV 2 arg "" "REGISTERS" "")
  bole_registered_stages(stages ${name})
  string(TOUPPER ${vtk_module} BOLE_VTK_MODULE_UPPER)
  set(BOLE_VTK_MODULE ${vtk_module})
  set(BOLE_REGISTER_INCLUDES "")
  set(BOLE_REGISTER_CALL "")
  if(arg_REGISTERS)
    set(BOLE_REGISTER_INCLUDES "#include \"pipeline/stage.h\"\n#include \"${arg_REGISTERS}\"\n")
    set(BOLE_REGISTER_CALL "\n  bole::${name}::register_stages(bole::pipeline::StageRegistry::global());")
  endif()
  set(sources "")
  set(headers "")
  while(stages)
    list(POP_FRONT stages BOLE_STAGE BOLE_CLASS)
    foreach(suffix IN ITEMS h cxx)
      configure_file(${CMAKE_SOURCE_DIR}/resources/cmake/stage_class.${suffix}.in ${CMAKE_CURRENT_BINARY_DIR}/${BOLE_CLASS}.${suffix} @ONLY)
    endforeach()
    list(APPEND headers ${CMAKE_CURRENT_BINARY_DIR}/${BOLE_CLASS}.h)
    list(APPEND sources ${CMAKE_CURRENT_BINARY_DIR}/${BOLE_CLASS}.cxx)
  endwhile()
  vtk_module_add_module(Bole::${vtk_module} SOURCES ${sources} HEADERS ${headers})
  bole_vtk_sources(${vtk_module})
endfunction()
