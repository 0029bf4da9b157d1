#pragma once

#include <map>
#include <string>
#include <vector>

#include "readers/foil_shapes.hpp"

namespace bumpfoil {

/// Layout of a bearing in space.
enum class ShapeLayout {
  cylinder,   ///< actual shape: X, Y and the axis Z, m
  unwrapped,  ///< pads one after the other: along the foils, axis, height above the sleeve, m
};

/// An unstructured grid of VTK in XML, the format of ParaView. The cell data `part` distinguish its parts.
class VtuText {
 public:
  VtuText(ShapeLayout layout, double radius, double sleeve_radius)
      : layout_(layout), radius_(radius), sleeve_radius_(sleeve_radius) {}

  /// @param begin  of the unwrapped pad, m
  void add(const ShapedGrid& grid, const ShapedPad& pad, double begin);

  /// The file content. @param numbers  global field data
  [[nodiscard]] std::string text(const std::map<std::string, double>& numbers) const;

 private:
  void add_point(const ShapedPoint& point, const ShapedPad& pad, double begin);

  ShapeLayout layout_;
  double radius_, sleeve_radius_;
  std::vector<double> places_{}, displacements_{}, forces_{};  ///< three per point
  std::vector<double> thicknesses_{}, pressures_{}, contacts_{};
  std::vector<int> corners_{}, ends_{};
  std::vector<signed char> types_{}, parts_{};  ///< of cells
};

}  // namespace bumpfoil
