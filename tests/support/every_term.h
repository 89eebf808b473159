// Every term of the lists (math/cloth.h) by itself: on one element of its family, in all poses of
// that kind of element. A new term needs no line here; a new kind of element needs its poses.
#pragma once
#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "support/folds.h"

// One element and the places of its vertices.
template <class Element>
struct PosedElement {
  std::string pose;
  Element element;
  VecX x;         // m
  double length;  // m: a move of this size changes the element a lot
};

// The poses of a kind of element, `each` random elements in every pose.
inline std::vector<PosedElement<Triangle>> poses_of(std::type_identity<Triangle>, Random& random,
                                                    int each) {
  std::vector<PosedElement<Triangle>> posed;
  for (const Pose pose : all_poses)
    for (int i = 0; i < each; ++i) {
      const Rest rest = random_rest(random);
      const Triangle t = make_triangle(rest);
      const Vecs<2> w = pose_w(pose, random);
      const double narrow = w[0].cross(w[1]).norm() / std::max(w[0].norm(), w[1].norm());
      posed.push_back({name(pose), t, positions(rest, w, random.vector(3, 1)),
                       narrow / t.weight.cwiseAbs().maxCoeff()});
    }
  return posed;
}

inline std::vector<PosedElement<Spring>> poses_of(std::type_identity<Spring>, Random& random,
                                                  int each) {
  std::vector<PosedElement<Spring>> posed;
  for (const double length : {1e-3, 0.5, 1.0, 2.0})
    for (const double share : {1.0, 0.3})
      for (int i = 0; i < each; ++i) {
        VecX x(6);
        x << random.vector(3, 1), Vec3::Zero();
        x.tail<3>() = x.head<3>() + length * random.direction();
        posed.push_back({"length " + std::to_string(length) + ", share " + std::to_string(share),
                         make_spring(0, 1, random.between(0.9, 1.1), share), x, length});
      }
  return posed;
}

// Hinges folded to both sides of their angle at rest.
inline std::vector<PosedElement<Hinge>> poses_of(std::type_identity<Hinge>, Random& random, int) {
  std::vector<PosedElement<Hinge>> posed;
  for (const FoldCase& fold : all_folds(random.seed()))
    for (const double away : {0.3, -1.2})
      posed.push_back({fold.name,
                       hinge_near(fold.theta, fold.theta - away, bridson_shape(fold.flat_hinge)),
                       fold.x, fold.length});
  return posed;
}

inline std::vector<PosedElement<QuadraticHinge>> poses_of(std::type_identity<QuadraticHinge>,
                                                          Random& random, int) {
  std::vector<PosedElement<QuadraticHinge>> posed;
  for (const FoldCase& fold : all_folds(random.seed()))
    if (fold.theta != 0)  // a flat hinge is at rest
      posed.push_back({fold.name, quadratic(fold.flat_hinge), fold.x, fold.length});
  return posed;
}

// Random values of the members of a term other than k and kd.
inline void vary(Term&, Random&) {}
inline void vary(StretchTerm& term, Random& random) {
  term.b = {random.between(0.7, 1.3), random.between(0.7, 1.3)};
}
inline void vary(MembraneTerm& term, Random& random) {
  term.kappa = random.between(2, 16);
}
inline void vary(Membrane<NeoHookeanBarrier>& term, Random& random) {
  term.kappa = term.mu() + random.between(0, 8);
}
inline void vary(LinearMembrane& term, Random& random) {
  vary(static_cast<MembraneTerm&>(term), random);
  term.axes = {axes_of({random.direction(), random.direction()})};
}

// A cloth of one element, on which one term acts.
struct TermSample {
  std::string pose;
  Cloth cloth;
  VecX x;
  double length;
};

template <class T>
std::vector<TermSample> samples_of(unsigned seed, int each) {
  Random random(seed);
  std::vector<TermSample> samples;
  const Families none;
  for_each_family(none, [&]<class Family>(const Family& of) {
    if constexpr (Family::template lists<T>) {
      using Element = typename decltype(of.elements)::value_type;
      for (const PosedElement<Element>& posed :
           poses_of(std::type_identity<Element>(), random, each)) {
        TermSample sample{posed.pose, bare_cloth(Family::N), posed.x, posed.length};
        for_each_family(sample.cloth, [&](auto& family) {
          if constexpr (std::is_same_v<decltype(family), Family&>)
            family.elements = {posed.element};
        });
        T term(random.between(2, 8), random.between(0.5, 2));
        vary(term, random);
        sample.cloth.template term<T>() = term;
        samples.push_back(std::move(sample));
      }
    }
  });
  return samples;
}

// One term of the lists.
struct ListedTerm {
  TermInfo info;
  std::string name;                                                         // bend_dihedral
  std::function<std::vector<TermSample>(unsigned seed, int each)> samples;  // `each` per pose
};
inline void PrintTo(const ListedTerm& term, std::ostream* out) {
  *out << term.name;
}

inline std::vector<ListedTerm> every_term() {
  std::vector<ListedTerm> terms;
  const Families none;
  for_each_term(none, [&]<class T>(const std::optional<T>&) {
    std::string name(T::info.table);
    if (!T::info.model.empty()) name += "_" + std::string(T::info.model);
    std::replace(name.begin(), name.end(), '-', '_');
    terms.push_back({T::info, name, samples_of<T>});
  });
  return terms;
}
