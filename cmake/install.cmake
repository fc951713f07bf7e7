# What `cmake --install` lays down: the programs, the libraries with their public headers (each
# layer lists them in its file set), the CMake package for find_package(stream_recon), the
# licence and the documents.
include(CMakePackageConfigHelpers)
set(package_directory ${CMAKE_INSTALL_LIBDIR}/cmake/stream_recon)

foreach(layer spatial io engine)
  set_target_properties(stream_recon_${layer} PROPERTIES EXPORT_NAME ${layer})
  install(TARGETS stream_recon_${layer} EXPORT stream_recon_targets
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
    FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/stream_recon)
endforeach()

if(STREAM_RECON_TOOLS)
  get_property(programs DIRECTORY tools PROPERTY BUILDSYSTEM_TARGETS)
  foreach(program IN LISTS programs)
    get_target_property(type ${program} TYPE)
    if(type STREQUAL "EXECUTABLE")
      install(TARGETS ${program} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
    endif()
  endforeach()
endif()

install(EXPORT stream_recon_targets NAMESPACE stream_recon:: DESTINATION ${package_directory})
configure_package_config_file(cmake/stream_recon-config.cmake.in stream_recon-config.cmake
  INSTALL_DESTINATION ${package_directory})
write_basic_package_version_file(stream_recon-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES
  ${PROJECT_BINARY_DIR}/stream_recon-config.cmake
  ${PROJECT_BINARY_DIR}/stream_recon-config-version.cmake
  DESTINATION ${package_directory})

install(FILES LICENSE NOTICE README.md CHANGELOG.md
  DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/stream_recon)
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/stream_recon)
