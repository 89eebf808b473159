#!/usr/bin/env python3
"""Tests of the assignments: what is handed out, and how hand-ins are graded.

    python3 tests/assignments/assignments_test.py [--full] [unittest's options]
    python3 tests/assignments/assignments_test.py --task A3.4

--full: both mistakes of every task, and the build of every copy, some ten minutes.
--task: the check of one task A or B, its mistakes, and its copy, in a minute; for two, give it twice.
"""
import argparse
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree
from unittest import mock

import check
import films
import functions
import grade
import handed
import make
import results
import runs
import tasks
import workshop
from runs import FAILED, PASSED, UNWRITTEN
from tasks import HERE, SOURCE

parser = argparse.ArgumentParser(add_help=False)
parser.add_argument("--full", action="store_true")
parser.add_argument("--task", action="append")
OPTIONS, UNITTEST_ARGUMENTS = parser.parse_known_args()
FULL = OPTIONS.full
OF_A_TASK = ["TasksAreComplete", "CopiesHaveNoAnswers", "TheProjectPasses", "MistakesFail"]
WORK = pathlib.Path(os.environ.get("ASSIGNMENTS_WORK", SOURCE / "build/assignments_test"))
EVERY = tasks.load_all()
try:
    TRIED = tasks.select(OPTIONS.task or list(EVERY))
except tasks.TaskError as error:
    parser.error(str(error))
CODE = [task for task in TRIED if task.kind in ("write", "mend")]
GROUPS = sorted({task.id[:2] for task in TRIED})  # A1, A2, …: what is handed out together
if not CODE:
    parser.error("tasks C have their tests in measures_test.py, tasks D in inventions_test.py")


def reference(task):
    """The bodies of the project."""
    return [functions.body(task.source.read_text(), name) for name in task.functions]


def changed(task, bodies, helpers=""):
    return workshop.changed_files(task, bodies, helpers, "nobody")


def mistaken(task, change):
    """The bodies with a typical mistake: in the one that has the text."""
    bodies = [
        b.replace(change["cut"], change["with"]) if change["cut"] in b else b
        for b in reference(task)
    ]
    assert bodies != reference(task), f"{task.id}: no body has {change['cut']}"
    return bodies


class Hands(unittest.TestCase):
    """Copies and hand-ins in a directory of their own."""

    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.place = pathlib.Path(place.name)

    def copy(self, *names):
        out = self.place / "-".join(names)
        make.copy(tasks.select(names), out)
        return out

    def write_body(self, copy, id, body):
        task = EVERY[id]
        file = copy / task.file
        file.write_text(functions.with_body(file.read_text(), task.functions[0], body))


class TasksAreComplete(unittest.TestCase):
    def test_there_are_four_kinds_over_all_steps(self):
        self.assertGreaterEqual(len(EVERY), 16)
        self.assertEqual({task.kind for task in EVERY.values()}, set(results.KINDS))
        self.assertEqual({task.step for task in EVERY.values()}, {1, 2, 3, 4, 5})

    # The code of the project is public: it is no answer to what is measured and invented.
    def test_the_code_answers_at_most_half_of_the_tasks(self):
        code = [task.id for task in EVERY.values() if task.kind in ("write", "mend")]
        self.assertLessEqual(
            2 * len(code), len(EVERY), "there are too few tasks C and D for one more A or B"
        )

    def test_each_task_says_what_it_must(self):
        letters = {"write": "A", "mend": "B", "measure": "C", "invent": "D"}
        for task in EVERY.values():
            with self.subTest(task.id):
                self.assertRegex(task.id, rf"^{letters[task.kind]}[1-5]\.\d$")
                self.assertTrue(task.points > 0 and task.minutes > 0 and task.title and task.hint)
                if task.check:
                    self.assertTrue((HERE / "checks" / task.check).exists())
                if task.kind == "write":
                    self.assertGreaterEqual(len(task.mistakes), 2)

    def test_the_sections_of_the_lessons_exist(self):
        for task in EVERY.values():
            file, _, anchor = task.lesson.partition("#")
            headings = re.findall(r"^#+ (.*)$", (SOURCE / file).read_text(), re.MULTILINE)
            anchors = [re.sub(r"[^\w\- ]", "", h.lower()).replace(" ", "-") for h in headings]
            self.assertIn(anchor, anchors, task.id)

    def test_each_mistake_is_a_change_of_one_place(self):
        for task in CODE:
            for change in task.mistakes + [c for c in [task.planted] if c]:
                places = sum(body.count(change["cut"]) for body in reference(task))
                self.assertEqual(places, 1, f"{task.id}: {change['cut']}")


