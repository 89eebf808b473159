"""Runs the checks of a task, apart from everything else, and says how they ended.

A check is a program that a student's code is part of. It runs in an empty directory, with little
time, memory and room for files. With bubblewrap (Debian's package) it sees nothing of the machine
but /usr, and no network; no process of it is left. Without bubblewrap it can read what the user can
read.
"""
import dataclasses
import functools
import os
import pathlib
import re
import resource
import secrets
import shutil
import signal
import subprocess
import tempfile
import xml.etree.ElementTree as ElementTree

SECONDS, MEGABYTES, OUTPUT = 20, 4096, 10_000_000
PASSED, FAILED, UNWRITTEN = "passed", "failed", "unwritten"
ANSWERED = "answered"  # with a number that only the grader can compare


@dataclasses.dataclass
class Ending:
    """How a task ended: a state, a sentence on the first failure, and GoogleTest's own report, if
    there is one.
    """

    state: str
    message: str = ""
    report: ElementTree.Element = None


@functools.cache
def sandbox():
    """The words that start a program in bubblewrap; none where it does not work."""
    words = [
        "bwrap",
        "--ro-bind",
        "/usr",
        "/usr",
        "--symlink",
        "usr/lib",
        "/lib",
        "--symlink",
        "usr/lib64",
        "/lib64",
        "--ro-bind-try",
        "/etc/ld.so.cache",
        "/etc/ld.so.cache",
        "--ro-bind-try",
        "/etc/alternatives",
        "/etc/alternatives",
        "--proc",
        "/proc",
        "--dev",
        "/dev",
        "--unshare-all",
        "--die-with-parent",
        "--new-session",
    ]
    try:
        works = (
            subprocess.run([*words, "/usr/bin/true"], capture_output=True, timeout=10).returncode
            == 0
        )
    except (OSError, subprocess.TimeoutExpired):
        works = False
    return words if works else []


def limits(seconds):
    def limit():
        resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 1))
        resource.setrlimit(resource.RLIMIT_AS, (MEGABYTES * 2**20,) * 2)
        resource.setrlimit(resource.RLIMIT_FSIZE, (OUTPUT,) * 2)
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))

    return limit


def run_apart(command, directory, output, seconds, words="", variables=None):
    """Runs a command that is given its words on standard input. Returns (exit code, whether it took
    too long).
    """
    if sandbox():
        command = [*sandbox(), "--bind", str(directory), "/run", "--chdir", "/run", *command]
    late = False
    with open(output, "wb") as sink:
        process = subprocess.Popen(
            command,
            cwd=directory,
            stdin=subprocess.PIPE,
            stdout=sink,
            stderr=subprocess.STDOUT,
            start_new_session=True,
            preexec_fn=limits(seconds),
            env={"PATH": "/usr/bin", **(variables or {})},
        )
        try:
            process.communicate(words.encode(), timeout=seconds)
        except subprocess.TimeoutExpired:
            late = True
        except BrokenPipeError:
            pass
        kill(process)
    return process.returncode, late


def kill(process):
    try:
        os.killpg(process.pid, signal.SIGKILL)
    except ProcessLookupError:
        pass
    process.wait()


def run_check(program, seed=1):
    """Runs the checks that `program` has."""
    word = secrets.token_hex(16)
    with tempfile.TemporaryDirectory() as place:
        directory, output = pathlib.Path(place) / "run", pathlib.Path(place) / "output"
        directory.mkdir()
        shutil.copy2(program, directory / "checks")
        code, late = run_apart(
            ["./checks", "--gtest_output=xml:report.xml"],
            directory,
            output,
            SECONDS,
            word + "\n",
            {"CHECK_SEED": str(seed)},
        )
        return ending(code, late, output, directory / "report.xml", word)


def ending(code, late, output, report, word):
    """What the exit code, the last line and the report say together."""
    if late or code in (
        -signal.SIGXCPU,
        128 + signal.SIGXCPU,
        128 + signal.SIGKILL,
        -signal.SIGKILL,
    ):
        return Ending(
            FAILED, f"The check did not end within {SECONDS} seconds: does a loop never end?"
        )
    if code in (-signal.SIGSEGV, 128 + signal.SIGSEGV):
        return Ending(
            FAILED,
            "The check crashed: it read or wrote memory that does not belong to it "
            "(a place beyond the end of a vector?).",
        )
    if code in (-signal.SIGABRT, 128 + signal.SIGABRT):
        if broken := re.search(r"Assertion [`'](.*)' failed", output.read_text(errors="replace")):
            return Ending(
                FAILED,
                "The check stopped at a wrong index or a wrong size: "
                f"`{broken.group(1)}` does not hold.",
            )
    if output.stat().st_size >= OUTPUT:
        return Ending(FAILED, "The check wrote more than 10 MB.")
    if not output.read_bytes().endswith(f"\n{word}\n".encode()):
        return Ending(
            FAILED,
            f"The check ended before it was done (exit code {code}): "
            "does the code call exit, abort or assert?",
        )
    try:
        suites = ElementTree.parse(report).getroot()
    except (OSError, ElementTree.ParseError):
        return Ending(FAILED, "The check left no report.")
    failure = suites.find(".//failure")
    if failure is None and int(suites.get("tests", 0)) > 0:
        return Ending(PASSED, "", suites)
    message = sentence(failure.get("message")) if failure is not None else "The check ran no test."
    return Ending(UNWRITTEN if "not written yet: " in message else FAILED, message, suites)


def sentence(message):
    """Of GoogleTest's message, the words of the check. An exception has its own text."""
    thrown = r'^C\+\+ exception with description "(.*)" thrown in'
    if found := re.search(thrown, message, re.MULTILINE | re.DOTALL):
        return found.group(1)
    lines = message.split("\n")
    return "\n".join(line for line in lines[1:] if line != "Failed").strip() or message


def last_line(output):
    lines = output.read_text(errors="replace").strip().split("\n")
    return lines[-1]


def first_line(output, *words):
    """Of the output of a compiler, the first line that has one of the words, and its code below."""
    lines = output.split("\n")
    for line, below in zip(lines, lines[1:] + [""]):
        if any(word in line for word in words):
            line = re.sub(r" \{aka ‘[^’]*’\}", "", line.strip())
            code = re.match(r"\s*\d+ \|\s*(.*)", below)
            return f"{line}\n{code.group(1)}" if code else line
    return ""


def first_error(output):
    """The first error of a compiler, without the rest of its explanations."""
    found = first_line(output, " error: ", "undefined reference")
    return found or "\n".join(output.split("\n")[-5:]).strip()
