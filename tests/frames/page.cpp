#include "page.h"

#include <cctype>
#include <functional>
#include <string_view>

#include "text/text.h"
#include "text/text_file.h"

namespace {

const std::filesystem::path page_directory = PAGE_DIRECTORY;

// Replaces every `begin NAME end` of the text by what `content` says of NAME.
std::string replaced(const std::string& text, const std::string& begin, const std::string& end,
                     const std::function<std::string(const std::string& name)>& content) {
  std::string result;
  size_t done = 0;
  for (size_t at; (at = text.find(begin, done)) != text.npos;) {
    const size_t name = at + begin.size(), name_end = text.find(end, name);
    result += text.substr(done, at - done) + content(text.substr(name, name_end - name));
    done = name_end + end.size();
  }
  return result + text.substr(done);
}

// In a string of JSON \u003c is a <. So no text in the data can end the element that holds it.
std::string without_markup(const std::string& json) {
  return replaced(json, "<", "", [](const std::string&) { return "\\u003c"; });
}

}  // namespace

std::string page(const std::string& name, const std::string& json) {
  const auto file_in = [](const std::string& element) {
    return [=](const std::string& file) {
      return "<" + element + ">\n" + read_text(page_directory / file) + "</" + element + ">";
    };
  };
  std::string html = read_text(page_directory / (name + ".html"));
  html = replaced(html, R"(<link rel="stylesheet" href=")", R"(">)", file_in("style"));
  html = replaced(html, R"(<script src=")", R"("></script>)", file_in("script"));
  const std::string data = R"(<script type="application/json" id="data">)";
  return replaced(html, data, "</script>", [&](const std::string&) {
    return data + "\n" + without_markup(json) + "</script>";
  });
}

std::string address_of(const std::filesystem::path& relative) {
  std::string address;
  for (const char c : relative.string())
    if (std::isalnum(static_cast<unsigned char>(c)) ||
        std::string_view("-._~/").find(c) != std::string_view::npos)
      address += c;
    else
      address += text("%%%02X", static_cast<unsigned char>(c));
  return address;
}
