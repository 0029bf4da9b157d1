#include "bumpfoil/analysis/program.hpp"

#include <algorithm>

namespace bumpfoil {

Program push_and_pull(Control control, const Line& line, double origin, double amplitude, int steps) {
  const double top = origin + amplitude;
  return {{Branch::loading, control, line, origin, top, steps}, {Branch::unloading, control, line, top, origin, steps}};
}

Program swing(Control control, const Line& line, double origin, double amplitude, int steps) {
  const double top = origin + amplitude;
  const double bottom = origin - amplitude;
  return {{Branch::loading, control, line, origin, top, steps},
          {Branch::unloading, control, line, top, bottom, 2 * steps},
          {Branch::loading, control, line, bottom, origin, steps}};
}

double largest_place(const Program& program) {
  double largest = 0.0;
  for (const Leg& leg : program) {
    largest = std::max({largest, leg.line.place(leg.begin).norm(), leg.line.place(leg.end).norm()});
  }
  return largest;
}

int increments_of(const Program& program) {
  int increments = 1;
  for (const Leg& leg : program) increments += leg.steps;
  return increments;
}

}  // namespace bumpfoil
