"""The workshop of the grader: the project's own code, in which one task at a time is the student's."""
import contextlib
import fcntl
import re
import shutil
import subprocess

import functions
import handed
import make
import runs
from runs import FAILED, Ending
from tasks import TaskError

COMPILE_SECONDS = 120


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


def with_bodies(text, task, bodies):
    """The text of the task's file, with these bodies."""
    for name, body in zip(task.functions, bodies):
        text = functions.with_body(text, name, body, task.file)
    return text


def changed_files(task, bodies, helpers, student):
    """The files in which the student's code for this task stands."""
    changed = {task.file: with_bodies(project_text(task), task, bodies)}
    if helpers:
        changed[handed.HELPERS] = helpers
    if task.kind == "invent" and task.given:
        changed[task.numbers_file] = make.numbers_header(task, student)
    return changed


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
        changed keep their time: nothing is rebuilt. Raises TaskError where the project itself cannot
        be built: no student is to pay for that.
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
        self.must(
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
        self.must(
            "cmake", "--build", self.build, "--target", *sorted(common), seconds=5 * COMPILE_SECONDS
        )

    def must(self, *command, seconds=COMPILE_SECONDS):
        if output := self.run(*command, seconds=seconds):
            raise TaskError(f"{self.directory}: the project itself cannot be built:\n{output}")

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
