# The VTK modules: modules/vtkbridge and every modules/*/vtk, and the Python package bole made from them.
find_package(VTK 9.1 REQUIRED COMPONENTS CommonCore CommonDataModel CommonExecutionModel WrappingTools)
bole_note_version(VTK ${VTK_VERSION})

# Our own .cxx files of a VTK module are held to our warnings; the wrapper code that VTK generates is not.
function(bole_vtk_sources target)
  target_link_libraries(${target} PRIVATE $<BUILD_INTERFACE:bole_build>)
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
  LIBRARY_DESTINATION ${CMAKE_INSTALL_LIBDIR}
  HIERARCHY_DESTINATION ${CMAKE_INSTALL_LIBDIR}/bole/hierarchy)

add_library(bole::vtkbridge ALIAS vtkBoleBridge)

if(BOLE_PYTHON)
  find_package(Python3 REQUIRED COMPONENTS Interpreter Development.Module)
  find_package(VTK 9.1 REQUIRED COMPONENTS Python WrappingPythonCore)
  set(BOLE_PYTHON_DIR "${CMAKE_BINARY_DIR}/lib/python")
  vtk_module_wrap_python(
    MODULES ${bole_vtk_modules}
    TARGET Bole::Python
    PYTHON_PACKAGE bole
    MODULE_DESTINATION lib/python
    LIBRARY_DESTINATION ${CMAKE_INSTALL_LIBDIR}
    INSTALL_HEADERS OFF)

  # bole/__init__.py brings the classes of all modules together.
  set(bole_python_imports "")
  foreach(module IN LISTS bole_vtk_modules)
    string(REPLACE "Bole::" "" name ${module})
    string(APPEND bole_python_imports "from .${name} import *\n")
  endforeach()
  configure_file(${CMAKE_SOURCE_DIR}/resources/cmake/bole_init.py.in ${BOLE_PYTHON_DIR}/bole/__init__.py @ONLY)
  install(FILES ${BOLE_PYTHON_DIR}/bole/__init__.py DESTINATION lib/python/bole)
endif()
