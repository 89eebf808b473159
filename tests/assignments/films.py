"""Films of a student's programs beside those of the project."""
import pathlib
import shutil
import subprocess
import tempfile

import handed
import make
import runs
from handed import Refused
from tasks import SOURCE
from workshop import COMPILE_SECONDS, Workshop, is_given, shown_error, with_bodies

FILM_SECONDS = 120


def write_films(chosen, hand_in, student, work, programs, out):
    """out/films/STEP/report.html: the film of the project and that of the student, with all bodies
    of the student that are taken. Returns a sentence for each step that has no film.
    """
    studio = Workshop(work / "films", chosen)
    with studio.locked():
        studio.prepare(student)
        for task in chosen:
            put_bodies(task, hand_in, studio.directory / "copy")
        return [
            sentence
            for step in sorted({make.PROGRAMS[task.step] for task in chosen})
            if (sentence := write_film(step, studio, programs, out / "films" / step))
        ]


def put_bodies(task, hand_in, copy):
    """What is refused, cannot be read, or is not written yet, stays as the project has it."""
    try:
        bodies, helpers = handed.bodies(task, hand_in), handed.helpers(hand_in)
    except Refused:
        return
    if task.kind == "write" and is_given(task, bodies):
        return
    file = copy / task.file
    file.write_text(with_bodies(file.read_text(), task, bodies))
    if helpers:
        (copy / handed.HELPERS).write_text(helpers)


def write_film(step, studio, programs, out):
    """A sentence if there is no film."""
    compare, reference = programs / "tests/frames/compare_runs", programs / step / step
    if not (compare.exists() and reference.exists()):
        return f"No film of {step}: {programs} has no {step} and compare_runs. Build them first."
    if output := studio.run(
        "cmake", "--build", studio.build, "--target", step, seconds=10 * COMPILE_SECONDS
    ):
        return f"No film of {step}: it does not compile: {shown_error(output, studio.directory)}"
    with tempfile.TemporaryDirectory() as place:
        run = pathlib.Path(place) / "run"
        run.mkdir()
        shutil.copy2(studio.build / step / step, run / "program")
        shutil.copy2(SOURCE / step / "scene.toml", run)
        output = pathlib.Path(place) / "output"
        code, late = runs.run_apart(
            ["./program", "scene.toml", "--out", "yours", *make.FILM], run, output, FILM_SECONDS
        )
        if code or late:
            return (
                f"No film of {step}: the run ended with exit code {code}: {runs.last_line(output)}"
            )
        subprocess.run(
            [reference, "--out", run / "reference", *make.FILM],
            check=True,
            stdout=subprocess.DEVNULL,
        )
        out.mkdir(parents=True, exist_ok=True)
        for name in ("reference", "yours"):
            shutil.copytree(run / name, out / name, dirs_exist_ok=True)
    subprocess.run(
        [compare, out / "reference", out / "yours", "--html", out / "report.html"],
        stdout=subprocess.DEVNULL,
    )
    return ""