class CopiesHaveNoAnswers(Hands):
    def test_no_copy_has_a_telling_line(self):
        for group in GROUPS:
            with self.subTest(group):
                copy = self.copy(group)
                lines = set()
                for task in tasks.select([group]):
                    if task.kind == "write":
                        lines |= set().union(
                            *(make.telling_lines(body) for body in reference(task))
                        )
                text = {
                    make.statement(line)
                    for f in copy.rglob("*")
                    if f.suffix in (".h", ".cpp", ".md", ".py")
                    for line in f.read_text().split("\n")
                }
                self.assertEqual(lines & text, set())

    def test_a_quote_goes_with_its_loops_and_conditions(self):
        lesson = (self.copy("A3") / "step03_implicit/README.md").read_text()
        self.assertIn("In `line_search`", lesson)
        self.assertNotIn("step /= 2", lesson)
        self.assertIn("diff step02_damping/time_step.h", lesson)
        self.assertNotIn("The diff", lesson)
        self.assertNotIn("1e-4 * step * fall", lesson)
        self.assertIn("const double decrement = ", lesson)  # of another function

    def test_the_formulas_stay(self):
        self.assertIn("∂C/∂w = √a n", (self.copy("A1") / "common/math/triangle.h").read_text())

    def test_a_copy_that_answers_its_task_is_refused(self):
        with self.assertRaisesRegex(
            tasks.TaskError, r"A2.1 is answered by step03_implicit/time_step.h, line \d+"
        ):
            self.copy("A2.1", "A3.1")

    def test_an_unknown_task_is_refused(self):
        with self.assertRaisesRegex(tasks.TaskError, "there is no task A9; there are A1.1, "):
            tasks.select(["A9"])

    def test_nothing_is_written_into_a_directory_with_files(self):
        done = subprocess.run(
            [sys.executable, HERE / "make.py", "A1", "--out", HERE], capture_output=True, text=True
        )
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertIn("is not empty", done.stderr)

    # The copy sees it without a build, and so does the grader.
    def test_a_fresh_copy_has_no_points(self):
        for group in GROUPS:
            with self.subTest(group):
                copy = self.copy(group)
                chosen = [task for task in tasks.select([group]) if task.check]
                if not chosen:
                    continue
                endings = [grade.code_of(task, copy, "nobody") for task in chosen]
                self.assertEqual([e.state for e in endings], [UNWRITTEN] * len(chosen))
                done = subprocess.run(
                    [copy / "check", *(t.id for t in chosen)], capture_output=True, text=True
                )
                self.assertEqual(done.returncode, 1, done.stderr)
                self.assertIn(f"total    0 of {sum(t.points for t in chosen)} points", done.stdout)
                self.assertFalse((copy / "build").exists())

    # What ./check lets pass, the grader takes.
    def test_check_refuses_what_the_grader_refuses(self):
        copy = self.copy("A3")
        file = copy / EVERY["A3.3"].file
        given = file.read_text()
        for change, words in (
            (
                lambda: self.write_body(copy, "A3.3", "\n#include <cmath>\n"),
                "begins with # is not taken",
            ),
            (
                lambda: file.write_text(given.replace("positive_part(", "mine(")),
                "must stay as they were handed out",
            ),
            (
                lambda: file.write_text(given + "namespace x {"),
                "tension.h, line [0-9]+: '{' is never closed",
            ),
        ):
            file.write_text(given)
            change()
            done = subprocess.run([copy / "check", "A3.3"], capture_output=True, text=True)
            self.assertRegex(" ".join(done.stdout.split()), words, done.stderr)
            self.assertRegex(grade.code_of(EVERY["A3.3"], copy, "nobody").message, words)

    def test_a_refused_line_has_its_number_in_the_file(self):
        copy = self.copy("A3")
        self.write_body(copy, "A3.3", "\n#include <cmath>\n")
        lines = (copy / EVERY["A3.3"].file).read_text().split("\n")
        words = f"tension.h, line {1 + lines.index('#include <cmath>')}: a line that begins with #"
        self.assertIn(words, grade.code_of(EVERY["A3.3"], copy, "nobody").message)

    # A machine without a package is no mistake of a student.
    def test_a_project_that_cannot_be_built_is_said(self):
        with mock.patch.object(workshop.Workshop, "run", return_value="GTest was not found"):
            with self.assertRaisesRegex(tasks.TaskError, "cannot be built:\nGTest was not found"):
                workshop.Workshop(self.place / "work", [EVERY["A1.1"]]).prepare()

    def test_the_film_of_a_student_has_the_numbers_of_the_student(self):
        task, copy = EVERY["D1.1"], self.copy("D1.1")
        built = mock.patch.object(workshop.Workshop, "run", return_value="")
        with built, mock.patch.object(films, "write_film"):
            films.write_films([task], copy, "ada", self.place / "work", None, self.place / "out")
        numbers = (self.place / "work/films/copy" / task.numbers_file).read_text()
        self.assertIn(f"= {task.numbers('ada')['strain_limit']};", numbers)

    @unittest.skipUnless(FULL, "--full")
    def test_a_fresh_copy_builds(self):
        for group in GROUPS:
            with self.subTest(group):
                copy = self.copy(group)
                for command in (
                    [
                        "cmake",
                        "-S",
                        copy,
                        "-B",
                        copy / "build",
                        "-G",
                        "Ninja",
                        "-DCMAKE_CXX_FLAGS=",
                    ],
                    ["cmake", "--build", copy / "build"],
                ):
                    done = subprocess.run(
                        command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True
                    )
                    self.assertEqual(done.returncode, 0, done.stdout)
                    self.assertNotIn("warning:", done.stdout)

    @unittest.skipUnless(FULL, "--full")
    def test_the_commands_of_its_readme_run(self):
        copy = self.place / "copy"
        make_it = [
            sys.executable,
            HERE / "make.py",
            "A4",
            "--with-reference",
            "A4.2",
            "--out",
            copy,
        ]
        subprocess.run(make_it, check=True, stdout=subprocess.DEVNULL)
        self.write_body(copy, "A4.1", reference(EVERY["A4.1"])[0])
        blocks = re.findall(
            r"^```sh\n(.*?)^```$", (copy / "README.md").read_text(), re.MULTILINE | re.DOTALL
        )
        self.assertEqual(len(blocks), 4)
        for block in blocks:
            done = subprocess.run(
                ["bash", "-e", "-c", block], cwd=copy, capture_output=True, text=True
            )
            self.assertEqual(done.returncode, 0, block + done.stdout + done.stderr)
        self.assertTrue((copy / "out/step04_cg/report.html").exists())


