#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace bumpfoil {

/// How drawing a picture went.
enum class PlotStatus {
  drawn,
  no_gnuplot,  ///< the program is not installed
  failed,      ///< it ended with an error
};

/// Runs a gnuplot script, in silence.
/// @param variables  string variables that are defined before it starts
PlotStatus run_gnuplot(const std::filesystem::path& script, const std::map<std::string, std::string>& variables);

}  // namespace bumpfoil
