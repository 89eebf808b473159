// cantilever_points [DIRECTORY]: how far a strip of cloth droops under its own weight, and how far the
// elastica does. Prints the numbers and writes cantilever.csv, cantilever.gp and, where gnuplot is
// installed, cantilever.png into the directory.
#include "cantilever.h"
#include "support/gnuplot.h"

namespace {

constexpr double lightest = 0.3, heaviest = 1700;  // Γ
const std::vector<double> Gammas = {0.5, 1, 2, 5, 10, 20, 50, 100, 200, 500, 1000};

void write_line(const std::filesystem::path& file) {
  std::ofstream csv(file);
  for (double Gamma = lightest; Gamma < heaviest; Gamma *= 1.1)
    csv << Gamma << ',' << elastica(Gamma).droop() << '\n';
}

void write_points(const std::filesystem::path& file) {
  std::ofstream csv(file);
  const std::vector<Tip> all = tips(Cantilever{}, Gammas);
  std::printf("Gamma,exact,ours\n");
  for (size_t i = 0; i < Gammas.size(); ++i) {
    csv << Gammas[i] << ',' << all[i].droop() << '\n';
    std::printf("%g,%.6f,%.6f\n", Gammas[i], elastica(Gammas[i]).droop(), all[i].droop());
  }
}

const std::string script = gnuplot_style + R"(
set terminal pngcairo size 900,540 font "sans,13" background rgb "white"
set output "cantilever.png"
set title "A strip of cloth under its own weight, 32 cells" font "sans,15"
set xlabel "weight against stiffness, Γ = ρ g L³ / B"
set ylabel "how far it droops, H / W"
set logscale xy
set format x "%g"
set format y "%g"
set xrange [0.3:1700]
set yrange [0.03:40]
set key top left reverse Left samplen 2
plot "cantilever_exact.csv" using 1:2 with lines lt 1 lw 2.5 title "heavy elastica, exact", \
     "cantilever.csv" using 1:2 with points pt 7 ps 1.5 lc rgb "#D55E00" title "step05\\_bend"
)";

}  // namespace

int main(int argc, char** argv) {
  const std::filesystem::path directory = argc > 1 ? argv[1] : ".";
  write_line(directory / "cantilever_exact.csv");
  write_points(directory / "cantilever.csv");
  draw(directory, "cantilever", script);
}
