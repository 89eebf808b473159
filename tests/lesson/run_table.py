#!/usr/bin/env python3
"""Prints a table of a lesson: runs programs and collects what they print and log.

    python3 tests/lesson/run_table.py energy_of_h

from the root of the repository; the programs are those of build/release. Without a name: the names.
"""
import csv
import pathlib
import re
import subprocess
import sys
import tempfile

SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def minus(text):
    return text.replace("-", "−")


def power(value, digits=1):
    """0.032 as 3.2·10⁻², and 0.32 as it is."""
    if 0.1 <= abs(value) < 10:
        return minus(f"{value:.{digits + 1}g}")
    mantissa, exponent = f"{value:.{digits}e}".split("e")
    return f"{minus(mantissa)}·10{str(int(exponent)).translate(SUPERSCRIPTS)}"


def print_table(headings, rows):
    for cells in (headings, ["---"] * len(headings), *rows):
        print("|" + "|".join(cells) + "|" if cells[0] == "---" else "| " + " | ".join(cells) + " |")


def numbers_of(file):
    """The rows of a CSV file, each with its numbers by the names of the columns."""
    return [{name: float(text) for name, text in row.items()} for row in csv.DictReader(file)]


class Run:
    """One run of a step: its exit code, what it says, and the rows of its log.csv."""

    def __init__(self, step, *options, scene=None):
        with tempfile.TemporaryDirectory() as out:
            arguments = [f"build/release/{step}/{step}", "--no-pictures", "--out", out, *options]
            if scene:
                path = pathlib.Path(out, "scene.toml")
                path.write_text(scene, encoding="utf-8")
                arguments.insert(1, str(path))
            result = subprocess.run(arguments, text=True, stdout=subprocess.PIPE,
                                    stderr=subprocess.STDOUT, check=False)
            if result.returncode not in (0, 1):
                sys.exit(f"exit code {result.returncode} of {' '.join(arguments)}\n{result.stdout}")
            self.exploded, self.text = result.returncode == 1, result.stdout
            log = pathlib.Path(out, "log.csv")
            with log.open(encoding="utf-8") as file:
                self.log = numbers_of(file)

    def find(self, expression):
        match = re.search(expression, self.text)
        return match[1] if match else None

    def column(self, name):
        return [row[name] for row in self.log]

    def at(self, time):
        """The frame nearest to a time, s."""
        return min(self.log, key=lambda row: abs(row["time"] - time))

    def seconds(self):
        return sum(self.column("milliseconds")) / 1000


def scene_of(step, **values):
    """The scene of a step with other values: stretch_k = 100 is the k of [stretch]."""
    lines, table = [], ""
    for line in pathlib.Path(step, "scene.toml").read_text(encoding="utf-8").splitlines():
        if line.startswith("["):
            table = line[1:line.index("]")]
        key = line.split("=")[0].strip()
        lines.append(f"{key} = {values[f'{table}_{key}']}" if f"{table}_{key}" in values else line)
    return "\n".join(lines) + "\n"


# Step 1 ---------------------------------------------------------------------------------------

def energy_of_h():
    rows = []
    for h in ("2.5e-5", "5e-5", "1e-4", "2e-4"):
        run = Run("step01_explicit", "--end", "0.8", "--frames", "16", "--h", h)
        total = run.column("total")
        change = max(abs(energy - total[0]) for energy in total)
        lowest = minus(f"{run.at(0.25)['lowest']:.6f}")
        rows.append((h, run.find(r"(\d+) steps"), power(change), lowest))
    print_table(("h (s)", "steps", "largest change of the total energy (J)",
                 "lowest point at 0.25 s (m)"), rows)


