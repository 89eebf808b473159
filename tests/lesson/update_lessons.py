#!/usr/bin/env python3
"""Renews what the READMEs print of programs, or checks that it is up to date.

    python3 tests/lesson/update_lessons.py            rewrites the blocks and numbers that changed
    python3 tests/lesson/update_lessons.py --check    prints a diff and exits with 1 if one changed

Three kinds of HTML comments say where a text comes from: console, table and number. Each begins in
column 1. The command may go on in the next lines, and each further word ("only:", "find:", "as:",
"slow") has its own line.

    <!-- console: build/release/step01_explicit/step01_explicit
         only: h_crit|done -->
    ```
    …the output of the command. With "only", a regular expression: the lines that match;
    the lines left out become a line with "…"
    ```
    <!-- end 1a2b3c -->

    <!-- table: python3 tests/lesson/run_table.py energies -->
    …the output of the command, which is Markdown
    <!-- end 4d5e6f -->

    <!-- number changed: diff a.h b.h | grep -c '^[<>]' -->
    and then, anywhere in this file but at the beginning of a line:
    In this step <!--changed-->22<!--/--> lines change.

    <!-- number gain: ctest --test-dir build/release -V -R PrintedMatrix
         find: gains (\\S+) J
         as: %.0e -->
    "find": the number is the first group of a regular expression. "as": its format, as in printf.

A block ends with a checksum of its text. The check refuses a block that was edited by hand.

"slow" commands take longer than a few seconds and run with --slow only. Without it the check
compares a slow block with its checksum, and a slow number with the result that its comment keeps:
"slow: 0.67".

Times are not compared: they differ from run to run. In a console they are the numbers in "in 0.4 s"
and before "ms", in a table the columns whose headings contain "ms", "seconds" or "time". Rewriting
a block keeps its old times; --times renews them.

Commands run in an empty directory with links to all files of the repository, and with build/release
linked to the build directory: what they write to out/ is deleted afterwards. Programs of the steps
run with --no-pictures, which changes no number. A command that several places name runs once.
"""
import argparse
import difflib
import hashlib
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

SOURCE = pathlib.Path(__file__).resolve().parents[2]
REPAIR = "cmake --build build/release --target update_lessons"


class LessonError(Exception):
    """A comment, a command or an output that is not as it has to be: one line."""


# Comments ---------------------------------------------------------------------------------------

BLOCK = re.compile(
    r"^<!-- (console|table): (.*?)-->\n(.*?)^<!-- end(?: ([0-9a-f]{6}))? -->$", re.S | re.M)
DEFINITION = re.compile(r"^<!-- number (\w+): (.*?)-->$", re.S | re.M)
INLINE = re.compile(r"<!--(\w+)-->(.*?)<!--/-->", re.S)


class Recipe:
    """How a text is made: the command of a comment and the words in the lines below it."""

    def __init__(self, text):
        self.only = self.find = self.format = self.result = None
        self.slow = False
        command = []
        for line in (line.strip() for line in text.strip().splitlines()):
            key, _, value = line.partition(": ")
            if key == "slow":
                self.slow, self.result = True, value
            elif key == "only":
                self.only = re.compile(value)
            elif key == "find":
                self.find = re.compile(value, re.M)
            elif key == "as":
                self.format = value
            else:
                command.append(line)
        self.command = " ".join(command)


def checksum(text):
    return hashlib.sha256(text.encode()).hexdigest()[:6]


# Commands ---------------------------------------------------------------------------------------

STEP_PROGRAM = re.compile(r"^build/release/(step0\d_\w+)/\1\b[^|;&<>]*$")
CTEST = re.compile(r"^ctest --test-dir build/release -V -R (\S+)$")


