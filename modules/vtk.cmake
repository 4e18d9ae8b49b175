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

  # The package is app/python/bole and what the build knows: _build.py, once for the build and once for an installation.
  list(TRANSFORM bole_vtk_modules REPLACE "^Bole::(.*)$" "\"\\1\"" OUTPUT_VARIABLE bole_python_modules)
  string(REPLACE ";" ", " bole_python_modules "${bole_python_modules}")
  execute_process(
    COMMAND ${Python3_EXECUTABLE} -c "import vtkmodules, pathlib; print(pathlib.Path(vtkmodules.__file__).resolve().parents[1])"
    OUTPUT_VARIABLE bole_vtk_folder OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  set(package_source ${CMAKE_SOURCE_DIR}/app/python/bole)
  set(package ${BOLE_PYTHON_DIR}/bole)
  set(installed_build ${CMAKE_BINARY_DIR}/generated/installed/_build.py)
  set(bole_libraries ${BOLE_LIBRARIES_FROM_PYTHON})
  set(bole_engine ${BOLE_ENGINE_FROM_PYTHON})
  set(bole_program ${BOLE_PROGRAM_FROM_PYTHON})
  configure_file(${package_source}/_build.py.in ${installed_build} @ONLY)
  file(GLOB package_files CONFIGURE_DEPENDS ${package_source}/*.py)
  install(FILES ${package_files} ${installed_build} DESTINATION ${BOLE_INSTALL_PYTHON_DIR}/bole COMPONENT python)
  file(RELATIVE_PATH bole_libraries ${package} ${CMAKE_LIBRARY_OUTPUT_DIRECTORY})
  file(RELATIVE_PATH bole_program ${package} ${CMAKE_RUNTIME_OUTPUT_DIRECTORY}/bole)
  set(bole_engine ${CMAKE_SOURCE_DIR}/app/python)
  configure_file(${package_source}/_build.py.in ${package}/_build.py @ONLY)
  foreach(file IN LISTS package_files) # links: what is edited there is what runs
    get_filename_component(name ${file} NAME)
    file(CREATE_LINK ${file} ${package}/${name} SYMBOLIC)
  endforeach()
  # PYTHONPATH=build/headless/lib/python is short to type.
  if(IS_DIRECTORY ${CMAKE_BINARY_DIR}/lib/python AND NOT IS_SYMLINK ${CMAKE_BINARY_DIR}/lib/python)
    file(REMOVE_RECURSE ${CMAKE_BINARY_DIR}/lib/python) # of a build before this layout: its modules would be taken for current ones
  endif()
  file(CREATE_LINK python3/dist-packages ${CMAKE_BINARY_DIR}/lib/python SYMBOLIC)
endif()
