#!/usr/bin/env python3
"""Writes a copy of the project in which the functions of some tasks are missing.

    python3 tests/assignments/make.py A3.1 A3.2 --out DIR        two tasks
    python3 tests/assignments/make.py A1 C1 --student ada --out DIR     all tasks A1.… and C1.…

DIR is complete: a student needs nothing else but the Debian packages of the project. It has the
checks of the tasks, `check A3.1`, and a README. A task is refused if another file of the copy
answers it.
"""
import argparse
import json
import pathlib
import re
import shutil
import subprocess
import sys

import functions
import measures
import results
import tasks
from tasks import HERE, SOURCE, TaskError

PROGRAMS = {
    1: "step01_explicit",
    2: "step02_damping",
    3: "step03_implicit",
    4: "step04_cg",
    5: "step05_bend",
}
STUDENT_FILES = {
    "helpers.h": "common/math/helpers.h",
    "not_written.h": "common/math/not_written.h",
    "checks.cmake": "tests/assignments/checks.cmake",
    "check": "check",
    "Containerfile": "Containerfile",
}
HOW = {  # what each kind of task asks for
    "write": "**Write** (A). The body of a function is missing. The comment above the function "
    "has its formula, and\n  the lesson derives it.",
    "mend": "**Find the mistake** (B). A function has a mistake. Find it and mend it.",
    "measure": "**Measure** (C). You have a scene of your own. Run it, and write the number into\n"
    "  [answers.toml](answers.toml). `./check` reads the number, and only the grader knows whether\n"
    "  it is right.",
    "invent": "**Invent** (D). You write a condition or a force that the project does not have, "
    "into a file\n  of `inventions`.",
}
NEEDS = (
    " Solve the tasks A\nand B first: the program uses their functions, "
    "and stops where one is missing."
)
FILM = ["--size", "640x360", "--export", "obj"]  # of the run that a student compares with
TOOLS = ["answers.py", "functions.py", "handed.py", "runs.py", "results.py", "check.py"]


# The files of a copy ------------------------------------------------------------------------------


def included(path, roots):
    """The project's files that a file includes, directly or not."""
    found, waiting = set(), [path]
    while waiting:
        for name in re.findall(r'^#include "([^"]+)"', waiting.pop().read_text(), re.MULTILINE):
            for root in roots:
                file = root / name
                if file.exists() and file not in found:
                    found.add(file)
                    waiting.append(file)
    return found


def files_of(chosen):
    """The files that the tasks need, as paths below SOURCE."""
    files = {SOURCE / name for name in ("LICENSE", ".clang-format")}
    files |= {
        f for f in (SOURCE / "common").rglob("*") if f.is_file() and "__pycache__" not in f.parts
    }
    for step in {task.step for task in chosen}:
        files |= {f for f in (SOURCE / PROGRAMS[step]).rglob("*") if f.is_file()}
    checks = HERE / "checks"
    for task in chosen:
        if task.check:
            files |= {checks / task.check} | included(
                checks / task.check, [SOURCE, SOURCE / "tests"]
            )
    files |= {checks / "main.cpp"} | included(checks / "main.cpp", [SOURCE / "tests"])
    files |= files_of_compare_runs()
    return sorted(f.relative_to(SOURCE) for f in files)


def files_of_compare_runs():
    frames = SOURCE / "tests/frames"
    listed = frames / "compare_runs.cmake"
    sources = {frames / name for name in re.findall(r"\$\{here\}/(\w+\.cpp)", listed.read_text())}
    headers = set().union(*(included(source, [frames, SOURCE / "tests"]) for source in sources))
    return {listed} | sources | headers | {f for f in (frames / "page").rglob("*") if f.is_file()}


# Answers that stand elsewhere ---------------------------------------------------------------------


