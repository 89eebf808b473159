// Meshes: grids, OBJ files with seams, refusals, masses, and files that are read back bit for bit.
#include <cstring>
#include <set>

#include "scene/make_cloth.h"
#include "scene/memory.h"
#include "scene/velocities.h"
#include "support/scene_files.h"
#include "text/text_file.h"

namespace mesh_test {

using MeshTest = SceneFiles;

double rest_area(const Mesh& mesh) {
  double area = 0;
  for (size_t face = 0; face < mesh.faces.size(); ++face) area += make_triangle(mesh, face).area;
  return area;
}

double total_mass(const Cloth& cloth) {
  return cloth.mass.sum() / 3;
}

double signed_area(const std::array<Vec2, 3>& uv) {
  const Vec2 a = uv[1] - uv[0], b = uv[2] - uv[0];
  return 0.5 * (a.x() * b.y() - a.y() * b.x());
}

Vec3 normal(const Mesh& mesh, const Face& f) {
  const Vec3 x0 = mesh.x.segment<3>(3 * f[0]);
  return Vec3(mesh.x.segment<3>(3 * f[1]) - x0).cross(Vec3(mesh.x.segment<3>(3 * f[2]) - x0));
}

TEST_F(MeshTest, AGridIsNumberedRowByRowFromTheBottomLeft) {
  const Mesh grid = make_grid({3, 8}, {3, 4}, Diagonals::same);
  ASSERT_EQ(grid.vertices(), 20);
  for (int j = 0; j <= 4; ++j)
    for (int i = 0; i <= 3; ++i)
      EXPECT_EQ(grid.x.segment<3>(3 * (4 * j + i)), Vec3(i, 0, -2.0 * j)) << i << ", " << j;
  EXPECT_EQ(grid.faces.size(), 24u);
}

TEST_F(MeshTest, TheTwoDiagonalsAreThoseOfTheDrawing) {
  const Mesh same = make_grid({2, 1}, {2, 1}, Diagonals::same);
  EXPECT_EQ(same.faces, (std::vector<Face>{{0, 1, 3}, {4, 3, 1}, {1, 2, 4}, {5, 4, 2}}));
  const Mesh alternating = make_grid({2, 2}, {2, 2}, Diagonals::alternating);
  EXPECT_EQ(
      alternating.faces,
      (std::vector<Face>{
          {0, 1, 3}, {4, 3, 1}, {1, 2, 5}, {1, 5, 4}, {3, 4, 7}, {3, 7, 6}, {4, 5, 7}, {8, 7, 5}}));
}

TEST_F(MeshTest, EveryTriangleOfAGridShowsItsFrontUpwardsAndTurnsWithUAndV) {
  const Mesh grid = make_grid({1, 2}, {3, 4}, Diagonals::alternating);
  for (size_t face = 0; face < grid.faces.size(); ++face) {
    EXPECT_GT(normal(grid, grid.faces[face]).y(), 0);
    EXPECT_GT(signed_area(grid.rest[face]), 0);
    const Triangle t = make_triangle(grid, face);
    const Vecs<2> w = gather(t, grid.x);
    EXPECT_LT((w[0] - Vec3(1, 0, 0)).norm() + (w[1] - Vec3(0, 0, -1)).norm(), 1e-14);
  }
}

TEST_F(MeshTest, RestAreasAndMassesAddUpToThoseOfTheSheet) {
  for (const Diagonals d : {Diagonals::same, Diagonals::alternating}) {
    const Mesh grid = make_grid({0.7, 1.3}, {7, 11}, d);
    const Cloth cloth = make_cloth(grid, {.density = 0.2, .pins = {3}});
    EXPECT_NEAR(rest_area(grid), 0.7 * 1.3, 1e-14);
    EXPECT_NEAR(total_mass(cloth), 0.2 * 0.7 * 1.3, 1e-15);
    for (int c = 0; c < cloth.mass.size(); ++c)
      EXPECT_EQ(cloth.inverse_mass[c], c / 3 == 3 ? 0 : 1 / cloth.mass[c]);
  }
}

TEST_F(MeshTest, AClothHasTrianglesOnlyForStretchOrShear) {
  const Mesh grid = make_grid({1, 1}, {2, 2}, Diagonals::same);
  EXPECT_TRUE(make_cloth(grid, {}).triangles.elements.empty());
  EXPECT_EQ(make_cloth(grid, Model().add(StretchTerm(1))).triangles.elements.size(), 8u);
  EXPECT_EQ(make_cloth(grid, Model().add(ShearTerm(1))).triangles.elements.size(), 8u);
}

TEST_F(MeshTest, AGridBeyondMemoryIsRefusedBeforeAnythingIsAllocated) {
  expect_says(message([] {
                make_grid({1, 1}, {2147483647, 2147483647}, Diagonals::same);
              }),
              {"2147483647 x 2147483647 cells", "MB", "fewer"});
  EXPECT_FALSE(too_large({40, 40}));
  const Mesh grid = make_grid({1, 1}, {40, 40}, Diagonals::same);
  const Cloth cloth = make_cloth(grid, Model().add(StretchTerm(1)));
  const size_t bytes =
      grid.faces.size() * (sizeof(Face) + sizeof(grid.rest[0]) + sizeof(Triangle)) +
      sizeof(double) * size_t(5 * grid.x.size());
  EXPECT_EQ(bytes_of_grid({40, 40}), double(bytes));
  EXPECT_EQ(cloth.triangles.elements.capacity(), grid.faces.size());
}

// Two triangles on an edge that is a seam: its vertices have other (u, v) on the other side.
const std::string seam =
    "mtllib none.mtl\r\no shirt\n# a comment\n\nv 0 0 0\nv 1 0 0 1 0 0\nv 0 1 0\n  v\t1 1 1e0\n"
    "vn 0 0 1\nvt 0 0\nvt 1 0\nvt +0 1 0\nvt 5 5\nvt 6 5\nvt 6 6\n"
    "g front\ns 1\nusemtl red\nf 1/1/1 2/2/1 3/3/1\ng back\nf -3/-2 -1/-1 -2/-3\n";

TEST_F(MeshTest, TextureCoordinatesBelongToFaceCornersSoThatSeamsKeepBothSides) {
  const Mesh mesh = read_obj(write("seam.obj", seam));
  EXPECT_EQ(mesh.faces, (std::vector<Face>{{0, 1, 2}, {1, 3, 2}}));
  EXPECT_EQ(mesh.rest[0], (std::array{Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)}));
  EXPECT_EQ(mesh.rest[1], (std::array{Vec2(6, 5), Vec2(6, 6), Vec2(5, 5)}));
  EXPECT_EQ(mesh.x.segment<3>(9), Vec3(1, 1, 1));
}