def weight_of_a():
    rows = []
    for cells in (10, 20, 40):
        lowest = []
        for softer in (1, (10 / cells)**2):
            run = Run("step01_explicit", "--end", "0.5", "--frames", "1", "--cells", str(cells),
                      "--set", f"stretch.k={1000 * softer}", "--set", f"shear.k={500 * softer}")
            lowest.append(minus(f"{run.log[-1]['lowest']:.3f}"))
        rows.append((f"{cells} × {cells}", *lowest))
    print_table(("cells", "lowest point at 0.5 s with √a (m)", "with a (m)"), rows)


# Step 2 ---------------------------------------------------------------------------------------

def energies():
    one, two = Run("step01_explicit"), Run("step02_damping")
    rows = []
    for time in (0.25, 0.5, 0.75, 1):
        kinetic = [f"{run.at(time)['kinetic']:.5f}" for run in (one, two)]
        total = [minus(f"{run.at(time)['total']:.4f}") for run in (one, two)]
        rows.append((f"{time:.2f}", *kinetic, *total))
    print_table(("t (s)", "kinetic, step 1 (J)", "kinetic, step 2 (J)",
                 "total, step 1 (J)", "total, step 2 (J)"), rows)


def critical_step_of_damping():
    rows = []
    for stretch in (0, 0.02, 0.05, 0.07, 0.1, 0.2):
        shear = stretch / 2
        run = Run("step02_damping", scene=scene_of("step02_damping", damping_stretch=stretch,
                                                   damping_shear=shear))
        h_crit = float(run.find(r"h_crit = ([\d.e-]+) s"))
        last_step = run.find(r"exploded in step (\d+)")
        outcome = f"explodes in step {last_step}" if run.exploded else "runs"
        rows.append((f"{stretch:g}, {shear:g}", f"{h_crit:.3g}", outcome))
    print_table(("kd of stretch, of shear (N·s/m)", "h_crit (s)", "h = 2e-4 s"), rows)


# Step 3 ---------------------------------------------------------------------------------------

def price_of_h():
    rows = []
    for h, steps in (("0.0002 (step 2)", ""), ("0.0025", "400"), ("0.005", "200"), ("0.01", "100"),
                     ("0.0166667", "60"), ("0.0333", "31"), ("0.1", "10")):
        if not steps:
            run, again, gained = Run("step02_damping"), "", "none"
        else:
            every_step = ("step03_implicit", "--h", h, "--frames", steps)
            run = Run(*every_step)
            highest = max(Run(*every_step, "--guard", "off").column("total"))
            gained = "none" if highest < 1e-2 else power(highest) if highest > 1e3 else f"{highest:.2f}"
            again = f"{run.log[-1]['redone']:.0f}"
        last = run.log[-1]
        rows.append((h, run.find(r"(\d+) steps"), again, f"{run.seconds():.2g}",
                     minus(f"{last['total']:.2g}"), minus(f"{last['lowest']:.2f}"), gained))
    print_table(("h (s)", "steps", "taken again", "seconds", "energy at the end (J)",
                 "lowest point at the end (m)", "most energy gained with `--guard off` (J)"), rows)


def cost_of_stiffness():
    rows = []
    for exponent, h in ((3, "2e-4"), (4, "6.325e-5"), (5, "2e-5"), (6, "6.325e-6")):
        k = {"stretch_k": 10.0**exponent, "shear_k": 10.0**exponent / 2}
        explicit = Run("step02_damping", "--h", h, scene=scene_of("step02_damping", **k))
        implicit = Run("step03_implicit", scene=scene_of("step03_implicit", **k))
        e = str(exponent).translate(SUPERSCRIPTS), str(exponent - 1).translate(SUPERSCRIPTS)
        rows.append((f"10{e[0]}, 5·10{e[1]}",
                     explicit.find(r"(\d+) steps"), f"{explicit.seconds():.2g}",
                     implicit.find(r"(\d+) steps"), f"{implicit.seconds():.2g}"))
    print_table(("k, k_shear (N/m)", "step 2, explicit: steps", "seconds",
                 "step 3, implicit: steps", "seconds"), rows)


