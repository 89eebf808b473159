// Plots of measurements: a CSV file, a gnuplot script beside it, and the picture where gnuplot is installed.
#pragma once
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

// Colours that colour-blind readers can distinguish (Okabe & Ito), and the settings that all plots share.
inline const std::string gnuplot_style = R"(set datafile separator ","
set linetype 1 lw 2 pt 7 ps 1.1 lc rgb "#0072B2"
set linetype 2 lw 2 pt 5 ps 1.1 lc rgb "#D55E00"
set linetype 3 lw 2 pt 9 ps 1.3 lc rgb "#009E73"
set linetype 4 lw 2 pt 13 ps 1.3 lc rgb "#CC79A7"
set linetype 5 lw 2 pt 11 ps 1.3 lc rgb "#000000"
set linetype 6 lw 2 pt 4 ps 1.1 lc rgb "#E69F00"
set linetype 7 lw 2 pt 6 ps 1.1 lc rgb "#56B4E9"
set grid lc rgb "#dddddd" lt 1 lw 1
set border lc rgb "#444444"
set tics textcolor rgb "#222222"
set format x "10^{%T}"
set format y "10^{%T}"
)";

// Runs DIRECTORY/NAME.gp, which writes DIRECTORY/NAME.png, or prints the command that does.
inline void draw(const std::filesystem::path& directory, const std::string& name,
                 const std::string& script) {
  std::ofstream(directory / (name + ".gp")) << script;
  const std::string command = "cd '" + directory.string() + "' && gnuplot " + name + ".gp";
  const bool drawn = std::system((command + " 2>/dev/null").c_str()) == 0;
  std::printf("%s %s\n", drawn ? "  see" : "  gnuplot is missing; later:",
              drawn ? (directory / (name + ".png")).c_str() : command.c_str());
}
