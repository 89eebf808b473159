#!/usr/bin/env python3
"""Checks tasks of this copy: builds the check of each task and runs it.

    ./check A3.1          one task
    ./check               all of them
"""
import argparse
import json
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
import answers
import functions
import results
import runs

COPY = HERE.parents[1]
BUILD = COPY / "build"


class Part:
    """A task, as tasks.json of a copy tells it."""

    def __init__(self, entry):
        self.__dict__.update(entry)
        self.target = "check_" + self.id.replace(".", "_")


def is_given(task):
    """True if every body is the one that was handed out."""
    text = (COPY / task.file).read_text()
    bodies = [functions.body(text, name, task.file) for name in task.functions]
    return [results.fingerprint(body) for body in bodies] == task.given


def build(target):
    """The output of the build, empty if it succeeded."""
    if not (BUILD / "CMakeCache.txt").exists():
        print("Configuring …", flush=True)
        done = subprocess.run(
            [
                "cmake",
                "-S",
                COPY,
                "-B",
                BUILD,
                "-G",
                "Ninja",
                "-DCMAKE_BUILD_TYPE=Release",
                "-DCMAKE_CXX_FLAGS=",
            ],
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
        )
        if done.returncode:
            sys.exit(f"check: this copy cannot be configured:\n{done.stdout}")
    done = subprocess.run(
        ["cmake", "--build", BUILD, "--target", target],
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
    )
    return done.stdout if done.returncode else ""


def answered(task):
    """Of a task that measures: whether answers.toml has a number. Only the grader knows whether it
    is right.
    """
    try:
        number = answers.number(COPY, task.id)
    except answers.AnswerError as error:
        return runs.Ending(runs.FAILED, str(error))
    has = "no number" if number is None else f"the number {number:g}"
    return runs.Ending(
        runs.UNWRITTEN, f"answers.toml has {has} for {task.id}. The grader compares it."
    )


def check(task):
    if task.kind == "measure":
        return answered(task)
    try:
        if is_given(task):
            return runs.Ending(runs.UNWRITTEN, results.KINDS[task.kind])
    except (OSError, functions.CodeError) as error:
        return runs.Ending(runs.FAILED, str(error))
    print(f"Building the check of {task.id} …", flush=True)
    if output := build(task.target):
        return runs.Ending(runs.FAILED, "It does not compile: " + runs.first_error(output))
    return runs.run_check(BUILD / "checks" / task.target)


def main():
    every = {entry["id"]: Part(entry) for entry in json.loads((HERE / "tasks.json").read_text())}
    parser = argparse.ArgumentParser(
        prog="check", description="Builds and runs the checks of tasks."
    )
    parser.add_argument(
        "tasks", nargs="*", metavar="TASK", help=f"{', '.join(every)}; without one, all of them"
    )
    names = parser.parse_args().tasks or list(every)
    if unknown := [name for name in names if name not in every]:
        print(
            f"check: there is no task {unknown[0]} here; there are {', '.join(every)}",
            file=sys.stderr,
        )
        return 2
    found = [results.result(every[name], check(every[name])) for name in names]
    print(results.table(found))
    return 0 if all(r.state == runs.PASSED for r in found) else 1


if __name__ == "__main__":
    sys.exit(main())
