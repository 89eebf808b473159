#!/usr/bin/env python3
"""Runs the commands that a reader of the Markdown files can type.

    python3 tests/lesson/run_commands.py           runs the cheap ones; the test Lessons.CommandsRun
    python3 tests/lesson/run_commands.py --list    prints all of them, each with its class
    python3 tests/lesson/run_commands.py --fully   runs all of them, in a fresh checkout; with
                                                   names of files, only those of these files

A command is a block "```sh", a line of code that begins with a program, or a span of code that
begins with one. A loop is one command. Each command has a class:

cheap      The test runs it: without pictures, or with small ones if the command uses them.
done       update_lessons.py runs the same text.
rehearsed  It builds, or runs tests. The test asks whether the target or the tests exist.
expensive  It measures for long, builds, or changes the checkout.

Only --fully runs the last two. Its checkout is that of the last commit, and the commands of the
README build it. A word such as my_scene.toml stands for something of the reader: STAND_INS says
what it is here. The exit code has to be 0, or 1 where ENDS_WITH_1 has a reason.
"""
import argparse
import itertools
import os
import pathlib
import platform
import re
import subprocess
import sys
import tempfile
import textwrap
import time

import update_lessons
from update_lessons import SOURCE, LessonError, Recipe, Runner

# Classes ------------------------------------------------------------------------------------------

THIS_TARGET = "--target check_lessons_fully"  # would start itself again
BUILDS_THE_CHECKOUT = "install_packages"

EXPENSIVE = (
    (r"install_packages|cmake --(workflow|preset)|cmake -S", "it configures and builds"),
    (r"update_lessons\.py", "it changes the lessons"),
    (r"pictures\.py(?! --list)", "it draws pictures of the lessons"),
    (r"run_commands\.py --fully", "it runs the commands of a lesson"),
    (r"tradeoff/tradeoff(?! --help)|stability_map|definite_study|measure_tolerance|threshold_study",
     "it measures for minutes"),
    (r"compare_models|cantilever_points|draw_energy", "it draws pictures of a lesson"),
    (r"bench/", "it measures times"),
    (r"_test\.py --task", "it compiles for a minute"),
    (r"--explain", "it measures for twenty seconds"),
    (r"^(for (h|k|fabric) in|while read)|step03\S+ .*--cells 80", "its runs take 6 to 45 s"),
)

REHEARSALS = (  # command, the same without effect
    (r"ctest (?=--test-dir )", "ctest -N "),
    (r"cmake --build build/release( --target \w+)?", r"\g<0> -- -n"),
)

ENDS_WITH_1 = (
    (r"^diff ", "the files differ"),
    (r"compare_(runs|frames) ", "the runs differ"),
    (r"assignments/grade\.py ", "a fresh copy has no points"),
    (r"^for kd in", "the strongest damping explodes"),
    (r"step0\S+ .*--jacobian bw98", "the cloth explodes: this matrix is not definite"),
    (r"step01\S+ --h 2.88e-4", "the cloth explodes: h is beyond h_crit"),
)

STAND_INS = {  # a word of the reader, and what it is here
    "my_scene.toml": "step04_cg/scene.toml",
    "a.png": "step04_cg/frame.png",
    "b.png": "step05_bend/frame.png",
    "HALF_OF_KD": "0.05",
    "KD": "0.1",
}


class Command:
    """A text that a shell can run, and where it stands."""

    def __init__(self, file, line, text):
        self.file, self.line, self.text = file, line, text

    @property
    def place(self):
        return f"{self.file}:{self.line}"

    def kind(self, done=()):
        """(class, reason)"""
        if self.text in done:
            return "done", "update_lessons.py runs it"
        if rehearsal(self.text):
            return "rehearsed", "it builds or runs tests"
        for pattern, reason in EXPENSIVE:
            if re.search(pattern, self.text):
                return "expensive", reason
        return "cheap", ""

    def exit_code(self):
        return int(any(re.search(pattern, self.text) for pattern, _ in ENDS_WITH_1))


