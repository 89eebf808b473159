#include "program/options.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <CLI/CLI.hpp>
#include <cmath>
#include <csignal>
#include <iostream>
#include <map>

#include "picture/renderer.h"
#include "program/option_checks.h"
#include "scene/scene.h"
#include "text/bad_input.h"

namespace {

std::string below_one(const std::string& text) {
  double number = 0;
  if (CLI::detail::lexical_cast(text, number) && number > 0 && number < 1) return {};
  return "wants a number above 0 and below 1, not \"" + text + "\"";
}

std::array<int, 2> parse_size(const std::string& text) {
  std::array<int, 2> size{};
  const char* const end = text.data() + text.size();
  const auto width = std::from_chars(text.data(), end, size[0]);
  const bool has_x = width.ec == std::errc() && width.ptr != end && *width.ptr == 'x';
  const auto height = std::from_chars(width.ptr + has_x, end, size[1]);
  if (!has_x || height.ec != std::errc() || height.ptr != end)
    throw BadInput("--size: wants WIDTHxHEIGHT, such as 1280x720, not \"" + text + "\"");
  try {
    check_size(size[0], size[1]);
  } catch (const std::invalid_argument& error) {
    throw BadInput(std::string("--size: ") + error.what());
  }
  return size;
}

// One of the names stands for its value. Unlike CLI::CheckedTransformer it takes no value for a name.
template <class Value>
CLI::Validator NamedValues(const std::map<std::string, Value>& values) {
  const auto translate = [values](std::string& name) -> std::string {
    const auto found = values.find(name);
    if (found == values.end()) {
      std::vector<std::string> names;
      for (const auto& [valid, value] : values) names.push_back(valid);
      return "wants " + joined(names, " or ") + ", not \"" + name + "\"";
    }
    name = std::to_string(int(found->second));
    return {};
  };
  return CLI::Validator(translate, "");
}

std::string not_empty(const std::string& text) {
  return text.empty() ? "wants a value, not an empty text" : "";
}

// A file must not get a descriptor of the standard streams: it would then receive what the program says.
void open_missing_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(stream, F_GETFD) == -1 && open("/dev/null", O_RDONLY) != stream) std::abort();
}

// A large cloth takes minutes until the first line of its run: after a second a line says so.
void announce_long_set_up() {
  std::signal(SIGALRM, [](int) {
    constexpr std::string_view words = "reading the scene and setting up the run ...\n";
    (void)!write(STDOUT_FILENO, words.data(), words.size());
  });
  alarm(1);
}

// The pages of --help, --version and --explain are the whole result of their runs.
int end_of_page(const std::string& program, int code) {
  std::cout.flush();
  if (std::fflush(stdout) == 0 && !std::ferror(stdout) && std::cout) return code;
  std::cerr << program << ": the page could not be written to the standard output\n";
  return 1;
}

void declare_pages(CLI::App& app, const Program& program) {
  // No -h: CLI11 2.4 refuses --h beside it.
  app.set_help_flag("--help", "list the options");
  app.set_version_flag("--version", program.name + " (Large Steps " LARGE_STEPS_VERSION ")");
  app.footer("Example: " + program.name + " --set stretch.k=500 --out out/soft");
}

// "; 0.01 in the step's own scene": what runs where an option of the scene is absent.
std::string own_value(const Program& program, const char* table, const char* key) {
  const std::string value = value_in_scene(program.directory / "scene.toml", table, key);
  return value.empty() ? "" : "; " + value + " in the step's own scene";
}

void declare_scene(CLI::App& app, const Program& program, Options& options) {
  app.option_defaults()->group("Scene");
  app.add_option("scene", options.scene,
                 "the scene to simulate; the step's own scene.toml if absent")
      ->option_text("[scene.toml]");
  app.add_option("--h", options.overrides.h, "time step, s" + own_value(program, "time", "h"))
      ->check(positive_number)
      ->option_text("S");
  app.add_option("--end", options.overrides.end,
                 "simulated time, s" + own_value(program, "time", "end"))
      ->check(positive_number)
      ->option_text("S");
  app.add_option("--frames", options.overrides.frames,
                 "number of frames after the start" + own_value(program, "time", "frames"))
      ->check(positive_integer)
      ->option_text("N");
  app.add_option("--cells", options.overrides.cells,
                 "cells of the grid along u, and along v in proportion" +
                     own_value(program, "cloth", "cells"))
      ->check(positive_integer)
      ->option_text("N");
  app.add_option("--set", options.overrides.set,
                 "set a value of the scene, such as stretch.k=1e4; can be repeated")
      ->allow_extra_args(false)
      ->option_text("TABLE.KEY=VALUE");
  app.add_option("--without", options.overrides.without,
                 "leave out a table of the scene; can be repeated")
      ->allow_extra_args(false)
      ->option_text("TABLE");
}