class ASlipOfTheGraderIsSaid(Hands):
    def doubts(self, student, *names):
        copy = self.place / "copy"
        if not copy.exists():
            make.copy(tasks.select(["A3.1", "C3.1"]), copy, student="ada")
        return list(grade.doubts(tasks.select(names), copy, student))

    def test_no_doubt(self):
        self.assertEqual(self.doubts("ada", "A3.1", "C3.1"), [])

    def test_another_student(self):
        (sentence,) = self.doubts("bob", "A3.1", "C3.1")
        self.assertIn("other numbers for C3.1 than --student bob would have", sentence)

    def test_a_task_that_was_not_handed_out(self):
        (sentence,) = self.doubts("ada", "A3.1", "A3.2")
        self.assertIn("was made without A3.2", sentence)

    def test_a_list_of_tasks_that_is_broken_is_not_read(self):
        self.doubts("ada", "A3.1")
        for text in ("", "[1]", '["A3.1"]', "{}", "null", "[" * 100_000, '[{"id": []}]'):
            (self.place / "copy/tests/assignments/tasks.json").write_text(text)
            self.assertEqual(self.doubts("bob", "C3.1"), [])

    def test_another_directory(self):
        (sentence,) = grade.doubts(tasks.select(["A3.1", "C3.1"]), self.place, "ada")
        self.assertIn("has no file of these tasks", sentence)


