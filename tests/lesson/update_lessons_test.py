#!/usr/bin/env python3
"""Tests of update_lessons.py, with commands whose output is known."""
import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import update_lessons
from update_lessons import Document, LessonError, Runner


class FakeRunner:
    """Knows the outputs, and remembers which commands ran."""

    def __init__(self, **outputs):
        self.outputs, self.ran = outputs, []

    def output(self, command):
        self.ran.append(command)
        return self.outputs[command]


def renewed(text, check=False, slow=False, times=False, **outputs):
    return Document("README.md", text, FakeRunner(**outputs), check, slow, times)


def block(kind, head, content):
    return f"<!-- {kind}: {head} -->\n{content}<!-- end {update_lessons.checksum(content)} -->\n"


class Blocks(unittest.TestCase):
    def test_a_console_is_what_the_command_prints(self):
        document = renewed("<!-- console: say -->\nold\n<!-- end -->\n", say="one\ntwo\n")
        self.assertEqual(document.renewed, block("console", "say", "```\none\ntwo\n```\n"))

    def test_lines_that_are_left_out_become_an_ellipsis(self):
        document = renewed("<!-- console: say\n     only: on|fo -->\n<!-- end -->\n",
                           say="one\ntwo\nthree\nfour\nfive\n")
        self.assertIn("```\none\n  …\nfour\n```\n", document.renewed)

    def test_a_block_that_is_up_to_date_stays_as_it_is(self):
        text = block("table", "say", "| a |\n|---|\n| 1 |\n")
        document = renewed(text, say="| a |\n|---|\n| 1 |\n")
        self.assertEqual(document.renewed, text)
        self.assertEqual(document.edited, [])

    def test_another_number_is_a_difference(self):
        document = renewed(block("table", "say", "| a |\n|---|\n| 1 |\n"),
                           say="| a |\n|---|\n| 2 |\n")
        self.assertIn("\n-| 1 |\n", document.difference())
        self.assertIn("\n+| 2 |\n", document.difference())

    def test_a_block_that_was_edited_by_hand_is_named(self):
        text = "text\n" + block("console", "say", "```\none\n```\n").replace("one", "eleven")
        document = renewed(text, say="one\n")
        self.assertEqual(document.edited, [2])
        self.assertIn("```\none\n```\n", document.renewed)

    def test_even_where_only_a_time_was_edited(self):
        text = block("console", "say", "```\ndone in 0.5 s\n```\n").replace("0.5", "0.1")
        self.assertEqual(renewed(text, say="done in 0.7 s\n").edited, [1])

    def test_a_block_without_an_end_is_refused(self):
        with self.assertRaisesRegex(LessonError, "1 blocks begin, 0 end, and 0 do both"):
            renewed("<!-- table: say -->\n| a |\n", say="")


class Times(unittest.TestCase):
    console = "```\n5 steps in 0.5 s (100 ms each), energy 2 J\n```\n"
    table = "| h | ms | J |\n|---|---|---|\n| 1 | 10 | 7 |\n"

    def test_are_not_compared(self):
        text = block("console", "say", self.console) + block("table", "list", self.table)
        document = renewed(text, say="5 steps in 0.9 s (180 ms each), energy 2 J\n",
                           list=self.table.replace("10", "99"))
        self.assertEqual(document.difference(), "")

    def test_are_kept_where_something_else_changes(self):
        document = renewed(block("console", "say", self.console),
                           say="5 steps in 0.9 s (180 ms each), energy 3 J\n")
        self.assertIn("5 steps in 0.5 s (100 ms each), energy 3 J", document.renewed)

    def test_are_renewed_on_demand(self):
        document = renewed(block("table", "list", self.table), times=True,
                           list=self.table.replace("10", "99"))
        self.assertIn("| 1 | 99 | 7 |", document.renewed)

    def test_other_columns_are_compared(self):
        document = renewed(block("table", "list", self.table), list=self.table.replace("7", "8"))
        self.assertIn("| 1 | 10 | 8 |", document.renewed)


