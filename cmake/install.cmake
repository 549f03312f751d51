# Installation: libraries, the program, its manual, and what find_package and pkg-config need to find them.
# Public headers are installed where they are listed (headers.cmake). Of three components, of which packages are
# made (packages.cmake): runtime, what programs load; dev, what compilers need; tools, the program.
set(clers_cmake_dir ${CMAKE_INSTALL_LIBDIR}/cmake/clers)
set(clers_pc_dir ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
function(clers_install_libraries export)
  install(TARGETS ${ARGN} EXPORT ${export}
    RUNTIME COMPONENT runtime
    LIBRARY COMPONENT runtime NAMELINK_COMPONENT dev
    ARCHIVE COMPONENT dev)
  install(EXPORT ${export} NAMESPACE clers:: DESTINATION ${clers_cmake_dir} COMPONENT dev)
endfunction()

set(clers_libraries clers_codec clers_topology clers_modeling)
foreach(library io gltf c)
  string(TOUPPER ${library} option)
  if(CLERS_${option})
    list(APPEND clers_libraries clers_${library})
  endif()
endforeach()
clers_install_libraries(clers-targets ${clers_libraries})
# Those that need a library of somebody else's are sets of their own: who does not ask for them needs none of it.
set(clers_foreign)
foreach(library draco meshopt)
  string(TOUPPER ${library} option)
  if(CLERS_${option})
    list(APPEND clers_foreign clers_${library})
    clers_install_libraries(clers-${library}-targets clers_${library})
  endif()
endforeach()
list(APPEND clers_libraries ${clers_foreign})
# Before 1.0 a minor version may break.
set_target_properties(${clers_libraries} PROPERTIES
  VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})

configure_package_config_file(cmake/clers-config.cmake.in clers-config.cmake
  INSTALL_DESTINATION ${clers_cmake_dir})
# Before 1.0 a minor version may break.
write_basic_package_version_file(clers-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES
  ${CMAKE_CURRENT_BINARY_DIR}/clers-config.cmake
  ${CMAKE_CURRENT_BINARY_DIR}/clers-config-version.cmake
  DESTINATION ${clers_cmake_dir} COMPONENT dev)

# Installed libraries look for each other beside themselves, and the program for them from where it is:
# a tree with shared libraries runs from any prefix.
if(NOT DEFINED CMAKE_INSTALL_RPATH)
  file(RELATIVE_PATH clers_to_libraries /prefix/${CMAKE_INSTALL_BINDIR} /prefix/${CMAKE_INSTALL_LIBDIR})
  set_target_properties(${clers_libraries} PROPERTIES INSTALL_RPATH "$ORIGIN")
  if(CLERS_CLI AND BUILD_SHARED_LIBS)
    set_target_properties(clers_cli PROPERTIES INSTALL_RPATH "$ORIGIN/${clers_to_libraries}")
  endif()
endif()

set(clers_pc_libs "-lclers_codec -lclers_modeling -lclers_topology")
if(CLERS_IO)
  string(PREPEND clers_pc_libs "-lclers_io ")
endif()
if(CLERS_GLTF)
  string(PREPEND clers_pc_libs "-lclers_gltf ")
endif()
if(BUILD_SHARED_LIBS)
  set(clers_pc_requires "Requires.private")
else()
  set(clers_pc_requires "Requires")
endif()
# The prefix is found from where the file is: an installed tree can be moved, and `cmake --install
# --prefix` may name another one than was configured.
file(RELATIVE_PATH clers_pc_up /prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig /prefix)
string(REGEX REPLACE "/$" "" clers_pc_up ${clers_pc_up})
configure_file(cmake/clers.pc.in clers.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/clers.pc DESTINATION ${clers_pc_dir} COMPONENT dev)
# Static libraries need what they are made with.
set(clers_draco_requires draco)
set(clers_draco_private "")
set(clers_meshopt_requires "")
set(clers_meshopt_private -lmeshoptimizer)
foreach(library IN LISTS clers_foreign)
  string(REPLACE clers_ "" name ${library})
  set(clers_pc_name ${name})
  set(clers_pc_more_requires ${${library}_requires})
  set(clers_pc_more_libs ${${library}_private})
  if(BUILD_SHARED_LIBS)
    set(clers_pc_more_requires "")
    set(clers_pc_more_libs "")
  endif()
  configure_file(cmake/clers-foreign.pc.in clers-${name}.pc @ONLY)
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/clers-${name}.pc DESTINATION ${clers_pc_dir} COMPONENT dev)
endforeach()
# A shared library for C needs nothing that its users would see; a static one all that C++ needs.
if(CLERS_C)
  set(clers_pc_c_requires "")
  set(clers_pc_c_libs "")
  set(clers_pc_c_flags "")
  if(clers_c_type STREQUAL STATIC_LIBRARY)
    set(clers_pc_c_requires "libzstd libxxhash")
    set(clers_pc_c_flags -DCLERS_C_STATIC)
    set(libraries ${CMAKE_CXX_IMPLICIT_LINK_LIBRARIES})
    list(REMOVE_ITEM libraries ${CMAKE_C_IMPLICIT_LINK_LIBRARIES})
    list(TRANSFORM libraries PREPEND -l)
    string(JOIN " " clers_pc_c_libs -lclers_codec -lclers_topology ${libraries} -pthread)
  endif()
  configure_file(cmake/clers-c.pc.in clers-c.pc @ONLY)
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/clers-c.pc DESTINATION ${clers_pc_dir} COMPONENT dev)
endif()

if(CLERS_CLI)
  # Where zsh looks is not the same everywhere: Debian has share/zsh/vendor-completions.
  set(CLERS_ZSH_DIR ${CMAKE_INSTALL_DATADIR}/zsh/site-functions CACHE STRING "Where completion for zsh is installed")
  install(TARGETS clers_cli RUNTIME COMPONENT tools)
  configure_file(codec/cli/clers.1.in clers.1 @ONLY)
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/clers.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT tools)
  install(FILES codec/cli/completion/clers.bash RENAME clers
    DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT tools)
  install(FILES codec/cli/completion/_clers DESTINATION ${CLERS_ZSH_DIR} COMPONENT tools)
endif()
install(FILES LICENSE codec/format.md codec/format-values.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT dev)