class AFilmHasWhatIsWritten(Hands):
    def test_and_the_code_of_the_project_for_the_rest(self):
        copy, studio = self.copy("A3"), self.place / "studio"
        self.write_body(copy, "A3.3", "\n  return T;  // mine\n")
        make.copy(tasks.select(["A3"]), studio, hand_out=False)
        for task in tasks.select(["A3"]):
            films.put_bodies(task, copy, studio)
        self.assertIn("return T;  // mine", (studio / EVERY["A3.3"].file).read_text())
        for id in ("A3.1", "A3.2", "A3.4"):
            self.assertNotIn(f'not_written("{id}"', (studio / EVERY[id].file).read_text())


class Graded(Hands):
    """Hand-ins that are built."""

    @classmethod
    def setUpClass(cls):
        cls.lock = workshop.Workshop(WORK, TRIED).locked()
        cls.workshop = cls.lock.__enter__()
        cls.addClassCleanup(cls.lock.__exit__, None, None, None)
        cls.workshop.prepare()

    def endings(self, attempts):
        """attempts: (task, bodies), each task once. The checks of all are built together."""
        for task, bodies in attempts:
            self.workshop.place(task, changed(task, bodies))
        self.workshop.build_together([task for task, _ in attempts])
        return {task.id: self.workshop.check(task, 1) for task, _ in attempts}

    def check(self, id, body, helpers="", seed=1):
        self.workshop.place(EVERY[id], changed(EVERY[id], [body], helpers))
        return self.workshop.check(EVERY[id], seed)


class TheProjectPasses(Graded):
    def test_every_check(self):
        found = self.endings([(task, reference(task)) for task in CODE])
        self.assertEqual(
            {id: (e.state, e.message) for id, e in found.items()},
            {id: (PASSED, "") for id in found},
        )

    def test_the_hidden_checks(self):
        for task in CODE[:4]:
            for seed in (2, 3):
                self.assertEqual(
                    runs.run_check(self.workshop.build / "checks" / task.target, seed).state, PASSED
                )


class MistakesFail(Graded):
    def attempt(self, choose):
        attempts = [(task, mistaken(task, choose(task))) for task in CODE if choose(task)]
        found = self.endings(attempts)
        self.assertEqual({id: e.state for id, e in found.items()}, {id: FAILED for id in found})
        for id, ending in found.items():
            self.assertRegex(ending.message, "expected|Expected|not", id)
            self.assertNotIn("compile", ending.message, id)
            if OPTIONS.task:
                name = choose(EVERY[id]).get("name", "the planted mistake")
                print(f"{id}, {name}: {ending.message}")

    def test_a_typical_one(self):
        self.attempt(lambda task: task.planted or task.mistakes[0])

    @unittest.skipUnless(FULL or OPTIONS.task, "--full")
    def test_another_typical_one(self):
        self.attempt(lambda task: task.mistakes[1] if task.mistakes else None)


