#!/usr/bin/env python3
"""Grades the tasks of a hand-in.

    python3 tests/assignments/grade.py DIR A3 B3 --student ada --out results/ada

DIR is the student's copy. The bodies of the named functions, helpers.h, and answers.toml are graded,
and tasks.json is read to warn of another --student. For each task the code goes into the project's
own, so that a mistake costs one task. Answers are compared with what the project's programs measure
(measures.py). The result is a table, and in --out: results.json for Gradescope, junit.xml, and one
file TASK.exit with an exit code for each task.

Exit code: 0 if all tasks passed, 1 if not, 2 if the command cannot be used.
"""
import argparse
import contextlib
import fcntl
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

import answers
import functions
import handed
import make
import measures
import results
import runs
import tasks
from handed import Refused
from runs import FAILED, PASSED, UNWRITTEN, Ending
from tasks import SOURCE

COMPILE_SECONDS = 120


# The workshop: the project's own code, in which one task at a time is the student's
# -----------------


class Workshop:
    """A copy in which all bodies are the project's. It is made once, and is used for every hand-in."""

    def __init__(self, directory, chosen):
        self.directory, self.build = directory, directory / "build"
        self.hand_in = directory / "hand_in"
        self.chosen = {task.id: task for task in chosen}

    @contextlib.contextmanager
    def locked(self):
        self.directory.mkdir(parents=True, exist_ok=True)
        with open(self.directory / "lock", "w") as lock:
            fcntl.flock(lock, fcntl.LOCK_EX)
            yield self

    def prepare(self, student="nobody"):
        """Writes the copy, with the numbers of a student, and configures it. Files that have not
        changed keep their time: nothing is rebuilt.
        """
        fresh = self.directory / "fresh"
        shutil.rmtree(fresh, ignore_errors=True)
        make.copy(list(self.chosen.values()), fresh, hand_out=False, student=student)
        for path in fresh.rglob("*"):
            old = self.directory / "copy" / path.relative_to(fresh)
            if path.is_file() and not (old.exists() and old.read_bytes() == path.read_bytes()):
                old.parent.mkdir(parents=True, exist_ok=True)
                shutil.copy2(path, old)
        shutil.rmtree(fresh)
        self.run(
            "cmake",
            "-S",
            self.directory / "copy",
            "-B",
            self.build,
            "-G",
            "Ninja",
            "-DCMAKE_BUILD_TYPE=Release",
            "-DCMAKE_CXX_FLAGS=",
            f"-DHAND_IN={self.hand_in}",
        )
        # What no student writes is built now, so that it takes no time from the first hand-in.
        common = {"check_main"}.union(*(task.libraries for task in self.chosen.values()))
        self.run(
            "cmake", "--build", self.build, "--target", *sorted(common), seconds=5 * COMPILE_SECONDS
        )

    def run(self, *command, seconds=COMPILE_SECONDS):
        """The output if the command failed, else nothing."""
        try:
            done = subprocess.run(
                command,
                stdout=subprocess.PIPE,
                stderr=subprocess.STDOUT,
                text=True,
                errors="replace",
                timeout=seconds,
            )
        except subprocess.TimeoutExpired:
            return f"error: the compiler was still busy after {seconds} seconds"
        return done.stdout if done.returncode else ""

    def place(self, task, changed):
        """changed: file → text, for this task only."""
        shutil.rmtree(self.hand_in / task.id, ignore_errors=True)
        for file, text in changed.items():
            path = self.hand_in / task.id / file
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)
        (self.directory / "copy/tests/assignments/checks" / task.check).touch()

    def build_together(self, placed):
        """Builds the checks of several tasks at once, which takes less time. What fails is built
        again by check().
        """
        if placed:
            self.run(
                "cmake",
                "--build",
                self.build,
                "--target",
                *(task.target for task in placed),
                "--",
                "-k",
                "0",
                seconds=COMPILE_SECONDS * len(placed),
            )

    def check(self, task, seed):
        if output := self.run("cmake", "--build", self.build, "--target", task.target):
            return Ending(FAILED, "It does not compile: " + shown_error(output, self.directory))
        return runs.run_check(self.build / "checks" / task.target, seed)


def shown_error(output, directory):
    """The first error of the compiler, with the student's name of the file."""
    error = runs.first_error(output)
    return re.sub(re.escape(str(directory)) + r"/(hand_in/[^/]+|copy|build)/", "", error)


# Grading ------------------------------------------------------------------------------------------


def project_text(task):
    """The file of a task as the project has it; of an invention, as it was handed out."""
    return task.source.read_text()


def is_project(task, bodies):
    """True if every body is the project's own, but for comments and spaces."""
    text = project_text(task)
    return all(
        functions.squeezed(body) == functions.squeezed(functions.body(text, name, task.file))
        for body, name in zip(bodies, task.functions)
    )


def is_given(task, bodies):
    """True if every body is the one that was handed out."""
    text = project_text(task)
    given = [functions.body(text, name, task.file) for name in task.functions]
    if task.kind != "invent":
        given = [task.given_body(body, name) for body, name in zip(given, task.functions)]
    return [functions.squeezed(b) for b in bodies] == [functions.squeezed(b) for b in given]


def changed_files(task, bodies, helpers, student):
    """The files in which the student's code for this task stands."""
    text = project_text(task)
    for name, body in zip(task.functions, bodies):
        text = functions.with_body(text, name, body, task.file)
    changed = {task.file: text}
    if helpers:
        changed[handed.HELPERS] = helpers
    if task.kind == "invent" and task.given:
        changed[task.numbers_file] = make.numbers_header(task, student)
    return changed


