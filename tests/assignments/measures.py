"""The tasks that measure: the scene of each student, and the answer that the grader expects.

A task C1.1 has a class here. It is made from the numbers of one student (`given` of
tasks/C1.1.toml), writes the scene, and knows the answer: by a formula where there is one, and else
by runs of the project's programs. A new task needs such a class, a line in MEASURES and its file in
tasks/.

An answer that is wrong is called too large or too small, with the tolerance and its reason. The
expected number is not printed, because a student may hand in again. (By many hand-ins a student can
close in on it. Limit their number, if that matters.)

The numbers follow from the text of --student and from nothing else. An instructor who grades with
--student "ada 7f3k", the ID and a secret word, has numbers that nobody can compute before they are
handed out. A student who has the scene can still read here how the grader finds the answer, and do
the same: that is a measurement, too.
"""
import csv
import dataclasses
import functools
import json
import math
import pathlib
import re
import shutil
import subprocess
import tempfile
import types

import answers
import distance
from runs import FAILED, PASSED, UNWRITTEN, Ending
from tasks import HERE, TaskError

SECONDS = 60  # for one run


# Answers ------------------------------------------------------------------------------------------


@dataclasses.dataclass(frozen=True)
class Answer:
    """The number that is expected, others that are as right, and how far from one of them is right,
    too.
    """

    values: tuple  # the expected one first
    share: float  # of a value
    why: str  # a sentence: how much is allowed, and for which reason

    def accepts(self, number):
        return any(abs(number - value) <= self.share * value for value in self.values)

    def ending(self, number, unit):
        if self.accepts(number):
            return Ending(PASSED, f"Right. {self.why}")
        side = "small" if number < self.values[0] else "large"
        return Ending(FAILED, f"{number:g} {unit}".strip() + f" is too {side}. {self.why}")


def within(value, share, reason):
    """An answer from which another one may differ by a share of it."""
    return Answer((value,), share, f"An error of {100 * share:g} % is allowed: {reason}.")


# Runs ---------------------------------------------------------------------------------------------


@dataclasses.dataclass(frozen=True)
class Run:
    """What a run printed and wrote."""

    output: str
    log: list  # a row for each frame: column → number
    vertices: list  # at the end, m


class Programs:
    """The programs of a build directory."""

    def __init__(self, build):
        self.build = pathlib.Path(build)

    def run(self, program, scene, *options):
        """Runs a scene, given as text. It may explode; TaskError if the program is not built, or
        fails otherwise.
        """
        path = self.build / program / program
        if not path.exists():
            raise TaskError(
                f"{path} is not built: cmake --build {self.build} --target {program}, or name another "
                "directory with --build"
            )
        with tempfile.TemporaryDirectory() as place:
            file, out = pathlib.Path(place) / "scene.toml", pathlib.Path(place) / "out"
            file.write_text(scene)
            words = [path, file, "--no-pictures", "--out", out, *map(str, options)]
            try:
                done = subprocess.run(
                    words,
                    stdout=subprocess.PIPE,
                    stderr=subprocess.STDOUT,
                    text=True,
                    timeout=SECONDS,
                )
            except subprocess.TimeoutExpired:
                raise TaskError(f"{program} did not end within {SECONDS} seconds") from None
            if done.returncode and "exploded" not in done.stdout:
                raise TaskError(f"{program} failed on the scene of a task: {done.stdout.strip()}")
            with open(out / "log.csv") as log:
                rows = [
                    {name: float(value) for name, value in row.items()}
                    for row in csv.DictReader(log)
                ]
            mesh = out / "final.obj"
            return Run(
                done.stdout, rows, distance.vertices(mesh.read_text()) if mesh.exists() else []
            )


def no_answer(what):
    """For numbers in `given` that are chosen so that a question has no answer."""
    return TaskError(f"a task has no answer for this student: {what}")


def first(found, what):
    """The first of some values."""
    for value in found:
        return value
    raise no_answer(what)


