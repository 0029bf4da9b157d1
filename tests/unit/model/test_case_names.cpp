#include "bumpfoil/model/case_names.hpp"

#include <gtest/gtest.h>

#include "bumpfoil/experiments/equilibrium/equilibrium_settings.hpp"

namespace bumpfoil {
namespace {

TEST(CaseNames, BelongToTheirValues) {
  EXPECT_EQ(name_of(Wrap::clockwise), "clockwise");
  EXPECT_EQ(name_of(Wrap::counterclockwise), "counterclockwise");
  EXPECT_EQ(name_of(BumpFoilModel::truss), "truss");
  EXPECT_EQ(name_of(BumpFoilModel::frame), "frame");
  EXPECT_EQ(name_of(BumpFoilModel::former), "former");
  EXPECT_EQ(name_of(Geometry::linear), "linear");
  EXPECT_EQ(name_of(Geometry::nonlinear), "nonlinear");
  EXPECT_EQ(name_of(HeightReference::overall), "overall");
  EXPECT_EQ(name_of(HeightReference::midsurface), "midsurface");
  EXPECT_EQ(name_of(WeldPosition::mid_flat), "mid_flat");
  EXPECT_EQ(name_of(WeldPosition::arc_start), "arc_start");
  EXPECT_EQ(name_of(SolverName::newton), "newton");
  EXPECT_EQ(name_of(SolverName::uzawa), "uzawa");
  EXPECT_EQ(name_of(SolverName::events), "events");
  EXPECT_EQ(name_of(StripWeld::one_end), "one_end");
  EXPECT_EQ(name_of(StripWeld::none), "none");
  EXPECT_EQ(name_of(GasPreset::air), "air");
  EXPECT_EQ(name_of(GasPreset::helium), "helium");
  EXPECT_EQ(name_of(GasPreset::nitrogen), "nitrogen");
  EXPECT_EQ(name_of(GasPreset::steam), "steam");
  EXPECT_EQ(name_of(FilmWall::rigid), "rigid");
  EXPECT_EQ(name_of(FilmWall::springs), "springs");
  EXPECT_EQ(name_of(FilmWall::rigid_across), "rigid_across");
  EXPECT_EQ(name_of(FilmPath::load_ramp), "load_ramp");
  EXPECT_EQ(name_of(FilmPath::speed_ramp), "speed_ramp");
  EXPECT_EQ(name_of(FilmPath::position_ray), "position_ray");
  EXPECT_EQ(name_of(FilmPath::cold_start), "cold_start");
}

}  // namespace
}  // namespace bumpfoil
