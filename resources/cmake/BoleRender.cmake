# Drawing without a screen.

# bole_headless_executable(TARGET...) : the executables draw through OSMesa, without a display. bole_osmesa and OSMesa become
#   their first libraries, so that VTK's gl* calls bind to OSMesa and not to libOpenGL. Call it after target_link_libraries().
function(bole_headless_executable)
  foreach(target IN LISTS ARGN)
    get_target_property(libraries ${target} LINK_LIBRARIES)
    if(NOT libraries)
      set(libraries "")
    endif()
    set_target_properties(${target} PROPERTIES LINK_LIBRARIES "bole_osmesa;${BOLE_OSMESA_LIBRARY};${libraries}")
    target_link_options(${target} PRIVATE "LINKER:--no-as-needed") # some distributions drop libraries that nothing refers to by name
  endforeach()
endfunction()
