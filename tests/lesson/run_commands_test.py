#!/usr/bin/env python3
"""Tests of run_commands.py, with texts and commands whose results are known."""
import pathlib
import sys
import tempfile
import unittest
from unittest import mock

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import run_commands
from run_commands import Command, commands_of

STEP = "build/release/step01_explicit/step01_explicit"


def texts(markdown):
    return [command.text for command in commands_of("README.md", markdown)]


class Finding(unittest.TestCase):
    def test_a_block_of_the_shell_is_one_command(self):
        self.assertEqual(texts("1. Try:\n\n   ```sh\n   mkdir a\n     ls a\n   ```\n"),
                         ["mkdir a\n  ls a"])

    def test_other_blocks_are_none(self):
        self.assertEqual(texts(f"```\n{STEP} --h 1\n```\n\n    h = 1\n"), [])
        self.assertEqual(texts("```cpp\n    diff a b\n```\n"), [])

    def test_an_indented_line_is_a_command_with_its_continuations(self):
        self.assertEqual(texts(f"    {STEP} --h 1 \\\n      --cells 8\n    diff a b\n"),
                         [f"{STEP} --h 1 \\\n  --cells 8", "diff a b"])

    def test_a_loop_is_one_command(self):
        self.assertEqual(texts("    for h in 1 2; do\n      echo $h\n    done\n\ntext\n"),
                         ["for h in 1 2; do\n  echo $h\ndone"])

    def test_a_span_is_a_command_if_it_begins_with_a_program(self):
        text = (f"Call `{STEP}\n--h 1` (`diff`, `{STEP}.cpp`, `build/release/tests/…`) "
                "or `ctest --test-dir b -R X`.")
        self.assertEqual(texts(text), [f"{STEP} --h 1", "ctest --test-dir b -R X"])

    def test_an_instrument_is_a_command_without_arguments(self):
        self.assertEqual(texts("`build/release/tests/a/b` draws.\n"), ["build/release/tests/a/b"])

    def test_comments_are_none_and_keep_the_lines(self):
        found = commands_of("README.md", f"<!-- console:\n    {STEP} -->\n\n    diff a b\n")
        self.assertEqual([(command.text, command.place) for command in found],
                         [("diff a b", "README.md:4")])


class Classes(unittest.TestCase):
    def kind(self, text, done=()):
        return Command("README.md", 1, text).kind(done)[0]

    def test_of_commands(self):
        self.assertEqual(self.kind(STEP), "cheap")
        self.assertEqual(self.kind(STEP, done={STEP}), "done")
        self.assertEqual(self.kind(f"{STEP} --explain"), "expensive")
        self.assertEqual(self.kind("ctest --test-dir build/release -L math"), "rehearsed")
        self.assertEqual(self.kind("ctest --test-dir build/release -L math\nmkdir a"), "cheap")

    def test_a_rehearsal_has_no_effect(self):
        self.assertEqual(run_commands.rehearsal("cmake --build build/release --target a  # why"),
                         "cmake --build build/release --target a -- -n  # why")

    def test_pictures_are_small_or_absent(self):
        self.assertEqual(run_commands.with_cheap_pictures(f"{STEP} --h 1"),
                         f"{STEP} --no-pictures --h 1")
        self.assertEqual(run_commands.with_cheap_pictures(f"{STEP} --size 9x9 --motion"),
                         f"{STEP} --size 80x45 --motion")

    def test_words_of_the_reader_have_stand_ins(self):
        self.assertEqual(run_commands.with_stand_ins("a=KD b=HALF_OF_KD data.png a.png"),
                         "a=0.1 b=0.05 data.png step04_cg/frame.png")


class Running(unittest.TestCase):
    def failure(self, text):
        with tempfile.TemporaryDirectory() as directory:
            return run_commands.failure(Command("README.md", 1, text), text, directory)

    def test_a_wrong_exit_code_is_a_failure(self):
        self.assertEqual(self.failure("true"), "")
        self.assertIn("exit code 1 instead of 0\nwhy", self.failure("echo why; false"))
        self.assertIn("exit code 0 instead of 1", self.failure("diff /dev/null /dev/null"))

    def test_an_exit_code_of_2_ends_a_script(self):
        self.assertIn("exit code 2 instead of 0", self.failure("(exit 2)\ntrue"))
        self.assertEqual(self.failure("(exit 1)\ntrue"), "")

    def test_tests_that_do_not_exist_are_a_failure(self):
        self.assertEqual(self.failure("echo; echo 'Total Tests: 0'"), "it selects no test")

    def test_the_same_text_runs_once(self):
        text = "echo >> a; [ $(wc -l < a) = 1 ]"  # fails the second time
        with tempfile.TemporaryDirectory() as directory, mock.patch("builtins.print"):
            lines, failed = run_commands.run(
                [(Command("a.md", line, text), text) for line in (1, 2)], directory, {})
        self.assertEqual(failed, 0)
        self.assertEqual(lines[1], ("a.md", f"OK     as a.md:1  a.md:2  {text}"))


class Result(unittest.TestCase):
    def test_a_run_renews_the_part_of_its_files(self):
        with tempfile.TemporaryDirectory() as directory:
            path = pathlib.Path(directory) / "result.txt"
            with mock.patch.multiple(run_commands, machine=lambda _: "a machine",
                                     git=lambda *_: "a commit"):
                for lines in ([("a.md", "OK      1 s  a.md:1  x"), ("b.md", "FAILED  2 s  b.md:1  y")],
                              [("b.md", "OK      3 s  b.md:1  y")]):
                    run_commands.write_result(path, directory, lines, "")
            text = path.read_text()
        self.assertEqual(text.count("machine  a machine"), 2)
        self.assertIn("a.md  1 commands, 0 failed", text)
        self.assertIn("b.md  1 commands, 0 failed", text)
        self.assertNotIn("FAILED", text)


if __name__ == "__main__":
    unittest.main()