def crossing(f, target, low, high):
    """Where f, a falling function of ln x, is the target: intervals are halved, and the last one is
    a line.
    """
    f_low, f_high = f(low), f(high)
    if not f_low >= target >= f_high:
        raise no_answer(f"{target:g} is not between {f_high:g} and {f_low:g}")
    for _ in range(6):
        middle = math.sqrt(low * high)
        if (f_middle := f(middle)) > target:
            low, f_low = middle, f_middle
        else:
            high, f_high = middle, f_middle
    return low * (high / low) ** ((f_low - target) / (f_low - f_high))


# Scenes -------------------------------------------------------------------------------------------

UNITS = {
    "cloth.size": "m",
    "cloth.density": "kg/m²",
    "gravity.g": "m/s²",
    "stretch.k": "N/m",
    "shear.k": "N/m",
    "bend.k": "N·m",
    "damping.stretch": "N·s/m",
    "damping.shear": "N·s/m",
    "start.velocity": "m/s",
    "time.h": "s",
    "time.end": "s",
}
GRAVITY = {"g": 9.81}


def in_toml(value):
    """A value as TOML writes it, numbers with ten digits."""
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(map(in_toml, value)) + "]"
    return f"{value:.10g}" if isinstance(value, float) else json.dumps(value)


def line(table, key, value):
    unit = UNITS.get(f"{table}.{key}")
    return f"{key} = {in_toml(value)}" + (f"  # {unit}" if unit else "")


def scene(**tables):
    """The text of a scene.toml: table = {key: value}. A table without keys is left out."""
    return "".join(
        "\n".join([f"[{table}]", *(line(table, *entry) for entry in entries.items())]) + "\n"
        for table, entries in tables.items()
        if entries
    )


def threads(k, share=0.5):
    """The tables of stretch and shear, whose k is a share of the other."""
    return {"stretch": {"k": k}, "shear": {"k": share * k}}


def square(n, diagonals="alternating"):
    """The table of a cloth that hangs by its two upper corners."""
    return {
        "size": [n.size, n.size],
        "cells": [n.cells, n.cells],
        "diagonals": diagonals,
        "density": n.density,
        "pins": ["top left", "top right"],
    }


def strip(n, cells, share, pins):
    """The table of a strip along u of square cells, whose width is about a share of its length."""
    rows = max(1, round(share * cells))
    return {
        "size": [n.length, n.length * rows / cells],
        "cells": [cells, rows],
        "density": n.density,
        "pins": pins(rows),
    }


class Measure:
    """A task for one student: n has the numbers of `given` by their names.

    scene() is the text of the student's scene.toml, answer(programs) the Answer.
    """

    def __init__(self, numbers):
        self.n = types.SimpleNamespace(**numbers)


# Step 1 -------------------------------------------------------------------------------------------


def critical_step(programs, scene):
    """h_crit in s, as step 1 prints it."""
    output = programs.run("step01_explicit", scene, "--h", "1e-6", "--end", "1e-6").output
    return float(re.search(r"h_crit = (\S+) s", output)[1])


class StableStiffness(Measure):
    """The largest k for which h is stable: h_crit is proportional to 1/√k."""

    k = 100

    def scene(self):
        n = self.n
        return scene(
            cloth=square(n, n.diagonals),
            gravity=GRAVITY,
            **threads(self.k, n.share),
            time={"h": n.h, "end": 0.5},
        )

    def answer(self, programs):
        return within(
            self.k * (critical_step(programs, self.scene()) / self.n.h) ** 2,
            0.01,
            "h_crit comes from a power iteration that stops at 1e-4, and k contains its square",
        )


class Explosion(Measure):
    """When a run beyond h_crit has pulled a thread to twice its length."""

    def scene(self):
        return scene(
            cloth=square(self.n),
            gravity=GRAVITY,
            **threads(self.n.k),
            time={"h": 1e-4, "end": 0.01},
        )

    def answer(self, programs):
        steps = 150
        h = self.n.factor * critical_step(programs, self.scene())
        log = programs.run(
            "step01_explicit", self.scene(), "--h", h, "--end", steps * h, "--frames", steps
        ).log
        step = first(
            (i for i, row in enumerate(log) if row["max_stretch"] > 2),
            f"no explosion in {steps} steps",
        )
        allowed = max(1.5, 0.04 * step)
        return Answer(
            (step * h,),
            allowed / step,
            f"An error of {allowed:.2g} steps is allowed: what is lost with the last digit of h_crit, or by the "
            "rounding of another machine, grows in every step.",
        )


