#pragma once

#include <map>
#include <string>
#include <vector>

#include "readers/foil_shapes.hpp"

namespace bumpfoil {

/// How a bearing is laid out in space.
enum class ShapeLayout {
  cylinder,   ///< as it is: X, Y and the axis Z, m
  unwrapped,  ///< pads one behind the other: along the foils, axis, height over the sleeve, m
};

/// An unstructured grid of VTK in XML, the format of ParaView. Its parts are told apart by the cell data `part`.
class VtuText {
 public:
  VtuText(ShapeLayout layout, double radius, double sleeve_radius)
      : layout_(layout), radius_(radius), sleeve_radius_(sleeve_radius) {}

  /// @param begin  of the pad, with all laid flat, m
  void add(const ShapedGrid& grid, const ShapedPad& pad, double begin);

  /// The file. @param numbers  of all of it
  [[nodiscard]] std::string text(const std::map<std::string, double>& numbers) const;

 private:
  void add_point(const ShapedPoint& point, const ShapedPad& pad, double begin);

  ShapeLayout layout_;
  double radius_, sleeve_radius_;
  std::vector<double> places_{}, displacements_{}, forces_{};  ///< three of each point
  std::vector<double> thicknesses_{}, pressures_{}, contacts_{};
  std::vector<int> corners_{}, ends_{};
  std::vector<signed char> types_{}, parts_{};  ///< of cells
};

}  // namespace bumpfoil