# Each has the checks of A3.3, and all other tasks as they are.
class BadHandInsCostOnlyTheirTask(Graded):
    ATTACKS = {
        "crash": ("*static_cast<volatile int*>(nullptr) = 1; return T;", "crashed"),
        "hang": ("for (volatile int i = 0;; i = i + 1) {} return T;", "did not end within"),
        "exit": ("std::exit(0); return T;", "ended before it was done"),
        "noise": (
            'for (;;) std::puts("[  PASSED  ] 4 tests. passed passed passed"); return T;',
            "10 MB|within|before",
        ),
        "memory": (
            "std::vector<char> v(std::size_t(1) << 40, 1); return T * v[7];",
            "bad_alloc|memory|ended",
        ),
        "recursion": ("return positive_part(Square<2>(T + Square<2>::Ones()));", "crashed"),
        "forged report": (
            'std::FILE* f = std::fopen("report.xml", "w"); std::fputs("<testsuites tests=\'4\'/>", f); '
            "std::fclose(f); std::_Exit(0); return T;",
            "ended before it was done",
        ),
        "not C++": ("return T +;", "does not compile: .*tension.h.*error"),
    }

    def setUp(self):
        super().setUp()
        self.seconds, runs.SECONDS = runs.SECONDS, 4
        self.addCleanup(lambda: setattr(runs, "SECONDS", self.seconds))

    def test_programs_that_end_badly(self):
        helpers = "#pragma once\n#include <cstdio>\n#include <cstdlib>\n#include <vector>\n"
        for name, (body, words) in self.ATTACKS.items():
            with self.subTest(name):
                ending = self.check("A3.3", body, helpers)
                self.assertEqual(ending.state, FAILED)
                self.assertRegex(ending.message, words)

    @unittest.skipUnless(runs.sandbox(), "bubblewrap does not work here")
    def test_no_source_can_be_read(self):
        secret = WORK / "copy/common/math/tension.h"
        body = f'if (std::FILE* f = std::fopen("{secret}", "r")) std::abort(); return T;'
        ending = self.check("A3.3", body, "#pragma once\n#include <cstdio>\n#include <cstdlib>\n")
        self.assertIn("expected", ending.message)  # wrong, but it ended

    def test_what_is_not_taken(self):
        copy = self.copy("A3")
        for body, words in (
            (
                '\n#include "/etc/passwd"\n return T;',
                "a line that begins with # is not taken",
            ),
            ("\n%:include <x>\n", "a line that begins with #"),
            ("/* */ # define x\n", "a line that begins with #"),
            ('asm(".incbin \\"/etc/passwd\\""); return T;', "the word asm is not taken"),
        ):
            self.write_body(copy, "A3.3", body)
            ending = grade.code_of(EVERY["A3.3"], copy, "nobody")
            self.assertEqual(ending.state, FAILED)
            self.assertIn(words, ending.message)
        self.assertEqual(grade.code_of(EVERY["A3.1"], copy, "nobody").state, UNWRITTEN)

    def test_a_function_that_was_removed(self):
        copy = self.copy("A3")
        file = copy / "common/math/tension.h"
        file.write_text(
            file.read_text().replace("positive_part(const Square<2>", "other(const Square<2>")
        )
        self.assertIn(
            "has no function positive_part", grade.code_of(EVERY["A3.3"], copy, "nobody").message
        )
        file.unlink()
        self.assertIn(
            "no readable common/math/tension.h",
            grade.code_of(EVERY["A3.3"], copy, "nobody").message,
        )
        file.symlink_to("/dev/zero")
        self.assertIn("there is no such file", grade.code_of(EVERY["A3.3"], copy, "nobody").message)
        file.unlink()
        file.write_text(" " * (handed.BYTES + 1))
        self.assertIn("larger than 1000 kB", grade.code_of(EVERY["A3.3"], copy, "nobody").message)

    # The grader takes named bodies and helpers.h: a changed check or header of the copy counts for
    # nothing.
    def test_other_files_are_not_taken(self):
        copy = self.copy("A3")
        for file in copy.rglob("*.cpp"):
            file.write_text("int main() { return 0; }")
        (copy / "common/math/types.h").write_text("#error changed")
        self.write_body(copy, "A3.3", reference(EVERY["A3.3"])[0] + " // mine\n")
        self.assertEqual(grade.code_of(EVERY["A3.3"], copy, "nobody").state, PASSED)

    # A1.1 and B1.1 are in one file, and the cloth of A1.2 uses it.
    def test_a_mistake_costs_one_task(self):
        copy = self.copy("A1", "B1")
        chosen = [EVERY[id] for id in ("A1.1", "A1.2", "B1.1")]
        for task in chosen:
            self.write_body(copy, task.id, reference(task)[0])
        self.write_body(copy, "A1.1", mistaken(EVERY["A1.1"], EVERY["A1.1"].mistakes[0])[0])
        found = grade.grade(chosen, copy, "nobody", 1, self.workshop)
        self.assertEqual([r.state for r in found], [FAILED, PASSED, PASSED])

    def test_a_helper_is_taken(self):
        copy = self.copy("A3")
        helpers = copy / "common/math/helpers.h"
        helpers.write_text(
            helpers.read_text()
            + "inline double larger(double a, double b) { return a > b ? a : b; }\n"
        )
        self.write_body(
            copy,
            "A3.3",
            reference(EVERY["A3.3"])[0].replace("std::max(mean - r, 0.0)", "larger(mean - r, 0)"),
        )
        found = grade.grade([EVERY["A3.3"], EVERY["A3.1"]], copy, "nobody", 1, self.workshop)
        self.assertEqual([(r.state, r.score) for r in found], [(PASSED, 6), (UNWRITTEN, 0)])


