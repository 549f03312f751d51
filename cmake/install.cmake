# Installation: libraries, the program, its manual, and what find_package and pkg-config need to find them.
# Public headers are installed where they are listed (headers.cmake).
install(TARGETS clers_codec clers_topology clers_modeling EXPORT clers-targets)
if(CLERS_IO)
  install(TARGETS clers_io EXPORT clers-targets)
endif()
if(CLERS_GLTF)
  install(TARGETS clers_gltf EXPORT clers-targets)
endif()
install(EXPORT clers-targets NAMESPACE clers:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/clers)
# Those that need a library of somebody else's are sets of their own: who does not ask for them needs none of it.
set(clers_foreign)
foreach(library draco meshopt)
  string(TOUPPER ${library} option)
  if(CLERS_${option})
    list(APPEND clers_foreign clers_${library})
    install(TARGETS clers_${library} EXPORT clers-${library}-targets)
    install(EXPORT clers-${library}-targets NAMESPACE clers:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/clers)
  endif()
endforeach()
configure_package_config_file(cmake/clers-config.cmake.in clers-config.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/clers)
# Before 1.0 a minor version may break.
write_basic_package_version_file(clers-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES
  ${CMAKE_CURRENT_BINARY_DIR}/clers-config.cmake
  ${CMAKE_CURRENT_BINARY_DIR}/clers-config-version.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/clers)

# Installed libraries look for each other beside themselves, and the program for them from where it is:
# a tree with shared libraries runs from any prefix.
if(NOT DEFINED CMAKE_INSTALL_RPATH)
  file(RELATIVE_PATH clers_to_libraries /prefix/${CMAKE_INSTALL_BINDIR} /prefix/${CMAKE_INSTALL_LIBDIR})
  set(clers_libraries clers_codec clers_topology clers_modeling)
  if(CLERS_IO)
    list(APPEND clers_libraries clers_io)
  endif()
  if(CLERS_GLTF)
    list(APPEND clers_libraries clers_gltf)
  endif()
  list(APPEND clers_libraries ${clers_foreign})
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
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/clers.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
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
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/clers-${name}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endforeach()

if(CLERS_CLI)
  install(TARGETS clers_cli)
  configure_file(codec/cli/clers.1.in clers.1 @ONLY)
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/clers.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
  install(FILES codec/cli/completion/clers.bash RENAME clers
    DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
  install(FILES codec/cli/completion/_clers DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions)
endif()
install(FILES LICENSE codec/format.md codec/format-values.md DESTINATION ${CMAKE_INSTALL_DOCDIR})

# Before 1.0 a minor version may break.
set_target_properties(clers_codec clers_topology clers_modeling PROPERTIES
  VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
if(CLERS_IO)
  set_target_properties(clers_io PROPERTIES
    VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
endif()
if(CLERS_GLTF)
  set_target_properties(clers_gltf PROPERTIES
    VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
endif()
foreach(library IN LISTS clers_foreign)
  set_target_properties(${library} PROPERTIES
    VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
endforeach()
