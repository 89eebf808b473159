#!/usr/bin/env python3
"""Draws the pictures (PNG) of the Markdown files anew, or checks that they are up to date.

    python3 tests/lesson/pictures.py              draws the quick ones, and stores those that differ
    python3 tests/lesson/pictures.py PICTURE …    the same for these pictures, of any class
    python3 tests/lesson/pictures.py --check      changes nothing, exits with 1 if one differs
    python3 tests/lesson/pictures.py --list       prints all of them, each with class and commands

A picture differs if compare_frames says so. Of an animation, all frames are compared. Every command
runs in a directory of its own, which is deleted afterwards. Each picture has a class:

quick   Its commands take less than 20 seconds of processor time, most of them less than five.
slow    They take longer, up to ten minutes.
timed   They take minutes as well. The picture shows times, which differ from run to run: draw it on
        a machine that does nothing else.

The golden pictures, the frame.png of each step, are not here: the target update_frames draws them.
"""
import argparse
import pathlib
import struct
import subprocess
import sys
import tempfile
import textwrap
import zlib

from run_commands import last_lines, run_script
from update_lessons import SOURCE, LessonError, Runner

REPAIR = "python3 tests/lesson/pictures.py"

# The pictures -------------------------------------------------------------------------------------

STEP1, STEP2, STEP3, STEP4, STEP5 = (
    f"build/release/{step}/{step}" for step in
    ("step01_explicit", "step02_damping", "step03_implicit", "step04_cg", "step05_bend"))
TESTS = "build/release/tests"
STRAIN = ("--end 0.5 --frames 1 --strain 0.008 --size 480x400 "
          "--set camera.eye=[0.75,-0.3,1.15] --set camera.target=[0.62,-0.47,-0.3]")
SEVEN_STEPS = f"{STEP3} --h 0.1 --end 0.7 --frames 7"
MODEL = f"{STEP5} --preconditioner multigrid --size 640x360 --frames 1"
MODELS = {"dihedral": "1e-4", "bridson": "4e-4", "quadratic": "3.33333333e-5", "springs": "6"}  # k
SHEET = "cd out && ../build/release/tests/frames/compare_runs"