def statement(line):
    """A line without spaces, comments, the mark of a diff, and the head of a loop, which many
    functions share.
    """
    line = functions.squeezed(re.sub(r"^[<>] ", "", line))
    head = re.match(r"for\((?:[^()]|\([^()]*\))*\)", line)
    return line[head.end() :] if head else line


def telling_lines(body):
    """The statements of a body that give an answer away."""
    lines = [statement(line) for line in body.split("\n")]
    return {
        line
        for line in lines
        if len(line) >= 24 and not line.startswith(("for(", "if(", "const auto"))
    }


# The fold of a lesson with the diff to the step before.
DIFF = r"<details><summary>The diff</summary>.*?</details>\n\n"


def without_answers(lesson, lines):
    """A lesson without its diff, and with … in place of each block of code that has a telling line:
    the loops and conditions around it tell as much.
    """

    def shown(block):
        tells = any(statement(line) in lines for line in block["code"].split("\n"))
        indent = block["indent"]
        return f"{indent}```cpp\n{indent}…\n{indent}```" if tells else block.group()

    lesson = re.sub(DIFF, "", lesson, flags=re.DOTALL)
    return re.sub(
        r"^(?P<indent> *)```cpp\n(?P<code>.*?)^(?P=indent)```$",
        shown,
        lesson,
        flags=re.MULTILINE | re.DOTALL,
    )


def refuse_answers(out, answers):
    """answers: task → telling lines. Raises TaskError if a file of the copy has one of them."""
    for path in sorted(out.rglob("*")):
        if path.suffix not in (".h", ".cpp", ".md", ".py", ".toml", ".json") or not path.is_file():
            continue
        for number, line in enumerate(path.read_text().split("\n"), 1):
            for task, lines in answers.items():
                if statement(line) in lines:
                    raise TaskError(
                        f"{task} is answered by {path.relative_to(out)}, line {number}: {line.strip()}\n"
                        "Hand out tasks of one step together, or only one of the two tasks."
                    )


# The copy -----------------------------------------------------------------------------------------


def numbers_header(task, student):
    """The numbers of one student, as a header."""
    lines = [
        f"inline constexpr double {name} = {value!r};"
        for name, value in task.numbers(student).items()
    ]
    return "// The numbers of one student.\n#pragma once\n\n" + "\n".join(lines) + "\n"


def add_term(cloth_h, task):
    """math/cloth.h, with the invented term at the end of its list: all steps then have it."""
    text, count = re.subn(
        rf"(using {task.list} =\s*Family<[^;]*)>;", rf"\1, {task.term}>;", cloth_h
    )
    if count != 1:
        raise TaskError(f"tasks/{task.id}.toml: math/cloth.h has no list {task.list}")
    return text.replace(
        '#include "math/triangle.h"', f'#include "math/triangle.h"\n#include "{task.file}"', 1
    )


def add_invention(task, out, student):
    (out / task.file).parent.mkdir(exist_ok=True)
    shutil.copy2(task.source, out / task.file)
    if task.given:
        (out / task.numbers_file).write_text(numbers_header(task, student))
    if task.term:
        cloth = out / "common/math/cloth.h"
        cloth.write_text(add_term(cloth.read_text(), task))


def add_reference(chosen, out, programs):
    """reference/STEP: the films of the project, if its programs are built. Returns the steps that
    have none.
    """
    missing = []
    for step in sorted({PROGRAMS[task.step] for task in chosen}):
        program = programs / step / step
        if program.exists():
            subprocess.run(
                [program, "--out", out / "reference" / step, *FILM],
                check=True,
                stdout=subprocess.DEVNULL,
            )
        else:
            missing.append(step)
    return missing


def fill_text(name, **values):
    """The text of a template of student/, with {{name}} replaced by a value."""
    text = (HERE / "student" / name).read_text()
    for key, value in values.items():
        text = text.replace("{{" + key + "}}", value)
    return text


def fill(name, out, **values):
    (out / name).write_text(fill_text(name + ".in", **values))