# Strips that vibrate along their length -----------------------------------------------------------


class Vibration(Measure):
    """A strip on a smooth table: its left end is held, and it is pushed to the right."""

    @property
    def omega(self):
        """Of the first vibration, sin(π s/2L), where s is the distance from the held end: 1/s."""
        return math.pi / (2 * self.n.length) * math.sqrt(self.n.k / self.n.density)

    why = (
        "16 cells vibrate more slowly than a strip by 0.04 %, the other vibrations of the strip last for a while, "
        "and a curve is read to a few percent"
    )

    def pushed(self, h, end, frames, damping=None):
        return scene(
            cloth=strip(self.n, 16, 0.25, lambda rows: ["left"]),
            **threads(self.n.k),
            damping=damping,
            start={"velocity": [0.1, 0, 0]},
            time={"h": h, "end": end, "frames": frames},
        )


class DampedVibration(Vibration):
    """Which kd lets the amplitude fall to a tenth in a given time.

    ρ ü = k u'' + kd u̇'' with u = q(t) sin(π s/2L) is q̈ + kd π²/(4 ρ L²) q̇ + ω² q = 0, so q falls
    as exp(−kd π²/(8 ρ L²) t).
    """

    def scene(self):
        return self.pushed(1e-4, 2 * self.n.time, 200, {"stretch": 0.0})

    def answer(self, programs):
        n = self.n
        kd = 8 * n.density * n.length**2 * math.log(10) / (math.pi**2 * n.time)
        return within(kd, 0.05, self.why)


class MethodDamping(Vibration):
    """After how many implicit steps the method has taken nine tenths of an undamped vibration.

    Backward Euler divides the amplitude by √(1 + h² ω²) in every step.
    """

    def scene(self):
        return self.pushed(self.n.h, 1200 * self.n.h, 1200)

    def answer(self, programs):
        steps = 2 * math.log(10) / math.log(1 + (self.n.h * self.omega) ** 2)
        return within(steps, 0.06, self.why)


# Errors -------------------------------------------------------------------------------------------


class Fall(Measure):
    """A cloth that begins to fall from its two corners, and a run that counts as the truth."""

    damping = {"stretch": 0.02, "shear": 0.01}

    def cloth(self, h, end):
        return scene(
            cloth=square(self.n),
            gravity=GRAVITY,
            **threads(self.n.k),
            damping=self.damping,
            time={"h": h, "end": end, "frames": 1},
        )

    def end(self, programs, program, *options):
        return programs.run(program, self.scene(), *options).vertices


class ErrorOfStep(Fall):
    """How far the run with h is from that with h/32."""

    def scene(self):
        return self.cloth(self.n.h, self.n.h * self.n.steps)

    def answer(self, programs):
        run = functools.partial(self.end, programs, "step03_implicit", "--h")
        apart = distance.distances(run(self.n.h), run(self.n.h / 32))
        return within(
            1000 * distance.rms(apart),
            0.03,
            "another machine rounds in another way, and h/32 may be " "written with few digits",
        )


class FewestSteps(Fall):
    """How few steps are as near to 800 steps as is asked."""

    def scene(self):
        return self.cloth(self.n.end / 20, self.n.end)

    def error(self, programs, steps):
        """RMS distance from the truth, mm."""
        return 1000 * distance.rms(
            distance.distances(self.run(programs, steps), self.run(programs, 800))
        )

    @functools.cache
    def run(self, programs, steps):
        return self.end(programs, "step03_implicit", "--h", self.n.end / steps)

    def answer(self, programs):
        few, enough = 4, 400
        if not self.error(programs, few) > self.n.limit >= self.error(programs, enough):
            raise no_answer(f"it is not between {few} and {enough} steps")
        while enough - few > 1:
            steps = (few + enough) // 2
            if self.error(programs, steps) > self.n.limit:
                few = steps
            else:
                enough = steps
        return within(
            enough,
            0.04,
            "the error falls with every step more, but by little, and another machine rounds "
            "in another way",
        )