# Step 4 ---------------------------------------------------------------------------------------

def measured_tolerances(*options):
    with tempfile.TemporaryDirectory() as out:
        subprocess.run(["build/release/tests/lesson/measure_tolerance", "--out", out, *options],
                       stdout=subprocess.DEVNULL, check=True)
        with next(pathlib.Path(out).glob("*.csv")).open(encoding="utf-8") as file:
            return numbers_of(file)


def tolerances():
    rows = []
    for row in measured_tolerances():
        exponent = round(-len(str(int(1 / row["tolerance"] + 0.5))) + 1)
        name = f"10{str(exponent).translate(SUPERSCRIPTS)}"
        rows.append((f"**{name}** (default)" if exponent == -4 else name,
                     power(row["error_median"]), power(row["error_worst"]),
                     f"{row['iterations_median']:.0f}", f"{row['milliseconds']:.1f}",
                     power(row["position_end"]), power(row["position_worst"])))
    print_table(("tolerance", "error of Δv, median", "worst", "iterations, median", "ms, median",
                 "error of position at 1 s", "worst of the run"), rows)


def residuals():
    rows = []
    for name, options in (("k = 10³", ()), ("k = 10⁶", ("--k", "1e6"))):
        row = next(row for row in measured_tolerances("--preconditioner", "ic", *options)
                   if abs(row["tolerance"] - 1e-2) < 1e-9)
        rows.append((name, *(f"{row[column]:.2g}" for column in
                             ("residual_median", "residual_worst", "error_median", "error_worst"))))
    print_table(("", "relative residual, median", "worst", "error of Δv, median", "worst"), rows)


def whole_step():
    """Of bench_solve step: iterations and milliseconds of each way to the same error."""
    text = subprocess.run(["build/release/tests/bench/bench_solve", "step"], text=True, check=True,
                          stdout=subprocess.PIPE, stderr=subprocess.DEVNULL).stdout
    ways = re.findall(r"^(step \d, (?:\w+)|triplets, Eigen's CG) +(\S+) +(\d+) +\S+ +(\S+) +\S+$",
                      text.split("80 x 80")[0], re.M)
    names = {"step 3, ldlt": "LDLᵀ (step 3)", "step 3, cholmod": "CHOLMOD (step 3)",
             "triplets, Eigen's CG": "triplets and Eigen's conjugate gradients with its diagonal"}
    rows = [(names.get(way, f"`{way[8:]}`"), "" if tolerance == "direct" else iterations,
             f"{float(ms):.0f}")
            for way, tolerance, iterations, ms in ways]
    print_table(("method", "iterations", "ms"), rows)


def warm_starts():
    """Of bench_solve warm: iterations in the default scene, begun with z and with the last Δv."""
    text = subprocess.run(["build/release/tests/bench/bench_solve", "warm"], text=True, check=True,
                          stdout=subprocess.PIPE, stderr=subprocess.DEVNULL).stdout
    rows = []
    case = re.compile(r"^default, t = (\S+) s +(\w+) +(.*)$", re.M)
    for time, preconditioner, numbers in case.findall(text):
        # Four pairs at equal error, then cold, warm and their errors at each of four tolerances.
        number = numbers.split()
        rows.append((time, f"`{preconditioner}`", f"{number[12]} → {number[13]}",
                     f"{number[20]} → {number[21]}"))
    print_table(("t (s)", "preconditioner", "tolerance 10⁻²", "tolerance 10⁻⁴"), rows)


TABLES = {function.__name__: function for function in
          (energy_of_h, weight_of_a, energies, critical_step_of_damping, price_of_h, cost_of_stiffness,
           tolerances, residuals, whole_step, warm_starts)}

if __name__ == "__main__":
    if len(sys.argv) != 2 or sys.argv[1] not in TABLES:
        sys.exit("usage: run_table.py " + "|".join(TABLES))
    TABLES[sys.argv[1]]()
