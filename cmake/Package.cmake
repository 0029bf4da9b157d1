# The Debian package of `make deb`: all that is installed, and the Python package, under /usr.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME bumpfoil)
set(CPACK_PACKAGE_CONTACT "The Bumpfoil authors <authors@bumpfoil.invalid>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "mechanics of bump-type gas foil bearings")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION "Forces, hysteresis loops, contact and friction of the foils of a bearing, at
rest, vibrating or running; tolerance studies, sweeps, and pages to look at.
This package has the program, a static library for C++20, the Python package,
documentation and examples.")
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS gnuplot-nox)
# What find_package(bumpfoil) looks for.
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "g++, cmake, libeigen3-dev, libfmt-dev, libtomlplusplus-dev, libnetcdf-dev, \
libnetcdf-c++4-dev, libtbb-dev, libceres-dev, libnlopt-dev")
set(CPACK_INSTALL_CMAKE_PROJECTS "${PROJECT_BINARY_DIR};bumpfoil;Unspecified;/")
if(BUMPFOIL_BUILD_PYTHON)
  list(APPEND CPACK_INSTALL_CMAKE_PROJECTS "${PROJECT_BINARY_DIR};bumpfoil;python;/")
  # The compiled module is of one version of Python.
  find_package(Python3 REQUIRED COMPONENTS Interpreter)
  math(EXPR next "${Python3_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PACKAGE_DEPENDS
      "python3 (>= 3.${Python3_VERSION_MINOR}), python3 (<< 3.${next}), python3-numpy")
  string(APPEND CPACK_DEBIAN_PACKAGE_RECOMMENDS
         ", python3-matplotlib, python3-netcdf4, python3-pandas, python3-xarray")
endif()
# Compiled files of Python come and go with the package. Scripts of a tarball may be writable by their group.
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA ${PROJECT_SOURCE_DIR}/cmake/debian/postinst
    ${PROJECT_SOURCE_DIR}/cmake/debian/prerm)
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/finish_package.cmake)
set(BUMPFOIL_CHANGELOG ${PROJECT_SOURCE_DIR}/CHANGELOG.md)
set(BUMPFOIL_COPYRIGHT ${PROJECT_SOURCE_DIR}/cmake/debian/copyright)
set(CPACK_PROJECT_CONFIG_FILE ${PROJECT_BINARY_DIR}/package_settings.cmake)
file(CONFIGURE OUTPUT package_settings.cmake @ONLY CONTENT
     "set(BUMPFOIL_CHANGELOG \"@BUMPFOIL_CHANGELOG@\")\nset(BUMPFOIL_COPYRIGHT \"@BUMPFOIL_COPYRIGHT@\")\n")
include(CPack)