TEST_F(MeshTest, WithoutTextureCoordinatesTheRestShapeIsTheTriangleItselfLaidFlat) {
  const Mesh mesh =
      read_obj(write("m.obj", "v 1 1 1\nv 1 4 1\nv 1 1 5\nv 2 2 9\nf 1 2 3\nf 1//1 3//1 4//1"));
  EXPECT_EQ(mesh.rest[0], (std::array{Vec2(0, 0), Vec2(3, 0), Vec2(0, 4)}));
  for (size_t face = 0; face < 2; ++face) {
    const Vecs<2> w = gather(make_triangle(mesh, face), mesh.x);
    EXPECT_NEAR(w[0].norm(), 1, 1e-15);
    EXPECT_NEAR(w[1].norm(), 1, 1e-15);
    EXPECT_NEAR(w[0].dot(w[1]), 0, 1e-15);
  }
}

// tinyobjloader's numbers may be off in the last digit.
constexpr double last_digit = 2e-15;

void expect_same_rest(const Mesh& a, const Mesh& b) {
  ASSERT_EQ(a.rest.size(), b.rest.size());
  for (size_t f = 0; f < a.rest.size(); ++f)
    for (size_t c = 0; c < 3; ++c)
      EXPECT_LE((a.rest[f][c] - b.rest[f][c]).norm(), last_digit * b.rest[f][c].norm())
          << "face " << f;
}

TEST_F(MeshTest, AnObjFileComesBackToTheLastDigit) {
  const Mesh mesh = read_obj(write("seam.obj", seam));
  const VecX x = VecX::Random(12).array() * 1e-3 + 1.0 / 3;
  write_obj(directory / "out.obj", mesh, x);
  const Mesh back = read_obj(directory / "out.obj");
  EXPECT_LE((back.x - x).cwiseAbs().maxCoeff(), last_digit);
  EXPECT_EQ(back.faces, mesh.faces);
  expect_same_rest(back, mesh);
  EXPECT_FALSE(std::filesystem::exists(directory / "out.obj.part"));

  const Mesh grid = make_grid({0.1, 0.3}, {3, 7}, Diagonals::alternating);
  write_obj(directory / "grid.obj", grid, grid.x);
  const std::string text = read_text(directory / "grid.obj");
  expect_same_rest(read_obj(directory / "grid.obj"), grid);
  size_t vt = 0;
  for (size_t at = 0; (at = text.find("\nvt ", at)) != text.npos; ++at) ++vt;
  EXPECT_EQ(vt, 32u) << "one per vertex where there is no seam";
}

