// A family: the elements of one shape, and the terms that can act on them.
//
// A term is one effect that a scene can model. One struct holds all that the program knows of it:
//
//   struct ShearTerm : Term {                       its stiffness k and its damping kd
//     using Term::Term;
//     static constexpr TermInfo info = {…};         what a scene calls it
//     void conditions(element, y, act) const;       hands its conditions at y to act(term, condition)
//   };
//
// The list of a family (math/cloth.h) names every term that there is. Reading a scene, refusing what a
// step does not teach, damping, the columns of log.csv, --explain and the tests of every model follow
// from the lists.
#pragma once
#include <optional>
#include <string_view>
#include <vector>

#include "math/condition.h"

// Units of a stiffness k and of its damping kd.
struct Units {
  std::string_view k, kd;
};
inline constexpr Units newton_per_metre = {"N/m", "N·s/m"}, newton_metre = {"N·m", "N·m·s"};

// The cost of rotating an element as a rigid body. `free`: none. `damped`: no energy, but damping
// resists the rotation. `stored`: energy, as in small-strain elasticity.
enum class Rotation { free, damped, stored };

// The ways to resist a change of shape within the plane of the cloth. A scene models one of them.
enum class InPlane { none, threads, membrane, springs };

struct TermInfo {
  std::string_view table;       // of scene.toml, and the column of log.csv
  std::string_view model = {};  // the value of the key model, where a table offers several
  int first_step = 1;           // the first step that teaches the table; 0 if no scene can name it
  Units units = newton_per_metre;
  bool rests_flat = false;  // the rest shape is flat even where the mesh is not
  Rotation rotation = Rotation::free;
  InPlane in_plane = InPlane::none;
};

// The place of a term in a family: empty if the scene does not name the term.
template <class T>
struct TermSlot {
  std::optional<T> term;
};

template <class Element_, class... Terms>
struct Family : TermSlot<Terms>... {
  using Element = Element_;
  static constexpr int N = Element::N, Y = Element::Y;
  std::vector<Element> elements;  // empty where no term acts on them

  // Hands every condition of an element, at y, to act(term, condition). An absent term is one branch.
  template <class Act>
  void conditions(const Element& element, const Vecs<Y>& y, const Act& act) const {
    for_each_term([&](const auto& term) {
      if (term) term->conditions(element, y, act);
    });
  }

  template <class T>
  static constexpr bool lists = (std::is_same_v<T, Terms> || ...);
  template <class T>
  std::optional<T>& term() {
    return TermSlot<T>::term;
  }
  template <class T>
  const std::optional<T>& term() const {
    return TermSlot<T>::term;
  }

  // Hands every slot of the list, filled or empty, to act(term).
  template <class Act>
  void for_each_term(const Act& act) {
    (act(TermSlot<Terms>::term), ...);
  }
  template <class Act>
  void for_each_term(const Act& act) const {
    (act(TermSlot<Terms>::term), ...);
  }

  bool acts() const { return (TermSlot<Terms>::term.has_value() || ...); }
};
