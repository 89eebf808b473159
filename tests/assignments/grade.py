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
import json
import pathlib
import sys

import answers
import functions
import handed
import measures
import results
import runs
import tasks
from films import write_films
from handed import Refused
from runs import FAILED, PASSED, UNWRITTEN, Ending
from tasks import SOURCE
from workshop import Workshop, changed_files, is_given, is_project


# Grading ------------------------------------------------------------------------------------------


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
