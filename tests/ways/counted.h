// The matrix and the energy of the steps, with counters in every function that moves data.
// `counting` points to the counts of this thread.
#pragma once
#include "math/energy.h"
#include "math/pattern.h"
#include "ways/simulator.h"

inline thread_local Counts* counting = nullptr;

class CountInto {
 public:
  explicit CountInto(Counts& counts) : before(counting) { counting = &counts; }
  ~CountInto() { counting = before; }
  CountInto(const CountInto&) = delete;

 private:
  Counts* before;
};

struct CountedMatrix : BlockMatrix {
  CountedMatrix() = default;
  CountedMatrix(const BlockMatrix& A) : BlockMatrix(A) {}
  CountedMatrix(const CountedMatrix&) = default;
  CountedMatrix& operator=(const CountedMatrix& A) {
    counting->bytes += 2 * A.stored();
    BlockMatrix::operator=(A);
    return *this;
  }

  void set_zero() {
    counting->bytes += stored();
    BlockMatrix::set_zero();
  }
  void set_diagonal(const VecX& d) {
    ++counting->assemblies;
    counting->bytes += stored() + vector();
    BlockMatrix::set_diagonal(d);
  }
  void add(double factor, const BlockMatrix& B) {
    if (!B.empty()) counting->bytes += 3 * stored();  // reads both, writes one
    BlockMatrix::add(factor, B);
  }
  void multiply(const VecX& p, VecX& Ap) const {
    count_product(3);
    BlockMatrix::multiply(p, Ap);
  }
  void add_product(double factor, const VecX& p, VecX& y) const {
    count_product(3);
    BlockMatrix::add_product(factor, p, y);
  }
  double form(const VecX& p) const {
    count_product(1);
    return BlockMatrix::form(p);
  }

 private:
  void count_product(int vectors) const {
    if (empty()) return;
    ++counting->products;
    counting->bytes += stored() + long(sizeof(int) * column.size()) + vectors * vector();
  }
  long stored() const { return long(sizeof(Mat3) * (diagonal.size() + upper.size())); }
  long vector() const { return long(sizeof(Vec3) * diagonal.size()); }
};

struct CountedEnergy : LastEnergy {
  using LastEnergy::LastEnergy;

  template <class Positions>
  double at(const Cloth& cloth, const Positions& positions) {
    if (x != positions) count(cloth);
    return LastEnergy::at(cloth, positions);
  }

 private:
  static void count(const Cloth& cloth) {
    ++counting->energies;
    for_each_family(cloth, [](const auto& family) {
      for (const auto& element : family.elements)
        counting->bytes += long(sizeof element + sizeof(Vec3) * element.vertices.size());
    });
  }
};

// The bytes of one evaluation of all forces, and of K and D if the step has them. Every
// element is read, with the positions and velocities of its vertices. Its forces and blocks
// are added to the sums in memory.
inline long bytes_of_forces(const Cloth& cloth, bool velocities, int matrices) {
  long bytes = long(sizeof(double)) * cloth.mass.size();  // f = 0
  if (cloth.gravity) bytes += 3 * long(sizeof(double)) * cloth.mass.size();
  for_each_family(cloth, [&](const auto& family) {
    for (const auto& element : family.elements) {
      const long N = long(element.vertices.size());
      bytes += long(sizeof element) + N * (velocities ? 4 : 3) * long(sizeof(Vec3)) +
               matrices * N * (N + 1) / 2 * 2 * long(sizeof(Mat3));
    }
  });
  return bytes;
}
