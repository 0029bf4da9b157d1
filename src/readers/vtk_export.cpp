#include "bumpfoil/readers/vtk_export.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numbers>
#include <utility>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/results/made_folder.hpp"
#include "bumpfoil/results/result_folder.hpp"
#include "readers/foil_shapes.hpp"
#include "readers/stored_result.hpp"
#include "readers/vtu_text.hpp"
#include "results/netcdf_image.hpp"

namespace bumpfoil {
namespace {

constexpr std::array<std::string_view, 2> layout_words{"cylinder", "unwrapped"};

/// Distance between unwrapped pads, relative to the radius.
constexpr double between_pads = 0.1;

std::string vtu_text(const FoilShapes& shapes, std::size_t state, ShapeLayout layout) {
  VtuText text(layout, shapes.radius(), shapes.sleeve_radius());
  double begin = 0.0;
  for (const ShapedPad& pad : shapes.pads()) {
    for (const ShapedGrid& grid : shapes.foils(state, pad)) text.add(grid, pad, begin);
    if (layout == ShapeLayout::unwrapped) text.add(shapes.journal(state, pad), pad, begin);
    begin += (pad.length + between_pads) * shapes.radius();
  }
  const ShapedPad all_around{.weld = 0.0, .sense = 1.0, .length = 2.0 * std::numbers::pi};
  if (layout == ShapeLayout::cylinder) text.add(shapes.journal(state, all_around), all_around, 0.0);
  return text.text(shapes.numbers_of(state));
}

}  // namespace

std::size_t write_vtk(std::string bytes, const std::string& name, const std::filesystem::path& folder,
                      Existing existing) {
  const NetcdfImage image(std::move(bytes), name);
  const auto command = image.texts().find("bumpfoil_command");
  if (command == image.texts().end()) image.refuse("", "is not a result of this program");
  constexpr std::array<std::string_view, 4> shown{"cycle", "path", "equilibrium", "film"};
  if (std::find(shown.begin(), shown.end(), command->second) == shown.end()) {
    throw Error(ErrorKind::input,
                {{name, 0, "", "", fmt::format("is a result of {}, which has no shapes", command->second),
                  "export results of cycle, path, equilibrium or film"}});
  }
  const FoilShapes shapes(image);
  const MadeFolder made(folder);
  std::size_t count = 0;
  for (const ShapeLayout layout : {ShapeLayout::cylinder, ShapeLayout::unwrapped}) {
    const std::string_view word = layout_words.at(static_cast<std::size_t>(layout));
    std::string list =
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" "
        "byte_order=\"LittleEndian\">\n<Collection>\n";
    count = 0;
    for (std::size_t state = 0; state < shapes.states(); ++state) {
      if (!shapes.is_reached(state)) continue;
      const std::string file = fmt::format("{}_{:04}.vtu", word, state);
      write_file(folder / file, vtu_text(shapes, state, layout), existing);
      list += fmt::format("<DataSet timestep=\"{}\" file=\"{}\"/>\n", state, file);
      ++count;
    }
    // Written last, so that it only lists existing files.
    write_file(folder / fmt::format("{}.pvd", word), list + "</Collection>\n</VTKFile>\n", existing);
  }
  return count;
}

std::size_t write_vtk_of(const std::filesystem::path& results, const std::filesystem::path& folder, Existing existing) {
  StoredResult result = read_stored_result(results, "result.nc", {.advice = "restore it from a backup or rerun"});
  return write_vtk(std::move(result.bytes), (results / "result.nc").string(), folder, existing);
}

}  // namespace bumpfoil
