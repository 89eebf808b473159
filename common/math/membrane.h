// Membranes: a triangle as a sheet of one elastic material. The literature writes a model as an energy ψ(F)
// per area at rest, with the Lamé constants μ and λ of a sheet, N/m. For a measure e of strain
//
//   ψ = μ e:e + λ/2 tr²e  =  κ/2 (e11 + e22)² + μ/2 (e11 − e22)² + μ/2 (2 e12)²,   κ = λ + μ
//
// So every membrane has three conditions, each with √a: one on the area, with k = κ, and two on the shape,
// with k = μ. All three are zero at rest. A model is a formula for them.
//
//   stvk                  e = (FᵀF − I)/2        St. Venant–Kirchhoff
//   linear                e = (F + Fᵀ)/2 − I     linear_membrane.h
//   corotated             e = √(FᵀF) − I
//   arap                  the same with λ = 0: as rigid as possible
//   neo-hookean           ψ = μ/2 |F|² + κ/2 (J − 1 − μ/κ)² + constant
//   neo-hookean-barrier   ψ = μ/2 (|F|² − 2 − 2 ln J) + λ/2 ln² J, without bound as the area goes to zero
//
// With S = √(FᵀF): det S = J and tr S = s = √(A + D + 2J), so that S = (FᵀF + J I)/s, and
// S11 − S22 = (A − D)/s, 2 S12 = 2B/s. As |F|² = (S11 − S22)² + (2 S12)² + 2J, the two neo-Hookean models
// have the shape conditions of corotated. Source: the forms are derived here and in tests/math/membrane_test.cpp.
#pragma once
#include <string_view>
#include <utility>
#include <vector>

#include "math/metric.h"

// What all membranes share: the moduli. Damping is in proportion to stiffness; kd is that of the shape.
struct MembraneTerm : Term {
  explicit MembraneTerm(double mu, double kd_ = 0) : Term(mu, kd_), kappa(mu) {}

  double mu() const { return k; }
  double lambda() const { return kappa - k; }
  Term area() const { return Term(kappa, k > 0 ? kd * (kappa / k) : kd); }

  // [membrane] gives mu and lambda, or E and nu:   μ = E/(2 (1 + ν)),   λ = E ν/(1 − ν²)
  static constexpr std::array<const char*, 4> keys = {"E", "nu", "mu", "lambda"};
  template <class Table>
  static std::array<double, 2> read_moduli(const Table& table) {
    if (table.has("mu")) {
      for (const char* key : {"E", "nu"})
        if (table.has(key)) table.refuse(key, "mu and lambda say it already; take it out");
      return {table.not_negative("mu"), table.has("lambda") ? table.number("lambda") : 0};
    }
    if (table.has("lambda")) table.refuse("lambda", "it needs mu, N/m, beside it");
    const double E = table.not_negative("E"), nu = table.has("nu") ? table.number("nu") : 0;
    if (!(std::abs(nu) < 1)) table.refuse("nu", "it must be between -1 and 1");
    return {E / (2 * (1 + nu)), E * nu / (1 - nu * nu)};
  }
  template <class Table>
  void read(const Table& table) {
    const auto [mu, lambda] = read_moduli(table);
    k = mu;
    kappa = mu + lambda;
    if (!(kappa >= 0)) table.refuse("lambda", "lambda + mu must not be negative");
  }

  // What --explain prints.
  std::vector<std::pair<const char*, double>> stiffnesses() const {
    return {{"mu", mu()}, {"lambda", lambda()}};
  }

  double kappa;  // N/m, the bulk modulus of a sheet
};

template <class Model>
struct Membrane : MembraneTerm {
  using MembraneTerm::MembraneTerm;
  static constexpr TermInfo info = {
      .table = "membrane", .model = Model::name, .in_plane = InPlane::membrane};

  // C/√a of the three conditions.
  template <class Number>
  std::array<Number, 3> strains(const Metric<Number>& m) const {
    return Model::strains(m, *this);
  }

  template <class Table>
  void read(const Table& table) {
    MembraneTerm::read(table);
    if constexpr (requires { Model::check(*this, table); }) Model::check(*this, table);
  }

