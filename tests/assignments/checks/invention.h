// The checks of an invented condition: what every condition must satisfy, on a triangle or on a spring. A
// task names its term, and says C once more, by the formula of its statement:
//
//   struct Statement {
//     using Term = StrainLimitTerm;
//     static std::vector<double> C(const Triangle&, const Vecs<2>& w);   of all its conditions
//     static bool is_smooth(const Vecs<2>& w);                           false near a kink of C
//   };
//   INSTANTIATE_TYPED_TEST_SUITE_P(StrainLimit, Invention, Statement);
#pragma once
#include <algorithm>

#include "assignments/checks/check.h"
#include "assignments/checks/cloths.h"
#include "step03_implicit/time_step.h"

namespace invention {

// Elements and their poses -----------------------------------------------------------------------

// An element at the positions x, where its vectors are y.
template <class Element>
struct Posed {
  Element element;
  VecX x;
  Vecs<Element::Y> y = gather(element, x);
};

// Threads between half and 1.8 times as long as at rest, at 30° to 150° to each other.
inline Posed<Triangle> random_pose(std::type_identity<Triangle>, Random& random) {
  const Rest rest = random_rest(random);
  const double angle = random.between(pi / 6, 5 * pi / 6);
  const Mat3 R = random.rotation();
  const Vec3 w_u = random.between(0.5, 1.8) * Vec3::UnitX();
  const Vec3 w_v = random.between(0.5, 1.8) * Vec3(std::cos(angle), std::sin(angle), 0);
  return {make_triangle(rest), positions(rest, {R * w_u, R * w_v}, random.vector(3, 1))};
}
inline Posed<Spring> random_pose(std::type_identity<Spring>, Random& random) {
  VecX x(6);
  x << random.vector(3, 1), Vec3::Zero();
  x.tail<3>() = x.head<3>() + random.between(0.5, 1.8) * random.direction();
  return {make_spring(0, 1, random.between(0.8, 1.2), random.between(0.3, 1)), x};
}

inline std::string shown(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}
inline std::string shown(const Vec3& v) {
  return "(" + shown(v[0]) + ", " + shown(v[1]) + ", " + shown(v[2]) + ")";
}
inline std::string shown(const Posed<Triangle>& p) {
  return "a triangle with a = " + shown(p.element.area) + " m², w_u = " + shown(p.y[0]) +
         ", w_v = " + shown(p.y[1]);
}
inline std::string shown(const Posed<Spring>& p) {
  return "a spring with L = " + shown(p.element.rest_length) +
         " m, √q = " + shown(p.element.sqrt_share) + ", y = " + shown(p.y[0]) + " m";
}

// Which of the numbers of a derivative belongs to which vector.
inline std::string by(const Posed<Triangle>&) {
  return ", by w_u (0 to 2) and w_v (3 to 5)";
}
inline std::string by(const Posed<Spring>&) {
  return ", by y";
}

// The numbers c_mn with ∂²C/∂y_m∂y_n = c_mn P across the element (math/tension.h), from second derivatives.
inline MatX part_across(const Posed<Triangle>& p, const MatX& second) {
  const Vec3 n = p.y[0].cross(p.y[1]).normalized();
  MatX c(2, 2);
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) c(i, j) = n.dot(Mat3(second.block<3, 3>(3 * i, 3 * j)) * n);
  return c;
}
inline MatX part_across(const Posed<Spring>& p, const MatX& second) {
  const Vec3 q = p.y[0].unitOrthogonal();
  const Mat3 P = across(p.element, p.y);
  return MatX::Constant(1, 1, q.dot(Mat3(second) * q) / q.dot(P * q));
}

// What the student wrote -------------------------------------------------------------------------

