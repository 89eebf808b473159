#!/usr/bin/env python3
"""Tests of functions.py: finding functions in C++ text, and replacing their bodies."""
import subprocess
import unittest

import functions
from tasks import SOURCE

TEXT = """
// int hidden() { return 1; }
namespace a {
template <class T, int N = 3>
struct Box {
  explicit Box(int size_ = {}) : size{size_}, text("}") { ++size; }  // } in a comment
  int value() const { return text.size() > 1 ? '{' : 1'000; }
  std::array<int, 2> b = {1, 1};
  int size;
};
inline int twice(int x) { if (x) { return 2 * x; } return 0; }
inline double twice(double x) { return 2 * x; }
namespace {
void apart() { auto f = [](int i) { return i; }; f(1); }
}
}  // namespace a
int a::Box<int>::outside() const noexcept { return R"(})"[0]; }
#define LOST() { broken(
"""


class FindsFunctions(unittest.TestCase):
    def names(self):
        return [f.name for f in functions.functions(TEXT)]

    def test_by_their_qualified_names(self):
        self.assertEqual(
            self.names(),
            ["a::Box::Box", "a::Box::value", "a::twice", "a::twice", "a::apart", "a::Box::outside"],
        )

    def test_body_is_what_stands_between_the_braces(self):
        self.assertEqual(functions.body(TEXT, "a::Box::Box"), " ++size; ")
        self.assertEqual(functions.body(TEXT, "a::twice(double"), " return 2 * x; ")

    def test_refuses_a_name_that_two_functions_have(self):
        with self.assertRaisesRegex(
            functions.CodeError, r"x.h has 2 functions a::twice \(lines 11, 12\)"
        ):
            functions.find(TEXT, "a::twice", "x.h")

    def test_refuses_a_name_that_no_function_has(self):
        with self.assertRaisesRegex(functions.CodeError, "x.h has no function a::hidden"):
            functions.find(TEXT, "a::hidden", "x.h")

    def test_says_which_brace_is_never_closed(self):
        with self.assertRaisesRegex(functions.CodeError, "line 2: '{' is never closed"):
            functions.functions("int x;\nint f() { return 1;")

    def test_a_body_replaces_another(self):
        changed = functions.with_body(TEXT, "a::Box::value", " return 7; ")
        self.assertEqual(functions.body(changed, "a::Box::value"), " return 7; ")
        self.assertEqual(functions.body(changed, "a::apart"), functions.body(TEXT, "a::apart"))

    def test_knows_how_deep_a_declaration_stands(self):
        for name, spaces in (("a::Box::value", "  "), ("a::twice(int", ""), ("a::apart", "")):
            self.assertEqual(functions.indentation(TEXT, name), spaces)

    def test_squeezed_bodies_differ_in_code_only(self):
        self.assertEqual(functions.squeezed('a = 1;  // one\n b( "//" );'), 'a=1;b("//");')

    # Every brace of the project's code is matched, and each body can be taken out and put back.
    def test_reads_all_code_of_the_project(self):
        listed = subprocess.run(
            ["git", "ls-files", "*.h", "*.cpp"], cwd=SOURCE, capture_output=True, text=True
        )
        files = listed.stdout.split() or [
            str(f.relative_to(SOURCE)) for f in SOURCE.rglob("common/*/*.h")
        ]
        count = 0
        for file in files:
            text = (SOURCE / file).read_text()
            for f in functions.functions(text):
                self.assertEqual(text[f.begin - 1] + text[f.end], "{}", f"{file}: {f.name}")
                count += 1
        self.assertGreater(count, 200)


if __name__ == "__main__":
    unittest.main()
