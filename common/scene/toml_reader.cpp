#include "scene/toml_reader.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "text/bad_input.h"
#include "text/text.h"
#include "text/text_file.h"

namespace {

// So products of several numbers of a scene stay far from the end of double, 1e308.
constexpr double largest_number = 1e30;

bool is_in(double value, Range range) {
  return std::abs(value) <= largest_number &&
         (value == 0 || range != Range::positive || value >= 1 / largest_number) &&
         (range != Range::positive || value > 0) && (range != Range::not_negative || value >= 0);
}

std::string words(Range range) {
  if (range == Range::positive) return " from 1e-30 to 1e30";
  return range == Range::not_negative ? " from 0 to 1e30" : " from -1e30 to 1e30";
}

bool read_number(const toml::node& node, Range range, double& number) {
  if (!node.is_number()) return false;
  number = *node.value<double>();
  return is_in(number, range);
}

bool read_whole(const toml::node& node, int most, int& number) {
  if (!node.is_integer()) return false;
  const int64_t value = *node.value<int64_t>();
  number = int(value);
  return value >= 1 && value <= most;
}

// Reads `count` elements with read_one; false where the node is no such list.
template <class Number, class Read>
bool read_list(const toml::node& node, int count, Number* numbers, const Read& read_one) {
  const toml::array* list = node.as_array();
  if (!list || int(list->size()) != count) return false;
  for (int i = 0; i < count; ++i)
    if (!read_one((*list)[i], numbers[i])) return false;
  return true;
}

// The value as the file has it; a long one only from its beginning.
std::string shown(const toml::node& node) {
  const std::string all = one_line(as_toml(node));
  return all.size() <= 60 ? all : all.substr(0, 57) + "...";
}

std::string origin(const toml::node& value) {
  return is_given(value) ? " from the command line" : "";
}

std::string up_to(int most) {
  return "from 1 to " + std::to_string(most);
}

}  // namespace

std::string as_toml(const toml::node& node) {
  if (const auto number = node.value_exact<double>()) {
    const std::string digits = shortest(*number);
    return digits + (digits.find_first_not_of("-0123456789") == digits.npos ? ".0" : "");
  }
  std::vector<std::string> parts;
  if (const toml::array* list = node.as_array()) {
    for (const toml::node& entry : *list) parts.push_back(as_toml(entry));
    return "[" + joined(parts, ", ") + "]";
  }
  if (const toml::table* table = node.as_table()) {
    for (const auto& [key, value] : *table)
      parts.push_back(std::string(key.str()) + " = " + as_toml(value));
    return "{ " + joined(parts, ", ") + " }";
  }
  std::ostringstream out;
  node.visit([&](const auto& value) { out << value; });
  return out.str();
}

bool is_given(const toml::node& node) {
  return node.source().begin.line == 0;
}

toml::table read_toml(const std::filesystem::path& file) {
  const std::string text = read_text(file);
  try {
    return toml::parse(text, file.string());
  } catch (const toml::parse_error& error) {
    throw BadInput(file.string() + ":" + std::to_string(error.source().begin.line) + ": " +
                   one_line(std::string(error.description())));
  }
}

std::string location(const std::filesystem::path& file, const toml::node& node) {
  std::string at = file.string() + ":";
  const toml::source_index line = node.source().begin.line;
  if (line) at += std::to_string(line) + ":";
  return at + " ";
}

void TomlTable::allow_only(const Names& keys) const {
  for (const auto& [key, value] : table_)
    if (std::find(keys.begin(), keys.end(), key.str()) == keys.end())
      throw BadInput(location(file_, value) + title_ + " has no key " + std::string(key.str()) +
                     (is_given(value) ? ", which --set names" : "") + "; " +
                     valid_names(key.str(), keys));
}

const toml::node& TomlTable::need(std::string_view key, const std::string& what) const {
  if (const toml::node* node = table_.get(key)) return *node;
  refuse_table("needs " + std::string(key) + " = " + what);
}

void TomlTable::refuse(std::string_view key, const std::string& must) const {
  refuse(key, need(key, "a value"), must);
}

void TomlTable::refuse(std::string_view key, const toml::node& value,
                       const std::string& must) const {
  throw BadInput(location(file_, value) + title_ + " " + std::string(key) + " = " + shown(value) +
                 origin(value) + " is not valid: " + must);
}

void TomlTable::refuse_table(const std::string& must) const {
  throw BadInput(location(file_, table_) + title_ + " " + must);
}

double TomlTable::number(std::string_view key, Range range) const {
  const std::string what = "a number" + words(range);
  const toml::node& node = need(key, what);
  double number = 0;
  if (!read_number(node, range, number)) refuse(key, node, "it must be " + what);
  return number;
}

Vec2 TomlTable::two_numbers(std::string_view key, Range range) const {
  const std::string what = "two numbers" + words(range) + ", like [1.0, 1.0]";
  const toml::node& node = need(key, what);
  Vec2 v;
  if (!read_list(node, 2, v.data(), [&](auto& n, double& d) { return read_number(n, range, d); }))
    refuse(key, node, "it must be " + what);
  return v;
}

Vec3 TomlTable::three_numbers(std::string_view key, const std::string& what) const {
  const toml::node& node = need(key, what);
  Vec3 v;
  if (!read_list(node, 3, v.data(),
                 [](auto& n, double& d) { return read_number(n, Range::any, d); }))
    refuse(key, node, "it must be " + what);
  return v;
}

int TomlTable::whole_number(std::string_view key, int most) const {
  const std::string what = "a whole number " + up_to(most);
  const toml::node& node = need(key, what);
  int number = 0;
  if (!read_whole(node, most, number)) refuse(key, node, "it must be " + what);
  return number;
}

std::array<int, 2> TomlTable::two_whole_numbers(std::string_view key) const {
  constexpr int most = std::numeric_limits<int>::max();
  const std::string what = "two whole numbers " + up_to(most) + ", like [40, 40]";
  const toml::node& node = need(key, what);
  std::array<int, 2> numbers;
  if (!read_list(node, 2, numbers.data(), [](auto& n, int& i) { return read_whole(n, most, i); }))
    refuse(key, node, "it must be " + what);
  return numbers;
}

std::string TomlTable::one_of(std::string_view key, const Names& valid) const {
  const toml::node& node = need(key, "a name");
  const std::string name = node.value_or(std::string());
  if (std::find(valid.begin(), valid.end(), name) == valid.end())
    refuse(key, node, valid_names(name, valid));
  return name;
}

std::filesystem::path TomlTable::existing_file(std::string_view key) const {
  const toml::node& node = need(key, "the name of a file");
  if (!node.is_string()) refuse(key, node, "it must be the name of a file");
  const std::filesystem::path path = file_.parent_path() / *node.value<std::string>();
  if (const std::string reason = no_file(path); !reason.empty())
    refuse(key, node, path.string() + ": " + reason);
  return path;
}

const toml::array& TomlTable::list(std::string_view key, const std::string& of_what) const {
  const toml::node& node = need(key, of_what);
  if (!node.is_array()) refuse(key, node, "it must be " + of_what);
  return *node.as_array();
}

std::optional<std::string> TomlTable::text(std::string_view key) const {
  return need(key, "text").value<std::string>();
}
