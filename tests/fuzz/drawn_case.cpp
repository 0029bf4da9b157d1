#include "fuzz/drawn_case.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numbers>

namespace bumpfoil {
namespace {

/// Writes a case table by table.
class CaseDraft {
 public:
  explicit CaseDraft(DrawsOfBytes& draws) : draws_(draws) {}

  /// The bearing and its loading. @return the command
  std::string write();

  [[nodiscard]] std::string text() const { return text_; }

 private:
  template <typename... Parts>
  void add(fmt::format_string<Parts...> format, Parts&&... parts) {
    text_ += fmt::format(format, std::forward<Parts>(parts)...);
    text_ += '\n';
  }
  /// A value that is sometimes 0.
  double at_times(double probable, double value) { return draws_.chance(probable) ? value : 0.0; }
  std::string numbers_within(double most);

  void draw_bearing();
  void draw_bump_foil();
  void draw_top_foil();
  void draw_pads();
  void draw_film();
  void draw_states();
  void draw_rotor();
  void draw_cycle();
  void draw_path();
  void draw_strip();
  void draw_vibration();
  void draw_transient();
  std::string pair(double largest);
  /// Speeds in rpm.
  double rpm() { return (draws_.chance(0.5) ? 1.0 : -1.0) * draws_.decades(10.0, 200'000.0); }

  DrawsOfBytes& draws_;
  std::string text_;
  std::string command_;
  bool under_film_{};
  int bumps_{};
  int pads_{};
  double pitch_{}, length_{}, rise_{}, thickness_{}, radius_{}, clearance_{};
  double force_{};  ///< that compresses a bump by a tenth of its rise, about, N
};

std::string CaseDraft::numbers_within(double most) {
  std::vector<double> numbers = draws_.scatter(bumps_);
  for (double& number : numbers) number *= most;
  return fmt::format("[{}]", fmt::join(numbers, ", "));
}

std::string CaseDraft::pair(double largest) {
  const double size = draws_.uniform(0.0, largest);
  const double angle = draws_.uniform(0.0, 2.0 * std::numbers::pi);
  return fmt::format("[{}, {}]", size * std::cos(angle), size * std::sin(angle));
}

void CaseDraft::draw_bearing() {
  bumps_ = std::max(1, static_cast<int>(draws_.decades(0.8, under_film_          ? (draws_.chance(0.1) ? 60.0 : 16.0)
                                                            : draws_.chance(0.1) ? 500.0
                                                                                 : 80.0)));
  pads_ = command_ != "strip" && command_ != "film" && draws_.chance(0.3) ? draws_.whole(1, 6) : 0;
  pitch_ = draws_.decades(0.5e-3, 10e-3);
  length_ = pitch_ * draws_.uniform(0.3, 0.98);
  rise_ = length_ * draws_.decades(0.01, 0.45);
  const double arc = (0.25 * length_ * length_ + rise_ * rise_) / (2.0 * rise_);
  thickness_ = std::min(draws_.decades(5e-6, 2e-3), 0.95 * arc);
  const double arcs = std::max(1, pads_) * (bumps_ + 1) * pitch_;
  radius_ = std::max(4.1 * pitch_, arcs * draws_.decades(1.0, 5.0)) / (2.0 * std::numbers::pi);
  radius_ = std::max({radius_, 10.0 * thickness_, 5e-5});
  const double most = 0.1 * radius_;
  clearance_ = std::min(draws_.decades(1e-6, 5e-3), most);
  if (draws_.chance(0.15)) clearance_ = 0.0;
  if (draws_.chance(0.15)) clearance_ = -std::min(rise_ * draws_.decades(1e-3, 0.9), most);
  add("[bearing]\nradius = {}\naxial_length = {}\nradial_clearance = {}\nweld_angle = {}\nwrap = \"{}\"", radius_,
      radius_ * draws_.decades(0.1, 10.0), clearance_, draws_.uniform(-3.0, 3.0),
      draws_.among({"clockwise", "counterclockwise"}));
  if (draws_.chance(0.1)) add("taper = {}", draws_.uniform(-1.0, 1.0) * std::min(2.0 * rise_, most));
  if (draws_.chance(0.15)) {
    add("sleeve_waviness = [{{ harmonic = {}, amplitude = {}, phase = {} }}]", draws_.whole(1, 40),
        std::min(rise_, most) * draws_.decades(1e-3, 0.9), draws_.uniform(-3.0, 3.0));
  }
  if (!under_film_ && draws_.chance(0.1)) {
    add("journal_waviness = [{{ harmonic = {}, amplitude = {} }}]", draws_.whole(1, 40),
        std::min(rise_, most) * draws_.decades(1e-3, 0.9));
  }
}

void CaseDraft::draw_bump_foil() {
  const std::string model =
      draws_.among({"truss", "truss", "frame", "frame", command_ == "cycle" ? "former" : "frame"});
  const bool nonlinear = model == "frame" && !under_film_ && draws_.chance(0.2);
  const double modulus = draws_.decades(1e5, 1e13);
  add("[bump_foil]\nmodel = \"{}\"\nbumps = {}\npitch = {}\nlength = {}\nheight = {}", model, bumps_, pitch_, length_,
      rise_);
  add("height_reference = \"midsurface\"\nthickness = {}\nyoungs_modulus = {}\npoisson_ratio = {}", thickness_,
      std::max(modulus, 1e6), draws_.uniform(0.0, 0.5));
  force_ = std::max(modulus, 1e6) * std::pow(thickness_ / length_, 3) * radius_ * 0.1 * rise_;
  if (nonlinear) add("geometry = \"nonlinear\"");
  if (model == "frame" && draws_.chance(0.3)) add("weld_at = \"arc_start\"");
  if (draws_.chance(0.4)) add("height_errors = {}", numbers_within(rise_ * draws_.decades(1e-4, 0.999)));
  if (model == "frame" && draws_.chance(0.2)) add("stiffness_follows_height = true");
  if (draws_.chance(0.15)) add("sleeve_gaps = {}", numbers_within(rise_ * draws_.decades(1e-4, 0.999)));
  if (model != "former" && draws_.chance(0.1)) {
    add("section = [{{ from = 1, to = {}, height = {}, thickness = {} }}]", draws_.whole(1, bumps_),
        rise_ * draws_.decades(0.2, 1.0), thickness_ * draws_.decades(0.1, 1.0));
  }
  if (model != "former" && draws_.chance(0.1)) {
    add("shim = [{{ from = 1, to = {}, thickness = {} }}]", draws_.whole(1, bumps_), rise_ * draws_.decades(1e-3, 0.9));
  }
  if (model == "truss" && draws_.chance(0.8)) {
    add("truss = {{ k1 = {}, k2 = {}, k3 = {}, k4 = {}, theta_d = {} }}", draws_.decades(1e2, 1e10),
        draws_.decades(1e2, 1e10), draws_.decades(1e2, 1e10), draws_.decades(1e2, 1e10), draws_.uniform(0.01, 1.5));
  }
}

void CaseDraft::draw_top_foil() {
  add("[top_foil]\nthickness = {}\nyoungs_modulus = {}\npoisson_ratio = {}",
      std::min(draws_.decades(5e-6, 2e-3), 0.1 * radius_), std::max(1e6, draws_.decades(1e5, 1e13)),
      draws_.uniform(0.0, 0.5));
  if (draws_.chance(0.2))
    add("formed_radius = {}", radius_ * draws_.decades(0.9, 2.0));
  else if (clearance_ > 0.0 && draws_.chance(0.2))
    add("formed_radius = \"seated\"");
  if (draws_.chance(0.1)) add("seat_pressure = {}", draws_.decades(1.0, 1e5));
  if (draws_.chance(0.1)) add("overhang = {}", pitch_ * draws_.uniform(0.02, 0.9));
  add("[friction]\ntop_bump = {}\nbump_sleeve = {}", at_times(0.8, draws_.uniform(0.0, 1.0)),
      at_times(0.8, draws_.uniform(0.0, 1.0)));
}

void CaseDraft::draw_pads() {
  for (int pad = 0; pad < pads_; ++pad) {
    add("[[pad]]\nweld_edge = \"{}\"", draws_.among({"leading", "trailing"}));
    if (draws_.chance(0.3)) {
      add("lobe = {}", draws_.uniform(-1.0, 1.0) * std::min(0.1 * radius_, 2.0 * std::abs(clearance_)));
    }
  }
}

void CaseDraft::draw_film() {
  add("[gas]\npreset = \"{}\"\nambient_pressure = {}", draws_.among({"air", "helium", "nitrogen"}),
      draws_.chance(0.5) ? 101325.0 : draws_.decades(1e3, 1e7));
  if (draws_.chance(0.2)) add("mean_free_path = {}", draws_.decades(1e-9, 1e-6));
  add("[film]\ncolumns_per_pitch = {}\nrows = {}\nh_floor = {}", draws_.chance(0.2) ? 6 : 4, draws_.whole(2, 6),
      draws_.chance(0.5) ? 1e-7 : draws_.decades(1e-9, 1e-6));
  if (draws_.chance(0.1)) add("inlet_pressure = {}", draws_.decades(5e4, 1e6));
  if (command_ == "film") {
    add("wall = \"{}\"\nwall_stiffness = {}\nclosed = {}", draws_.among({"rigid", "springs", "rigid_across"}),
        draws_.decades(1e6, 1e13), draws_.chance(0.2));
  }
  const bool tilts = command_ == "equilibrium" && draws_.chance(0.25);
  if (command_ == "equilibrium" && draws_.chance(0.1)) {
    add("side_pressure = [{}, {}]", draws_.decades(5e4, 1e6), draws_.decades(5e4, 1e6));
  } else if (!tilts && draws_.chance(0.15) && command_ != "film") {
    add("[asperity]\nsigma = {}\nfriction = {}\npressure_factor = {}", draws_.decades(1e-8, 1e-5),
        draws_.uniform(0.0, 1.0), draws_.decades(1e5, 1e11));
  }
  if (!tilts) return;
  add("[width]\nmodes = {}", draws_.whole(1, 3));
  if (draws_.chance(0.3))
    add("moment = {}", pair(force_ * radius_));
  else
    add("tilt = {}", pair(std::min(0.05, 2.0 * std::abs(clearance_) / radius_)));
}

void CaseDraft::draw_states() {
  add("[equilibrium]\nspeeds = [\"{} rpm\", \"{} rpm\"]\nsteps = {}\npaths = \"one\"", rpm(), rpm(),
      draws_.whole(1, 4));
  const bool held = command_ == "film" || draws_.chance(0.5);
  add("path = \"{}\"", held ? draws_.among({"position_ray", "speed_ramp", "cold_start"})
                            : draws_.among({"load_ramp", "speed_ramp", "position_ray", "cold_start"}));
  if (held)
    add("positions = [{}]", pair(1.2 * std::abs(clearance_) + 0.05 * rise_));
  else
    add("loads = [{}]", pair(std::min(1e8, force_ * draws_.decades(1e-4, 1.0)) + 1e-6));
}

void CaseDraft::draw_rotor() {
  const double mass = force_ * draws_.decades(1e-4, 0.3) + 2e-6;
  add("[rotor]\nmass = {}", std::min(mass, 1e6));
  if (draws_.chance(0.4)) {
    const double gyration = radius_ * radius_;
    const double half_span = radius_ * draws_.decades(0.5, 10.0);
    add("bearings = [{}, {}]\ntransverse_inertia = {}\npolar_inertia = {}", -half_span, half_span,
        mass * gyration * draws_.decades(0.5, 50.0) + 1e-14, mass * gyration * 0.5);
  }
  add("[[rotor.unbalance]]\namount = {}", mass * draws_.decades(1e-9, 1e-5));
}

void CaseDraft::draw_cycle() {
  add("[cycle]\ndirections = [{}]\nsteps = {}", draws_.uniform(-3.0, 3.0), draws_.whole(1, 12));
  const double most = std::max(clearance_, 0.0) + draws_.decades(1e-3, 0.5) * rise_;
  if (draws_.chance(0.25)) {
    add("load = {}", std::clamp(force_ * draws_.decades(1e-5, 1.0), 1e-6, 1e9));
  } else {
    add("amplitude = {}", most);
    if (draws_.chance(0.15))
      add("preload = {}", pair(0.5 * most));
    else if (draws_.chance(0.1))
      add("preload = [\"{} N\", \"0 N\"]", std::clamp(0.1 * force_, 1e-6, 1e8));
  }
  if (draws_.chance(0.2)) add("swing = true");
  if (draws_.chance(0.2)) add("cycles = {}", draws_.whole(2, 4));
}

void CaseDraft::draw_path() {
  add("[path]");
  const double reach = std::max(clearance_, 0.0) + draws_.decades(1e-3, 0.4) * rise_;
  const bool by_load = draws_.chance(0.2);
  const double size = by_load ? std::clamp(force_ * draws_.decades(1e-5, 1.0), 1e-5, 1e8) : reach;
  const char* const unit = by_load ? "N" : "m";
  if (draws_.chance(0.5)) {
    const double axis = 0.5 * size * draws_.uniform(0.01, 1.0);
    add("centre = [\"{} {}\", \"0 {}\"]\nsemi_axes = [\"{} {}\", \"{} {}\"]\ntilt = {}\norbits = 2\nsteps = {}",
        0.5 * size, unit, unit, axis, unit, axis * draws_.uniform(0.0, 1.0), unit, draws_.uniform(-3.0, 3.0),
        draws_.whole(3, 12));
    return;
  }
  std::vector<std::string> points;
  for (int i = draws_.whole(1, 8); i > 0; --i) {
    const double angle = draws_.uniform(0.0, 2.0 * std::numbers::pi);
    points.push_back(fmt::format("[\"{} {}\", \"{} {}\"]", size * std::cos(angle), unit, size * std::sin(angle), unit));
  }
  add("points = [{}]", fmt::join(points, ", "));
}

void CaseDraft::draw_strip() {
  add("[strip]\nweld = \"{}\"\ntop_foil = {}\ncycles = {}\nsteps = {}", draws_.among({"one_end", "none"}),
      draws_.chance(0.6), draws_.whole(1, 3), draws_.whole(1, 10));
  if (draws_.chance(0.3))
    add("load = {}", std::clamp(force_ * draws_.decades(1e-5, 1.0), 1e-6, 1e9));
  else
    add("displacement = {}", rise_ * draws_.decades(1e-4, 0.6));
}

void CaseDraft::draw_vibration() {
  add("[vibration]\nloads = [[\"{} N\", \"1e-3 N\"]]\nmotion = \"{}\"\nfrequencies = [\"200 Hz\"]\nsteps = {}",
      std::clamp(force_ * draws_.decades(1e-4, 0.5), 1e-6, 1e8), "line", draws_.whole(1, 8));
  add("directions = [\"+X\"]\namplitudes = [{}, {}]", rise_ * draws_.decades(1e-5, 1e-2),
      rise_ * draws_.decades(1e-3, 0.1));
}

void CaseDraft::draw_transient() {
  const double speed = rpm();
  add("[transient]\nspeed = {{ from = \"{} rpm\", to = \"{} rpm\", time = {} }}\nsteps_per_revolution = {}", speed,
      speed * draws_.uniform(0.5, 1.5), 3.0 * 60.0 / std::abs(speed), draws_.whole(20, 40));
  if (draws_.chance(0.3)) {
    add("pulse = [{{ force = {}, begin = 0, duration = {} }}]", pair(force_), 30.0 / std::abs(speed));
  }
}

std::string CaseDraft::write() {
  command_ = draws_.among({"cycle", "cycle", "cycle", "path", "strip", "vibration", "equilibrium", "equilibrium",
                           "equilibrium", "film", "stability", "unbalance", "transient"});
  under_film_ = command_ != "cycle" && command_ != "path" && command_ != "strip" && command_ != "vibration";
  add("title = \"drawn for {}\"", command_);
  draw_bearing();
  draw_bump_foil();
  draw_top_foil();
  draw_pads();
  if (!under_film_ && draws_.chance(0.5)) add("[solver]\nname = \"{}\"", draws_.among({"events", "events", "uzawa"}));
  if (under_film_) draw_film();
  if (command_ == "cycle") draw_cycle();
  if (command_ == "path") draw_path();
  if (command_ == "strip") draw_strip();
  if (command_ == "vibration") draw_vibration();
  if (command_ == "equilibrium" || command_ == "film") draw_states();
  const bool rotates = command_ == "stability" || command_ == "unbalance" || command_ == "transient";
  if (rotates) draw_rotor();
  if (command_ == "stability") add("[stability]\nspeeds = [\"{} rpm\"]", rpm());
  if (command_ == "unbalance") {
    add("[unbalance]\nspeeds = [\"{} rpm\"]\norbits = {}\nsteps_per_revolution = 20", rpm(), draws_.chance(0.3));
  }
  if (command_ == "transient") draw_transient();
  return command_;
}

}  // namespace

DrawnCase draw_case(DrawsOfBytes draws) {
  CaseDraft draft(draws);
  const std::string command = draft.write();
  return {command, draft.text()};
}

}  // namespace bumpfoil