// What a condition says by all Y vectors of its element, as matrices: zero by those that it does not read.
template <int Y>
struct Written {
  static MatX C(const auto& c) { return one_number(c.C); }
  static MatX gradient(const auto& c) {
    MatX all = MatX::Zero(3 * Y, 1);
    for (int m = 0; m < c.M; ++m) all.block<3, 1>(3 * (c.first + m), 0) = c.dCdy[size_t(m)];
    return all;
  }
  static MatX second(const auto& c) {
    MatX all = MatX::Zero(3 * Y, 3 * Y);
    const auto blocks = c.second();
    for (int m = 0; m < c.M; ++m)
      for (int n = 0; n < c.M; ++n)
        all.block<3, 3>(3 * (c.first + m), 3 * (c.first + n)) = blocks[size_t(m)][size_t(n)];
    return all;
  }
  static MatX across(const auto& c) {
    MatX all = MatX::Zero(Y, Y);
    all.block(c.first, c.first, c.M, c.M) = c.across();
    return all;
  }
};

// A cloth with this term alone --------------------------------------------------------------------

inline void add_springs(const SmallCloth& small, Springs& springs) {
  for (const Triangle& t : small.cloth.triangles.elements)
    for (int i = 0; i < 3; ++i) {
      const int a = t.vertices[size_t(i)], b = t.vertices[size_t((i + 1) % 3)];
      const double length = (small.x.segment<3>(3 * a) - small.x.segment<3>(3 * b)).norm();
      springs.elements.push_back(make_spring(a, b, length));
    }
}

inline Vec3 sum(const VecX& f) {
  return f.reshaped(3, f.size() / 3).rowwise().sum();
}
inline Vec3 torque(const VecX& x, const VecX& f) {
  Vec3 all = Vec3::Zero();
  for (int i = 0; i < f.size(); i += 3) all += Vec3(x.segment<3>(i)).cross(Vec3(f.segment<3>(i)));
  return all;
}

// A free cloth in a random motion, pulled to one and a half times its size and crumpled a little.
template <class Term>
struct Free {
  explicit Free(double kd) {
    Random random(seed() + 7);
    if constexpr (Springs::lists<Term>) add_springs(small, small.cloth.springs);
    small.cloth.term<Term>() = Term(50, kd);
    state = {1.5 * small.x + random.vector(27, 0.1), random.vector(27, 0.5)};
  }
  double energy() const {
    return potential_energy(small.cloth, state.x) + kinetic_energy(small.cloth, state.v);
  }
  Vec3 momentum() const { return sum(state.v); }  // 1 kg per vertex

  SmallCloth small{2};
  State state;
};

}  // namespace invention

template <class Statement>
class Invention : public testing::Test {
 protected:
  using Invented = typename Statement::Term;
  using Element =
      typename std::conditional_t<Triangles::lists<Invented>, Triangles, Springs>::Element;
  using Posed = invention::Posed<Element>;
  using Free = invention::Free<Invented>;
  using Written = invention::Written<Element::Y>;

  // 20 random poses in which C has no kink.
  static std::vector<Posed> poses(unsigned of) {
    Random random(of);
    std::vector<Posed> found;
    while (found.size() < 20) {
      const Posed pose = invention::random_pose(std::type_identity<Element>(), random);
      if (Statement::is_smooth(pose.y)) found.push_back(pose);
    }
    return found;
  }

  // A matrix of every condition of an element.
  using Matrices = std::vector<MatX>;
  static Matrices every(const Element& element, const Vecs<Element::Y>& y, const auto& of) {
    Matrices found;
    Invented(1).conditions(element, y, [&](const auto&, const auto& c) { found.push_back(of(c)); });
    return found;
  }
  static Matrices C(const Element& element, const Vecs<Element::Y>& y) {
    return every(element, y, [](const auto& c) { return Written::C(c); });
  }
  static Matrices gradients(const Element& element, const Vecs<Element::Y>& y) {
    return every(element, y, [](const auto& c) { return Written::gradient(c); });
  }
  static Matrices seconds(const Element& element, const Vecs<Element::Y>& y) {
    return every(element, y, [](const auto& c) { return Written::second(c); });
  }
  static Matrices acrosses(const Element& element, const Vecs<Element::Y>& y) {
    return every(element, y, [](const auto& c) { return Written::across(c); });
  }

