#include "bumpfoil/structure/top_foil.hpp"

#include <cmath>

#include "bumpfoil/core/assert.hpp"
#include "core/linear_algebra.hpp"
#include "structure/series.hpp"

namespace bumpfoil {

TopFoilBeam make_top_foil_beam(const FoilDesign& foils) {
  return {foils.radius.value(), make_top_foil_section(foils).bending_stiffness,
          crest_positions(foils) / foils.radius.value()};
}

Matrix top_foil_compliance(const TopFoilBeam& beam) {
  const double scale = 0.5 * std::pow(beam.radius, 3) / beam.bending_stiffness;
  const Eigen::Index n = beam.theta.size();
  Matrix S(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j <= i; ++j) {
      // Closed form rewritten with the addition theorem: no cancellation near the weld.
      const double a = beam.theta[i];
      const double b = beam.theta[j];
      S(i, j) = S(j, i) = scale * (b * std::sin(a) * std::sin(b) - std::cos(a) * b * b * b * sine_moment(b));
    }
  }
  return S;
}

Matrix top_foil_stiffness(const TopFoilBeam& beam) {
  const Eigen::Index n = beam.theta.size();
  return solve_positive(top_foil_compliance(beam), Matrix::Identity(n, n));
}

double TopFoilMoments::load_diagonal(Eigen::Index j) const {
  return half_tangent[j - 1] + half_tangent[j] - inverse_sine[j - 1] - inverse_sine[j];
}

TopFoilMoments make_top_foil_moments(const TopFoilBeam& beam) {
  const Eigen::Index n = beam.theta.size();
  BUMPFOIL_ASSERT(n > 0);
  TopFoilMoments form;
  form.compliance_diagonal = Vector::Zero(n);
  form.compliance_off.resize(n - 1);
  form.inverse_sine.resize(n);
  form.half_tangent.resize(n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const double d = beam.theta[k] - (k > 0 ? beam.theta[k - 1] : 0.0);
    const double sine = std::sin(d);
    const double flexibility = beam.radius * d * d * d / (beam.bending_stiffness * sine * sine);
    const double self = flexibility * 2.0 * sine_remainder(2.0 * d);
    form.inverse_sine[k] = 1.0 / (beam.radius * sine);
    form.half_tangent[k] = std::tan(0.5 * d) / beam.radius;
    form.compliance_diagonal[k] += self;
    if (k + 1 < n) {
      form.compliance_diagonal[k + 1] += self;
      form.compliance_off[k] = flexibility * 0.5 * sine_moment(d);
    }
  }
  return form;
}

TopFoilMoments make_flat_top_foil_moments(double bending_stiffness, const Vector& spans, bool welded) {
  const Eigen::Index n = spans.size();
  BUMPFOIL_ASSERT(n > 0);
  TopFoilMoments form;
  form.welded = welded;
  form.inverse_sine = spans.cwiseInverse();
  form.half_tangent = Vector::Zero(n);
  form.compliance_diagonal = spans / (3.0 * bending_stiffness);
  form.compliance_diagonal.tail(n - 1) += spans.head(n - 1) / (3.0 * bending_stiffness);
  form.compliance_off = spans.head(n - 1) / (6.0 * bending_stiffness);
  return form;
}

TopFoilMoments make_top_foil_moments(const FoilDesign& foils) {
  if (foils.radius) return make_top_foil_moments(make_top_foil_beam(foils));
  Vector spans(static_cast<Eigen::Index>(foils.bumps.size()));
  double half_pitch_before = 0.0;
  for (Eigen::Index k = 0; k < spans.size(); ++k) {
    const double half_pitch = 0.5 * foils.bumps[static_cast<std::size_t>(k)].pitch;
    spans[k] = half_pitch_before + half_pitch;
    half_pitch_before = half_pitch;
  }
  return make_flat_top_foil_moments(make_top_foil_section(foils).bending_stiffness, spans, foils.welded);
}

double top_moment_scale(const FoilDesign& foils) {
  const double length = foils.reference_length();
  return make_top_foil_section(foils).bending_stiffness / (length * length);
}

Vector solve_tridiagonal(Vector diagonal, const Vector& off, Vector right) {
  const Eigen::Index n = diagonal.size();
  for (Eigen::Index k = 1; k < n; ++k) {
    const double factor = off[k - 1] / diagonal[k - 1];
    diagonal[k] -= factor * off[k - 1];
    right[k] -= factor * right[k - 1];
  }
  for (Eigen::Index k = n - 1; k >= 0; --k) {
    if (k + 1 < n) right[k] -= off[k] * right[k + 1];
    right[k] /= diagonal[k];
  }
  return right;
}

Vector top_foil_moments(const TopFoilMoments& form, const Vector& u) {
  const Eigen::Index n = form.size();
  BUMPFOIL_ASSERT(u.size() == n);
  // Differences first: u is smooth if the foil is soft, and only its curvature matters.
  Vector kink = Vector::Zero(n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const double before = k > 0 ? u[k - 1] : 0.0;  // crest k is entry k - 1; the weld does not move
    kink[k] = form.inverse_sine[k] * (u[k] - before);
    if (k > 0) {
      kink[k] += form.inverse_sine[k - 1] * ((k > 1 ? u[k - 2] : 0.0) - before) +
                 before * (form.half_tangent[k - 1] + form.half_tangent[k]);
    }
  }
  return solve_tridiagonal(form.compliance_diagonal, form.compliance_off, kink);
}

Vector top_foil_loads(const TopFoilMoments& form, const Vector& u) {
  return loads_of_moments(form, top_foil_moments(form, u));
}

Vector loads_of_moments(const TopFoilMoments& form, const Vector& moment) {
  const Eigen::Index n = form.size();
  BUMPFOIL_ASSERT(moment.size() == n);
  Vector load(n);
  for (Eigen::Index j = 1; j <= n; ++j) {  // crest j
    const double at = j < n ? moment[j] : 0.0;
    const double after = j + 1 < n ? moment[j + 1] : 0.0;
    load[j - 1] = form.inverse_sine[j - 1] * (moment[j - 1] - at);
    if (j < n) {
      load[j - 1] += form.inverse_sine[j] * (after - at) + at * (form.half_tangent[j - 1] + form.half_tangent[j]);
    }
  }
  return load;
}

}  // namespace bumpfoil