def rehearsal(text):
    """The text without effect, or None if a line of it has no rehearsal."""
    lines = []
    for line in text.splitlines():
        for pattern, harmless in REHEARSALS:
            if re.match(pattern, line):
                lines.append(re.sub(pattern, harmless, line, count=1))
                break
        else:
            return None
    return "\n".join(lines)


# Finding ------------------------------------------------------------------------------------------

INSTRUMENT = r"build/release/tests/[\w/]+(?=\s|$|`)"  # a command even without arguments
PROGRAM = r"(?:build/release/step0\w+/\w+|ctest --test-dir|cmake -\S+|diff|python3)\s"
LINE = re.compile(rf"{INSTRUMENT}|build/release/step0\w+/\w+$|{PROGRAM}|(?:for|while) \w")
SPAN = re.compile(rf"`((?:{INSTRUMENT}|{PROGRAM})[^`]*)`")


def without_comments(text):
    """The text with its HTML comments blank, line by line."""
    return re.sub(r"<!--.*?-->", lambda match: re.sub(r"[^\n]", " ", match[0]), text, flags=re.S)


def commands_of_lines(lines):
    """(offset, text) of each command: a whole loop, or a line with its continuations."""
    if re.match(r"(for|while) ", lines[0]):
        yield 0, "\n".join(lines)
        return
    begin = 0
    for end, line in enumerate(lines):
        if not line.endswith("\\"):
            yield begin, "\n".join(lines[begin:end + 1])
            begin = end + 1


def commands_of(file, text):
    """All commands of a Markdown text, in its order."""
    lines = without_comments(text).splitlines()
    prose = []  # (line, text) outside of blocks
    found = []
    i = 0
    while i < len(lines):
        begin = i
        if fence := re.match(r" *```(\w*)$", lines[i]):
            i += 1
            while i < len(lines) and lines[i].strip() != "```":
                i += 1
            if fence[1] == "sh":
                block = textwrap.dedent("\n".join(lines[begin + 1:i]))
                found.append(Command(file, begin + 2, block))
            i += 1
        elif re.match(r" {4}", lines[i]) and LINE.match(lines[i].strip()):
            while i < len(lines) and re.match(r" {4}.*\S", lines[i]):
                i += 1
            block = textwrap.dedent("\n".join(lines[begin:i])).splitlines()
            found += [Command(file, begin + offset + 1, command)
                      for offset, command in commands_of_lines(block) if LINE.match(command)]
        else:
            prose.append((begin + 1, lines[i]))
            i += 1
    return sorted([*found, *spans_of(file, prose)], key=lambda command: command.line)


def spans_of(file, prose):
    """Commands in spans of code, which may go on in the next line."""
    text = "\n".join(line for _, line in prose)
    for match in SPAN.finditer(text):
        line = prose[text.count("\n", 0, match.start())][0]
        yield Command(file, line, " ".join(match[1].split()))


def documents():
    """All Markdown files in the order of reading: the README, the lessons, and the rest."""
    found = [path.relative_to(SOURCE) for path in SOURCE.rglob("*.md")]
    found = [path for path in found if path.parts[0] not in ("build", "out")]
    return sorted(found, key=lambda path: (
        str(path) != "README.md", not path.parts[0].startswith("step"), path))


def all_commands():
    return [command for path in documents()
            for command in commands_of(path, (SOURCE / path).read_text(encoding="utf-8"))]


def commands_of_update_lessons():
    """The commands that the test Lessons.PrintWhatTheProgramsPrint runs."""
    recipes = []
    for path in update_lessons.readmes():
        text = (SOURCE / path).read_text(encoding="utf-8")
        recipes += [Recipe(match[2]) for match in update_lessons.BLOCK.finditer(text)]
        recipes += [Recipe(match[2]) for match in update_lessons.DEFINITION.finditer(text)]
    return {recipe.command for recipe in recipes if not recipe.slow}


# Running ------------------------------------------------------------------------------------------

