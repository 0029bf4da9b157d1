#include "case/film_keys.hpp"

namespace bumpfoil {

void describe(CaseVisitor& keys, GasSettings& gas) {
  using enum Presence;
  using enum Dimension;
  keys.choice({"preset", defaulted, "Gas", "sets the viscosity; or \"helium\", \"nitrogen\", \"steam\""}, gas.preset);
  keys.value({"temperature", defaulted, "Temperature", "of the film, uniform", "293 K", temperature}, &gas.temperature);
  keys.value({.name = "viscosity",
              .presence = optional,
              .title = "Viscosity",
              .text = "instead of that of the preset at the temperature",
              .example = "18.5 uPa s",
              .dimension = viscosity,
              .instead = true},
             &gas.viscosity);
  keys.value({"ambient_pressure", defaulted, "Ambient pressure", "at all edges of the film and behind the foils",
              "101325 Pa", pressure},
             &gas.ambient_pressure);
  keys.value(
      {"mean_free_path", defaulted, "Mean free path", "at ambient pressure; 0: no slip at the walls", "0 nm", length},
      &gas.mean_free_path);
}

void describe(CaseVisitor& keys, FilmSettings& film) {
  using enum Presence;
  using enum Dimension;
  keys.value(
      {"columns_per_pitch", defaulted, "Columns per pitch", "of the mesh; even, so that every crest is a column"},
      &film.columns_per_pitch);
  keys.value({"rows", defaulted, "Rows", "of the mesh, on half the width"}, &film.rows);
  keys.value(
      {"h_floor", defaulted, "Contact threshold", "a thinner film counts as contact (touchdown)", "0.1 um", length},
      &film.h_floor);
  keys.value(
      {"h_lift_off", optional, "Lift-off above",
       "minimum film thickness of a journal that has lifted off, such as three times the roughness", "2 um", length},
      &film.h_lift_off);
  keys.choice({"wall", defaulted, "Bearing surface",
               "bearing surface instead of the foils, for the command film; or \"springs\": an elastic foundation, or "
               "\"rigid_across\": an axially uniform one"},
              film.wall);
  keys.value({"wall_stiffness", optional, "Foundation modulus", "of the elastic foundation: pressure over displacement",
              "5 GPa/m", bed_stiffness},
             &film.wall_stiffness);
  keys.value({"closed", defaulted, "Closed surface", "true: no slot at the weld"}, &film.closed);
}

void describe(CaseVisitor& keys, EquilibriumSettings& equilibrium) {
  using enum Presence;
  using enum Dimension;
  keys.value({"speeds", required, "Speeds", "of the journal; positive turns X to Y", "[\"45000 rpm\"]", frequency},
             &equilibrium.speeds);
  keys.vectors({"loads", optional, "Loads", "on the journal, along X and Y", "[[\"50 N\", \"0 N\"]]", force},
               equilibrium.loads);
  keys.vectors({.name = "positions",
                .presence = optional,
                .title = "Positions",
                .text = "of the journal, along X and Y, instead of loads",
                .example = "[[\"25 um\", \"0 um\"]]",
                .dimension = length,
                .instead = true},
               equilibrium.positions);
  // Positions have no load to ramp.
  if (!equilibrium.positions.empty() && equilibrium.path == FilmPath::load_ramp) {
    equilibrium.path = FilmPath::position_ray;
  }
  keys.choice({"path", defaulted, "Path",
               "how states are reached: load after load; \"position_ray\", default with positions; \"speed_ramp\"; "
               "\"cold_start\": each from ambient pressure"},
              equilibrium.path);
  keys.choice({"paths", defaulted, "Paths",
               "number of paths: \"two\" compares the states with those of a second path and reports where they "
               "differ; \"one\" does not; \"all\" keeps the states of every path. Sweeps and ensembles use one"},
              equilibrium.paths);
  keys.value({"steps", defaulted, "Steps", "equal increments of the ramp to the first state of a path"},
             &equilibrium.steps);
  keys.value({"frequencies", optional, "Frequencies",
              "of small motions about the states, for stiffness and damping; default: that of the rotation",
              "[\"375 Hz\", \"750 Hz\"]", frequency},
             &equilibrium.frequencies);
  keys.value({"limits", defaulted, "Limits",
              "true: find lift-off speeds and load capacities, too, where the film is film.h_lift_off thin"},
             &equilibrium.limits);
  keys.value({"ross_version", defaulted, "Version of ROSS",
              "that coefficients.toml is for; 2 has synchronous coefficients alone"},
             &equilibrium.ross_version);
}

}  // namespace bumpfoil