class LoosestTolerance(Fall):
    """The loosest of ten tolerances that keeps the cloth where an exact solution puts it."""

    damping = {}

    def scene(self):
        return self.cloth(0.01, self.n.end)

    def answer(self, programs):
        run = functools.partial(
            self.end,
            programs,
            "step04_cg",
            "--preconditioner",
            self.n.preconditioner,
            "--tolerance",
        )
        tolerances = [self.n.loosest / 2**i for i in range(10)]
        truth = run(1e-10)
        errors = [1000 * max(distance.distances(run(tolerance), truth)) for tolerance in tolerances]
        right = [
            self.loosest(tolerances, errors, factor * self.n.limit) for factor in (1, 1.2, 1 / 1.2)
        ]
        return Answer(
            tuple(right),
            0.01,
            "The answers to limits up to 20 % from yours are right, too: the number of iterations is a "
            "whole number, so the error jumps, and on another machine elsewhere.",
        )

    def loosest(self, tolerances, errors, limit):
        return first(
            (tolerance for tolerance, error in zip(tolerances, errors) if error <= limit),
            f"all tolerances have errors above {limit:g} mm",
        )


# Step 5 -------------------------------------------------------------------------------------------


class Droop(Measure):
    """Which k of bending lets a clamped strip droop by a given part of its length."""

    cells = 10

    def clamp(self, rows):
        """The vertices of the first two columns."""
        return [j * (self.cells + 1) + i for j in range(rows + 1) for i in (0, 1)]

    def clamped(self, k):
        return scene(
            cloth=strip(self.n, self.cells, 0.3, self.clamp),
            gravity=GRAVITY,
            **threads(1000),
            bend={"k": k},
            time={"h": 0.05, "end": 5, "frames": 1},
        )

    def scene(self):
        return self.clamped(1e-3)

    def droop(self, programs, k):
        """How far the lowest vertex comes to rest below the clamp, as a share of the length."""
        return -programs.run("step05_bend", self.clamped(k)).log[-1]["lowest"] / self.n.length

    def answer(self, programs):
        weight = self.n.density * 9.81 * self.n.length**3
        k = crossing(lambda k: self.droop(programs, k), self.n.percent / 100, weight / 50, weight)
        return within(
            k, 0.03, "a droop that is read to a hundredth of the length gives k to about 3 %"
        )


MEASURES = {
    "C1.1": StableStiffness,
    "C1.2": Explosion,
    "C2.1": DampedVibration,
    "C3.1": MethodDamping,
    "C3.2": ErrorOfStep,
    "C3.3": FewestSteps,
    "C4.1": LoosestTolerance,
    "C5.1": Droop,
}


# What make.py and grade.py call -------------------------------------------------------------------


def measure(task, student):
    return MEASURES[task.id](task.numbers(student))


def add(chosen, out, student):
    """Writes answers.toml, and into measure/ the scene of each task and the script that compares
    two meshes.
    """
    asked = [task for task in chosen if task.kind == "measure"]
    for task in asked:
        place = out / "measure" / task.id
        place.mkdir(parents=True)
        (place / "scene.toml").write_text(f"# Task {task.id}\n{measure(task, student).scene()}")
    if asked:
        shutil.copy2(HERE / "distance.py", out / "measure/distance.py")
        (out / answers.FILE).write_text(
            "# Write your answers here, and take away the # of each line.\n"
            "# If other tasks change a program, measure with it when they pass.\n"
            + "".join(
                f'# "{task.id}" =     # {task.unit or "no unit"}: {task.title}\n' for task in asked
            )
        )


def grade(task, hand_in, student, programs):
    try:
        number = answers.number(hand_in, task.id)
    except answers.AnswerError as error:
        return Ending(FAILED, str(error))
    if number is None:
        return Ending(UNWRITTEN, f'{answers.FILE} has no line "{task.id}" = …')
    return measure(task, student).answer(programs).ending(number, task.unit)