class Runner:
    """Runs each command once, in a directory that is deleted afterwards."""

    def __init__(self, build):
        self.build = pathlib.Path(build).resolve()
        self.outputs = {}
        self.room = tempfile.TemporaryDirectory(prefix="update_lessons_")
        self.directory = pathlib.Path(self.room.name)
        for entry in SOURCE.iterdir():
            if entry.name not in ("build", "out", ".git"):
                (self.directory / entry.name).symlink_to(entry)
        (self.directory / "build").mkdir()
        (self.directory / "build/release").symlink_to(self.build)

    def output(self, command):
        if command not in self.outputs:
            output = self._run(command)
            if not output.strip():
                raise LessonError(f"{command} prints nothing")
            for root in (SOURCE, self.directory):
                output = output.replace(f"{root}/", "…/")
            self.outputs[command] = output
        return self.outputs[command]

    def _run(self, command):
        if match := CTEST.match(command):
            return self._run_tests(match[1].strip("'"))
        if STEP_PROGRAM.match(command):
            command += " --no-pictures"
        # 1 is no failure of diff, grep and an exploded run. It is one of a Python script.
        allowed = (0,) if command.startswith("python3 ") else (0, 1)
        return self._shell(["bash", "-c", command], command, allowed)

    def _shell(self, arguments, name, allowed):
        result = subprocess.run(arguments, cwd=self.directory, text=True, stdout=subprocess.PIPE,
                                stderr=subprocess.STDOUT, check=False)
        if result.returncode not in allowed:
            raise LessonError(f"exit code {result.returncode} of {name}\n{result.stdout}")
        return result.stdout

    def _run_tests(self, expression):
        """What ctest -V -R prints, without touching the records of a ctest that may be running."""
        listed = subprocess.run(
            ["ctest", "--test-dir", str(self.build), "-R", expression, "--show-only=json-v1"],
            text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=False)
        if listed.returncode != 0:
            raise LessonError(listed.stderr.strip())
        tests = [test for test in json.loads(listed.stdout)["tests"] if "command" in test]
        if not tests:
            raise LessonError(f"no test is named {expression}, or the tests are not built")
        return "".join(self._shell(test["command"], test["name"], allowed=(0,)) for test in tests)


# Texts ---------------------------------------------------------------------------------------

SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def in_lesson_notation(number):
    """-4e+13 becomes −4·10¹³, and 1e-04 becomes 10⁻⁴."""
    sign = "−" if number.startswith("-") else ""
    mantissa, _, exponent = number.lstrip("-").partition("e")
    if not exponent:
        return sign + mantissa
    power = f"10{str(int(exponent)).translate(SUPERSCRIPTS)}"
    return sign + (power if mantissa == "1" else f"{mantissa}·{power}")


def number_text(recipe, output):
    text = output.strip()
    if recipe.find:
        match = recipe.find.search(output)
        if not match:
            raise LessonError(f"{recipe.command}: "
                              f"nothing matches {recipe.find.pattern} in\n{output}")
        text = match[1]
    if recipe.format:
        text = recipe.format % float(text)
    if not text or "\n" in text:
        raise LessonError(f"{recipe.command}: one number is needed, not\n{output}")
    return in_lesson_notation(text)


def shown_lines(recipe, output):
    lines = []
    for line in output.rstrip("\n").splitlines():
        if not recipe.only or recipe.only.search(line):
            lines.append(line)
        elif not lines or lines[-1] != "  …":
            lines.append("  …")
    return lines[:-1] if lines and lines[-1] == "  …" else lines


def block_text(kind, recipe, output):
    lines = shown_lines(recipe, output)
    if kind == "console":
        lines = ["```", *lines, "```"]
    return "".join(line.rstrip() + "\n" for line in lines)


TIME = re.compile(r"(?<=\bin )[\d.]+(?= m?s\b)|[\d.]+(?= ms\b)")
TIME_HEADING = re.compile(r"\b(ms|seconds|time)\b")


def without_times(kind, text):
    """The text with every time taken out, and the times."""
    times = []

    def take(time):
        times.append(time)
        return "\0"

    if kind == "console":
        return TIME.sub(lambda match: take(match[0]), text), times
    lines = []
    columns = []
    for line in text.splitlines(keepends=True):
        cells = re.split(r"(?<!\\)\|", line)
        if not line.startswith("|"):
            columns = []
        elif not columns:
            columns = [i for i, cell in enumerate(cells) if TIME_HEADING.search(cell)] or [-1]
        elif not line.startswith("|-"):
            for i in columns:
                if i >= 0 and i < len(cells):
                    cells[i] = take(cells[i])
        lines.append("|".join(cells))
    return "".join(lines), times


def with_times(text, times):
    for time in times:
        text = text.replace("\0", time, 1)
    return text


# Documents ---------------------------------------------------------------------------------------