def code_of(task, hand_in, student):
    """What is known without a check, or else the files in which the student's code stands."""
    try:
        bodies = handed.bodies(task, hand_in)
        if is_given(task, bodies):
            return Ending(UNWRITTEN, results.KINDS[task.kind])
        if task.kind != "invent" and is_project(task, bodies):
            return Ending(PASSED)
        return changed_files(task, bodies, handed.helpers(hand_in), student)
    except Refused as error:
        return Ending(FAILED, str(error))


def grade_codes(chosen, hand_in, student, seed, workshop):
    """How each task ended whose answer is code."""
    endings = {task.id: code_of(task, hand_in, student) for task in chosen}
    placed = [task for task in chosen if not isinstance(endings[task.id], Ending)]
    for task in placed:
        workshop.place(task, endings[task.id])
    workshop.build_together(placed)
    for task in placed:
        endings[task.id] = workshop.check(task, seed)
    return endings


def grade(chosen, hand_in, student, seed, workshop, build=SOURCE / "build/release"):
    endings = grade_codes([task for task in chosen if task.check], hand_in, student, seed, workshop)
    for task in chosen:
        if task.kind == "measure":
            endings[task.id] = measures.grade(task, hand_in, student, measures.Programs(build))
    return [results.result(task, endings[task.id]) for task in chosen]


# Slips of the grader ------------------------------------------------------------------------------


def handed_out(hand_in):
    """What the copy says about its tasks, task → its entry. The student may have changed it."""
    try:
        entries = json.loads(handed.read(hand_in, "tests/assignments/tasks.json"))
        return {entry["id"]: entry for entry in entries}
    except (Refused, ValueError, TypeError, KeyError, RecursionError):
        return {}


def doubts(chosen, hand_in, student):
    """Sentences if the directory is no copy, or one with other tasks, or for another --student."""
    if not any((hand_in / (task.file or answers.FILE)).is_file() for task in chosen):
        yield f"{hand_in} has no file of these tasks: it is not what make.py wrote"
    known = handed_out(hand_in)
    for task in chosen if known else []:
        numbers = task.numbers(student)
        if task.id not in known:
            yield f"{hand_in} was made without {task.id}: the code there is the project's own"
        elif known[task.id].get("numbers", numbers) != numbers:
            yield f"{hand_in} has other numbers for {task.id} than --student {student} would have"


# Films --------------------------------------------------------------------------------------------

FILM_SECONDS = 120


def write_films(chosen, hand_in, student, work, programs, out):
    """out/films/STEP/report.html: the film of the project and that of the student, with all bodies of the student
    that are taken. Returns a sentence for each step that has no film."""
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
    text = (copy / task.file).read_text()
    for name, body in zip(task.functions, bodies):
        text = functions.with_body(text, name, body, task.file)
    (copy / task.file).write_text(text)
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


# Results ------------------------------------------------------------------------------------------


def write(found, out):
    out.mkdir(parents=True, exist_ok=True)
    (out / "results.json").write_text(results.gradescope(found))
    (out / "junit.xml").write_text(results.junit(found))
    for r in found:
        (out / f"{r.id}.exit").write_text("0\n" if r.state == PASSED else "1\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("hand_in", type=pathlib.Path, metavar="DIR", help="the student's copy")
    parser.add_argument(
        "tasks", nargs="+", metavar="TASK", help="A3.2, or A3 for all that begin so"
    )
    parser.add_argument(
        "--student", default="nobody", metavar="ID", help="whose numbers the tasks C and D have"
    )
    parser.add_argument(
        "--hidden", type=int, default=1, metavar="SEED", help="other random numbers in the checks"
    )
    parser.add_argument(
        "--out", type=pathlib.Path, metavar="DIR", help="where results.json and junit.xml go"
    )
    parser.add_argument(
        "--work",
        type=pathlib.Path,
        default=SOURCE / "build/assignments",
        metavar="DIR",
        help="where the project is built for the checks (default: %(default)s)",
    )
    parser.add_argument(
        "--frames",
        action="store_true",
        help="write films of the student's programs beside the project's into --out",
    )
    parser.add_argument(
        "--build",
        type=pathlib.Path,
        default=SOURCE / "build/release",
        metavar="DIR",
        help="where the project is built (default: %(default)s)",
    )
    options = parser.parse_args()
    if options.frames and not options.out:
        raise tasks.TaskError("--frames needs --out DIR, where the films go")
    if not options.hand_in.is_dir():
        raise tasks.TaskError(f"{options.hand_in} is not a directory")
    chosen = tasks.select(options.tasks)
    for sentence in doubts(chosen, options.hand_in, options.student):
        print(f"grade.py: {sentence}", file=sys.stderr)
    if not runs.sandbox():
        print(
            "grade.py: bubblewrap does not work here: the code of students runs with your rights, "
            "and can read your files",
            file=sys.stderr,
        )
    with Workshop(options.work, chosen).locked() as workshop:
        workshop.prepare()
        found = grade(
            chosen, options.hand_in, options.student, options.hidden, workshop, options.build
        )
    print(results.table(found))
    if options.out:
        write(found, options.out)
    if options.frames:
        code = [task for task in chosen if task.check]
        for sentence in write_films(
            code, options.hand_in, options.student, options.work, options.build, options.out
        ):
            print(sentence)
    return 0 if all(r.state == PASSED for r in found) else 1


if __name__ == "__main__":
    try:
        sys.exit(main())
    except (tasks.TaskError, functions.CodeError) as error:
        print(f"grade.py: {error}", file=sys.stderr)
        sys.exit(2)