STEP_PROGRAM = r"build/release/(step0\d_\w+)/\1\b"
NEEDS_PICTURES = r"compare_runs|--motion"
# A script ends where a command ends with 2 or more. 1 is an explosion or a difference: it goes on.
BREAK_OFF = "trap 'code=$?; [ $code -lt 2 ] || exit $code' ERR\n"


def with_stand_ins(text):
    for word, here in STAND_INS.items():
        text = re.sub(rf"(?<![\w/.]){re.escape(word)}\b", here, text)
    return text


def with_cheap_pictures(text):
    """The text with small pictures if it needs them, and without pictures otherwise."""
    if re.search(NEEDS_PICTURES, text):
        text = re.sub(r" --size \S+", "", text)
        return re.sub(STEP_PROGRAM, r"\g<0> --size 80x45", text)
    if "--no-pictures" in text:
        return text
    return re.sub(STEP_PROGRAM, r"\g<0> --no-pictures", text)


def run_script(script, directory):
    """Runs commands of a shell. Returns their exit code and what they print."""
    result = subprocess.run(["bash", "-c", BREAK_OFF + script], cwd=directory, text=True,
                            errors="replace", stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                            stderr=subprocess.STDOUT, check=False)
    return result.returncode, result.stdout


def last_lines(output):
    return "\n".join(output.splitlines()[-20:])


def failure(command, script, directory):
    """Runs the script of a command. Returns what is wrong with it, or nothing."""
    code, output = run_script(with_stand_ins(script), directory)
    if "\nTotal Tests: 0\n" in output:
        return "it selects no test"
    if code != command.exit_code():
        return f"exit code {code} instead of {command.exit_code()}\n{last_lines(output)}"
    return ""


def run(jobs, directory, ran):
    """Runs (command, script) pairs. Returns (file, line) for each, and how many failed.

    What ran before is in ran, script → (place, what was wrong), and does not run again.
    """
    lines = []
    failed = 0
    for command, script in jobs:
        if script in ran:
            place, wrong = ran[script]
            took = f"as {place}"
        else:
            begin = time.monotonic()
            wrong = failure(command, script, directory)
            took = f"{time.monotonic() - begin:7.1f} s"
            ran[script] = command.place, wrong
        failed += bool(wrong)
        line = (f"{'FAILED' if wrong else 'OK':6} {took}  {command.place}  "
                + " ".join(command.text.split()))
        lines.append((str(command.file), line))
        print(line, flush=True)
        if wrong:
            print(textwrap.indent(wrong, "    "), flush=True)
    return lines, failed


def cheap_jobs(commands):
    done = commands_of_update_lessons()
    for command in commands:
        kind, _ = command.kind(done)
        if kind == "rehearsed":
            yield command, rehearsal(command.text)
        elif kind == "cheap":
            yield command, with_cheap_pictures(command.text)


def git(directory, *arguments):
    return subprocess.run(["git", "-C", str(directory), *arguments], text=True, check=True,
                          stdout=subprocess.PIPE).stdout.strip()


def check_out(directory, build):
    """A fresh checkout of the last commit; with the programs of a build, if one is given."""
    git(SOURCE, "clone", "--quiet", "--no-hardlinks", str(SOURCE), str(directory))
    if build:
        (directory / "build").mkdir()
        (directory / "build/release").symlink_to(pathlib.Path(build).resolve())


# The result of --fully ----------------------------------------------------------------------------

def machine(directory):
    cpu = re.search(r"^model name\s*: (.*)$", pathlib.Path("/proc/cpuinfo").read_text(), re.M)
    cache = (directory / "build/release/CMakeCache.txt").read_text(encoding="utf-8")
    compiler = re.search(r"^CMAKE_CXX_COMPILER:\w+=(.*)$", cache, re.M)[1]
    version = subprocess.run([compiler, "--version"], text=True, check=True,
                             stdout=subprocess.PIPE).stdout.splitlines()[0]
    return f"{cpu[1] if cpu else platform.machine()}, {os.cpu_count()} cores, {version}"


