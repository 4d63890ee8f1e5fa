# Settings of the Debian packages that scripts/package makes: the programs, the library with its
# headers, and the Python module. The programs use the system's image libraries as shared libraries,
# as Debian requires, so that security fixes apply to them.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME transformesh)
set(CPACK_PACKAGE_VENDOR "The TransforMesh authors")
set(CPACK_PACKAGE_CONTACT "The TransforMesh authors <transformesh@users.noreply.github.com>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "mesh evolution as Unix filters")
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL programs development python)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(CPACK_DEBIAN_PROGRAMS_PACKAGE_NAME transformesh)
set(CPACK_DEBIAN_PROGRAMS_DESCRIPTION
    "Small programs that read and write PLY and OFF on pipes: they remove the
self-intersections of a triangle mesh exactly, keep it well sampled, move it,
morph it into another one, and reconstruct surfaces from photographs.")
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_SUGGESTS "man-db, jq, gnuplot-nox")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libtransformesh-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libeigen3-dev, libgmp-dev, libmpfr-dev, \
libjpeg-dev, libminizip-dev, libpng-dev, libpugixml-dev, libtiff-dev, zlib1g-dev")
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION
    "The library and its headers: exact removal of self-intersections of triangle
meshes, remeshing, morphing, evolution with any velocity, and reconstruction
from photographs, for C++20.")

find_package(Python3 REQUIRED COMPONENTS Interpreter)
math(EXPR next_minor "${Python3_VERSION_MINOR} + 1")
set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-transformesh)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA ${PROJECT_SOURCE_DIR}/python/debian/postinst
    ${PROJECT_SOURCE_DIR}/python/debian/prerm)
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3 (>= ${Python3_VERSION_MAJOR}.\
${Python3_VERSION_MINOR}), python3 (<< ${Python3_VERSION_MAJOR}.${next_minor}), python3-numpy")
set(CPACK_DEBIAN_PYTHON_DESCRIPTION
    "The module for Python, on NumPy arrays: exact removal of self-intersections of
triangle meshes, remeshing, morphing, evolution with any velocity, and
reconstruction from photographs.")

# Documents that Debian requires in each package.
include(GNUInstallDirs)
find_program(TM_GZIP gzip)
# License of three.js, which is part of the viewer.
set(three_copyright "")
if(TARGET viewer)
  file(READ ${PROJECT_SOURCE_DIR}/tools/viewer/node_modules/three/LICENSE licence)
  string(REGEX REPLACE "^.*\n(Permission is)" "\\1" licence "${licence}")
  string(STRIP "${licence}" licence)
  string(REPLACE "\n\n" "\n.\n" licence "${licence}")
  string(REPLACE "\n" "\n " licence "${licence}")
  set(three_copyright "
Files: usr/share/transformesh/viewer.html
Copyright: 2026 The TransforMesh authors
 2010-2026 three.js authors
License: GPL-3 and Expat

License: Expat
 ${licence}
")
endif()
function(install_package_documents package component)
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/package/${package})
  file(MAKE_DIRECTORY ${folder})
  configure_file(${PROJECT_SOURCE_DIR}/cmake/copyright.in ${folder}/copyright @ONLY)
  string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
  file(WRITE ${folder}/changelog "${package} (${PROJECT_VERSION}) unstable; urgency=medium

  * See CHANGELOG.md of the project.

 -- ${CPACK_PACKAGE_CONTACT}  ${date}
")
  execute_process(COMMAND ${TM_GZIP} -9nf ${folder}/changelog)
  install(FILES ${folder}/copyright ${folder}/changelog.gz COMPONENT ${component}
          DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package})
endfunction()
install_package_documents(transformesh programs)
install_package_documents(libtransformesh-dev development)
install_package_documents(python3-transformesh python)
install(FILES ${PROJECT_SOURCE_DIR}/docs/python.md COMPONENT python
        DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/python3-transformesh)
install(FILES ${PROJECT_SOURCE_DIR}/README.md COMPONENT programs
        DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/transformesh)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/tests/install/project COMPONENT development
        DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/libtransformesh-dev/examples)
include(CPack)
