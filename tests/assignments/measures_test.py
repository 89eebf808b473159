#!/usr/bin/env python3
"""Tests of the tasks that measure: measures.py, answers.py, distance.py.

    python3 tests/assignments/measures_test.py               needs step01_explicit … step05_bend
    python3 tests/assignments/measures_test.py --full        50 students for costly answers, too
    python3 tests/assignments/measures_test.py --build DIR   if not build/release
"""
import argparse
import contextlib
import functools
import io
import math
import pathlib
import re
import sys
import tempfile
import tomllib
import unittest
from unittest import mock

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import answers
import check
import distance
import grade as grader
import make
import measures
import tasks
from runs import ANSWERED, FAILED, PASSED, UNWRITTEN

SETTINGS = argparse.Namespace(build=tasks.SOURCE / "build/release", full=False)
TASKS = {id: task for id, task in tasks.load_all().items() if task.kind == "measure"}
COSTLY = ["C3.3", "C4.1", "C5.1"]  # ten runs or more for each answer


def students(task):
    many = SETTINGS.full or task.id not in COSTLY
    return [f"student {i}" for i in range(50 if many else 10)]


@functools.cache
def expected(id, student):
    return measures.measure(TASKS[id], student).answer(measures.Programs(SETTINGS.build))


@contextlib.contextmanager
def hand_in(text):
    """A directory whose answers.toml is the text."""
    with tempfile.TemporaryDirectory() as place:
        directory = pathlib.Path(place)
        (directory / answers.FILE).write_bytes(text if isinstance(text, bytes) else text.encode())
        yield directory


def grade(id, text, student="student 0"):
    """How a task ends, with the answer that is remembered instead of new runs."""
    with hand_in(text) as directory, mock.patch.object(measures, "measure") as measure:
        measure.return_value.answer = lambda programs: expected(id, student)
        return measures.grade(TASKS[id], directory, student, None)


class Tasks(unittest.TestCase):
    def test_each_has_its_class(self):
        self.assertEqual(sorted(TASKS), sorted(measures.MEASURES))

    def test_questions_take_the_numbers(self):
        for task in TASKS.values():
            question = task.question.format(**task.numbers("ada"))
            self.assertNotIn("{", question)
            self.assertIn("Answer" if task.unit != "steps" else "?", question, task.id)

    def test_a_secret_word_makes_other_numbers(self):
        for task in TASKS.values():
            self.assertEqual(task.numbers("ada"), task.numbers("ada"))
            self.assertNotEqual(task.numbers("ada"), task.numbers("ada 7f3k"))


class ExpectedAnswers(unittest.TestCase):
    def test_score(self):
        for task in TASKS.values():
            for student in students(task):
                for value in expected(task.id, student).values:
                    ending = grade(task.id, f'"{task.id}" = {value:.4g}', student)
                    self.assertEqual(ending.state, PASSED, (task.id, student, ending.message))

    def test_are_seldom_those_of_a_neighbour(self):
        for task in TASKS.values():
            found = [expected(task.id, student) for student in students(task)]
            pairs = [a.accepts(b.values[0]) for a in found for b in found if a is not b]
            print(f"{task.id}: {sum(pairs)} of {len(pairs)} answers of neighbours are accepted")
            self.assertLessEqual(sum(pairs), 0.1 * len(pairs), task.id)

    def test_allow_no_more_than_they_say(self):
        for id in TASKS:
            answer = expected(id, "student 0")
            low, high = min(answer.values), max(answer.values)
            for value, state, word in (
                (low * (1 - 1.1 * answer.share), FAILED, "small"),
                (low * (1 - 0.9 * answer.share), PASSED, "Right"),
                (high * (1 + 0.9 * answer.share), PASSED, "Right"),
                (high * (1 + 1.1 * answer.share), FAILED, "large"),
            ):
                ending = grade(id, f'"{id}" = {value!r}')
                self.assertEqual(ending.state, state, (id, value))
                self.assertIn(word, ending.message)
                self.assertIn("allowed" if len(answer.values) == 1 else "20 %", ending.message)

    def test_are_those_of_the_same_student_in_grade_and_make(self):
        task, value = TASKS["C1.1"], expected("C1.1", "student 3").values[0]
        with hand_in(f'"C1.1" = {value}') as directory:
            states = [
                grader.grade([task], directory, student, 1, mock.Mock(), SETTINGS.build)[0].state
                for student in ("student 3", "student 4")
            ]
        self.assertEqual(states, [PASSED, FAILED])
        section = make.section(task, "student 3")
        self.assertIn(f"h = {task.numbers('student 3')['h']:g} s", section)
        self.assertIn("build/step01_explicit/step01_explicit measure/C1.1/scene.toml", section)

    def test_are_not_given_away(self):
        for id in TASKS:
            message = grade(id, f'"{id}" = 7e9').message
            for number in map(float, re.findall(r"\d+(?:\.\d+)?(?:e[-+]?\d+)?", message)):
                self.assertFalse(expected(id, "student 0").accepts(number), message)