class Numbers(unittest.TestCase):
    head = "<!-- number lines: count\n     find: (\\S+) lines\n     as: %.1e -->\n"

    def test_stand_in_a_sentence(self):
        document = renewed(self.head + "Here <!--lines-->7<!--/--> lines change.\n",
                           count="21234 lines\n")
        self.assertIn("Here <!--lines-->2.1·10⁴<!--/--> lines", document.renewed)

    def test_are_written_as_in_the_lessons(self):
        for printed, written in (("-3.5", "−3.5"), ("4e+13", "4·10¹³"), ("1e-04", "10⁻⁴"),
                                 ("-1.5e-3", "−1.5·10⁻³")):
            self.assertEqual(update_lessons.in_lesson_notation(printed), written)

    def test_what_is_not_found_is_an_error(self):
        with self.assertRaisesRegex(LessonError, "nothing matches"):
            renewed(self.head + "a <!--lines-->7<!--/-->\n", count="no number\n")

    def test_without_a_definition_are_refused(self):
        with self.assertRaisesRegex(LessonError, "no comment defines the number other"):
            renewed(self.head + "a <!--lines-->7<!--/--> <!--other-->7<!--/-->\n",
                    count="1 lines\n")

    def test_without_a_place_are_refused(self):
        with self.assertRaisesRegex(LessonError, "lines stands nowhere"):
            renewed(self.head, count="1 lines\n")

    def test_must_not_begin_a_line(self):
        with self.assertRaisesRegex(LessonError, "README.md:4: .*begin the line with a word"):
            renewed(self.head + "<!--lines-->7<!--/--> lines\n", count="1 lines\n")


class Slow(unittest.TestCase):
    table = block("table", "list\n     slow", "| 1 |\n")
    number = "<!-- number lost: run\n     slow: 0.67 -->\nHere <!--lost-->0.67<!--/--> J.\n"

    def test_commands_do_not_run_without_the_option(self):
        document = renewed(self.table + self.number)
        self.assertEqual(document.runner.ran, [])
        self.assertEqual(document.difference(), "")

    def test_commands_run_with_the_option(self):
        document = renewed(self.table + self.number, slow=True, list="| 2 |\n", run="0.68\n")
        self.assertIn("| 2 |\n", document.renewed)
        self.assertIn("slow: 0.68 -->\nHere <!--lost-->0.68<!--/--> J.", document.renewed)

    def test_results_that_were_edited_are_noticed(self):
        self.assertEqual(renewed(self.table.replace("1 |", "3 |"), check=True).edited, [1])
        document = renewed(self.number.replace("-->0.67", "-->0.70"), check=True)
        self.assertIn("+Here <!--lost-->0.67<!--/--> J.", document.difference())


class Commands(unittest.TestCase):
    def setUp(self):
        self.build = tempfile.TemporaryDirectory()
        self.runner = Runner(self.build.name)

    def tearDown(self):
        self.runner.room.cleanup()
        self.build.cleanup()

    def test_run_among_the_files_of_the_repository_and_leave_none_there(self):
        command = "mkdir -p out; echo 1 > out/a; cat out/a; head -1 README.md"
        self.assertEqual(self.runner.output(command), "1\n# Large Steps\n")
        self.assertTrue((self.runner.directory / "out/a").exists())
        self.assertFalse((update_lessons.SOURCE / "out/a").exists())

    def test_run_once(self):
        count = "echo x >> count; wc -l < count"
        self.assertEqual(self.runner.output(count), self.runner.output(count))

    def test_that_fail_are_an_error(self):
        with self.assertRaisesRegex(LessonError, "exit code 2 of exit 2"):
            self.runner.output("exit 2")

    def test_that_print_nothing_are_an_error(self):
        with self.assertRaisesRegex(LessonError, "true prints nothing"):
            self.runner.output("true")


if __name__ == "__main__":
    unittest.main()
