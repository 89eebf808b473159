// Runs a scene that its arguments describe, and prints counts, time, positions and velocities. It is built
// once from the headers as they are, and once for each term from headers without the term (CMakeLists.txt).
//
//   run_full step=5 method=block steps=40 h=0.01 cells=12 gravity=9.81 stretch=1000 stretch.kd=0.02 bend=0
//
// A term without an argument is not modelled. The cloth is a square metre that starts folded, sheared and
// spinning. One corner is held. From step 4 on another corner is pulled, and the middle slides on a rail.
#include <bit>
#include <cinttypes>
#include <cstdio>
#include <map>
#include <stdexcept>
#include <string>

#include "absent/counted.h"
#include "scene/make_cloth.cpp"  // a part of this program, so that terms are cut from it, too
#include "step05_bend/time_step.h"
#include "support/cpu_time.h"
#ifdef LARGE_STEPS_2_AND_3
#include "step02_damping/time_step.h"
#include "step03_implicit/time_step.h"
#endif

namespace {

// name=value, as on the command line.
class Arguments {
 public:
  Arguments(int argc, char** argv) {
    for (int i = 1; i < argc; ++i) {
      const std::string argument = argv[i];
      const size_t equals = argument.find('=');
      if (equals == std::string::npos) throw std::invalid_argument(argument + " is not name=value");
      values[argument.substr(0, equals)] = argument.substr(equals + 1);
    }
  }
  bool has(const std::string& name) const { return values.contains(name); }
  const std::string& text(const std::string& name) const {
    const auto found = values.find(name);
    if (found == values.end()) throw std::invalid_argument(name + "=value is missing");
    return found->second;
  }
  std::string text(const std::string& name, const std::string& absent) const {
    return has(name) ? text(name) : absent;
  }
  double number(const std::string& name) const { return std::stod(text(name)); }
  double number(const std::string& name, double absent) const {
    return has(name) ? number(name) : absent;
  }
  int whole(const std::string& name) const { return std::stoi(text(name)); }

 private:
  std::map<std::string, std::string> values;
};

std::vector<Pin> pins(int step, const Grid& grid) {
  const int right = grid.cells[0], middle = grid.vertex(right / 2, grid.cells[1] / 2);
  const Mat3 rail = Mat3::Identity() - Vec3::UnitY() * Vec3::UnitY().transpose();
  if (step < 4) return {0};
  return {0, Pin(right, Mat3::Zero(), Vec3(0, 0.1, 0)), Pin(middle, rail)};
}

Model make_model(const Arguments& arguments, const Grid& grid) {
  Model model;
  model.pins = pins(arguments.whole("step"), grid);
  if (arguments.has("gravity")) model.gravity = Vec3(0, -arguments.number("gravity"), 0);
  for_each_term(model, [&]<class T>(std::optional<T>& term) {
    const std::string table(T::info.table), chosen = arguments.text(table + ".model", "dihedral");
    if (arguments.has(table) && (T::info.model.empty() || T::info.model == chosen))
      term = T(arguments.number(table), arguments.number(table + ".kd", 0));
  });
  return model;
}

State thrown(const Mesh& mesh) {
  const Vec3 spin(1.5, 5, 3), centre(0.5, 0, -0.5), drift(0.3, -0.2, 0.5);
  State state{mesh.x, VecX::Zero(mesh.x.size())};
  for (int i = 1; i < mesh.vertices(); ++i) {
    const double u = mesh.x[3 * i], v = -mesh.x[3 * i + 2];
    state.x.segment<3>(3 * i) += Vec3(0.05 * v, 0.03 * std::sin(9 * u + 3 * v), 0);
    state.v.segment<3>(3 * i) = drift + spin.cross(Vec3(mesh.x.segment<3>(3 * i) - centre));
  }
  return state;
}

Method make_method(const Arguments& arguments) {
  Method method;
  method.solver = method.preconditioner = arguments.text("method");
  method.jacobian = arguments.number("bw98", 0) == 1 ? Jacobian::bw98 : Jacobian::definite;
  method.newton = int(arguments.number("newton", 1));
  method.tolerance = arguments.number("tolerance", method.tolerance);
  return method;
}

void print(const char* name, long count) {
  std::printf("%s %ld\n", name, count);
}
void print_blocks(const char* name, const BlockMatrix& matrix) {
  print(name, long(matrix.diagonal.size() + matrix.upper.size()));
}

template <class System>
void print_counts(const Cloth& cloth, const System& system) {
  print("triangles", long(cloth.triangles.elements.size()));
  print("springs", long(cloth.springs.elements.size() + cloth.bend_springs.elements.size()));
  print("hinges", long(cloth.hinges.elements.size() + cloth.quadratic_hinges.elements.size()));
  if constexpr (requires { system.A; }) {
    print_blocks("blocks", system.A);
    print("indefinite", system.counts.indefinite);
    print("unconverged", system.counts.unconverged);
    print("iterations", system.counts.iterations);
    print("capped", system.counts.capped);
  }
}

// Bit by bit, so that −0 is not 0.
void print_bits(const VecX& numbers) {
  for (const double number : numbers) std::printf("%" PRIu64 "\n", std::bit_cast<uint64_t>(number));
}

template <class System, class TimeStep>
void run(const Arguments& arguments, const TimeStep& time_step) {
  const int cells = arguments.whole("cells"), steps = arguments.whole("steps");
  const double h = arguments.number("h");
  const Mesh mesh = make_grid({1, 1}, {cells, cells}, Diagonals::alternating);
  const Model model = make_model(arguments, *mesh.grid);
  const Method method = make_method(arguments);
  State state = thrown(mesh);
  std::vector<double> times(steps);

  counted::allocations = counted::bytes = 0;
  Cloth cloth = make_cloth(mesh, model);
  System system = [&] {
    if constexpr (std::is_constructible_v<System, const Cloth&, const Method&>)
      return System(cloth, method);
    else
      return System(cloth);
  }();
  for (double& time : times) time = seconds([&] { time_step(cloth, h, state, system); });
  const long allocations = counted::allocations, bytes = counted::bytes;

  print("allocations", allocations);
  print("bytes", bytes);
  print_counts(cloth, system);
  std::printf("microseconds %.3f\n", 1e6 * median(times));
  print_bits(state.x);
  print_bits(state.v);
}

void run_step(const Arguments& arguments) {
  const int step = arguments.whole("step");
  if (step == 5) return run<step05::System>(arguments, [](auto&... a) { step05::time_step(a...); });
#ifdef LARGE_STEPS_2_AND_3
  if (step == 3) return run<step03::System>(arguments, [](auto&... a) { step03::time_step(a...); });
  if (step == 2) return run<step02::System>(arguments, [](auto&... a) { step02::time_step(a...); });
#endif
  throw std::invalid_argument("step=" + arguments.text("step") + " is not in this program");
}

}  // namespace

int main(int argc, char** argv) try {
  run_step(Arguments(argc, argv));
} catch (const std::exception& e) {
  std::fprintf(stderr, "%s: %s\n", argv[0], e.what());
  return 2;
}