def rate(log, begin, period):
    """Of the amplitude, per s: from the total energies at two times, a whole number of periods
    apart.
    """

    def energy(time):
        after = next(i for i, row in enumerate(log) if row["time"] >= time)
        a, b = log[after - 1], log[after]
        share = (time - a["time"]) / (b["time"] - a["time"])
        return math.exp((1 - share) * math.log(a["total"]) + share * math.log(b["total"]))

    count = max(1, int(begin / period))
    return math.log(energy(begin) / energy(begin + count * period)) / (2 * count * period)


class Formulas(unittest.TestCase):
    """What a student measures who does not know the formula."""

    def test_of_damping_is_what_step_2_does(self):
        task = measures.measure(TASKS["C2.1"], "student 0")
        kd = task.answer(None).values[0]
        run = measures.Programs(SETTINGS.build).run(
            "step02_damping", task.scene(), "--set", f"damping.stretch={kd}"
        )
        seen = rate(run.log, task.n.time / 2, 2 * math.pi / task.omega)
        self.assertAlmostEqual(seen * task.n.time / math.log(10), 1, delta=0.01)

    def test_of_the_method_is_what_step_3_does(self):
        task = measures.measure(TASKS["C3.1"], "student 0")
        time = task.answer(None).values[0] * task.n.h
        run = measures.Programs(SETTINGS.build).run("step03_implicit", task.scene())
        seen = rate(run.log, time / 2, 2 * math.pi / task.omega)
        self.assertAlmostEqual(seen * time / math.log(10), 1, delta=0.01)

    def test_of_the_stable_step_is_what_step_1_says_of_a_stiffer_cloth(self):
        task = measures.measure(TASKS["C1.1"], "student 0")
        programs = measures.Programs(SETTINGS.build)
        k = task.answer(programs).values[0]
        stiff = re.sub(
            r"^k = (\S+)",
            lambda m: f"k = {float(m[1]) * k / task.k}",
            task.scene(),
            flags=re.MULTILINE,
        )
        self.assertAlmostEqual(measures.critical_step(programs, stiff) / task.n.h, 1, delta=1e-3)

    def test_find_where_a_falling_function_is_the_target(self):
        self.assertAlmostEqual(
            measures.crossing(lambda x: 1 / (1 + x), 0.2, 0.1, 100), 4, delta=0.02
        )
        with self.assertRaisesRegex(tasks.TaskError, "2 is not between"):
            measures.crossing(lambda x: 1 / (1 + x), 2, 0.1, 100)


class AnswersFile(unittest.TestCase):
    def test_without_an_answer_is_not_written(self):
        with tempfile.TemporaryDirectory() as empty:
            self.assertIsNone(answers.number(pathlib.Path(empty), "C1.1"))
        for text in ("", '# "C1.1" = 3\n', '"C1.2" = 3\n'):
            ending = grade("C1.1", text)
            self.assertEqual(ending.state, UNWRITTEN)
            self.assertEqual(ending.message, 'answers.toml has no line "C1.1" = …')

    def test_with_something_else_fails_with_a_sentence(self):
        for text, words in (
            ('"C1.1" =\n', 'line 1 is "C1.1" =. Write a line such as'),
            ('# mine\n"C1.1" = 2,5 N/m', 'line 2 is "C1.1" = 2,5 N/m. Write a line such as'),
            (b"\xff\xfe", "cannot be read"),
            ('"C1.1" = ' + "[" * 50_000, "cannot be read"),
            ('"C1.1" = ' + "1" * 5000, "cannot be read"),
            ("# " + "a" * 200_000, "larger than 100 kB"),
            ('"C1.1" = 1\n"C1.1" = 2', "cannot be read"),
            ("C1.1 = 3", 'in quotes, "C1.1"'),
            ('"C1.1" = "3"', '"C1.1" is not a number'),
            ('"C1.1" = true', "is not a number"),
            ('"C1.1" = nan', "is not a number"),
            ('"C1.1" = -inf', "is not a number"),
            ('"C1.1" = [3]', "is not a number"),
            ('"C1.1" = ' + "1" * 4000, "is not a number"),
        ):
            ending = grade("C1.1", text)
            self.assertEqual(ending.state, FAILED, text[:40])
            self.assertIn(words, ending.message)
            self.assertLess(len(ending.message), 300)

    def test_of_another_task_does_not_matter(self):
        value = expected("C1.1", "student 0").values[0]
        self.assertEqual(grade("C1.1", f'"C1.2" = "?"\n"C1.1" = {value}').state, PASSED)

    def test_is_looked_at_by_check(self):
        for text, state, words in (
            ('"C1.1" = 3', ANSWERED, "the number 3 "),
            ("", UNWRITTEN, "no number"),
            ('"C1.1" = "x"', FAILED, "is not a number"),
        ):
            with hand_in(text) as directory, mock.patch.object(check, "COPY", directory):
                ending = check.check(TASKS["C1.1"])
            self.assertEqual(ending.state, state)
            self.assertIn(words, ending.message)


