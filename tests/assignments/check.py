#!/usr/bin/env python3
"""Checks tasks of this copy: builds the check of each task and runs it.

    ./check A3.1          one task
    ./check A3            all tasks A3.…
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
import handed
import results
import runs

COPY = HERE.parents[1]
BUILD = COPY / "build"


class Part:
    """A task, as tasks.json of a copy tells it."""

    def __init__(self, entry):
        self.__dict__.update(entry)
        self.target = "check_" + self.id.replace(".", "_")


def is_given(task, bodies):
    """True if every body is the one that was handed out."""
    return [results.fingerprint(body) for body in bodies] == task.given


def build(target):
    """(whether it succeeded, the output of the compiler)"""
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
    return done.returncode == 0, done.stdout.replace(f"{COPY}/", "")


def answered(task):
    """Of a task that measures: whether answers.toml has a number."""
    try:
        number = answers.number(COPY, task.id)
    except answers.AnswerError as error:
        return runs.Ending(runs.FAILED, str(error))
    if number is None:
        return runs.Ending(runs.UNWRITTEN, f"answers.toml has no number for {task.id}.")
    return runs.Ending(
        runs.ANSWERED,
        f"answers.toml has the number {number:g} for {task.id}. "
        "Only the grader knows whether it is right.",
    )


def check(task):
    if task.kind == "measure":
        return answered(task)
    try:
        if is_given(task, handed.bodies(task, COPY)):
            return runs.Ending(runs.UNWRITTEN, results.KINDS[task.kind])
        handed.helpers(COPY)
    except handed.Refused as error:
        return runs.Ending(runs.FAILED, str(error))
    print(f"Building the check of {task.id} …", flush=True)
    built, output = build(task.target)
    if not built:
        return runs.Ending(runs.FAILED, "It does not compile: " + runs.first_error(output))
    return with_warning(runs.run_check(BUILD / "checks" / task.target), output)


def with_warning(ending, output):
    """A failure, with the first warning of the compiler: it often says why."""
    if ending.state == runs.FAILED and (warning := runs.first_line(output, " warning: ")):
        ending.message += "\nThe compiler warns: " + warning
    return ending


def main():
    every = {entry["id"]: Part(entry) for entry in json.loads((HERE / "tasks.json").read_text())}
    parser = argparse.ArgumentParser(
        prog="check", description="Builds and runs the checks of tasks."
    )
    parser.add_argument(
        "tasks", nargs="*", metavar="TASK", help=f"{', '.join(every)}; without one, all of them"
    )
    chosen = []
    for name in parser.parse_args().tasks or list(every):
        hits = [id for id in every if id == name or id.startswith(name + ".")]
        if not hits:
            print(
                f"check: there is no task {name} here; there are {', '.join(every)}",
                file=sys.stderr,
            )
            return 2
        chosen += [id for id in hits if id not in chosen]
    found = [results.result(every[id], check(every[id])) for id in chosen]
    print(results.table(found))
    return 0 if all(r.state == runs.PASSED for r in found) else 1


if __name__ == "__main__":
    sys.exit(main())
