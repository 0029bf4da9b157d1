#include "readers/vtu_text.hpp"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "core/base64.hpp"

namespace bumpfoil {
namespace {

/// VTK cell types.
constexpr signed char vtk_vertex = 1;
constexpr signed char vtk_quad = 9;

/// A column of numbers in VTK format: size in bytes, then the numbers, in base64.
template <typename Number>
std::string data_array(std::string_view type, std::string_view name, std::size_t components,
                       const std::vector<Number>& numbers) {
  const auto size = static_cast<std::uint32_t>(numbers.size() * sizeof(Number));
  std::vector<std::uint8_t> bytes(sizeof size + size);
  std::memcpy(bytes.data(), &size, sizeof size);
  if (size > 0) std::memcpy(bytes.data() + sizeof size, numbers.data(), size);
  const std::string vectors = components == 1 ? "" : fmt::format("NumberOfComponents=\"{}\" ", components);
  return fmt::format("<DataArray type=\"{}\" Name=\"{}\" {}format=\"binary\">{}</DataArray>\n", type, name, vectors,
                     base64_of(bytes));
}

/// Single precision suffices for pictures.
std::string field(std::string_view name, std::size_t components, const std::vector<double>& numbers) {
  return data_array("Float32", name, components, std::vector<float>(numbers.begin(), numbers.end()));
}

std::array<double, 3> turned(double outward, double counterclockwise, double polar) {
  return {outward * std::cos(polar) - counterclockwise * std::sin(polar),
          outward * std::sin(polar) + counterclockwise * std::cos(polar), 0.0};
}

}  // namespace

void VtuText::add_point(const ShapedPoint& point, const ShapedPad& pad, double begin) {
  const double polar = pad.weld + pad.sense * point.along;
  const auto vector = [&](double outward, double forward) -> std::array<double, 3> {
    if (layout_ == ShapeLayout::cylinder) return turned(outward, pad.sense * forward, polar);
    return {forward, 0.0, -outward};
  };
  std::array<double, 3> place = turned(point.radius, 0.0, polar);
  place[2] = point.z;
  if (layout_ == ShapeLayout::unwrapped)
    place = {begin + radius_ * point.along, point.z, sleeve_radius_ - point.radius};
  const auto append = [](std::vector<double>& list, const std::array<double, 3>& three) {
    list.insert(list.end(), three.begin(), three.end());
  };
  append(places_, place);
  append(displacements_, vector(point.outward, point.forward));
  append(forces_, vector(point.force_outward, point.force_forward));
  thicknesses_.push_back(point.film_thickness);
  pressures_.push_back(point.pressure);
  contacts_.push_back(point.contact);
}

void VtuText::add(const ShapedGrid& grid, const ShapedPad& pad, double begin) {
  const auto first = static_cast<int>(contacts_.size());
  for (const ShapedPoint& point : grid.points) add_point(point, pad, begin);
  const auto add_cell = [&](signed char type, std::initializer_list<int> corners) {
    for (const int corner : corners) corners_.push_back(first + corner);
    ends_.push_back(static_cast<int>(corners_.size()));
    types_.push_back(type);
    parts_.push_back(static_cast<signed char>(grid.part));
  };
  const auto count = static_cast<int>(grid.points.size());
  const auto columns = static_cast<int>(grid.columns);
  for (int i = 0; columns == 0 && i < count; ++i) add_cell(vtk_vertex, {i});
  for (int row = 0; columns > 0 && row + 1 < count / columns; ++row) {
    for (int k = row * columns; k + 1 < (row + 1) * columns; ++k) {
      add_cell(vtk_quad, {k, k + 1, k + 1 + columns, k + columns});
    }
  }
}

std::string VtuText::text(const std::map<std::string, double>& numbers) const {
  std::string out = fmt::format(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"{}\" "
      "header_type=\"UInt32\">\n<UnstructuredGrid>\n<FieldData>\n",
      std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian");
  for (const auto& [name, number] : numbers) {
    if (!std::isfinite(number)) continue;  // VTK has no form for absent numbers
    out += fmt::format(
        "<DataArray type=\"Float64\" Name=\"{}\" NumberOfTuples=\"1\" format=\"ascii\">{:.17g}</DataArray>\n", name,
        number);
  }
  out += fmt::format("</FieldData>\n<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n<PointData>\n",
                     contacts_.size(), types_.size());
  out += field("displacement", 3, displacements_);
  out += field("film_thickness", 1, thicknesses_);
  out += field("pressure", 1, pressures_);
  out += field("contact_force", 3, forces_);
  out += field("contact_state", 1, contacts_);
  out += "</PointData>\n<CellData>\n" + data_array("Int8", "part", 1, parts_) + "</CellData>\n<Points>\n";
  out += data_array("Float64", "Points", 3, places_) + "</Points>\n<Cells>\n";
  out += data_array("Int32", "connectivity", 1, corners_);
  out += data_array("Int32", "offsets", 1, ends_);
  out += data_array("UInt8", "types", 1, types_);
  return out + "</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

}  // namespace bumpfoil