class Document:
    """One README: its text as it is, and as the programs would have it."""

    def __init__(self, name, text, runner, check=False, slow=False, times=False):
        self.name, self.text, self.runner = name, text, runner
        self.check, self.slow, self.times = check, slow, times
        self.edited = []  # lines of blocks that were edited by hand
        self._check_form()
        self.renewed = self._renew_numbers(BLOCK.sub(self._renew_block, text))

    def _line(self, position):
        return self.text.count("\n", 0, position) + 1

    def _check_form(self):
        for match in re.finditer(r"^<!--\w+-->", self.text, re.M):
            raise LessonError(f"{self.name}:{self._line(match.start())}: Markdown takes a line "
                              "that begins with a comment for HTML: begin the line with a word")
        begins = len(re.findall(r"^<!-- (?:console|table): ", self.text, re.M))
        ends = len(re.findall(r"^<!-- end\b", self.text, re.M))
        blocks = [match[3] for match in BLOCK.finditer(self.text)]
        nested = any(re.search("^<!-- (console|table):", block, re.M) for block in blocks)
        if begins != ends or begins != len(blocks) or nested:
            raise LessonError(f"{self.name}: {begins} blocks begin, {ends} end, "
                              f"and {len(blocks)} do both")

    def _renew_block(self, match):
        kind, head, old, seal = match[1], match[2], match[3], match[4]
        recipe = Recipe(head)
        sealed = seal == checksum(old)
        if not sealed and seal:
            self.edited.append(self._line(match.start()))
        new = old
        if self.slow or not recipe.slow or (not sealed and not self.check):
            new = block_text(kind, recipe, self.runner.output(recipe.command))
            new_form, new_times = without_times(kind, new)
            old_form, old_times = without_times(kind, old)
            if not self.times and len(old_times) == len(new_times):
                new = with_times(new_form, old_times)
        return f"<!-- {kind}: {head}-->\n{new}<!-- end {checksum(new)} -->"

    def _renew_numbers(self, text):
        recipes = {match[1]: Recipe(match[2]) for match in DEFINITION.finditer(text)}
        used = {match[1] for match in INLINE.finditer(text)}
        for name in used - recipes.keys():
            raise LessonError(f"{self.name}: no comment defines the number {name}")
        for name in recipes.keys() - used:
            raise LessonError(f"{self.name}: the number {name} stands nowhere")

        for recipe in recipes.values():
            if self.slow or not recipe.slow or not recipe.result:
                recipe.result = number_text(recipe, self.runner.output(recipe.command))

        def with_result(match):
            return f"<!--{match[1]}-->{recipes[match[1]].result}<!--/-->"

        def with_kept_result(match):
            recipe = recipes[match[1]]
            if not recipe.slow:
                return match[0]
            return re.sub(r"^(\s+slow)\b[^\n]*?(?= *(?:-->)?$)", rf"\1: {recipe.result}", match[0],
                          flags=re.M)

        return DEFINITION.sub(with_kept_result, INLINE.sub(with_result, text))

    def difference(self):
        return "".join(difflib.unified_diff(
            self.text.splitlines(True), self.renewed.splitlines(True),
            f"{self.name} as it is", f"{self.name} by the programs"))


def readmes():
    patterns = ("README.md", "*/README.md", "tests/*/README.md")
    found = [path.relative_to(SOURCE) for pattern in patterns for path in SOURCE.glob(pattern)]
    return sorted(path for path in found if path.parts[0] not in ("build", "out"))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("files", nargs="*", help="READMEs; all if absent")
    parser.add_argument("--build", default=SOURCE / "build/release", help="build/release if absent")
    parser.add_argument("--check", action="store_true",
                        help="change nothing, exit with 1 on a difference")
    parser.add_argument("--slow", action="store_true", help="run the slow commands as well")
    parser.add_argument("--times", action="store_true", help="renew the times as well")
    arguments = parser.parse_args()
    runner = Runner(arguments.build)
    wrong = False
    for name in arguments.files or readmes():
        path = (SOURCE / name).resolve()
        document = Document(str(name), path.read_text(encoding="utf-8"), runner, arguments.check,
                            arguments.slow, arguments.times)
        for line in document.edited:
            print(f"{name}:{line}: this block was edited by hand: change its program or command")
        if document.edited or document.text != document.renewed:
            wrong = True
            sys.stdout.write(document.difference())
        if not arguments.check:
            path.write_text(document.renewed, encoding="utf-8")
    if wrong and arguments.check:
        print(f"\nThe programs print something else. To renew the READMEs: {REPAIR}")
        return 1
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except (LessonError, OSError) as error:
        print(f"update_lessons: {error}", file=sys.stderr)
        sys.exit(2)