def sections(path):
    """The parts of an earlier result: file → text."""
    parts = path.read_text(encoding="utf-8").split("\n\n")[1:] if path.exists() else []
    return {part.split()[0]: part.strip() for part in parts}


def section(file, lines, origin):
    """The result of one Markdown file."""
    own = [line for place, line in lines if place == file]
    failed = sum(line.startswith("FAILED") for line in own)
    return "\n".join([f"{file}  {len(own)} commands, {failed} failed", *origin, *own])


def write_result(path, directory, lines, built):
    """Renews the parts of the files whose commands ran, and keeps the others."""
    origin = [f"date     {time.strftime('%Y-%m-%d')}", f"machine  {machine(directory)}",
              f"commit   {git(directory, 'rev-parse', 'HEAD')}{built}"]
    parts = {**sections(path), **{file: section(file, lines, origin) for file, _ in lines}}
    text = "\n\n".join(["The commands of the Markdown files, as --fully ran them.",
                         *(parts[file] for file in sorted(parts))]) + "\n"
    whole = path.with_suffix(".part")
    whole.write_text(text, encoding="utf-8")
    whole.replace(path)


def run_fully(commands, build, result):
    """Runs all commands, those first that build the checkout. Returns how many failed."""
    commands = [command for command in commands if THIS_TARGET not in command.text]
    commands.sort(key=lambda command: BUILDS_THE_CHECKOUT not in command.text)
    built = ", with programs that were built before" if build else ""
    failures = 0
    ran = {}
    with tempfile.TemporaryDirectory(prefix="run_commands_") as room:
        directory = pathlib.Path(room) / "checkout"
        check_out(directory, build)
        for _, of_file in itertools.groupby(commands, lambda command: command.file):
            lines, failed = run(((command, command.text) for command in of_file), directory, ran)
            failures += failed
            if result:  # after every file: what is interrupted keeps the files before
                write_result(result, directory, lines, built)
    print(f"{len(commands)} commands, {failures} failed")
    return failures


# Command line -------------------------------------------------------------------------------------

def list_of(commands):
    done = commands_of_update_lessons()
    for command in commands:
        kind, reason = command.kind(done)
        first, *others = command.text.splitlines()
        stand_ins = [word for word in STAND_INS if with_stand_ins(word) != word
                     and re.search(rf"(?<![\w/.]){re.escape(word)}\b", command.text)]
        notes = [reason] * bool(reason) + [f"example: {word} is {STAND_INS[word]}"
                                           for word in stand_ins]
        yield (f"{kind:9}  {command.place}  {first}{' …' if others else ''}"
               + (f"  ({'; '.join(notes)})" if notes else ""))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--list", action="store_true", help="print the commands and their classes")
    parser.add_argument("--fully", action="store_true", help="run all commands in a fresh checkout")
    parser.add_argument("--build", help="build/release if absent; with --fully, in place of "
                                        "what the commands build")
    parser.add_argument("files", nargs="*", metavar="FILE", help="Markdown files; all if absent")
    parser.add_argument("--only", default="", metavar="REGEX", help="commands that match")
    parser.add_argument("--result", type=pathlib.Path, help="file for the result of --fully")
    arguments = parser.parse_args()
    if arguments.result and (not arguments.fully or arguments.only):
        parser.error("--result needs --fully, without --only")
    commands = [command for command in all_commands()
                if re.search(arguments.only, command.text)
                and (not arguments.files or str(command.file) in arguments.files)]
    if not commands:
        raise LessonError("no command is found")
    if arguments.list:
        print("\n".join(list_of(commands)))
        return 0
    if not arguments.fully:
        runner = Runner(arguments.build or SOURCE / "build/release")
        lines, failed = run(cheap_jobs(commands), runner.directory, {})
        print(f"{len(lines)} commands, {failed} failed")
        return int(failed > 0)
    return int(run_fully(commands, arguments.build, arguments.result) > 0)


if __name__ == "__main__":
    try:
        sys.exit(main())
    except (LessonError, OSError, subprocess.CalledProcessError) as error:
        print(f"run_commands: {error}", file=sys.stderr)
        sys.exit(2)