class Copy(unittest.TestCase):
    def test_has_a_scene_for_each_task_and_a_file_for_the_answers(self):
        with tempfile.TemporaryDirectory() as place:
            out = pathlib.Path(place)
            measures.add(list(tasks.load_all().values()), out, "ada")
            for id in TASKS:
                scene = tomllib.loads((out / "measure" / id / "scene.toml").read_text())
                self.assertIn("cloth", scene)
            text = (out / answers.FILE).read_text()
            self.assertEqual(answers.read(out), {})
            (out / answers.FILE).write_text(re.sub(r'^# (".*=)', r"\1 5", text, flags=re.MULTILINE))
            self.assertEqual(answers.read(out), {id: 5 for id in TASKS})
            self.assertTrue((out / "measure/distance.py").exists())

    def test_without_such_tasks_has_none_of_them(self):
        with tempfile.TemporaryDirectory() as place:
            measures.add([tasks.load_all()["A1.1"]], pathlib.Path(place), "ada")
            self.assertEqual(list(pathlib.Path(place).iterdir()), [])


class Programs(unittest.TestCase):
    def test_that_are_not_built_are_named(self):
        with hand_in('"C5.1" = 1') as directory, self.assertRaises(tasks.TaskError) as refused:
            measures.grade(TASKS["C5.1"], directory, "ada", measures.Programs("/nowhere"))
        self.assertIn(
            "/nowhere/step05_bend/step05_bend is not built: cmake --build", str(refused.exception)
        )

    def test_that_refuse_a_scene_say_so(self):
        with self.assertRaisesRegex(tasks.TaskError, "failed on the scene of a task: .*colour"):
            measures.Programs(SETTINGS.build).run("step01_explicit", "[colour]\n")


class Distance(unittest.TestCase):
    def run_on(self, *texts):
        with tempfile.TemporaryDirectory() as place:
            files = [pathlib.Path(place) / f"{i}.obj" for i in range(len(texts))]
            for file, text in zip(files, texts):
                file.write_text(text)
            output, errors = io.StringIO(), io.StringIO()
            with mock.patch.object(
                sys, "argv", ["distance.py", *map(str, files)]
            ), contextlib.redirect_stdout(output), contextlib.redirect_stderr(errors):
                return distance.main(), output.getvalue() + errors.getvalue()

    def test_is_that_of_the_vertices(self):
        self.assertEqual(
            self.run_on("v 0 0 0\nvt 1 1\nv 1 0 0\nf 1 2 1\n", "v 0 0.003 0.004\nv 1 0 0\n"),
            (0, "root mean square 3.536 mm, largest 5 mm\n"),
        )

    def test_of_two_cloths_is_refused(self):
        code, text = self.run_on("v 0 0 0\n", "v 0 0 0\nv 1 0 0\n")
        self.assertEqual(code, 2)
        self.assertIn("different numbers of vertices, 1 and 2", text)

    def test_of_no_cloth_is_refused(self):
        code, text = self.run_on("", "v 0 a 0\n")
        self.assertEqual(code, 2)
        self.assertIn("distance.py: ", text)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(add_help=False)
    parser.add_argument("--build", type=pathlib.Path, default=SETTINGS.build)
    parser.add_argument("--full", action="store_true")
    rest = parser.parse_known_args(namespace=SETTINGS)[1]
    unittest.main(argv=[sys.argv[0], *rest])
