// Pages of HTML, each one file that needs no network and no other file but its pictures.
#pragma once
#include <filesystem>
#include <string>

// The page of the template page/NAME.html, with the style sheets and scripts that it names inside,
// and with the data, a text in JSON, in its element "data".
std::string page(const std::string& name, const std::string& json);

// The address of a file relative to the page: all bytes but letters, digits and - . _ ~ / as %20.
std::string address_of(const std::filesystem::path& relative);
