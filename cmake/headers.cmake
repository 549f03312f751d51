# clers_public_headers(TARGET FOLDER HEADER...): what users include, as <clers/FOLDER/HEADER> ("." for
# FOLDER: <clers/HEADER>), wherever it stands in the source tree. Public headers include each other that way.
# Where clers is part of a larger build a header of one line leads there; nothing else of the source tree
# is on a user's include path.
function(clers_public_headers target folder)
  set(made ${PROJECT_BINARY_DIR}/include)
  foreach(header ${ARGN})
    cmake_path(ABSOLUTE_PATH header BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} NORMALIZE)
    cmake_path(GET header FILENAME name)
    file(CONFIGURE OUTPUT ${made}/clers/${folder}/${name} CONTENT "#include \"${header}\"\n" @ONLY)
    if(CLERS_INSTALL)
      install(FILES ${header} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/clers/${folder} COMPONENT dev)
    endif()
  endforeach()
  target_include_directories(${target} PUBLIC
    $<BUILD_INTERFACE:${made}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
endfunction()
