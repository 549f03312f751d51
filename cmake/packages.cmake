# Debian packages by `cpack` in the build directory of the preset deb: libclers, libclers-dev, clers-tools.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME clers)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "compression of meshes, without loss unless less is asked for")
set(CPACK_PACKAGE_CONTACT "the clers authors")  # who publishes them sets CPACK_DEBIAN_PACKAGE_MAINTAINER
set(CPACK_PACKAGING_INSTALL_PREFIX ${CMAKE_INSTALL_PREFIX})
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL runtime dev tools)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(clers_deb_version "${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}")
set(clers_deb_runtime libclers${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME ${clers_deb_runtime})
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SECTION libs)
set(CPACK_COMPONENT_RUNTIME_DESCRIPTION "The libraries that programs load. Polygons and meshes that are not manifold
come back as they were.")
set(CPACK_DEBIAN_DEV_PACKAGE_NAME libclers-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS
  "${clers_deb_runtime} (= ${clers_deb_version}), libzstd-dev, libxxhash-dev, pkg-config")
set(CPACK_DEBIAN_DEV_PACKAGE_SUGGESTS "libdraco-dev, libmeshoptimizer-dev")
set(CPACK_COMPONENT_DEV_DESCRIPTION "Headers, and files for CMake and pkg-config, to compile programs that
compress meshes; and what is in the bytes.")
set(CPACK_DEBIAN_TOOLS_PACKAGE_NAME clers-tools)
set(CPACK_DEBIAN_TOOLS_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_TOOLS_PACKAGE_DEPENDS "${clers_deb_runtime} (= ${clers_deb_version})")
set(CPACK_COMPONENT_TOOLS_DESCRIPTION "Compresses mesh files (PLY, OBJ, OFF, STL) and scenes (glTF), restores,
compares and measures them. With a manual and completion for bash and zsh.")

# Programs and libraries say what else they need; ours need each other.
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_TOOLS_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
foreach(library IN LISTS clers_libraries)
  get_target_property(folder ${library} BINARY_DIR)
  list(APPEND CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${folder})
endforeach()

# What Debian wants to be there.
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_SOURCE_DIR}/packaging/deb/documents.cmake)
set(CPACK_CLERS_SOURCE ${CMAKE_CURRENT_SOURCE_DIR})
include(CPack)
