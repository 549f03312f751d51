# Run by cpack, once files are where packages take them from: each package has its licence and the list of changes, and
# manuals are compressed.
foreach(component ${CPACK_COMPONENTS_ALL})
  string(TOUPPER ${component} upper)
  set(name ${CPACK_DEBIAN_${upper}_PACKAGE_NAME})
  set(share ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/${component}${CPACK_PACKAGING_INSTALL_PREFIX}/share)
  file(MAKE_DIRECTORY ${share}/doc/${name})
  file(COPY_FILE ${CPACK_CLERS_SOURCE}/LICENSE ${share}/doc/${name}/copyright)
  file(COPY_FILE ${CPACK_CLERS_SOURCE}/CHANGELOG.md ${share}/doc/${name}/changelog)
  file(GLOB manuals ${share}/man/man1/*.1)
  foreach(file ${manuals} ${share}/doc/${name}/changelog)
    execute_process(COMMAND gzip -9n ${file} COMMAND_ERROR_IS_FATAL ANY)
  endforeach()
endforeach()
