// What the lessons say about the code is true: differences between neighbours are small, functions that a
// step does not teach are the same byte for byte, and names exist.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

namespace lesson_test {

const std::filesystem::path source = SOURCE_DIRECTORY;

struct Step {
  std::string name;
  int budget;  // changed lines of time_step.h, those that diff marks < or >
};
const std::vector<Step> all_steps = {{"step01_explicit", 0},
                                     {"step02_damping", 30},
                                     {"step03_implicit", 130},
                                     {"step04_cg", 100},
                                     {"step05_bend", 40}};

std::vector<Step> steps() {
  std::vector<Step> there;
  for (const Step& step : all_steps)
    if (exists(source / step.name / "CMakeLists.txt")) there.push_back(step);
  return there;
}

std::string read(const std::filesystem::path& path) {
  std::ifstream file(path);
  EXPECT_TRUE(file) << path << " is missing";
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> all;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) all.push_back(line);
  return all;
}

// Lines deleted plus lines added: on both sides, all but the longest common subsequence.
int changed_lines(const std::vector<std::string>& a, const std::vector<std::string>& b) {
  std::vector<std::vector<int>> common(a.size() + 1, std::vector<int>(b.size() + 1, 0));
  for (size_t i = 0; i < a.size(); ++i)
    for (size_t j = 0; j < b.size(); ++j)
      common[i + 1][j + 1] =
          a[i] == b[j] ? common[i][j] + 1 : std::max(common[i][j + 1], common[i + 1][j]);
  return int(a.size() + b.size()) - 2 * common[a.size()][b.size()];
}

TEST(Lessons, NeighboursDifferByNoMoreThanTheirBudget) {
  for (size_t s = 1; s < steps().size(); ++s) {
    const auto of = [&](size_t step) {
      return lines(read(source / steps()[step].name / "time_step.h"));
    };
    const int changed = changed_lines(of(s - 1), of(s));
    EXPECT_LE(changed, steps()[s].budget) << steps()[s].name;
    EXPECT_GT(changed, 0) << steps()[s].name;
  }
}

TEST(Lessons, CountingChangesCountsThem) {
  EXPECT_EQ(changed_lines({"a", "b", "c"}, {"a", "b", "c"}), 0);
  EXPECT_EQ(changed_lines({"a", "b", "c"}, {"a", "x", "c", "d"}), 3);
}

// A function, from its signature to the brace in column 0.
std::string function(const std::string& text, const std::string& signature) {
  const size_t begin = text.find(signature), end = text.find("\n}\n", begin);
  EXPECT_NE(begin, std::string::npos) << signature;
  return begin == std::string::npos ? "" : text.substr(begin, end - begin);
}

TEST(Lessons, WhatAStepDoesNotTeachStaysByteForByte) {
  const std::string first = read(source / "step01_explicit/time_step.h");
  const std::string gravity = function(first, "inline void add_gravity(");
  for (const Step& step : steps())
    EXPECT_EQ(function(read(source / step.name / "time_step.h"), "inline void add_gravity("),
              gravity)
        << step.name;
}

TEST(Lessons, NoStepReadsAnotherAndNothingSharedReadsAStep) {
  const std::regex include("#include \"[^\"]*step0[1-5]");
  for (const auto& entry : std::filesystem::recursive_directory_iterator(source)) {
    const std::string path = relative(entry.path(), source).string();
    const bool code = path.ends_with(".h") || path.ends_with(".cpp");
    if (!code || !(path.starts_with("common/") || path.starts_with("step0"))) continue;
    EXPECT_FALSE(std::regex_search(read(entry.path()), include)) << path;
  }
}

std::vector<std::string> includes(const std::string& text) {
  const std::regex include("#include \"([^\"]+)\"");
  std::vector<std::string> all;
  for (std::sregex_iterator it(text.begin(), text.end(), include), end; it != end; ++it)
    all.push_back((*it)[1]);
  return all;
}

// What a step teaches needs mathematics alone: no scene, no program, no picture.
TEST(Lessons, TimeStepsAndHeadersOfMathIncludeMathOnly) {
  std::vector<std::filesystem::path> files;
  for (const Step& step : steps()) files.push_back(source / step.name / "time_step.h");
  for (const auto& entry : std::filesystem::directory_iterator(source / "common/math"))
    if (entry.path().extension() == ".h") files.push_back(entry.path());
  for (const auto& file : files)
    for (const std::string& header : includes(read(file)))
      EXPECT_TRUE(header.starts_with("math/")) << file << " includes " << header;
}

TEST(Lessons, IncludesAreFound) {
  EXPECT_EQ(includes("#include <array>\n#include \"math/a.h\"\n  #include \"b.h\"\n"),
            (std::vector<std::string>{"math/a.h", "b.h"}));
}

// The Markdown files of the repository.
std::vector<std::filesystem::path> documents() {
  std::vector<std::filesystem::path> found = {source / "README.md", source / "CONTRIBUTING.md"};
  for (const char* directory : {"common", "tests"})
    for (const auto& entry : std::filesystem::recursive_directory_iterator(source / directory))
      if (entry.path().extension() == ".md") found.push_back(entry.path());
  for (const Step& step : steps()) found.push_back(source / step.name / "README.md");
  return found;
}