def copy(chosen, out, hand_out=True, student="nobody"):
    """Writes the copy. With hand_out=False the bodies stay: this is what the grader builds."""
    copy_files(chosen, out)
    for task in chosen:
        if task.kind == "invent":
            add_invention(task, out, student)
    if hand_out:
        answers = {task.id: take_bodies(task, out) for task in chosen}
        take_quotes(out, set().union(*answers.values()))
        refuse_answers(out, answers)
        measures.add(chosen, out, student)
    write_tasks(chosen, out, student)


def copy_files(chosen, out):
    pairs = [(SOURCE / path, path) for path in files_of(chosen)]
    pairs += [(HERE / name, f"tests/assignments/{name}") for name in TOOLS]
    pairs += [(HERE / "student" / name, place) for name, place in STUDENT_FILES.items()]
    for source, place in pairs:
        (out / place).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(source, out / place)
    types = out / "common/math/types.h"
    types.write_text(
        types.read_text() + '\n#include "math/helpers.h"\n#include "math/not_written.h"\n'
    )


def take_bodies(task, out):
    """Puts what is handed out in place of the bodies. Returns the telling lines that this takes
    away.
    """
    taken = set()
    if task.kind == "invent":
        return taken
    for function in task.functions:
        text = (out / task.file).read_text()
        body = functions.body(text, function, task.file)
        given = task.given_body(body, function)
        if task.kind == "write":
            given = given.replace("\n", "\n" + functions.indentation(text, function))
        (out / task.file).write_text(functions.with_body(text, function, given, task.file))
        taken |= telling_lines(body) - telling_lines(given)
    return taken


def take_quotes(out, lines):
    for lesson in out.glob("step0*/README.md"):
        lesson.write_text(without_answers(lesson.read_text(), lines))


def write_tasks(chosen, out, student):
    """The files of the copy that name the tasks: tasks.json, CMakeLists.txt and README.md."""
    public = [public_part(task, out, student) for task in chosen]
    (out / "tests/assignments/tasks.json").write_text(
        json.dumps(public, indent=1, ensure_ascii=False) + "\n"
    )
    steps = sorted({PROGRAMS[task.step] for task in chosen})
    checks = [" ".join([task.id, task.check, *task.libraries]) for task in chosen if task.check]
    fill(
        "CMakeLists.txt",
        out,
        steps="\n".join(f"add_subdirectory({step} EXCLUDE_FROM_ALL)" for step in steps),
        checks="\n".join(f"check({check})" for check in checks),
    )
    kinds = {task.kind for task in chosen}
    fill(
        "README.md",
        out,
        kinds="\n".join(f"- {text}" for kind, text in HOW.items() if kind in kinds),
        first=chosen[0].id,
        points=str(sum(task.points for task in chosen)),
        count=str(len(chosen)),
        answers=" and answers.toml" if "measure" in kinds else "",
        see="\n".join(see(step, NEEDS if kinds & {"write", "mend"} else "") for step in steps),
        tasks="\n".join(section(task, student) for task in chosen),
    )


def see(step, needs):
    """How a student sees the program of a step, and compares it with the project's."""
    return fill_text("see.md.in", step=step, needs=needs, film=" ".join(FILM))


def public_part(task, out, student):
    """What the copy tells of a task: nothing of its answer. `given`: the bodies that were handed
    out. `numbers`: those of the student.
    """
    text = (out / task.file).read_text() if task.file else ""
    given = [results.fingerprint(functions.body(text, name, task.file)) for name in task.functions]
    return {
        "id": task.id,
        "kind": task.kind,
        "title": task.title,
        "points": task.points,
        "file": task.file,
        "functions": task.functions,
        "lesson": task.lesson,
        "hint": task.hint,
        "given": given,
        "numbers": task.numbers(student),
    }


