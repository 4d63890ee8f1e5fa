# Installs the library for other projects. They use `find_package(transformesh)` and the target
# `transformesh::transformesh`, or `pkg-config transformesh`. The public headers are
# include/transformesh.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

file(GLOB interface CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/include/transformesh/*.h)
set(views_headers color hull image photo_step reconstruct reconstruction_options views wrap)
set(TM_DEPENDENCIES "find_dependency(ZLIB)\nfind_dependency(pugixml)\n")
set(TM_REQUIRED "pugixml minizip zlib ")
if(TM_VIEWS)
  string(APPEND TM_DEPENDENCIES "find_dependency(JPEG)\nfind_dependency(TIFF)\n")
  string(APPEND TM_REQUIRED "libjpeg libtiff-4 ")
else()
  foreach(header IN LISTS views_headers)
    list(REMOVE_ITEM interface ${PROJECT_SOURCE_DIR}/include/transformesh/${header}.h)
  endforeach()
endif()
if(TM_VIEWS OR TM_SHOW)
  string(APPEND TM_DEPENDENCIES "find_dependency(PNG)\n")
  string(APPEND TM_REQUIRED "libpng ")
endif()
target_sources(transformesh PUBLIC FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR}/include
               FILES ${interface})

add_dependencies(installed transformesh)
install(TARGETS transformesh EXPORT transformeshTargets COMPONENT development
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development
        FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)
set(package ${CMAKE_INSTALL_LIBDIR}/cmake/transformesh)
install(EXPORT transformeshTargets NAMESPACE transformesh:: DESTINATION ${package} COMPONENT development)
configure_package_config_file(transformeshConfig.cmake.in transformeshConfig.cmake INSTALL_DESTINATION ${package})
write_basic_package_version_file(transformeshConfigVersion.cmake COMPATIBILITY SameMajorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/transformeshConfig.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/transformeshConfigVersion.cmake
        DESTINATION ${package} COMPONENT development)
file(RELATIVE_PATH from_pkgconfig_to_prefix /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
configure_file(transformesh.pc.in transformesh.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/transformesh.pc
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)
