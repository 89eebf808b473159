#!/usr/bin/env python3
"""Draws step03_implicit/figures/energy.png: energy against time, for several lengths of the step.

    python3 tests/lesson/draw_energy.py [FILE]

from the root of the repository, into that file or another one. The runs are those of the table
`run_table.py price_of_h`, seven seconds of computing. The picture is drawn by gnuplot.
"""
import pathlib
import subprocess
import sys

from run_table import Run

PICTURE = "step03_implicit/figures/energy.png"
# h in seconds, the number of steps, and a colour that colour-blind readers can distinguish.
LENGTHS = (("0.0025", "400", "#56B4E9"), ("0.005", "200", "#0072B2"), ("0.01", "100", "#009E73"),
           ("0.0166667", "60", "#E69F00"), ("0.0333", "31", "#D55E00"), ("0.1", "10", "#CC79A7"))
STYLE = """set terminal pngcairo size 720,400 font "DejaVu Sans,11"
set grid ytics lc rgb "#e8e8ec" lt 1 lw 1
unset border
set xtics 0.25 textcolor rgb "#333333" scale 0
set ytics 0.2 textcolor rgb "#333333" scale 0
set xrange [0:1.02]
set yrange [-0.9:0.03]
set rmargin 15
set xlabel "t (s)" textcolor rgb "#333333"
set ylabel "energy (J)" textcolor rgb "#333333"
"""


def main(picture=PICTURE):
    pathlib.Path(picture).parent.mkdir(parents=True, exist_ok=True)
    curves = [("step 2", "#333333", False, Run("step02_damping", "--frames", "100").log)]
    for h, steps, colour in LENGTHS:
        log = Run("step03_implicit", "--h", h, "--frames", steps).log
        curves.append((f"h = {float(h):.3g} s", colour, int(steps) <= 60, log))

    script = f'{STYLE}set output "{picture}"\n'
    plots, data = [], ""
    for name, colour, dots, log in curves:
        end = log[-1]["total"]
        script += (f'set label "{name}" at graph 1, first {end} offset 1,0 '
                   f'textcolor rgb "{colour}"\n')
        style = "linespoints pt 7 ps 0.6" if dots else "lines"
        plots.append(f'"-" with {style} lw 2 lc rgb "{colour}" notitle')
        data += "".join(f"{row['time']} {row['total']}\n" for row in log) + "e\n"
    script += "plot " + ", ".join(plots) + "\n" + data
    subprocess.run(["gnuplot"], input=script, text=True, check=True)


if __name__ == "__main__":
    main(*sys.argv[1:])
