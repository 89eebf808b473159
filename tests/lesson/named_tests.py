#!/usr/bin/env python3
"""Checks that every test that a Markdown file names exists: each "ctest … -R NAME" and each `Suite.Name`.

    python3 tests/lesson/named_tests.py build/release
"""
import json
import pathlib
import re
import subprocess
import sys

SOURCE = pathlib.Path(__file__).resolve().parents[2]
NAMED = r"ctest[^`\n]*?\s-R\s+('[^']+'|[^\s`)<]+)|`([A-Z][A-Za-z0-9]*\.[A-Z][A-Za-z0-9]*)`"


def named_expressions():
    """(file, line, expression) of each name of a test in the Markdown files of the repository."""
    for path in sorted(SOURCE.rglob("*.md")):
        if path.relative_to(SOURCE).parts[0] in ("build", "out"):
            continue
        text = path.read_text(encoding="utf-8")
        for match in re.finditer(NAMED, text):
            line = text.count("\n", 0, match.start()) + 1
            expression = match[1].strip("'") if match[1] else rf"{match[2]}\b"
            yield path.relative_to(SOURCE), line, expression


def main(build):
    listed = subprocess.run(["ctest", "--test-dir", build, "--show-only=json-v1"], text=True,
                            check=True, stdout=subprocess.PIPE).stdout
    tests = [test["name"] for test in json.loads(listed)["tests"]]
    expressions = list(named_expressions())
    missing = [(file, line, expression) for file, line, expression in expressions
               if not any(re.search(expression, name) for name in tests)]
    for file, line, expression in missing:
        print(f"{file}:{line}: no test is named {expression}")
    if not expressions:
        print("no Markdown file names a test: the search is wrong")
    return 1 if missing or not expressions else 0


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("usage: named_tests.py BUILD_DIRECTORY")
    sys.exit(main(sys.argv[1]))
