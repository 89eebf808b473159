#!/usr/bin/env python3
"""Tests of the tasks D: answers that are differentiated by machine pass their checks, and mistakes do not.

    python3 tests/assignments/inventions_test.py [--full] [unittest's options]

An answer compiles in five to fifteen seconds. So only a few are tried; --full: all answers for two
students, and all mistakes, some ten minutes.
"""
import os
import pathlib
import re
import sys
import tempfile
import tomllib
import unittest

import functions
import grade
import handed
import make
import tasks
import workshop
from runs import FAILED, PASSED, UNWRITTEN
from tasks import HERE, SOURCE

FULL = "--full" in sys.argv
WORK = (
    pathlib.Path(os.environ.get("ASSIGNMENTS_WORK", SOURCE / "build/assignments_test"))
    / "inventions"
)
INVENTED = [task for task in tasks.load_all().values() if task.kind == "invent"]
STUDENTS = ["ada", "emmy"] if FULL else ["ada"]
# Without --full: an answer on a triangle, and mistakes in what compiles fast.
ANSWERED = [task for task in INVENTED if FULL or task.id == "D1.1"]
MISTAKEN = [task for task in INVENTED if FULL or task.id in ("D2.1", "D5.1")]


class Answer:
    """answers/TASK.toml: a body for each function, helpers, and mistakes."""

    def __init__(self, task):
        entries = tomllib.loads((HERE / f"answers/{task.id}.toml").read_text())
        self.bodies = [entries["bodies"][name] for name in task.functions]
        self.helpers = (HERE / "answers/derivatives.h").read_text() + entries["helpers"]
        self.mistakes = entries["mistakes"]

    def with_change(self, cut, new):
        """The bodies with `new` for a text that one of them has once."""
        assert (
            sum(body.count(cut) for body in self.bodies) == 1
        ), f"the bodies do not have once: {cut}"
        return [body.replace(cut, new) for body in self.bodies]


def other_number(task, body):
    """The body with the number of another student in place of the name that every student has."""
    for name, value in task.numbers("a neighbour").items():
        body = re.sub(rf"\b{name}\b", repr(value), body)
    return body


class Inventions(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.workshop = cls.enterClassContext(workshop.Workshop(WORK, INVENTED).locked())
        cls.workshop.prepare()

    def ending(self, task, bodies, student="ada"):
        """How the check ends for an answer. The grader would refuse its helpers."""
        changed = workshop.changed_files(task, bodies, Answer(task).helpers, student)
        self.workshop.place(task, changed)
        return self.workshop.check(task, 1)

    def test_every_answer_passes(self):
        for task in ANSWERED:
            for student in STUDENTS:
                with self.subTest(task.id, student=student):
                    found = self.ending(task, Answer(task).bodies, student)
                    self.assertEqual((found.state, found.message), (PASSED, ""))

    def test_every_mistake_fails_with_its_own_sentence(self):
        for task in MISTAKEN:
            for mistake in Answer(task).mistakes[: None if FULL else 1]:
                with self.subTest(task.id, mistake=mistake["name"]):
                    found = self.ending(
                        task, Answer(task).with_change(mistake["cut"], mistake["with"])
                    )
                    self.assertEqual(found.state, FAILED)
                    self.assertIn(mistake["says"], found.message)

    @unittest.skipUnless(FULL, "compiles every answer once more")
    def test_the_numbers_of_another_student_fail(self):
        for task in INVENTED:
            with self.subTest(task.id):
                found = self.ending(
                    task, [other_number(task, body) for body in Answer(task).bodies]
                )
                self.assertEqual(found.state, FAILED)
                self.assertIn("expected", found.message)

    @unittest.skipUnless(FULL, "compiles every skeleton")
    def test_a_skeleton_compiles_and_says_what_is_not_written(self):
        for task in INVENTED:
            with self.subTest(task.id):
                given = [functions.body(task.source.read_text(), name) for name in task.functions]
                found = self.ending(task, given)
                self.assertEqual(found.state, UNWRITTEN)
                self.assertIn(f"task {task.id}", found.message)


class HandsOut(unittest.TestCase):
    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.copy = pathlib.Path(place.name) / "copy"
        make.copy(INVENTED, self.copy, student="ada")

    def hand_in(self, task):
        """Writes the answer into the copy, as a student would."""
        answer, file = Answer(task), self.copy / task.file
        for name, body in zip(task.functions, answer.bodies):
            file.write_text(functions.with_body(file.read_text(), name, body))
        (self.copy / handed.HELPERS).write_text(answer.helpers)

    def test_a_fresh_copy_is_not_written_yet(self):
        for task in INVENTED:
            self.assertEqual(grade.code_of(task, self.copy, "ada").state, UNWRITTEN, task.id)

    def test_no_answer_can_be_handed_in(self):
        for task in INVENTED:
            self.hand_in(task)
            found = grade.code_of(task, self.copy, "ada")
            self.assertEqual(found.state, FAILED, task.id)
            self.assertRegex(found.message, "begins with # is not taken .*<unsupported/Eigen")

    def test_no_copy_has_an_answer(self):
        answers = {functions.squeezed(body) for task in INVENTED for body in Answer(task).bodies}
        self.assertFalse(list(self.copy.rglob("answers")))
        for path in self.copy.rglob("*.h"):
            text = functions.squeezed(path.read_text())
            self.assertFalse([body for body in answers if body in text], path)

    def test_each_student_reads_other_numbers(self):
        text = (self.copy / "README.md").read_text()
        for task in INVENTED:
            header = (self.copy / task.numbers_file).read_text()
            for name, value in task.numbers("ada").items():
                self.assertIn(f"inline constexpr double {name} = {value!r};", header)
                self.assertIn(str(value), text)
                self.assertNotEqual(value, task.numbers("emmy")[name])

    def test_the_lists_of_terms_have_the_inventions(self):
        cloth = (self.copy / "common/math/cloth.h").read_text()
        for task in INVENTED:
            if task.term:
                self.assertRegex(
                    cloth, rf"using {task.list} =\s*Family<[^;]*\b{task.term}\b[^;]*>;"
                )


if __name__ == "__main__":
    unittest.main(argv=[argument for argument in sys.argv if argument != "--full"])
