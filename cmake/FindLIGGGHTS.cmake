# Debian's libliggghts-dev ships neither a CMake package nor a pkg-config file.
find_path(LIGGGHTS_INCLUDE_DIR liggghts/library.h)
find_library(LIGGGHTS_LIBRARY liggghts)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(LIGGGHTS
  REQUIRED_VARS LIGGGHTS_LIBRARY LIGGGHTS_INCLUDE_DIR
  REASON_FAILURE_MESSAGE "Install Debian's package libliggghts-dev, or run ./bootstrap.")
if(LIGGGHTS_FOUND AND NOT TARGET LIGGGHTS::LIGGGHTS)
  add_library(LIGGGHTS::LIGGGHTS UNKNOWN IMPORTED)
  # An imported target's includes are system ones: LIGGGHTS' own headers do not compile without warnings.
  set_target_properties(LIGGGHTS::LIGGGHTS PROPERTIES
    IMPORTED_LOCATION ${LIGGGHTS_LIBRARY}
    INTERFACE_INCLUDE_DIRECTORIES "${LIGGGHTS_INCLUDE_DIR};${LIGGGHTS_INCLUDE_DIR}/liggghts")
endif()
