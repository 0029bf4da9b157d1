#pragma once

#include <filesystem>
#include <string>

#include "bumpfoil/results/write_file.hpp"

namespace bumpfoil {

/// Writes a result for ParaView and other programs that read VTK's XML files: cylinder.pvd and unwrapped.pvd, which
/// list one file for each state that was reached. Each of these has the foils, the journal, film thickness and pressure
/// on the top foil, and the contact forces, and as field data what the result says of the whole state.
///
/// The format is simple; VTK's own writers would add a hundred megabytes of libraries to every installation.
///
/// @param bytes  of result.nc of `cycle`, `path`, `equilibrium` or `film`   @param name  of it in messages
/// @return the number of states
/// @throws Error (file) if it is another file, if files exist that must not be replaced, or if writing fails
std::size_t write_vtk(std::string bytes, const std::string& name, const std::filesystem::path& folder,
                      Existing existing);

/// The same of the result.nc in a folder of results, whose checksums are verified.
std::size_t write_vtk_of(const std::filesystem::path& results, const std::filesystem::path& folder, Existing existing);

}  // namespace bumpfoil
