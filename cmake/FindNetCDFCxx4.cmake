# The C++ interface of netCDF-4 ships no CMake package: defines NetCDF::cxx4, and NetCDF::c that it needs, with HDF5,
# in which it stores files. The package of the C library names libraries of its own build that need not be there, so it
# is not asked.
find_path(NetCDFCxx4_INCLUDE_DIR ncFile.h)
find_library(NetCDFCxx4_LIBRARY NAMES netcdf_c++4 netcdf-cxx4)
find_path(NetCDFCxx4_C_INCLUDE_DIR netcdf.h)
find_library(NetCDFCxx4_C_LIBRARY netcdf)
find_path(NetCDFCxx4_HDF5_INCLUDE_DIR hdf5.h PATH_SUFFIXES hdf5/serial)
find_library(NetCDFCxx4_HDF5_LIBRARY NAMES hdf5_serial hdf5 NAMES_PER_DIR)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(NetCDFCxx4 REQUIRED_VARS NetCDFCxx4_LIBRARY NetCDFCxx4_INCLUDE_DIR
                                                           NetCDFCxx4_C_LIBRARY NetCDFCxx4_C_INCLUDE_DIR
                                                           NetCDFCxx4_HDF5_LIBRARY NetCDFCxx4_HDF5_INCLUDE_DIR)
if(NetCDFCxx4_FOUND AND NOT TARGET NetCDF::cxx4)
  add_library(NetCDF::c UNKNOWN IMPORTED)
  set_target_properties(NetCDF::c PROPERTIES IMPORTED_LOCATION "${NetCDFCxx4_C_LIBRARY}"
                        INTERFACE_INCLUDE_DIRECTORIES "${NetCDFCxx4_C_INCLUDE_DIR};${NetCDFCxx4_HDF5_INCLUDE_DIR}"
                        INTERFACE_LINK_LIBRARIES "${NetCDFCxx4_HDF5_LIBRARY}")
  add_library(NetCDF::cxx4 UNKNOWN IMPORTED)
  set_target_properties(NetCDF::cxx4 PROPERTIES IMPORTED_LOCATION "${NetCDFCxx4_LIBRARY}"
                        INTERFACE_INCLUDE_DIRECTORIES "${NetCDFCxx4_INCLUDE_DIR}" INTERFACE_LINK_LIBRARIES NetCDF::c)
endif()
mark_as_advanced(NetCDFCxx4_INCLUDE_DIR NetCDFCxx4_LIBRARY NetCDFCxx4_C_INCLUDE_DIR NetCDFCxx4_C_LIBRARY
                 NetCDFCxx4_HDF5_INCLUDE_DIR NetCDFCxx4_HDF5_LIBRARY)
