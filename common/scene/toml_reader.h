// scene.toml, key by key. Every value is read with its type and range, and a value that does not
// fit is refused in one line: `scene.toml:12: [time] h = -1.0 is not valid: it must be …`. Only the
// files that read a scene include this.
#pragma once
#include <toml++/toml.h>
#include <filesystem>
#include <optional>
#include <string>

#include "math/types.h"
#include "text/names.h"

enum class Range { any, not_negative, positive };

// One table of the file; messages call it by its title, [cloth].
class TomlTable {
 public:
  TomlTable(const std::filesystem::path& file, const std::string& title, const toml::table& table)
      : file_(file), title_(title), table_(table) {}

  // A table within this one: [cloth] pin.
  TomlTable inner(const std::string& name, const toml::table& table) const {
    return {file_, title_ + " " + name, table};
  }

  bool has(std::string_view key) const { return table_.contains(key); }
  void allow_only(const Names& keys) const;

  // Each refuses a table without the key. A whole number will do for a number; nan and inf will
  // not.
  double number(std::string_view key, Range range) const;
  Vec2 two_numbers(std::string_view key, Range range) const;
  Vec3 three_numbers(std::string_view key,
                     const std::string& what = "three numbers, like [0.0, 1.0, 0.0]") const;
  int whole_number(std::string_view key, int most) const;  // from 1
  std::array<int, 2> two_whole_numbers(std::string_view key) const;
  std::string one_of(std::string_view key, const Names& valid) const;
  std::filesystem::path existing_file(std::string_view key) const;  // relative to the scene's
  const toml::array& list(std::string_view key, const std::string& of_what) const;
  const toml::node& need(std::string_view key, const std::string& what) const;  // of any type
  std::optional<std::string> text(std::string_view key) const;  // absent where the value is no text

  [[noreturn]] void refuse(std::string_view key, const std::string& must) const;
  [[noreturn]] void refuse(std::string_view key, const toml::node& value,
                           const std::string& must) const;
  [[noreturn]] void refuse_table(const std::string& must) const;

 private:
  const std::filesystem::path& file_;
  std::string title_;
  const toml::table& table_;
};

// A value in TOML: numbers as short as they can be, 2.0 with its point, lists and tables on one line.
std::string as_toml(const toml::node&);

// A value of the command line has no line in the file.
bool is_given(const toml::node&);

// The parsed file; refused where it is missing or no TOML.
toml::table read_toml(const std::filesystem::path& file);

// `scene.toml:12: ` for a node in line 12, `scene.toml: ` for a value of the command line.
std::string location(const std::filesystem::path& file, const toml::node& node);