  // The slope in y of the column that of(element, y) finds for one of the conditions.
  static MatX slope(const Posed& pose, size_t condition, const auto& of) {
    const auto column = [&](const VecX& y) -> VecX {
      return of(pose.element, split<Element::Y>(y))[condition];
    };
    return slope_of(column, joined(pose.y), 1e-3);
  }
};
TYPED_TEST_SUITE_P(Invention);

TYPED_TEST_P(Invention, HasTheCOfTheStatement) {
  for (const auto& pose : this->poses(seed())) {
    std::vector<double> expected = TypeParam::C(pose.element, pose.y), got;
    for (const MatX& C : this->C(pose.element, pose.y)) got.push_back(C(0, 0));
    AGREES("the number of conditions of " + shown(pose), double(got.size()),
           double(expected.size()), 0);
    std::sort(got.begin(), got.end()), std::sort(expected.begin(), expected.end());
    for (size_t i = 0; i < got.size(); ++i)
      AGREES("C of " + shown(pose), got[i], expected[i], 1e-9);
  }
}

TYPED_TEST_P(Invention, HasTheSlopeOfCAsItsGradient) {
  for (const auto& pose : this->poses(seed() + 1)) {
    const std::vector<MatX> got = this->gradients(pose.element, pose.y);
    for (size_t i = 0; i < got.size(); ++i) {
      const MatX expected = this->slope(pose, i, TestFixture::C).transpose();
      AGREES("dCdy of " + shown(pose) + by(pose) + ", against the slope of C", got[i], expected,
             1e-6 * (1 + expected.norm()));
    }
  }
}

TYPED_TEST_P(Invention, HasTheSlopeOfTheGradientAsItsSecondDerivative) {
  for (const auto& pose : this->poses(seed() + 2)) {
    const std::vector<MatX> got = this->seconds(pose.element, pose.y);
    for (size_t i = 0; i < got.size(); ++i) {
      const MatX expected = this->slope(pose, i, TestFixture::gradients);
      const double tolerance = 1e-6 * (1 + expected.norm());
      AGREES("second() of " + shown(pose) + by(pose) + ", against the slope of dCdy", got[i],
             expected, tolerance);
      AGREES("second() of " + shown(pose) + by(pose) + ", against its transpose", got[i],
             MatX(got[i].transpose()), 1e-9 * (1 + expected.norm()));
    }
  }
}

TYPED_TEST_P(Invention, KnowsItsSecondDerivativeAcrossTheElement) {
  for (const auto& pose : this->poses(seed() + 3)) {
    const std::vector<MatX> got = this->acrosses(pose.element, pose.y),
                            second = this->seconds(pose.element, pose.y);
    for (size_t i = 0; i < got.size(); ++i) {
      const MatX expected = part_across(pose, second[i]);
      AGREES("across() of " + shown(pose) + ", against second() across the element", got[i],
             expected, 1e-8 * (1 + expected.norm()));
    }
  }
}

// C is a number that does not depend on where the cloth is and how it is turned. So a rotation turns the
// gradients with it.
TYPED_TEST_P(Invention, IgnoresARotation) {
  Random random(seed() + 4);
  for (const auto& pose : this->poses(seed() + 5)) {
    const Mat3 R = random.rotation();
    auto turned = pose.y;
    for (Vec3& y : turned) y = R * y;
    const std::vector<MatX> C = this->C(pose.element, pose.y),
                            C_turned = this->C(pose.element, turned),
                            g = this->gradients(pose.element, pose.y),
                            g_turned = this->gradients(pose.element, turned);
    for (size_t i = 0; i < C.size(); ++i) {
      AGREES("C of " + shown(pose) + ", turned in space", C_turned[i], C[i], 1e-9);
      AGREES("dCdy of " + shown(pose) + ", turned in space", g_turned[i],
             moved(g[i], R, Vec3::Zero()), 1e-9 * (1 + g[i].norm()));
    }
  }
}