# (class, commands, {picture: the file that the commands write})
RECIPES = (
    ("quick", STEP1, {"step01_explicit/film.png": "out/step01_explicit/film.png"}),
    ("quick", f"{STEP1} --h 2.88e-4 --end 0.012384 --frames 1 --strain 0.5 --size 960x540",
     {"step01_explicit/burst.png": "out/step01_explicit/frame_0001.png"}),
    ("quick", f"{TESTS}/lesson/compare_models",
     {f"step01_explicit/figures/{name}.png": f"out/compare_models/{name}.png"
      for name in ("pull", "rotation", "models")}),

    ("quick", f"{STEP1} {STRAIN}",
     {"step02_damping/strain_undamped.png": "out/step01_explicit/frame_0001.png"}),
    ("quick", f"{STEP2} {STRAIN}",
     {"step02_damping/strain_damped.png": "out/step02_damping/frame_0001.png"}),

    ("quick", f"{STEP2} --export obj --out out/short_steps\n"
              f"{STEP3} --export obj --out out/long_steps\n"
              f"{SHEET} short_steps long_steps --sheet film.png",
     {"step03_implicit/film.png": "out/film.png"}),
    ("quick", f"{STEP3} --h 0.0166667 --jacobian bw98",
     {"step03_implicit/film_bw98.png": "out/step03_implicit/film.png"}),
    ("quick", f"{STEP3} --h 0.0166667",
     {"step03_implicit/film_definite.png": "out/step03_implicit/film.png"}),
    ("quick", "python3 tests/lesson/draw_energy.py out/energy.png",
     {"step03_implicit/figures/energy.png": "out/energy.png"}),
    ("quick", f"{STEP3} --h 0.1 --end 0.1 --frames 1 --guard off",
     {"step03_implicit/one_system.png": "out/step03_implicit/frame_0001.png"}),
    ("quick", f"{STEP3} --h 0.1 --end 0.1 --frames 1",
     {"step03_implicit/taken_again.png": "out/step03_implicit/frame_0001.png"}),
    ("quick", f"{SEVEN_STEPS} --guard off",
     {"step03_implicit/film_bare.png": "out/step03_implicit/film.png"}),
    ("quick", SEVEN_STEPS, {"step03_implicit/film_guarded.png": "out/step03_implicit/film.png"}),
    ("quick", f"{SEVEN_STEPS} --newton 50",
     {"step03_implicit/film_newton50.png": "out/step03_implicit/film.png"}),
    ("quick", f"{TESTS}/tradeoff/tradeoff curtain --k 1e4 --small-steps --out out",
     {"step03_implicit/figures/small_steps.png": "out/small_steps.png"}),

    ("quick", f"{STEP4} --out out/held\n"
              f"{STEP4} --set 'cloth.pins=[\"top left\", {{vertex=\"top right\", fix=\"yz\"}}]' "
              f"--out out/slides\n{SHEET} held slides --sheet film.png",
     {"step04_cg/film.png": "out/film.png"}),
    ("slow", f"{TESTS}/lesson/measure_tolerance --out out",
     {"step04_cg/tolerance.png": "out/tolerance_block.png"}),
    ("quick", f"{STEP4} --tolerance 0.5",
     {"step04_cg/film_loose.png": "out/step04_cg/film.png"}),
    ("quick", STEP4, {"step04_cg/film_default.png": "out/step04_cg/film.png"}),
    ("timed", f"{TESTS}/bench/bench_solve growth",
     {f"step04_cg/{name}.png": f"out/bench_solve/{name}.png"
      for name in ("growth", "cg_or_direct")}),
    ("quick", f"{TESTS}/bench/bench_solve mode",
     {"step04_cg/figures/slow_mode.png": "out/bench_solve/slow_mode.png"}),

    ("quick", f"{STEP5} --size 400x225 --motion",
     {"step05_bend/motion.png": "out/step05_bend/motion.png"}),
    ("quick", f"{STEP4} step05_bend/scene.toml --without bend",
     {"step05_bend/without_bend.png": "out/step04_cg/still.png"}),
    *(("quick", f"{MODEL} --set bend.model={model} --set bend.k={k}",
       {f"step05_bend/model_{model}.png": "out/step05_bend/frame_0001.png"})
      for model, k in MODELS.items()),
    ("quick", f"mkdir out\n{TESTS}/physics/cantilever_points out",
     {"step05_bend/cantilever.png": "out/cantilever.png"}),

    ("quick", "for fabric in t_shirt jacket jeans blanket trousers; do\n"
              f"  {STEP5} common/fabrics/$fabric.toml --size 240x180 --out out/$fabric\ndone\n"
              f"{SHEET} t_shirt jacket jeans blanket trousers --sheet fabrics.png",
     {"common/fabrics/fabrics.png": "out/fabrics.png"}),
    ("slow", f"{TESTS}/extremes/stability_map",
     {"tests/extremes/stability_map.png": "out/stability_map/stability_map.png"}),
    ("timed", f"{TESTS}/tradeoff/tradeoff curtain --k 1e5 --out out",
     {"tests/tradeoff/work_precision.png": "out/work_precision.png"}),
)


# Drawing ------------------------------------------------------------------------------------------

def draw(commands, files, runner):
    """Runs the commands in the runner's directory. Raises LessonError if a file is not written."""
    code, output = run_script(commands, runner.directory)
    missing = [file for file in files if not (runner.directory / file).exists()]
    if missing or code not in (0, 1):  # 1: the cloth explodes, or the runs differ
        raise LessonError(f"exit code {code}, and {' '.join(missing) or 'no file'} is missing after"
                          f"\n{commands}\n{last_lines(output)}")


# Comparing ----------------------------------------------------------------------------------------

SIGNATURE = b"\x89PNG\r\n\x1a\n"


def chunk(kind, content):
    return (struct.pack(">I", len(content)) + kind + content
            + struct.pack(">I", zlib.crc32(kind + content)))


