# The VTK modules: modules/vtkbridge and every modules/*/vtk, and the Python package bole made from them.
find_package(VTK 9.1 REQUIRED COMPONENTS CommonCore CommonDataModel CommonExecutionModel WrappingTools)
bole_note_version(VTK ${VTK_VERSION})

# Our own .cxx files of a VTK module are held to our warnings; the wrapper code that VTK generates is not.
function(bole_vtk_sources target)
  target_link_libraries(${target} PRIVATE $<BUILD_INTERFACE:bole_build>)
  bole_precompile(${target})
endfunction()

include(BoleStageClasses)

file(GLOB bole_vtk_module_files CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/vtkbridge/vtk.module ${CMAKE_CURRENT_SOURCE_DIR}/*/vtk/vtk.module)
vtk_module_scan(
  MODULE_FILES ${bole_vtk_module_files}
  PROVIDES_MODULES bole_vtk_modules
  ENABLE_TESTS OFF
  WANT_BY_DEFAULT ON
  HIDE_MODULES_FROM_CACHE ON)

set(BUILD_SHARED_LIBS ON)
vtk_module_build(
  MODULES ${bole_vtk_modules}
  PACKAGE BoleVTK
  INSTALL_HEADERS OFF
  TEST_DIRECTORY_NAME NONE
  TARGETS_COMPONENT program
  LIBRARY_DESTINATION ${BOLE_INSTALL_LIBRARY_DIR}
  HIERARCHY_DESTINATION ${CMAKE_INSTALL_LIBDIR}/bole/hierarchy)

add_library(bole::vtkbridge ALIAS vtkBoleBridge)

if(BOLE_PYTHON)
  find_package(Python3 REQUIRED COMPONENTS Interpreter Development.Module)
  find_package(VTK 9.1 REQUIRED COMPONENTS Python WrappingPythonCore)
  set(BOLE_PYTHON_DIR "${CMAKE_BINARY_DIR}/${BOLE_INSTALL_PYTHON_DIR}")
  vtk_module_wrap_python(
    MODULES ${bole_vtk_modules}
    TARGET Bole::Python
    PYTHON_PACKAGE bole
    MODULE_DESTINATION ${BOLE_INSTALL_PYTHON_DIR}
    LIBRARY_DESTINATION ${BOLE_INSTALL_LIBRARY_DIR}
    COMPONENT python
    INSTALL_HEADERS OFF)

  # bole/__init__.py brings the classes of all modules together.
  set(bole_python_imports "")
  foreach(module IN LISTS bole_vtk_modules)
    string(REPLACE "Bole::" "" name ${module})
    string(APPEND bole_python_imports "from .${name} import *\n")
  endforeach()
  set(installed_init ${CMAKE_BINARY_DIR}/generated/installed/__init__.py)
  set(bole_libraries ${BOLE_LIBRARIES_FROM_PYTHON})
  set(bole_engine ${BOLE_ENGINE_FROM_PYTHON})
  configure_file(${CMAKE_SOURCE_DIR}/resources/cmake/bole_init.py.in ${installed_init} @ONLY)
  install(FILES ${installed_init} DESTINATION ${BOLE_INSTALL_PYTHON_DIR}/bole COMPONENT python)
  file(RELATIVE_PATH bole_libraries ${BOLE_PYTHON_DIR}/bole ${CMAKE_LIBRARY_OUTPUT_DIRECTORY})
  set(bole_engine ${CMAKE_SOURCE_DIR}/app/python)
  configure_file(${CMAKE_SOURCE_DIR}/resources/cmake/bole_init.py.in ${BOLE_PYTHON_DIR}/bole/__init__.py @ONLY)
  # PYTHONPATH=build/headless/lib/python is short to type.
  if(IS_DIRECTORY ${CMAKE_BINARY_DIR}/lib/python AND NOT IS_SYMLINK ${CMAKE_BINARY_DIR}/lib/python)
    file(REMOVE_RECURSE ${CMAKE_BINARY_DIR}/lib/python) # of a build before this layout: its modules would be taken for current ones
  endif()
  file(CREATE_LINK python3/dist-packages ${CMAKE_BINARY_DIR}/lib/python SYMBOLIC)
endif()
