// A garment whose seams give a vertex several places in the rest shape. The file lies beside the
// project; without it these tests are skipped.
#include <cmath>
#include <regex>
#include <sstream>

#include "support/program_runner.h"

namespace program_tshirt_test {

const std::filesystem::path shirt =
    std::filesystem::path(SOURCE_DIRECTORY) / "../shared/meshes/tshirt.obj";

// Read here without the project's own reader.
struct Shirt {
  std::vector<std::array<double, 3>> v;
  std::vector<std::array<double, 2>> vt;
  std::vector<std::array<std::array<int, 2>, 3>> f;  // corner: v, vt, from 0
};

Shirt read_shirt() {
  Shirt result;
  std::istringstream in(read_all(shirt));
  for (std::string line, word; std::getline(in, line);) {
    std::istringstream words(line);
    words >> word;
    if (word == "v") {
      auto& [x, y, z] = result.v.emplace_back();
      words >> x >> y >> z;
    } else if (word == "vt") {
      auto& [u, v] = result.vt.emplace_back();
      words >> u >> v;
    } else if (word == "f") {
      char slash;
      for (auto& [x, uv] : result.f.emplace_back()) {
        words >> x >> slash >> uv;
        --x;
        --uv;
      }
    }
  }
  return result;
}

// The area of the rest shape, and the most that a thread of it is stretched: with e = x_j − x_0 and
// d = uv_j − uv_0, the columns of F = (e₁ e₂)(d₁ d₂)⁻¹.
struct Fit {
  double area = 0, max_stretch = 0;
};

Fit fit_of(const Shirt& s) {
  Fit fit;
  for (const auto& face : s.f) {
    double d[2][2], e[2][3], wu = 0, wv = 0;
    for (size_t j = 0; j < 2; ++j) {
      for (size_t c = 0; c < 2; ++c)
        d[j][c] = s.vt[size_t(face[j + 1][1])][c] - s.vt[size_t(face[0][1])][c];
      for (size_t c = 0; c < 3; ++c)
        e[j][c] = s.v[size_t(face[j + 1][0])][c] - s.v[size_t(face[0][0])][c];
    }
    const double twice_area = d[0][0] * d[1][1] - d[0][1] * d[1][0];
    for (size_t c = 0; c < 3; ++c) {
      wu += std::pow((e[0][c] * d[1][1] - e[1][c] * d[0][1]) / twice_area, 2);
      wv += std::pow((-e[0][c] * d[1][0] + e[1][c] * d[0][0]) / twice_area, 2);
    }
    fit.area += std::abs(twice_area) / 2;
    fit.max_stretch = std::max(fit.max_stretch, std::sqrt(std::max(wu, wv)));
  }
  return fit;
}

// The two shoulders: of the vertices between collar and sleeve, the highest left and right (z is up
// in the file).
std::array<int, 2> shoulders(const Shirt& s) {
  std::array<int, 2> highest = {-1, -1};
  for (size_t i = 0; i < s.v.size(); ++i) {
    const auto& [x, y, z] = s.v[i];
    if (std::abs(x) < 0.05 || std::abs(x) > 0.15) continue;
    int& side = highest[x > 0];
    if (side < 0 || z > s.v[size_t(side)][2]) side = int(i);
  }
  return highest;
}

// Turned so that y is up; without texture coordinates, so that its triangles in space are the rest
// shape.
std::string upright_without_uv(const Shirt& s) {
  std::ostringstream out;
  out.precision(17);
  for (const auto& [x, y, z] : s.v) out << "v " << x << ' ' << z << ' ' << -y << '\n';
  for (const auto& [a, b, c] : s.f)
    out << "f " << a[0] + 1 << ' ' << b[0] + 1 << ' ' << c[0] + 1 << '\n';
  return out.str();
}

std::string scene(const std::string& mesh, const std::string& more) {
  return "[cloth]\nmesh = \"" + mesh + "\"\ndensity = 0.2\n" + more +
         "[stretch]\nk = 1000.0\n[shear]\nk = 500.0\n[time]\nh = 0.000001\nend = 0.000002\n";
}

class ShirtTest : public ProgramTest {
 protected:
  void SetUp() override {
    if (!exists(shirt)) GTEST_SKIP() << shirt << " does not exist";
  }
};

// If a corner took the first texture coordinate of its vertex, both numbers would change.
TEST_P(ShirtTest, TakesItsRestShapeFromTheTextureCoordinatesOfEachCorner) {
  const Fit fit = fit_of(read_shirt());
  write("scene.toml",
        scene(shirt.string(), "[start]\nvelocity = [1.0, 0.0, 0.0]\n"));  // E = m/2 (1 m/s)²
  expect_done({"scene.toml", "--no-pictures", "--out", "out"});
  const Table log = read_table(directory / "out/log.csv");
  EXPECT_NEAR(log.at("kinetic")[0], 0.2 * fit.area / 2, 1e-10);
  EXPECT_NEAR(log.at("max_stretch")[0], fit.max_stretch, 1e-9);
}

TEST_P(ShirtTest, HangsByItsShoulders) {
  const Shirt s = read_shirt();
  const auto [left, right] = shoulders(s);
  write("shirt.obj", upright_without_uv(s));
  write("scene.toml", scene("shirt.obj", "pins = [" + std::to_string(left) + ", " +
                                             std::to_string(right) + "]\n[gravity]\ng = 9.81\n"));
  const Outcome first = run({"scene.toml", "--no-pictures", "--out", "first"});
  std::smatch h_crit;
  std::string h = "0.0005";
  if (GetParam().is_explicit()) {
    ASSERT_TRUE(std::regex_search(first.out, h_crit, std::regex("h_crit = ([0-9.e-]+) s")));
    h = std::to_string(0.8 * std::stod(h_crit[1]));
  }
  expect_done({"scene.toml", "--no-pictures", "--out", "out", "--h", h, "--end", "0.05"});
  const Table log = read_table(directory / "out/log.csv");
  EXPECT_EQ(log.at("max_stretch")[0], 1) << "at rest as it lies";
  EXPECT_LT(log.at("lowest").back(), log.at("lowest")[0] - 1e-3) << "it falls";
  for (const double stretch : log.at("max_stretch")) EXPECT_LT(stretch, 1.5);
}

INSTANTIATE_TEST_SUITE_P(Programs, ShirtTest, testing::ValuesIn(programs()), name_of);

}  // namespace program_tshirt_test
