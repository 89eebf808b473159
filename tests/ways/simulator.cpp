#include "ways/simulator.h"

#include <stdexcept>
#include <string>

#include "math/direct_solver.h"
#include "math/preconditioner.h"
#include "math/stable_step.h"
#include "ways/counted.h"
#include "ways/vbd.h"
#include "ways/xpbd.h"

// The steps unchanged, but with matrices and energies that count, and in namespaces of their own.
#define BlockMatrix CountedMatrix
#define LastEnergy CountedEnergy
#define step01 counted_step01
#define step02 counted_step02
#define step03 counted_step03
#define step04 counted_step04
#define step05 counted_step05
#include "step01_explicit/time_step.h"
#include "step02_damping/time_step.h"
#include "step03_implicit/time_step.h"
#include "step04_cg/time_step.h"
#include "step05_bend/time_step.h"

namespace {

// Steps 1 and 2: the cost of a step is known beforehand.
template <class System, class TimeStep, class Forces>
class Explicit : public Simulator {
 public:
  Explicit(Cloth& cloth_, bool velocities, TimeStep time_step_, Forces forces_)
      : cloth(cloth_), system(cloth), time_step(time_step_), evaluate(forces_),
        bytes(bytes_of_forces(cloth, velocities, 0) + update()) {}

  void step(double h, State& state) override {
    time_step(cloth, h, state, system);
    ++counted.forces;
    counted.bytes += bytes;
  }
  const VecX& forces(const State& state) override {
    evaluate(cloth, state, system);
    return system.f;
  }
  Counts counts() const override { return counted; }

 private:
  // v += h M⁻¹ f and x += h v read five vectors and write two.
  long update() const { return 7 * long(sizeof(double)) * cloth.mass.size(); }

  Cloth& cloth;
  System system;
  TimeStep time_step;
  Forces evaluate;
  long bytes;
  Counts counted;
};

// Steps 3 to 5.
template <class System, class TimeStep, class Forces>
class Implicit : public Simulator {
 public:
  Implicit(Cloth& cloth_, const Method& method, TimeStep time_step_, Forces forces_)
      : cloth(cloth_), system(cloth, method), time_step(time_step_), evaluate(forces_),
        bytes(bytes_of_forces(cloth, true, system.D.empty() ? 1 : 2)) {}

  void step(double h, State& state) override {
    const CountInto here(counted);
    time_step(cloth, h, state, system);
  }
  const VecX& forces(const State& state) override {
    Counts aside;
    const CountInto there(aside);
    evaluate(cloth, state, system);
    return system.f;
  }

  // Every system needs one evaluation of the forces. An iteration of conjugate gradients
  // passes over 17 vectors, without those of the product. The rest of a system, b and the
  // changes of v and x, passes over 10.
  Counts counts() const override {
    Counts all = counted;
    all.forces = counted.assemblies;
    all.indefinite = system.counts.indefinite;
    all.redone = system.counts.redone;
    all.unconverged = system.counts.unconverged;
    all.iterations = system.counts.iterations;
    all.capped = system.counts.capped;
    const long vector = long(sizeof(double)) * cloth.mass.size();
    all.bytes += all.forces * (bytes + 10 * vector) + all.iterations * 17 * vector;
    return all;
  }

 private:
  Cloth& cloth;
  System system;
  TimeStep time_step;
  Forces evaluate;
  long bytes;
  Counts counted;
};

// XPBD and VBD. Every read of an element takes its bytes, and at each of its corners those of `per_corner`.
template <class System, class TimeStep>
class Sweeping : public Simulator {
 public:
  Sweeping(Cloth& cloth_, int sweeps, TimeStep time_step_, long per_corner_)
      : cloth(cloth_), system(cloth, sweeps), time_step(time_step_), per_corner(per_corner_) {
    if (sweeps < 1) throw std::invalid_argument("XPBD and VBD take one sweep per step or more");
  }

  void step(double h, State& state) override {
    time_step(cloth, h, state, system);
    ++steps;
  }
  const VecX& forces(const State& state) override {
    follow(cloth.hinges.elements, state.x);
    ::forces(cloth, state, f);
    return f;
  }

  // x̃ and v = (x − x0)/h read six vectors and write three.
  Counts counts() const override {
    long elements = 0, bytes = 0;
    for_each_family(cloth, [&](const auto& family) {
      for (const auto& element : family.elements) {
        ++elements;
        bytes += long(sizeof element) + long(element.vertices.size()) * per_corner;
      }
    });
    Counts all;
    all.iterations = steps * system.sweeps;
    all.bytes = steps * 9 * long(sizeof(double)) * cloth.mass.size();
    if (elements == 0) return all;
    all.forces = system.reads.forces / elements;
    all.energies = system.reads.energies / elements;
    all.bytes += (system.reads.forces + system.reads.energies) * bytes / elements;
    return all;
  }

 private:
  Cloth& cloth;
  System system;
  TimeStep time_step;
  long per_corner, steps = 0;
  VecX f;
};

template <class System, class TimeStep>
std::unique_ptr<Simulator> make_sweeping(Cloth& cloth, int sweeps, TimeStep step, long per_corner) {
  return std::make_unique<Sweeping<System, TimeStep>>(cloth, sweeps, step, per_corner);
}

template <class System, class TimeStep, class Forces>
std::unique_ptr<Simulator> make_explicit(Cloth& cloth, bool velocities, TimeStep step,
                                         Forces forces) {
  return std::make_unique<Explicit<System, TimeStep, Forces>>(cloth, velocities, step, forces);
}

template <class System, class TimeStep, class Forces>
std::unique_ptr<Simulator> make_implicit(Cloth& cloth, const Method& method, TimeStep step,
                                         Forces forces) {
  Counts aside;
  const CountInto there(aside);
  return std::make_unique<Implicit<System, TimeStep, Forces>>(cloth, method, step, forces);
}

std::unique_ptr<Simulator> make_step(const Configuration& configuration, Cloth& cloth) {
  switch (configuration.step) {
    case 1:
      return make_explicit<step01::System>(cloth, false, step01::time_step, step01::forces);
    case 2:
      return make_explicit<step02::System>(cloth, true, step02::time_step, step02::forces);
    case 3:
      return make_implicit<step03::System>(cloth, configuration.method, step03::time_step,
                                           step03::forces);
    case 4:
      return make_implicit<step04::System>(cloth, configuration.method, step04::time_step,
                                           step04::forces);
    case 5:
      return make_implicit<step05::System>(cloth, configuration.method, step05::time_step,
                                           step05::forces);
    default:
      throw std::invalid_argument("there is no step " + std::to_string(configuration.step));
  }
}

}  // namespace

// XPBD reads x, x0, S and 1/m of a corner, and writes x. VBD reads x, x0 and the place of the corner.
std::unique_ptr<Simulator> make_simulator(const Configuration& configuration, Cloth& cloth) {
  constexpr long vector = sizeof(Vec3), matrix = sizeof(Mat3), number = sizeof(double);
  switch (configuration.scheme) {
    case Scheme::xpbd:
      return make_sweeping<xpbd::System>(cloth, configuration.sweeps, xpbd::time_step,
                                         3 * vector + matrix + number);
    case Scheme::vbd:
      return make_sweeping<vbd::System>(cloth, configuration.sweeps, vbd::time_step,
                                        2 * vector + long(sizeof(vbd::System::Corner)));
    default:
      return make_step(configuration, cloth);
  }
}

double critical_step(Simulator& simulator, const Cloth& cloth, const State& state) {
  return critical_step(cloth, state,
                       [&](const State& at) -> const VecX& { return simulator.forces(at); });
}