class MessagesAreClear(unittest.TestCase):
    def test_an_exception_has_its_own_text(self):
        for first in ("", "unknown file\n"):
            message = first + 'C++ exception with description "no f" thrown in the test body.'
            self.assertEqual(runs.sentence(message), "no f")

    def test_a_failure_has_the_words_of_the_check(self):
        message = "x.cpp:1\nFailed\nC: expected 1, got 2"
        self.assertEqual(runs.sentence(message), "C: expected 1, got 2")

    def test_an_error_of_the_compiler_has_its_line_of_code(self):
        output = (
            "In file included from b.cpp:1:\n"
            "a.h:48:31: error: no match (‘Vecs<1>’ {aka ‘std::array<Vec3, 1>’} and ‘int’)\n"
            "   48 |     dCdy = 1;\n      |            ^\n"
        )
        self.assertEqual(
            runs.first_error(output),
            "a.h:48:31: error: no match (‘Vecs<1>’ and ‘int’)\ndCdy = 1;",
        )
        self.assertEqual(runs.first_line("all is well\n", " warning: "), "")

    def test_a_failure_has_the_warning_of_the_compiler(self):
        output = "a.h:4:12: warning: declaration of ‘C’ shadows a member\n    4 |     double C = 1;\n"
        self.assertIn("\ndouble C = 1;", check.with_warning(runs.Ending(FAILED), output).message)
        self.assertEqual(check.with_warning(runs.Ending(FAILED), "").message, "")
        self.assertEqual(check.with_warning(runs.Ending(PASSED), output).message, "")

    def test_a_wrong_index_is_named(self):
        with tempfile.TemporaryDirectory() as place:
            output = pathlib.Path(place) / "output"
            output.write_text("checks: Block.h:1: f(): Assertion `i < rows()' failed.\n")
            ending = runs.ending(128 + 6, False, output, output, "word")
        self.assertEqual(ending.state, FAILED)
        self.assertIn("wrong index or a wrong size: `i < rows()` does not hold", ending.message)


class ResultsAreWritten(Hands):
    def found(self):
        report = ElementTree.fromstring(
            '<testsuites tests="1"><testsuite><testcase name="A" classname="B"><failure '
            'message="x.cpp:1&#10;Failed&#10;f: expected 1, got 2"/></testcase></testsuite></testsuites>'
        )
        return [
            results.Result("A1.1", "one", 4, "L.md#a", PASSED),
            results.Result("A1.2", "two", 5, "L.md#b", FAILED, "f: expected 1, got 2", report),
            results.Result("A1.3", "three", 6, "L.md#c", UNWRITTEN, "not written yet"),
        ]

    def test_gradescope(self):
        tests = json.loads(results.gradescope(self.found()))["tests"]
        self.assertEqual(
            [(t["number"], t["score"], t["max_score"]) for t in tests],
            [("A1.1", 4, 4), ("A1.2", 0, 5), ("A1.3", 0, 6)],
        )
        self.assertEqual(tests[1]["output"], "f: expected 1, got 2\nRead again: L.md#b")

    def test_junit(self):
        suites = ElementTree.fromstring(results.junit(self.found()).encode())
        self.assertEqual([s.get("failures") + s.get("skipped") for s in suites], ["00", "10", "01"])
        self.assertEqual(suites[1].find(".//property[@name='points']").get("value"), "5")
        self.assertEqual(suites[1].find(".//failure").get("message"), "f: expected 1, got 2")
        names = [(c.get("classname"), c.get("name")) for c in suites.iter("testcase")]
        self.assertEqual(len(names), len(set(names)))

    def test_table(self):
        table = results.table(self.found())
        self.assertIn("total    4 of 15 points", table)
        self.assertIn("Read again: L.md#b", table)

    def test_an_exit_code_per_task(self):
        grade.write(self.found(), self.place / "out")
        self.assertEqual(
            [(self.place / "out" / f"A1.{i}.exit").read_text() for i in (1, 2, 3)],
            ["0\n", "1\n", "1\n"],
        )


if __name__ == "__main__":
    unittest.main(
        argv=[sys.argv[0], *UNITTEST_ARGUMENTS], defaultTest=OF_A_TASK if OPTIONS.task else None
    )
