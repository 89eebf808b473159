#include "support/program_runner.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fstream>
#include <iterator>
#include <sstream>

namespace {

using Clock = std::chrono::steady_clock;
constexpr double longest_run = 600;  // s, for a run under sanitizers on a busy machine

double seconds_until(Clock::time_point end) {
  return std::chrono::duration<double>(end - Clock::now()).count();
}

Clock::time_point in_seconds(double seconds) {
  return Clock::now() + std::chrono::milliseconds(long(1000 * seconds));
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, separator);) parts.push_back(part);
  return parts;
}

// In the child, between fork and exec.
[[noreturn]] void become(const std::vector<const char*>& words, const char* directory, int out,
                         int err, std::optional<long> largest_file) {
  dup2(open("/dev/null", O_RDONLY), STDIN_FILENO);
  dup2(out, STDOUT_FILENO);
  dup2(err, STDERR_FILENO);
  if (largest_file) {
    const rlimit limit = {rlim_t(*largest_file), rlim_t(*largest_file)};
    setrlimit(RLIMIT_FSIZE, &limit);
    std::signal(SIGXFSZ, SIG_IGN);  // so that writing fails with "File too large"
  }
  if (chdir(directory) == 0) execv(words[0], const_cast<char* const*>(words.data()));
  _exit(127);
}

}  // namespace

std::filesystem::path StepProgram::scene() const {
  return std::filesystem::path(SOURCE_DIRECTORY) / name / "scene.toml";
}

std::filesystem::path StepProgram::square() const {
  const std::filesystem::path other =
      std::filesystem::path(SOURCE_DIRECTORY) / "tests/steps/squares" / name / "scene.toml";
  return exists(other) ? other : scene();
}

std::vector<StepProgram> programs() {
  std::vector<StepProgram> list;
  for (const std::filesystem::path path : split(PROGRAMS, ':'))
    list.push_back({path.filename().string(), path});
  return list;
}

std::vector<StepProgram> explicit_programs() {
  std::vector<StepProgram> list = programs();
  std::erase_if(list, [](const StepProgram& program) { return !program.is_explicit(); });
  return list;
}

std::vector<StepProgram> iterative_programs() {
  std::vector<StepProgram> list = programs();
  std::erase_if(list, [](const StepProgram& program) { return !program.is_iterative(); });
  return list;
}

StepProgram program_called(const std::string& name) {
  for (const StepProgram& program : programs())
    if (program.name == name) return program;
  throw std::invalid_argument("tests/steps/CMakeLists.txt has no program " + name);
}

std::string name_of(const testing::TestParamInfo<StepProgram>& info) {
  return info.param.name;
}

Running::Running(const std::filesystem::path& program, const Arguments& arguments,
                 const std::filesystem::path& directory, std::optional<long> largest_file) {
  std::vector<const char*> words = {program.c_str()};
  for (const std::string& argument : arguments) words.push_back(argument.c_str());
  words.push_back(nullptr);

  int out_pipe[2], err_pipe[2];
  if (pipe2(out_pipe, O_CLOEXEC) != 0 || pipe2(err_pipe, O_CLOEXEC) != 0)
    throw std::runtime_error("no pipe");
  child = fork();
  if (child == 0) become(words, directory.c_str(), out_pipe[1], err_pipe[1], largest_file);
  close(out_pipe[1]);
  close(err_pipe[1]);
  out = out_pipe[0];
  err = err_pipe[0];
}

Running::~Running() {
  if (child > 0) {
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
  }
  for (const int end : {out, err})
    if (end >= 0) close(end);
}

bool Running::read_for(double seconds) {
  pollfd ends[] = {{out, POLLIN, 0}, {err, POLLIN, 0}};  // poll ignores a closed end, −1
  poll(ends, 2, int(1000 * seconds));
  for (const pollfd& end : ends) {
    if (end.revents == 0) continue;
    int& descriptor = end.fd == out ? out : err;
    char buffer[4096];
    const ssize_t size = read(descriptor, buffer, sizeof buffer);
    if (size > 0) {
      (end.fd == out ? outcome.out : outcome.err).append(buffer, size_t(size));
    } else {
      close(descriptor);
      descriptor = -1;
    }
  }
  return out >= 0 || err >= 0;
}

bool Running::wait_for_output(const std::string& text, double seconds) {
  const Clock::time_point end = in_seconds(seconds);
  while (outcome.out.find(text) == std::string::npos)
    if (seconds_until(end) <= 0 || !read_for(0.05)) return false;
  return true;
}

void Running::send(int signal) const {
  kill(child, signal);
}

Outcome Running::wait(double seconds) {
  const Clock::time_point end = in_seconds(seconds);
  for (int status = 0; seconds_until(end) > 0; read_for(0.02)) {
    if (waitpid(child, &status, WNOHANG) != child) continue;
    child = 0;
    while ((out >= 0 || err >= 0) && read_for(1)) {
    }
    outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return outcome;
  }
  ADD_FAILURE() << "still running after " << seconds << " s";
  return outcome;
}

ProgramDirectory::ProgramDirectory()
    : directory([] {
        std::string name = (std::filesystem::path(testing::TempDir()) / "programXXXXXX").string();
        if (!mkdtemp(name.data())) throw std::runtime_error("no temporary directory");
        return name;
      }()) {}

ProgramDirectory::~ProgramDirectory() {
  std::filesystem::remove_all(directory);
}

Outcome ProgramDirectory::run(const StepProgram& program, const Arguments& arguments,
                              std::optional<long> largest_file) const {
  return Running(program.path, arguments, directory, largest_file).wait(longest_run);
}

std::filesystem::path ProgramDirectory::write(const std::string& name,
                                              const std::string& text) const {
  std::ofstream(directory / name, std::ios::binary) << text;
  return directory / name;
}

void ProgramTest::expect_done(const Arguments& arguments) const {
  const Outcome outcome = run(arguments);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
}

Arguments ProgramTest::small_square(int cells, const Arguments& more) const {
  Arguments arguments = {GetParam().square(), "--cells", std::to_string(cells)};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

std::string read_all(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  EXPECT_TRUE(file.is_open()) << path << " cannot be read";
  return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<std::string> lines_of(const std::string& text) {
  return split(text, '\n');
}

std::vector<std::string> columns_of(const std::string& csv) {
  return split(csv.substr(0, csv.find('\n')), ',');
}

Table read_table(const std::filesystem::path& csv) {
  const std::string text = read_all(csv);
  EXPECT_TRUE(text.ends_with('\n')) << csv << " ends within a row";
  const std::vector<std::string> columns = columns_of(text), lines = lines_of(text);
  Table table;
  for (size_t row = 1; row < lines.size(); ++row) {
    const std::vector<std::string> cells = split(lines[row], ',');
    EXPECT_EQ(cells.size(), columns.size()) << csv << ", row " << row << ": " << lines[row];
    for (size_t c = 0; c < std::min(cells.size(), columns.size()); ++c)
      table[columns[c]].push_back(std::stod(cells[c]));
  }
  return table;
}

std::vector<std::string> files_in(const std::filesystem::path& directory) {
  std::vector<std::string> names;
  std::error_code absent;
  for (const auto& entry : std::filesystem::directory_iterator(directory, absent))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

int count_starting(const std::vector<std::string>& names, const std::string& start,
                   const std::string& end) {
  return int(std::count_if(names.begin(), names.end(), [&](const std::string& name) {
    return name.starts_with(start) && name.ends_with(end);
  }));
}