def table_of_tasks():
    kinds = {"mend": "find the mistake"}
    lines = ["| task | kind | points | minutes | title |", "|---|---|---|---|---|"]
    lines += [
        f"| {t.id} | {kinds.get(t.kind, t.kind)} | {t.points} | {t.minutes} | {t.title} |"
        for t in tasks.load_all().values()
    ]
    return "\n".join(lines)


def section(task, student):
    """The task in the README of the copy."""
    ask = {
        "write": "Write `{f}` in [{file}]({file}).",
        "invent": "Write `{f}` in [{file}]({file}).",
        "mend": "`{f}` in [{file}]({file}) has a mistake. Find it and mend it.",
        "measure": "The scene: `build/{p}/{p} measure/{id}/scene.toml --no-pictures`, with the program "
        "that you have\nbuilt as above. Write your answer into [answers.toml](answers.toml).",
    }[task.kind]
    names = "`, `".join(re.sub(r"\(.*", "", f) for f in task.functions)
    question = task.question.strip().format(**task.numbers(student))
    return (
        f"### {task.id} · {task.title} ({task.points} points, about {task.minutes} minutes)\n\n"
        + (question and f"{question}\n\n")
        + ask.format(f=names, file=task.file, p=PROGRAMS[task.step], id=task.id)
        + f" The lesson: [{task.lesson}]({task.lesson}).\n\n"
        f"<details><summary>A hint</summary>\n\n{task.hint}\n\n</details>\n"
    )


def main():
    parser = argparse.ArgumentParser(
        description=__doc__.split("\n")[0], epilog="Tasks: " + ", ".join(tasks.load_all()) + "."
    )
    parser.add_argument(
        "tasks", nargs="*", metavar="TASK", help="A3.2, or A3 for all that begin so"
    )
    parser.add_argument("--list", action="store_true", help="print a table of all tasks")
    parser.add_argument("--out", type=pathlib.Path, metavar="DIR", help="a new directory")
    parser.add_argument(
        "--student", default="nobody", metavar="ID", help="chooses the numbers of the tasks C and D"
    )
    parser.add_argument(
        "--with-reference",
        nargs="+",
        default=[],
        metavar="TASK",
        help="these tasks are not asked for: their functions are the project's",
    )
    parser.add_argument(
        "--build",
        type=pathlib.Path,
        default=SOURCE / "build/release",
        metavar="DIR",
        help="where the project is built; its programs make the reference films (default: %(default)s)",
    )
    options = parser.parse_args()
    if options.list:
        return print(table_of_tasks())
    if not (options.tasks and options.out):
        raise TaskError(
            "name the tasks and a new directory, as in A3.1 A3.2 --out DIR; --list lists the tasks"
        )
    if options.out.exists() and any(options.out.iterdir()):
        raise TaskError(f"{options.out} is not empty; --out needs a new directory")
    unfinished = options.out.with_name(options.out.name + ".unfinished")
    shutil.rmtree(unfinished, ignore_errors=True)
    try:
        known = [task.id for task in tasks.select(options.with_reference)]
        chosen = [task for task in tasks.select(options.tasks) if task.id not in known]
        if not chosen:
            raise TaskError("no task is left: --with-reference names all of them")
        copy(chosen, unfinished, student=options.student)
        missing = add_reference(chosen, unfinished, options.build)
        unfinished.rename(options.out)
    finally:
        shutil.rmtree(unfinished, ignore_errors=True)
    for step in missing:
        print(
            f"{options.out} has no reference film of {step}: {options.build} has no such program. "
            f"For a film, run cmake --build {options.build} --target {step} and make the copy again."
        )
    names, points = " ".join(task.id for task in chosen), sum(task.points for task in chosen)
    print(f"{options.out}: {names}, {points} points. Its README says how to begin.")


if __name__ == "__main__":
    try:
        main()
    except (TaskError, functions.CodeError) as error:
        print(f"make.py: {error}", file=sys.stderr)
        sys.exit(2)
