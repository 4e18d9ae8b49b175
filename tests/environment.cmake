# Read by ctest before it runs the tests of the build folder: what every test, and every program it starts, finds in its environment.
set(ENV{FONTCONFIG_FILE} ${CMAKE_CURRENT_LIST_DIR}/fonts.conf)