// Every file of the repository that a document names in `…` is there.
TEST(Lessons, FilesThatAreNamedExist) {
  const std::regex file("`((common|tests|step0[1-5]_[a-z]+)/[A-Za-z0-9_./]*)`");
  int named = 0;
  for (const auto& document : documents()) {
    const std::string text = read(document);
    for (std::sregex_iterator it(text.begin(), text.end(), file), end; it != end; ++it) {
      EXPECT_TRUE(exists(source / (*it)[1].str())) << document << ": " << (*it)[1];
      ++named;
    }
  }
  EXPECT_GT(named, 10);
}

// Prose and code are wrapped at 110 columns. Tables, pictures, comments and what programs print, between
// <!-- console … and <!-- end …, are as long as they are.
TEST(Lessons, ProseAndCodeAreWrapped) {
  for (const auto& document : documents()) {
    bool comment = false, printed = false;
    int number = 0;
    for (const std::string& line : lines(read(document))) {
      ++number;
      if (line.starts_with("<!-- ")) {
        comment = true;
        printed = line.starts_with("<!-- console");
      }
      const bool free = comment || printed || line.starts_with("|") || line.starts_with("![");
      if (line.find("-->") != std::string::npos) comment = false;
      const auto columns =
          std::ranges::count_if(line, [](unsigned char byte) { return (byte & 0xC0) != 0x80; });
      EXPECT_TRUE(free || columns <= 110) << document << ":" << number;
    }
  }
}

// The last column of a lesson's table of equations: names of functions that exist.
TEST(Lessons, TablesOfEquationsNameFunctionsThatExist) {
  std::string code;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(source / "common"))
    if (entry.path().extension() == ".h" || entry.path().extension() == ".cpp")
      code += read(entry.path());
  for (const Step& step : steps()) {
    const std::string all = code + read(source / step.name / "time_step.h");
    const std::regex row("\\| [^|]*\\|.*\\| ((`[^`|]+`(, )?)+) \\|"),
        name("`([A-Za-z_0-9]+)[^`]*`");
    int rows = 0;
    const std::string text = read(source / step.name / "README.md");
    const size_t table = text.find("| | formula | in the code |"), end = text.find("\n\n", table);
    ASSERT_NE(table, std::string::npos) << step.name;
    for (const std::string& line : lines(text.substr(table, end - table))) {
      std::smatch match;
      if (!std::regex_match(line, match, row)) continue;
      ++rows;
      const std::string names = match[1];
      for (std::sregex_iterator it(names.begin(), names.end(), name), none; it != none; ++it)
        EXPECT_NE(all.find((*it)[1].str() + "("), std::string::npos)
            << step.name << ": " << (*it)[1];
    }
    EXPECT_GE(rows, 2) << step.name;
  }
}

// Without the spaces at the beginning of each line: a quoted line is indented as its list is.
std::string unindented(const std::string& text) {
  std::string out;
  for (const std::string& line : lines(text)) {
    const size_t begin = line.find_first_not_of(' ');
    out += (begin == std::string::npos ? "" : line.substr(begin)) + "\n";
  }
  return out;
}

// The blocks of a document between ```cpp and ```, unindented.
std::vector<std::string> quoted_code(const std::string& document) {
  std::vector<std::string> blocks;
  bool code = false;
  for (const std::string& line : lines(unindented(document))) {
    if (line == "```cpp") blocks.emplace_back();
    if (code && line != "```") blocks.back() += line + "\n";
    code = line == "```cpp" || (code && line != "```");
  }
  return blocks;
}

TEST(Lessons, QuotedCodeIsFound) {
  EXPECT_EQ(quoted_code("a\n```cpp\n  b\n\nc\n```\nd\n   ```cpp\n   e;\n   ```\n```\nf\n```\n"),
            (std::vector<std::string>{"b\n\nc\n", "e;\n"}));
}

// The C++ that a lesson quotes stands in a file of its step, in a header of common/math, or in a test.
TEST(Lessons, QuoteTheCodeAsItIs) {
  std::string shared = unindented(read(source / "tests/support/plain_cg.h"));
  for (const auto& entry : std::filesystem::directory_iterator(source / "common/math"))
    shared += unindented(read(entry.path()));
  int quoted = 0;
  for (const Step& step : steps()) {
    const std::string code = shared + unindented(read(source / step.name / "time_step.h")) +
                             unindented(read(source / step.name / "main.cpp"));
    for (const std::string& block : quoted_code(read(source / step.name / "README.md"))) {
      EXPECT_NE(code.find("\n" + block), std::string::npos) << step.name << ":\n" << block;
      ++quoted;
    }
  }
  EXPECT_GT(quoted, 5);
}

TEST(Lessons, PlainConjugateGradientsArePrintedAsTheyAreTested) {
  const std::string tested = read(source / "tests/support/plain_cg.h");
  const size_t begin = tested.find("// Solves A x = b");
  ASSERT_NE(begin, std::string::npos);
  EXPECT_NE(read(source / "step04_cg/README.md").find(tested.substr(begin)), std::string::npos);
}

TEST(Lessons, ContinuousIntegrationRunsTheTestCommandOfTheReadme) {
  int commands = 0;
  for (const std::string& line : lines(read(source / "README.md")))
    commands += line.starts_with("common/install_packages ") && line.ends_with("--preset tests");
  EXPECT_EQ(commands, 1);
  EXPECT_NE(read(source / ".ci/run").find("eval \"$command\""), std::string::npos);
}

}  // namespace lesson_test
