// Bending costs nothing where a scene does not name it: step 5 is then step 4, to the last bit, with as
// many blocks, iterations, allocations and bytes.
//
// The linker hands every malloc of this program to the counter below, those of Eigen and of operator new
// among them.
#include <gtest/gtest.h>

#include <cstdlib>
#include <new>

#include "momenta.h"
#include "step04_cg/time_step.h"
#include "step05_bend/time_step.h"

namespace {
long allocations = 0;
size_t bytes = 0;
}  // namespace

extern "C" {
void* __real_malloc(size_t size);
void* __wrap_malloc(size_t size) {
  ++allocations;
  bytes += size;
  return __real_malloc(size);
}
}

// Not inlined: g++ would see free() meet the new of the library, and warn.
[[gnu::noinline]] void* operator new(std::size_t size) {
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

namespace {

// All that can be told of a run.
struct Outcome {
  State state;
  size_t blocks;
  long allocations, iterations, indefinite, capped, unconverged;
  size_t bytes;
};

template <class System, class TimeStep>
Outcome run(const Mesh& mesh, const Model& model, State state, const Method& method,
            const TimeStep& time_step) {
  const long allocations_before = allocations;
  const size_t bytes_before = bytes;
  Cloth cloth = make_cloth(mesh, model);
  System system(cloth, method);
  for (int i = 0; i < 20; ++i) time_step(cloth, 0.01, state, system);
  return {state,
          system.A.diagonal.size() + system.A.upper.size(),
          allocations - allocations_before,
          system.iterations,
          system.indefinite,
          system.capped,
          system.unconverged,
          bytes - bytes_before};
}

void step4(Cloth& cloth, double h, State& state, step04::System& system) {
  step04::time_step(cloth, h, state, system);
}

struct Options {
  const char* name;
  const char* preconditioner;
  Jacobian jacobian;
  int newton;
};
void PrintTo(const Options& o, std::ostream* out) {
  *out << o.name;
}

class BendAbsent : public testing::TestWithParam<Options> {
 protected:
  // A damped sheet that falls, held by a corner, a moving vertex and a rail.
  Mesh mesh = make_grid({1, 1}, {12, 12}, Diagonals::alternating);
  State start{mesh.x, VecX::Zero(mesh.x.size())};
  Model scene() const {
    Model m = model(1000, 500, Gravity::on);
    m.stretch->kd = m.shear->kd = 0.01;
    m.pins = {0, Pin(12, Mat3::Zero(), Vec3(0, 0.1, 0)),
              Pin(84, Mat3::Identity() - Vec3::UnitY() * Vec3::UnitY().transpose())};
    return m;
  }
  Method method() const {
    Method m;
    m.preconditioner = GetParam().preconditioner;
    m.jacobian = GetParam().jacobian;
    m.newton = GetParam().newton;
    return m;
  }
};
INSTANTIATE_TEST_SUITE_P(Ways, BendAbsent,
                         testing::Values(Options{"None", "none", Jacobian::definite, 1},
                                         Options{"Jacobi", "jacobi", Jacobian::definite, 1},
                                         Options{"Block", "block", Jacobian::definite, 1},
                                         Options{"Ic", "ic", Jacobian::definite, 1},
                                         Options{"Multigrid", "multigrid", Jacobian::definite, 1},
                                         Options{"Bw98", "block", Jacobian::bw98, 1},
                                         Options{"Newton", "block", Jacobian::definite, 5},
                                         Options{"NewtonMultigrid", "multigrid", Jacobian::bw98,
                                                 5}),
                         [](const auto& test) { return std::string(test.param.name); });

TEST_P(BendAbsent, Step05IsStep04) {
  const Outcome four = run<step04::System>(mesh, scene(), start, method(), step4);
  const Outcome five = run<step05::System>(mesh, scene(), start, method(), step05::time_step);
  EXPECT_TRUE(five.state.x == four.state.x);
  EXPECT_TRUE(five.state.v == four.state.v);
  EXPECT_NE(four.state.x, start.x);
  EXPECT_EQ(five.blocks, four.blocks);
  EXPECT_EQ(five.iterations, four.iterations);
  EXPECT_EQ(five.indefinite, four.indefinite);
  EXPECT_EQ(five.capped, four.capped);
  EXPECT_EQ(five.unconverged, four.unconverged);
  EXPECT_EQ(five.allocations, four.allocations);
  EXPECT_EQ(five.bytes, four.bytes);
  std::printf("%zu blocks, %ld iterations, %ld allocations, %zu bytes\n", five.blocks,
              five.iterations, five.allocations, five.bytes);
}

// With bending the same counts are others: they do count.
TEST_P(BendAbsent, IsSeenWhereItIsNot) {
  Model bent = scene();
  bent.bend = Term{"bend", 0};
  const Outcome without = run<step05::System>(mesh, scene(), start, method(), step05::time_step);
  const Outcome with = run<step05::System>(mesh, bent, start, method(), step05::time_step);
  EXPECT_GT(with.blocks, without.blocks);
  EXPECT_GT(with.allocations, without.allocations);
  EXPECT_GT(with.bytes, without.bytes + 6 * sizeof(Mat3) * size_t(mesh.vertices()));
}

}  // namespace