def frames_of(path):
    """The frames of a PNG, each as a PNG of its own: one, or those of an animation."""
    png = path.read_bytes()
    if not png.startswith(SIGNATURE):
        raise LessonError(f"{path} is no PNG")
    head, frames = b"", []
    at = len(SIGNATURE)
    while at + 12 <= len(png):
        size, kind = struct.unpack(">I4s", png[at:at + 8])
        content = png[at + 8:at + 8 + size]
        at += 12 + size
        if kind == b"IHDR":
            head = content
        elif kind == b"fcTL" or (kind == b"IDAT" and not frames):  # a frame begins
            frames.append(b"")
        if kind == b"IDAT":
            frames[-1] += content
        elif kind == b"fdAT":
            frames[-1] += content[4:]  # without its number
    return [SIGNATURE + chunk(b"IHDR", head) + chunk(b"IDAT", data) + chunk(b"IEND", b"")
            for data in frames]


def difference(stored, drawn, build):
    """Why the two pictures differ: one line, or nothing if they are the same."""
    if not stored.exists():
        return "it is not stored yet"
    old, new = frames_of(stored), frames_of(drawn)
    if len(old) != len(new):
        return f"{len(old)} frames are stored, and {len(new)} are drawn"
    with tempfile.TemporaryDirectory(prefix="pictures_") as room:
        a, b = pathlib.Path(room, "stored.png"), pathlib.Path(room, "drawn.png")
        for before, after in zip(old, new):
            a.write_bytes(before)
            b.write_bytes(after)
            result = subprocess.run([f"{build}/tests/frames/compare_frames", a, b], text=True,
                                    stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
            if result.returncode:
                return result.stdout.strip()
    return ""


# Renewing -----------------------------------------------------------------------------------------

def chosen(names):
    """The recipes of the named pictures, or of the quick ones, each with these pictures only."""
    unknown = set(names) - {picture for _, _, files in RECIPES for picture in files}
    if unknown:
        raise LessonError(f"no command draws {' '.join(sorted(unknown))}: see --list")
    for kind, commands, files in RECIPES:
        wanted = {picture: file for picture, file in files.items()
                  if (picture in names if names else kind == "quick")}
        if wanted:
            yield kind, commands, wanted


def store(drawn, stored):
    """Copies a file whole or not at all."""
    part = stored.with_suffix(".part")
    part.write_bytes(drawn.read_bytes())
    part.replace(stored)


def renew(names, build, check):
    """Draws the pictures, and stores those that differ. Returns how many differ."""
    differ = 0
    for _, commands, files in chosen(names):
        runner = Runner(build)
        with runner.room:
            draw(commands, files.values(), runner)
            for picture, file in files.items():
                stored, drawn = SOURCE / picture, runner.directory / file
                why = difference(stored, drawn, runner.build)
                differ += bool(why)
                if why and not check:
                    store(drawn, stored)
                verdict = "same" if not why else "differs" if check else "renewed"
                repair = f"; renew it by {REPAIR} {picture}" if why and check else ""
                print(f"{verdict:7}  {picture}{': ' * bool(why)}{why}{repair}", flush=True)
    return differ


def list_of(recipes):
    for kind, commands, files in recipes:
        yield "\n".join([*(f"{kind:5}  {picture} is {file} of" for picture, file in files.items()),
                         textwrap.indent(commands, "       ")])


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("pictures", nargs="*", metavar="PICTURE", help="the quick ones if absent")
    parser.add_argument("--list", action="store_true",
                        help="print the pictures, the files that are copied, and the commands")
    parser.add_argument("--check", action="store_true",
                        help="change nothing, exit with 1 on a difference")
    parser.add_argument("--build", default=SOURCE / "build/release", help="build/release if absent")
    arguments = parser.parse_args()
    if arguments.list:
        print("\n".join(list_of(chosen(arguments.pictures) if arguments.pictures else RECIPES)))
        return 0
    differ = renew(arguments.pictures, arguments.build, arguments.check)
    return int(arguments.check and differ > 0)


if __name__ == "__main__":
    try:
        sys.exit(main())
    except (LessonError, OSError) as error:
        print(f"pictures: {error}", file=sys.stderr)
        sys.exit(2)