TEST_F(MeshTest, VelocitiesComeBackBitForBit) {
  VecX v = VecX::Random(30) / 3;
  v.head<4>() << 5e-324, -1.7976931348623157e308, -0.0, 0.1;
  write_velocities(directory / "v.csv", v);
  const VecX back = read_velocities(directory / "v.csv", 10);
  EXPECT_EQ(std::memcmp(back.data(), v.data(), 30 * sizeof(double)), 0);
}

TEST_F(MeshTest, AFileThatCannotBeWrittenLeavesNothingAndSaysWhy) {
  const auto why = [](const std::filesystem::path& path) -> std::string {
    try {
      write_text(path, "text");
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "written";
  };
  std::filesystem::create_directory(directory / "d");
  expect_says(why(directory / "none" / "a"), {"cannot write", "none/a: No such file or directory"});
  expect_says(why(directory / "d"), {"cannot write", "/d: Is a directory"});
  EXPECT_FALSE(std::filesystem::exists(directory / "d.part"));
  std::filesystem::create_symlink("/dev/full", directory / "full.part");
  expect_says(why(directory / "full"), {"full: No space left on device"});
  EXPECT_FALSE(std::filesystem::exists(directory / "full.part"));
  EXPECT_FALSE(std::filesystem::exists(directory / "full"));
}

// Ends of lines are LF, CR LF or CR. A comment may stand behind data. Other lines are skipped.
TEST_F(MeshTest, OneReaderDecidesWhatALineIs) {
  const std::string v = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n", faces = "f 1 2 3\nf 2 4 3\n";
  const Mesh plain = read_obj(write("plain.obj", v + faces));
  std::string returns = "# vertices\n" + v + faces;
  std::replace(returns.begin(), returns.end(), '\n', '\r');
  const std::string one = "1" + std::string(400, '0') + "e-400";
  for (const std::string& text :
       {returns, v + "f 1 2 3# 4\nf 2 4 3 # 99999999 9 9", v + "f 1//0 2//0 3//0\nf 2 4 3",
        v + "l -99 0\nvw 0 1e308 1\np 77\n" + faces,
        "v 0 0 0\nv " + one + " 0 0\nv 0 1 0\nv 1 1 0\n" + faces}) {
    const Mesh mesh = read_obj(write("m.obj", text));
    EXPECT_EQ(mesh.faces, plain.faces) << text;
    EXPECT_EQ(mesh.x, plain.x) << text;
  }
}

struct BadObj {
  std::string text, said, valid;
};

TEST_F(MeshTest, WhatIsNoMeshOfTrianglesIsRefusedWithFileLineAndReason) {
  const std::string v = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 1 1 1\n";  // five lines
  const BadObj bad_objs[] = {
      {"", "m.obj: no faces", "triangles"},
      {v, "m.obj: no faces", "triangles"},
      {v + "f 1 2 3 4", "m.obj:6: ", "a triangle"},
      {v + "f 1 2", "m.obj:6: ", "a triangle"},
      {v + "f 1 2 x", "m.obj:6: ", "a triangle"},
      {v + "f 1 2 3x", "m.obj:6: ", "a triangle"},
      {v + "f 1 2 1-3", "m.obj:6: ", "a triangle"},
      {v + "f 1 2 99999999999", "m.obj:6: ", "a triangle"},
      {v + "f 1 2 3/", "m.obj:6: ", "a triangle"},
      {v + "f 1 2 3\nf 1 2 6", "m.obj:7: the face names a vertex that does not", "1 to 5"},
      {v + "f 1 2 0", "m.obj:6: the face names a vertex that does not exist", "1 to 5"},
      {v + "f 1 2 -6", "m.obj:6: the face names a vertex that does not exist", "1 to 5"},
      {v + "f 1/1 2/1 3/1", "m.obj:6: the face names a texture coordinate", "has none"},
      {v + "vt 0 0\nf 1/1 2/1 3/2", "m.obj:7: the face names a texture coordinate", "1 to 1"},
      {v + "vt 0 0\nf 1/-2 2/-2 3/-2", "m.obj:7: the face names a texture", "1 to 1"},
      {v + "vt 0 0\nf 1/1 2 3", "m.obj:7: ", "some corners only; all three"},
      {v + "v 0 0\n", "m.obj:6: ", "three finite numbers"},
      {v + "v nan 0 0\n", "m.obj:6: ", "three finite numbers"},
      {v + "v 0 inf 0\n", "m.obj:6: ", "three finite numbers"},
      {v + "v 0 1e400 0\n", "m.obj:6: ", "three finite numbers"},
      {v + "v 0 0 0m\n", "m.obj:6: ", "three finite numbers"},
      {v + "v 0 +-1 0\n", "m.obj:6: ", "three finite numbers"},
      {v + "# x\rf 1 2 9\n", "m.obj:7: the face names a vertex that does not", "1 to 5"},
      {v + "f 1 2 3# 4\nf 1 2 3 4 # 5", "m.obj:7: ", "a triangle"},
      {"\xEF\xBB\xBF" + v + "f 1 2 3", "m.obj:1: ", "byte order mark"},
      {v + "vt 0 nan\n", "m.obj:6: ", "two finite numbers"},
      {v + "f 1 2 2", "m.obj: face 0 (vertices 0, 1, 1", "three different"},
      {v + "v 2 0 0\nf 1 2 3\nf 1 2 6", "m.obj: face 1 (vertices 0, 1, 5", "no area"},
      {v + "v 0 0 0\nf 1 6 3", "m.obj: face 0 (vertices 0, 5, 2", "no area"},
      {v + "vt 0 0\nvt 1 1\nvt 3 3\nf 1/1 2/2 3/3", "m.obj: face 0", "no area"},
      {v + "f 1 2 3\nf 1 2 4\nf 2 1 5", "m.obj: the edge between vertices 0 and 1", "one or two"},
      {v + "f 1 2 3\nf 1 2 4", "m.obj: vertex 4", "no mass"},
  };
  for (const BadObj& bad : bad_objs)
    expect_says(message([&] { read_obj(write("m.obj", bad.text)); }), {bad.said, bad.valid});
}

TEST_F(MeshTest, ASliverIsRefusedByItsShapeAndNotByItsSize) {
  EXPECT_TRUE(has_area({Vec2(0, 0), Vec2(1e-9, 0), Vec2(0, 1e-9)}));
  EXPECT_TRUE(has_area({Vec2(0, 0), Vec2(1, 0), Vec2(0.5, 1e-11)}));
  EXPECT_FALSE(has_area({Vec2(0, 0), Vec2(1, 0), Vec2(0.5, 1e-12)}));
  EXPECT_FALSE(has_area({Vec2(0, 0), Vec2(1e9, 0), Vec2(5e8, 1e-4)}));
  EXPECT_FALSE(has_area({Vec2(0, 0), Vec2(0, 0), Vec2(0, 0)}));
}

// Garments with seams. They lie beside the source tree; without them these tests are skipped.
class Garment : public SceneFiles, public testing::WithParamInterface<const char*> {};

TEST_P(Garment, HasTheMassOfItsPatternAndComesBackToTheLastDigit) {
  const std::filesystem::path path =
      std::filesystem::path(__FILE__).parent_path() / "../../../shared/meshes" / GetParam();
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " does not exist";
  const Mesh mesh = read_obj(path);
  double area = 0;
  std::set<std::array<double, 3>> places;
  for (size_t face = 0; face < mesh.faces.size(); ++face) {
    area += std::abs(signed_area(mesh.rest[face]));
    for (size_t c = 0; c < 3; ++c)
      places.insert({double(mesh.faces[face][c]), mesh.rest[face][c].x(), mesh.rest[face][c].y()});
  }
  EXPECT_GT(int(places.size()), mesh.vertices()) << "a seam vertex has several rest positions";
  EXPECT_NEAR(total_mass(make_cloth(mesh, {.density = 0.2})), 0.2 * area, 1e-12);
  write_obj(directory / "out.obj", mesh, mesh.x);
  EXPECT_LE((read_obj(directory / "out.obj").x - mesh.x).cwiseAbs().maxCoeff(), last_digit);
  expect_same_rest(read_obj(directory / "out.obj"), mesh);
}

INSTANTIATE_TEST_SUITE_P(Of, Garment, testing::Values("tshirt.obj", "pants3.obj"));

}  // namespace mesh_test
