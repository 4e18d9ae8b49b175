# The target `package`: the Debian packages bole (program, libraries, resources, pipelines), bole-desktop and python3-bole.
# docs/dev/packaging.md tells how they are made and tested.
#
# A build for a higher level than the baseline (BOLE_ARCH, x86-64-v3 by default) gives packages for processors of that level, which refuse to be
# installed on others. With BOLE_BASELINE_PACKAGES it makes packages for every x86-64 processor: from a second build in build/package,
# compiled for the baseline, with its own libraries below added where the level pays; the dynamic loader takes those on
# processors that have it (glibc-hwcaps).
set(BOLE_HOT_MODULES cloud ground sim slam stems survey) # never base, which finds the resources by its own place
option(BOLE_BASELINE_PACKAGES "Packages for every x86-64 processor, by a second build; OFF: of this build as it is, for processors of its level alone" OFF)
set(BOLE_HWCAPS_BUILD "" CACHE PATH "Folder of a build for a higher level, whose libraries the packages take in beside those of this build")
set(BOLE_PACKAGE_DIR "${CMAKE_BINARY_DIR}" CACHE PATH "Where the packages are written")
set(BOLE_PACKAGE_MAINTAINER "Bole maintainers <maintainers@bole.invalid>" CACHE STRING "Who makes the packages: name and address")

# bole_installed_targets(OUT FOLDER): the libraries, modules and programs that the build makes by default there and below.
function(bole_installed_targets out folder)
  get_property(targets DIRECTORY ${folder} PROPERTY BUILDSYSTEM_TARGETS)
  set(found "")
  foreach(target IN LISTS targets)
    get_target_property(type ${target} TYPE)
    get_target_property(left_out ${target} EXCLUDE_FROM_ALL)
    if(type MATCHES "^(SHARED_LIBRARY|MODULE_LIBRARY|EXECUTABLE)$" AND NOT left_out)
      list(APPEND found ${target})
    endif()
  endforeach()
  get_property(below DIRECTORY ${folder} PROPERTY SUBDIRECTORIES)
  foreach(next IN LISTS below)
    bole_installed_targets(more ${next})
    list(APPEND found ${more})
  endforeach()
  set(${out} ${found} PARENT_SCOPE)
endfunction()

set(packaging ${CMAKE_SOURCE_DIR}/resources/packaging)
set(made ${CMAKE_BINARY_DIR}/packaging) # manual pages, completions, change logs
set(doc ${CMAKE_INSTALL_DATADIR}/doc)

# Written by the program itself, so that they are never out of date.
find_package(Python3 REQUIRED COMPONENTS Interpreter)
add_custom_command(
  OUTPUT ${made}/changelog.gz
  COMMAND ${Python3_EXECUTABLE} ${packaging}/make_files.py --bole $<TARGET_FILE:bole> --source ${CMAKE_SOURCE_DIR} --version ${PROJECT_VERSION} --maintainer
          ${BOLE_PACKAGE_MAINTAINER} --out ${made}
  DEPENDS bole ${packaging}/make_files.py ${packaging}/bole-desktop.1 ${CMAKE_SOURCE_DIR}/CHANGELOG.md
  COMMENT "Printing manual pages and completions" VERBATIM)
add_custom_target(packaging_files ALL DEPENDS ${made}/changelog.gz)

install(DIRECTORY ${made}/program/ DESTINATION ${CMAKE_INSTALL_DATADIR})
install(FILES ${packaging}/bole.lintian DESTINATION ${CMAKE_INSTALL_DATADIR}/lintian/overrides RENAME bole)
# The Processing provider for QGIS needs nothing of QGIS until that loads it, so it comes with the program.
set(qgis_plugin ${CMAKE_SOURCE_DIR}/app/qgis/bole_provider)
configure_file(${qgis_plugin}/metadata.txt ${made}/qgis/metadata.txt @ONLY)
install(DIRECTORY ${qgis_plugin} DESTINATION ${CMAKE_INSTALL_DATADIR}/qgis/python/plugins FILES_MATCHING PATTERN "*.py" PATTERN __pycache__ EXCLUDE)
install(FILES ${made}/qgis/metadata.txt ${CMAKE_SOURCE_DIR}/resources/icons/hicolor/scalable/apps/bole.svg DESTINATION ${CMAKE_INSTALL_DATADIR}/qgis/python/plugins/bole_provider)
set(packages program bole)
if(BOLE_PYTHON)
  list(APPEND packages python python3-bole)
endif()
if(BOLE_DESKTOP)
  list(APPEND packages desktop bole-desktop)
  install(DIRECTORY ${made}/desktop/ DESTINATION ${CMAKE_INSTALL_DATADIR} COMPONENT desktop)
  install(FILES ${packaging}/bole-desktop.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications COMPONENT desktop)
  install(FILES ${packaging}/bole-desktop.metainfo.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo COMPONENT desktop)
  install(FILES ${packaging}/bole.mime.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages RENAME bole.xml COMPONENT desktop)
  install(DIRECTORY ${CMAKE_SOURCE_DIR}/resources/icons/hicolor DESTINATION ${CMAKE_INSTALL_DATADIR}/icons COMPONENT desktop)
endif()
set(components "")
while(packages)
  list(POP_FRONT packages component package)
  list(APPEND components ${component})
  install(FILES ${packaging}/copyright DESTINATION ${doc}/${package} COMPONENT ${component})
  install(FILES ${made}/changelog.gz DESTINATION ${doc}/${package} COMPONENT ${component})
endwhile()

