# Relocatable install of the program, the library and its CMake package.
include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/bumpfoil)

install(TARGETS bumpfoil)
install(TARGETS bumpfoil_lib EXPORT bumpfoil FILE_SET HEADERS)
install(EXPORT bumpfoil FILE bumpfoilTargets.cmake NAMESPACE bumpfoil:: DESTINATION ${package_dir})

configure_package_config_file(cmake/bumpfoilConfig.cmake.in ${PROJECT_BINARY_DIR}/bumpfoilConfig.cmake
                              INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/bumpfoilConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/bumpfoilConfig.cmake ${PROJECT_BINARY_DIR}/bumpfoilConfigVersion.cmake
              cmake/FindNetCDFCxx4.cmake
        DESTINATION ${package_dir})
# Links between pages, and from them to examples and headers, lead to what is installed.
install(FILES LICENSE README.md CITATION.cff CHANGELOG.md CONTRIBUTING.md SECURITY.md packages.txt DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY docs examples DESTINATION ${CMAKE_INSTALL_DOCDIR} PATTERN site EXCLUDE PATTERN __pycache__ EXCLUDE)
file(RELATIVE_PATH headers /${CMAKE_INSTALL_DOCDIR} /${CMAKE_INSTALL_INCLUDEDIR})
file(CREATE_LINK ${headers} ${PROJECT_BINARY_DIR}/include SYMBOLIC)
install(FILES ${PROJECT_BINARY_DIR}/include DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES ${PROJECT_BINARY_DIR}/apps/bumpfoil.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES ${PROJECT_BINARY_DIR}/apps/bumpfoil.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions
        RENAME bumpfoil)
