// --explain: what a scene contains, what a step costs, what sets h, how large the error is and what
// could be left out. All of it is measured on the step's own functions, and printed on one page.
#pragma once
#include <functional>
#include <memory>

#include "explain/time_budget.h"
#include "math/counters.h"
#include "math/pattern.h"
#include "program/options.h"
#include "scene/scene.h"

// What a step's System takes, in bytes.
struct Memory {
  size_t vectors = 0;
  size_t matrices = 0;  // blocks and their pattern; a preconditioner or a factor is not counted
  size_t slots = 0;     // where the elements lie in the matrices
};

// A step on one cloth, without its types: --explain runs it, and runs it again without a term.
struct Simulation {
  std::function<void(double h, State&)> step;
  std::function<const VecX&(const State&)> forces;  // N
  std::function<Counters()> counters;
  std::function<Memory()> memory;
};
using Simulate = std::function<Simulation(const Cloth&, const Method&)>;

// Prints the page and returns 0; writes nothing else. The page says at its start how long it will
// take, and names what it did not measure because the time was over. Throws std::invalid_argument
// for a method that cannot solve this scene.
int explain(const Options&, const Scene&, const Simulate&, const TimeBudget& = TimeBudget(20));

template <class... Lists>
size_t bytes_in(const Lists&... lists) {
  return (size_t(0) + ... + (sizeof(*lists.data()) * size_t(lists.size())));
}

inline size_t bytes_of(const BlockMatrix& A) {
  return bytes_in(A.diagonal, A.upper, A.row_start, A.column);
}

// A System's own lists, by the names that they have in every step.
template <class System>
Memory memory_of(const System& s) {
  Memory memory;
  memory.vectors = bytes_in(s.f);
  if constexpr (requires { s.K; }) {
    memory.vectors +=
        bytes_in(s.b, s.dv, s.v, s.z, s.start.x, s.start.v, s.trial.x, s.trial.v, s.E.x);
    memory.matrices = bytes_of(s.K) + bytes_of(s.D) + bytes_of(s.A) + bytes_of(s.D_start);
    memory.slots = s.slots.bytes();
  }
  if constexpr (requires { s.preconditioner; }) memory.vectors += bytes_in(s.r, s.c, s.q, s.s);
  return memory;
}

template <class System>
Counters counters_of(const System& s) {
  if constexpr (requires { s.counts; }) return s.counts;
  return {};
}

template <class System>
System make_system(const Cloth& cloth, const Method& method) {
  if constexpr (std::is_constructible_v<System, const Cloth&, const Method&>)
    return System(cloth, method);
  else
    return System(cloth);
}

// The same for a step's System, time_step and forces.
template <class System, class TimeStep, class Forces>
int explain(const Options& options, const Scene& scene, TimeStep* time_step, Forces* forces) {
  return explain(options, scene, [=](const Cloth& of, const Method& method) -> Simulation {
    const auto cloth = std::make_shared<Cloth>(of);
    const auto system = std::make_shared<System>(make_system<System>(of, method));
    return {.step = [=](double h, State& state) { time_step(*cloth, h, state, *system); },
            .forces = [=](const State& state) -> const VecX& {
              forces(*cloth, state, *system);
              return system->f;
            },
            .counters = [=] { return counters_of(*system); },
            .memory = [=] { return memory_of(*system); }};
  });
}
