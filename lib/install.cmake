# The library as others use it: `find_package(transformesh)` and `transformesh::transformesh`, or `pkg-config transformesh`.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

# The contracts; what they include is installed with them.
set(public_headers
  clean/certify/certify.h clean/clean.h clean/clean_box.h clean/intersect/intersect.h clean/stitch/stitch.h
  evolution/evolve.h evolution/filter_step.h evolution/morphing.h evolution/offset.h
  evolution/reconstruction.h evolution/sequence.h evolution/tracking.h
  fill/fill.h fill/handles.h
  geometry/carry.h geometry/compare.h geometry/sample_surface.h geometry/selection.h
  geometry/source_points.h
  io/comments.h io/concatenate.h io/length_basis.h io/mesh_io.h
  mesh/components.h mesh/manifold.h mesh/measure.h mesh/mesh.h mesh/transform.h
  picture/line_drawing.h picture/ambient_occlusion.h picture/picture.h picture/png.h
  remesh/align_features.h remesh/decimate.h remesh/remesh.h
  shapes/shapes.h
  step/displace.h step/morph_step.h step/target.h step/target_file.h step/velocity.h
  support/parallel.h
  views/cameras/camera_file.h views/cameras/view_files.h views/color/color_vertices.h
  views/color/texture_surface.h views/hull/hull.h
  views/photo/photo_step.h views/photo/photograph.h views/wrap/wrap.h)
set(installed_headers)
while(public_headers)
  list(POP_FRONT public_headers header)
  if(header IN_LIST installed_headers)
    continue()
  endif()
  list(APPEND installed_headers ${header})
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${header})
  file(STRINGS ${header} includes REGEX "^#include \"[a-z]")
  list(TRANSFORM includes REPLACE "^#include \"(.*)\"$" "\\1")
  list(APPEND public_headers ${includes})
endwhile()
target_sources(transformesh PUBLIC FILE_SET HEADERS BASE_DIRS ${CMAKE_CURRENT_SOURCE_DIR}
               FILES ${installed_headers})

add_dependencies(installed transformesh)
install(TARGETS transformesh EXPORT transformeshTargets COMPONENT development
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development
        FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/transformesh COMPONENT development)
set(package ${CMAKE_INSTALL_LIBDIR}/cmake/transformesh)
install(EXPORT transformeshTargets NAMESPACE transformesh:: DESTINATION ${package} COMPONENT development)
configure_package_config_file(transformeshConfig.cmake.in transformeshConfig.cmake INSTALL_DESTINATION ${package})
write_basic_package_version_file(transformeshConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/transformeshConfig.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/transformeshConfigVersion.cmake
        DESTINATION ${package} COMPONENT development)
file(RELATIVE_PATH from_pkgconfig_to_prefix /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
configure_file(transformesh.pc.in transformesh.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/transformesh.pc
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)