  template <class Act>
  void conditions(const Triangle& t, const Vecs<2>& w, const Act& act) const {
    const auto e = strains(with_slopes(metric(w)));
    act(area(), MetricCondition(t, w, e[0], *this, 0));
    for (size_t shape = 1; shape < 3; ++shape)
      act(*this, MetricCondition(t, w, e[shape], *this, shape));
  }
};

struct Stvk {
  static constexpr std::string_view name = "stvk";

  template <class Number>
  static std::array<Number, 3> strains(const Metric<Number>& m, const MembraneTerm&) {
    return {0.5 * (m.A + m.D) - 1, 0.5 * (m.A - m.D), m.B};
  }
};

struct Corotated {
  static constexpr std::string_view name = "corotated";

  template <class Number>
  static std::array<Number, 3> strains(const Metric<Number>& m, const MembraneTerm&) {
    const Number s = m.trace_of_stretch();
    return {s - 2, (m.A - m.D) / s, 2 * m.B / s};
  }
};

struct Arap : Corotated {
  static constexpr std::string_view name = "arap";

  template <class Table>
  static void check(const MembraneTerm& term, const Table& table) {
    if (term.lambda() != 0)
      table.refuse(table.has("nu") ? "nu" : "lambda", "arap has none; give mu alone, or E alone");
  }
};

struct NeoHookean {
  static constexpr std::string_view name = "neo-hookean";

  template <class Number>
  static std::array<Number, 3> strains(const Metric<Number>& m, const MembraneTerm&) {
    const Number s = m.trace_of_stretch();
    return {m.J - 1, (m.A - m.D) / s, 2 * m.B / s};
  }
};

// φ(q) = 2 (e^q − 1 − q)/q² and its derivatives. Differentiating q² φ = 2 (e^q − 1 − q) gives each from those
// before. Near q = 0 these lose their digits, and the series φ = Σ 2 qⁿ/(n + 2)! is short.
template <int Derivative>
constexpr std::array<double, 14> phi_series() {
  std::array<double, 14> c{};
  for (int n = 0; n < 14; ++n) {
    c[size_t(n)] = 2.0 / ((n + Derivative + 1) * (n + Derivative + 2));
    for (int i = 1; i <= n; ++i) c[size_t(n)] /= i;
  }
  return c;
}
template <int Derivative>
double phi(double q) {
  if (std::abs(q) < 0.5) {
    static constexpr auto c = phi_series<Derivative>();
    double sum = 0;
    for (size_t n = c.size(); n-- > 0;) sum = sum * q + c[n];
    return sum;
  }
  if constexpr (Derivative == 0)
    return 2 * (std::expm1(q) - q) / (q * q);
  else if constexpr (Derivative == 1)
    return (2 * std::expm1(q) - 2 * q * phi<0>(q)) / (q * q);
  else
    return (2 * std::exp(q) - 4 * q * phi<1>(q) - 2 * phi<0>(q)) / (q * q);
}
template <int Derivative, class T>
Slopes<T> phi(const Slopes<T>& q) {
  return Slopes<T>::chain(q, phi<Derivative>(q.value), phi<Derivative + 1>(q.value));
}

// κ/2 C² = μ (J − 1 − ln J) + λ/2 ln² J, with q = ln J:   C = q √((μ φ(q) + λ)/κ)
struct NeoHookeanBarrier {
  static constexpr std::string_view name = "neo-hookean-barrier";

  template <class Table>
  static void check(const MembraneTerm& term, const Table& table) {
    if (term.lambda() < 0)
      table.refuse(table.has("nu") ? "nu" : "lambda", "this model needs one that is not negative");
    if (term.kappa == 0)
      table.refuse(table.has("mu") ? "mu" : "E", "this model needs one above zero");
  }

  template <class Number>
  static std::array<Number, 3> strains(const Metric<Number>& m, const MembraneTerm& term) {
    const Number s = m.trace_of_stretch(), q = log(m.J);
    const Number stiffness = 1 / term.kappa * (term.mu() * phi<0>(q) + term.lambda());
    return {q * sqrt(stiffness), (m.A - m.D) / s, 2 * m.B / s};
  }
};
