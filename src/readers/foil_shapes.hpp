#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "bumpfoil/model/case.hpp"
#include "bumpfoil/results/quantity.hpp"
#include "results/netcdf_image.hpp"

namespace bumpfoil {

/// A point of a deformed bearing, with its field values.
struct ShapedPoint {
  double along{};    ///< angle from the weld of its pad along the foils, rad
  double radius{};   ///< from the axis of the bearing, m
  double z{};        ///< from the mid-plane, m
  double outward{};  ///< radial displacement, m
  double forward{};  ///< displacement along the foils, m
  double film_thickness{absent};
  double pressure{absent};
  double force_outward{};  ///< of a contact, N
  double force_forward{};
  double contact{absent};  ///< its state, as numbered in the result
};

/// The part that a point belongs to.
enum class ShapedPart { top_foil, bump_foil, journal, journal_top, top_bump, bump_sleeve };

/// A surface, or single points.
struct ShapedGrid {
  ShapedPart part{};
  std::size_t columns{};            ///< of a surface; 0 for single points
  std::vector<ShapedPoint> points;  ///< of a surface, row by row along the foils
};

/// Foils between a weld and a free end.
struct ShapedPad {
  double weld{};    ///< polar angle, rad
  double sense{};   ///< 1: the foils run counterclockwise from the weld, -1: clockwise
  double lobe{};    ///< pad offset towards its middle, m
  double middle{};  ///< polar angle half way between its weld and its end, rad
  double length{};  ///< angle from the weld to the free end, rad
  double z{};       ///< axial position of its middle, m: that of a strip with its own film
  std::vector<std::size_t> bumps{}, feet{}, columns{};
};

/// Shapes of a bearing in the states of its result.nc: for `cycle`, `path`, `equilibrium` and `film`.
/// | Foils are surfaces without thickness. The top foil is offset from the journal by the gap or the film thickness of
/// the result, or follows its deflection if it varies over the width without a film. The crests are offset from the top
/// foil by their gap. The shape between foot and crest is unknown: each bump is drawn as an arc, flatter or higher.
/// Displacements are added to the radius as small quantities, as in the models.
class FoilShapes {
 public:
  /// The image must outlive it. @throws Error (file) if it lacks the required variables
  explicit FoilShapes(const NetcdfImage& image);

  [[nodiscard]] std::size_t states() const { return x_.size(); }
  /// Whether a requested state was computed.
  [[nodiscard]] bool is_reached(std::size_t state) const;
  [[nodiscard]] const std::vector<ShapedPad>& pads() const { return pads_; }
  [[nodiscard]] double radius() const { return radius_; }
  /// Radius of the sleeve under the tallest bump, m.
  [[nodiscard]] double sleeve_radius() const;

  /// Foils and contacts of a pad.
  [[nodiscard]] std::vector<ShapedGrid> foils(std::size_t state, const ShapedPad& pad) const;

  /// The journal surface over the foils of a pad.
  [[nodiscard]] ShapedGrid journal(std::size_t state, const ShapedPad& pad) const;

  /// Scalar results of each state, by name.
  [[nodiscard]] std::map<std::string, double> numbers_of(std::size_t state) const;

 private:
  /// A crest, a foot or a column of the film.
  struct Node {
    double along{}, polar{};
    std::size_t pad{};
  };

  [[nodiscard]] bool has(const std::string& name) const { return fields_.contains(name); }
  /// Whether the top foil varies over the width without a film.
  [[nodiscard]] bool has_curved_top() const { return has("top_slope") || has("top_parabola"); }
  [[nodiscard]] std::vector<double> constant(const std::string& name) const;
  [[nodiscard]] std::vector<double> per_bump(const std::string& name) const;
  [[nodiscard]] std::vector<Node> nodes(const std::string& prefix, const std::string& dimension) const;
  [[nodiscard]] double at(const std::string& name, std::size_t state, std::size_t node) const;
  [[nodiscard]] double journal_radius(std::size_t state, double polar, double z) const;
  [[nodiscard]] double film_at(const std::string& name, std::size_t state, std::size_t row, std::size_t column) const;
  [[nodiscard]] double across(const std::string& stem, const std::string& mean, std::size_t state, std::size_t node,
                              double z) const;
  template <typename Line>
  [[nodiscard]] ShapedGrid over_width(ShapedPart part, const ShapedPad& pad, bool varies, const Line& line) const;
  [[nodiscard]] double crest_radius(std::size_t state, const ShapedPad& pad, std::size_t bump, double z) const;
  [[nodiscard]] double middle_crest_radius(std::size_t state, const ShapedPad& pad, std::size_t bump) const;
  [[nodiscard]] double foot_radius(std::size_t state, const ShapedPad& pad, std::size_t bump, double foot_v) const;
  [[nodiscard]] ShapedGrid top_foil_of_film(std::size_t state, const ShapedPad& pad) const;
  [[nodiscard]] double undeformed_radius(const ShapedPad& pad, double polar) const;
  [[nodiscard]] ShapedPoint top_over_bump(std::size_t state, const ShapedPad& pad, std::size_t bump, double z) const;
  [[nodiscard]] ShapedGrid top_foil_of_bumps(std::size_t state, const ShapedPad& pad) const;
  [[nodiscard]] ShapedGrid bump_foil(std::size_t state, const ShapedPad& pad) const;
  [[nodiscard]] std::vector<ShapedPoint> bump_foil_at(std::size_t state, const ShapedPad& pad, double z) const;
  [[nodiscard]] std::vector<ShapedGrid> contacts(std::size_t state, const ShapedPad& pad) const;
  void make_pads();

  const NetcdfImage& image_;
  std::map<std::string, std::vector<double>> fields_{};  ///< of all states, by name
  std::map<std::string, std::size_t> widths_{};          ///< count of numbers per state
  std::vector<double> x_, tilt_x_, y_, tilt_y_;          ///< of each state
  double radius_{}, clearance_{}, half_width_{};
  double half_foil_{};  ///< half the width of foils and film of a pad, m
  WidthProfile profile_;
  std::vector<Node> bumps_, feet_, columns_;
  std::vector<double> rises_, half_lengths_, height_errors_;
  std::vector<std::pair<double, std::size_t>>
      rows_;  ///< positions over the width of a pad's foils, m, and their rows in the film
  std::vector<ShapedPad> pads_;
};

}  // namespace bumpfoil