# The libraries that a package for all processors takes from this build: installed only when asked for by name.
set(hot_targets "")
foreach(name IN LISTS BOLE_HOT_MODULES)
  list(APPEND hot_targets bole_${name})
endforeach()
if(BOLE_ARCH)
  install(TARGETS ${hot_targets} LIBRARY DESTINATION ${BOLE_INSTALL_LIBRARY_DIR}/glibc-hwcaps/${BOLE_ARCH} COMPONENT hwcaps EXCLUDE_FROM_ALL)
endif()
if(BOLE_HWCAPS_BUILD)
  # CPack hands its folder on by the environment variable DESTDIR, which holds for this installation too.
  install(CODE "execute_process(COMMAND \"${CMAKE_COMMAND}\" --install \"${BOLE_HWCAPS_BUILD}\" --component hwcaps --strip --prefix \"\${CMAKE_INSTALL_PREFIX}\"
  COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET)")
endif()

set(for_this_level_alone OFF)
if(BOLE_ARCH AND CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  set(for_this_level_alone ON)
endif()
if(for_this_level_alone AND BOLE_BASELINE_PACKAGES)
  add_custom_target(
    package
    COMMAND ${CMAKE_COMMAND} --preset package -DBOLE_HWCAPS_BUILD=${CMAKE_BINARY_DIR} -DBOLE_PACKAGE_DIR=${BOLE_PACKAGE_DIR}
            "-DBOLE_PACKAGE_MAINTAINER=${BOLE_PACKAGE_MAINTAINER}"
    COMMAND ${CMAKE_COMMAND} --build --preset package --target package
    DEPENDS ${hot_targets}
    WORKING_DIRECTORY ${CMAKE_SOURCE_DIR}
    VERBATIM USES_TERMINAL)
  return()
endif()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME bole)
set(CPACK_PACKAGE_VENDOR Bole)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_NAME} built using CMake") # CPack's own, which it leaves out: each package has a summary below
set(CPACK_PACKAGE_DIRECTORY ${BOLE_PACKAGE_DIR})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_COMPONENTS_ALL ${components})
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "${BOLE_PACKAGE_MAINTAINER}")
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${CMAKE_LIBRARY_OUTPUT_DIRECTORY})
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)

set(level_note "")
if(for_this_level_alone)
  set(level_note "\n.\nThis build needs a processor of the level ${BOLE_ARCH}.")
  set(CPACK_DEBIAN_PROGRAM_PACKAGE_CONTROL_EXTRA ${CMAKE_BINARY_DIR}/packaging/preinst)
  configure_file(${packaging}/preinst.in ${CMAKE_BINARY_DIR}/packaging/preinst @ONLY FILE_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
endif()

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME bole)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "fonts-liberation2, python3")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "bole-desktop, python3-bole, python3-distributed, qgis")
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION
    "LiDAR scans of a forest plot to a survey that can be signed
Bole turns raw LiDAR scans or finished point clouds of a forest plot into a
stem map with the diameter at breast height and its 95 % interval for every
tree, a terrain model, plot values, figures and a report.
.
This package holds the command line program bole, which needs no screen.${level_note}")

set(CPACK_DEBIAN_DESKTOP_PACKAGE_NAME bole-desktop)
set(CPACK_DEBIAN_DESKTOP_PACKAGE_SECTION science)
set(CPACK_DEBIAN_DESKTOP_PACKAGE_DEPENDS "bole (= ${PROJECT_VERSION})")
set(CPACK_DEBIAN_DESKTOP_PACKAGE_RECOMMENDS fonts-droid-fallback)
set(CPACK_DEBIAN_DESKTOP_DESCRIPTION
    "window to inspect and correct LiDAR surveys of forest plots
Bole turns raw LiDAR scans or finished point clouds of a forest plot into a
stem map with the diameter at breast height and its 95 % interval for every
tree.
.
This package holds the window, in which every stem can be inspected and
corrected.")

set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-bole)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
math(EXPR next_python "${Python3_VERSION_MINOR} + 1")
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "bole (= ${PROJECT_VERSION}), python3 (>= 3.${Python3_VERSION_MINOR}), python3 (<< 3.${next_python}), python3-vtk9")
set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "python3-numpy")
set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-pandas, jupyter-notebook")
set(CPACK_DEBIAN_PYTHON_DESCRIPTION
    "LiDAR surveys of forest plots on VTK (Python 3)
Bole turns raw LiDAR scans or finished point clouds of a forest plot into a
stem map with the diameter at breast height and its 95 % interval for every
tree.
.
This package holds the Python module bole: pipelines, and every stage as a
VTK algorithm.")

# CPack's own target would depend on everything, tests included; this one depends on what is installed.
set(CPACK_OUTPUT_CONFIG_FILE ${CMAKE_BINARY_DIR}/BolePackages.cmake)
set(CPACK_SOURCE_OUTPUT_CONFIG_FILE ${CMAKE_BINARY_DIR}/BoleSourcePackage.cmake)
include(CPack)
bole_installed_targets(installed_modules ${CMAKE_SOURCE_DIR}/modules)
bole_installed_targets(installed_programs ${CMAKE_SOURCE_DIR}/app)
add_custom_target(
  package
  COMMAND ${CMAKE_CPACK_COMMAND} --config ${CPACK_OUTPUT_CONFIG_FILE}
  DEPENDS ${installed_modules} ${installed_programs} packaging_files
  WORKING_DIRECTORY ${CMAKE_BINARY_DIR}
  VERBATIM USES_TERMINAL)
