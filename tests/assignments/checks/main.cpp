// The checks of one task as a program. It reads a word from its standard input, runs the checks, and writes the
// word as its last line: a program that ended early, or wrote more, has no result.
#include <cstdlib>
#include <iostream>

#include "assignments/checks/check.h"

unsigned seed() {
  const char* text = std::getenv("CHECK_SEED");
  return text ? unsigned(std::strtoul(text, nullptr, 10)) : 1;
}

namespace {

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

// The factor s with got = s · expected, if there is one.
double common_factor(const MatX& got, const MatX& expected) {
  const double s = got.cwiseProduct(expected).sum() / expected.squaredNorm();
  return (got - s * expected).norm() <= 1e-6 * got.norm() ? s : std::nan("");
}

std::string guess(const MatX& got, const MatX& expected) {
  if (!got.allFinite()) return " It is not a finite number.";
  if (expected.size() > 1 && expected.isZero(0)) return " All of it must be zero.";
  if (expected.isZero(0)) return "";
  if (expected.size() > 1 && got.isZero(0)) return " All of it is zero.";
  const double s = common_factor(got, expected);
  if (std::abs(s + 1) < 1e-6) return " The sign is the opposite one.";
  if (expected.size() > 1 && !std::isnan(s))
    return " All of it is " + number(s) + " times as large.";
  if (got.rows() == got.cols() && (got.transpose() - expected).norm() <= 1e-6 * expected.norm())
    return " It is the transpose.";
  return "";
}

}  // namespace

std::string disagreement(const MatX& got, const MatX& expected, double tolerance) {
  if (got.rows() != expected.rows() || got.cols() != expected.cols())
    return "expected " + std::to_string(expected.rows()) + " × " + std::to_string(expected.cols()) +
           " numbers, got " + std::to_string(got.rows()) + " × " + std::to_string(got.cols());
  const MatX error = (got - expected).cwiseAbs();
  if (got.allFinite() && (error.array() <= tolerance).all()) return "";
  Eigen::Index row = 0, column = 0;
  if (got.allFinite())
    error.maxCoeff(&row, &column);
  else
    (got.array() - got.array()).isNaN().cast<int>().maxCoeff(&row, &column);
  std::string place;
  if (got.size() > 1)
    place = got.cols() == 1
                ? " in entry " + std::to_string(row)
                : " in row " + std::to_string(row) + ", column " + std::to_string(column);
  return "expected " + number(expected(row, column)) + ", got " + number(got(row, column)) + place +
         (tolerance > 0 ? " (tolerance " + number(tolerance) + ")." : ".") + guess(got, expected);
}

MatX slope_of(const Function& f, const VecX& x, double h) {
  const auto central = [&](Eigen::Index j, double width) -> VecX {
    VecX ahead = x, behind = x;
    ahead[j] += width;
    behind[j] -= width;
    return (f(ahead) - f(behind)) / (ahead[j] - behind[j]);
  };
  MatX slope(f(x).size(), x.size());
  for (Eigen::Index j = 0; j < x.size(); ++j)
    slope.col(j) = (4 * central(j, h / 2) - central(j, h)) / 3;
  return slope;
}

int main(int argc, char** argv) {
  std::string word;
  std::getline(std::cin, word);
  testing::InitGoogleTest(&argc, argv);
  const int result = RUN_ALL_TESTS();
  std::cout << '\n' << word << std::endl;
  std::_Exit(result);
}