void declare_method(CLI::App& app, const Program& program, Method& method) {
  app.option_defaults()->group("Method");
  if (program.concepts.implicit) {
    app.add_option("--jacobian", method.jacobian,
                   "the matrix: definite, or bw98 as Baraff & Witkin print it; definite if absent")
        ->transform(NamedValues(std::map<std::string, Jacobian>{{"definite", Jacobian::definite},
                                                                {"bw98", Jacobian::bw98}}))
        ->option_text("definite|bw98");
    app.add_option("--newton", method.newton,
                   "largest number of Newton iterations per step; 1 if absent")
        ->check(positive_integer)
        ->option_text("N");
    app.add_option("--guard", method.guard,
                   "repeat a step that gains energy, by Newton's method; on if absent")
        ->transform(NamedValues(std::map<std::string, bool>{{"on", true}, {"off", false}}))
        ->option_text("on|off");
  }
  if (program.concepts.direct)
    app.add_option("--solver", method.solver,
                   "solver of the linear system; " + method.solver + " if absent")
        ->check(CLI::IsMember(solver_names))
        ->option_text(joined(solver_names, "|"));
  if (program.concepts.iterative) {
    app.add_option("--preconditioner", method.preconditioner,
                   "preconditioner of conjugate gradients; " + method.preconditioner + " if absent")
        ->check(CLI::IsMember(preconditioner_names))
        ->option_text(joined(preconditioner_names, "|"));
    app.add_option("--tolerance", method.tolerance,
                   "largest error of conjugate gradients, relative to the solution; " +
                       text("%g", method.tolerance) + " if absent")
        ->check(below_one)
        ->option_text("E");
    app.add_option("--max-iterations", method.max_iterations,
                   "largest number of iterations of conjugate gradients per system; " +
                       std::to_string(method.max_iterations) + " if absent")
        ->check(positive_integer)
        ->option_text("N");
  }
}

void declare_results(CLI::App& app, const Program& program, Options& options, std::string& size) {
  app.option_defaults()->group("Results");
  app.add_option("--out", options.out,
                 "directory of the results; out/" + program.name + " if absent")
      ->check(not_empty)
      ->option_text("DIR");
  app.add_flag(
      "--explain", options.explain,
      "print what the scene contains, what a step costs, what sets h and what could be left "
      "out; write no file");
  CLI::Option* const no_pictures = app.add_flag_callback(
      "--no-pictures", [&] { options.pictures = false; }, "write no pictures");
  app.add_flag("--motion", options.motion,
               "also write motion.png, which plays in a browser, and with ffmpeg motion.mp4")
      ->excludes(no_pictures);
  app.add_option(
         "--size", size,
         "size of every picture; 1280x720 for the still and half of that for the frames if absent")
      ->check(not_empty)
      ->option_text("WxH");
  app.add_flag("--wireframe", options.wireframe, "draw the triangles");
  app.add_flag("--caption", options.caption, "write the scene and the time on every picture");
  app.add_option("--strain", options.strain_scale,
                 "colour by strain; SCALE is the end of the colour scale, 0.1 for 10 %")
      ->check(positive_number)
      ->option_text("SCALE");
  app.add_option("--export",
                 "also write the cloth of every frame: obj, a mesh per frame, or pc2, all of them "
                 "in points.pc2; can be repeated")
      ->check(CLI::IsMember({"obj", "pc2"}))
      ->option_text("obj|pc2")
      ->take_all()
      ->each([&](const std::string& format) {
        (format == "obj" ? options.export_obj : options.export_pc2) = true;
      });
}

void declare(CLI::App& app, const Program& program, Options& options, std::string& size) {
  options.program = program.name;
  options.concepts = program.concepts;
  options.scene = program.directory / "scene.toml";
  options.out = std::filesystem::path("out") / program.name;

  declare_pages(app, program);
  declare_scene(app, program, options);
  declare_method(app, program, options.method);
  declare_results(app, program, options, size);
}

// --help or --version is printed, and nothing is left to do.
struct PageIsPrinted {
  int code;
};

struct CommandLine {
  CommandLine(const Program& program, const std::string& command, std::vector<std::string> words)
      : app(program.name + ": " + program.idea, command) {
    declare(app, program, options, size);
    std::reverse(words.begin(), words.end());  // as CLI11 wants them
    try {
      app.parse(std::move(words));
    } catch (const CLI::Success& page) {
      throw PageIsPrinted{app.exit(page)};
    }
    if (!size.empty()) options.size = parse_size(size);
  }
  // Does it give the option of this word, or one that excludes it?
  bool decides(const std::string& word) const {
    const auto given = [](const CLI::Option* option) { return option->count() > 0; };
    const CLI::Option* option = app.get_option_no_throw(word.substr(0, word.find('=')));
    return option && (given(option) || std::ranges::any_of(option->get_excludes(), given));
  }

  CLI::App app;
  Options options;
  std::string size;
};

// The options of the command line, and those of the scene's [run] that the command line does not give.
Options read_options(const Program& program, const std::string& command,
                     const std::vector<std::string>& words) {
  const CommandLine given(program, command, words);
  std::vector<std::string> all;
  for (const std::string& word : options_of_run(given.options.scene, program.name))
    if (!given.decides(word)) all.push_back(word);
  all.insert(all.end(), words.begin(), words.end());
  return all.size() == words.size() ? given.options : CommandLine(program, command, all).options;
}

}  // namespace

int run_program(int argc, char** argv, const Program& program,
                const std::function<int(const Options&)>& simulate) {
  open_missing_streams();
  try {
    const Options options = read_options(program, argv[0], {argv + 1, argv + argc});
    if (!options.explain) announce_long_set_up();
    const int code = simulate(options);
    return options.explain ? end_of_page(program.name, code) : code;
  } catch (const PageIsPrinted& page) {
    return end_of_page(program.name, page.code);
  } catch (const CLI::ParseError& error) {
    std::cerr << program.name << ": " << one_line(error.what()) << " (--help lists the options)\n";
    return 2;
  } catch (const BadInput& error) {
    std::cerr << one_line(error.what()) << "\n";
    return 2;
  } catch (const std::invalid_argument& error) {
    std::cerr << program.name << ": " << one_line(error.what()) << "\n";
    return 2;
  } catch (const std::bad_alloc&) {
    std::cerr << program.name << ": not enough memory for this cloth; take fewer cells\n";
    return 1;
  } catch (const std::exception& error) {
    std::cerr << program.name << ": " << one_line(error.what()) << "\n";
    return 1;
  }
}