// The forces on the vertices have no sum and no torque: a cloth can neither push nor turn itself.
TYPED_TEST_P(Invention, NeitherPushesNorTurnsTheCloth) {
  const typename TestFixture::Free free(0);
  const VecX& x = free.state.x;
  VecX f = VecX::Zero(27);
  add_elastic_forces(free.small.cloth.triangles, x, f);
  add_elastic_forces(free.small.cloth.springs, x, f);
  HOLDS("There is no force on a cloth that is pulled to 1.5 times its size", f.norm() > 1e-3);
  AGREES("the sum of the forces on a free cloth", invention::sum(f), VecX::Zero(3),
         1e-9 * f.norm());
  AGREES("the torque of the forces on a free cloth", invention::torque(x, f), VecX::Zero(3),
         1e-9 * f.norm());
}

// An element that has collapsed to a point has no directions.
TYPED_TEST_P(Invention, IsFiniteAtAPoint) {
  const auto element = this->poses(seed() + 6)[0].element;
  const auto y = zero_vectors<TestFixture::Element::Y>();
  const auto is_finite = [](const std::vector<MatX>& all) {
    return std::all_of(all.begin(), all.end(), [](const MatX& one) { return one.allFinite(); });
  };
  const std::string why =
      " of an element that has collapsed to a point is not a finite number. `Length` in "
      "math/condition.h says what |w| and w/|w| are there";
  HOLDS("C" + why, is_finite(this->C(element, y)));
  HOLDS("dCdy" + why, is_finite(this->gradients(element, y)));
  HOLDS("second()" + why, is_finite(this->seconds(element, y)));
  HOLDS("across()" + why, is_finite(this->acrosses(element, y)));
}

// For a very long h little is left of M, and the factorisation of A finds a negative eigenvalue of −K.
TYPED_TEST_P(Invention, HasADefiniteMatrix) {
  const typename TestFixture::Free free(0);
  step03::System system(free.small.cloth);
  step03::forces(free.small.cloth, free.state, system);
  step03::solve(free.small.cloth, 1000, system);
  HOLDS("A = M − h² K with h = 1000 s has a pivot that is not positive: −K is not definite",
        system.counts.indefinite == 0);
}

// d = D v: act(*this, …) hands the term itself, so that its kd acts as well.
TYPED_TEST_P(Invention, IsDamped) {
  const typename TestFixture::Free free(2);
  step03::System system(free.small.cloth);
  step03::forces(free.small.cloth, {free.state.x, VecX::Zero(27)}, system);
  const VecX at_rest = system.f;
  step03::forces(free.small.cloth, free.state, system);
  const VecX damping = system.f - at_rest;
  HOLDS("With kd = 2 there is no force of damping", damping.norm() > 1e-6);
  AGREES("the force of damping, against D v", damping, whole(system.D) * free.state.v,
         1e-9 * (1 + system.f.norm()));
  HOLDS("Damping gives energy to the cloth", damping.dot(free.state.v) < 0);
}

TYPED_TEST_P(Invention, KeepsMomentumAndGainsNoEnergy) {
  typename TestFixture::Free free(2);
  step03::System system(free.small.cloth);
  const Vec3 momentum = free.momentum();
  for (int step = 1; step <= 5; ++step) {
    const double before = free.energy();
    step03::time_step(free.small.cloth, 0.05, free.state, system);
    const std::string when = " of a free cloth in implicit step " + std::to_string(step);
    AGREES("the momentum" + when, free.momentum(), momentum, 1e-9);
    HOLDS("The energy" + when + " rose from " + invention::shown(before) + " J to " +
              invention::shown(free.energy()) + " J",
          free.energy() <= before * (1 + 1e-9));
  }
}

REGISTER_TYPED_TEST_SUITE_P(Invention, HasTheCOfTheStatement, HasTheSlopeOfCAsItsGradient,
                            HasTheSlopeOfTheGradientAsItsSecondDerivative,
                            KnowsItsSecondDerivativeAcrossTheElement, IgnoresARotation,
                            NeitherPushesNorTurnsTheCloth, IsFiniteAtAPoint, HasADefiniteMatrix,
                            IsDamped, KeepsMomentumAndGainsNoEnergy);
