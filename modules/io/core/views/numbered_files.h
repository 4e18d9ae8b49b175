// Files of a folder by the number in their names.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace bole::io {

// The entries of a folder by name. Empty where it cannot be listed.
std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder);

bool has_image_ending(const std::filesystem::path& path);  // .png, .jpg, .jpeg or .pgm, in upper or lower case

struct NumberedFiles {
  std::map<std::uint32_t, std::filesystem::path> by_number;
  std::size_t others = 0;    // images whose name is no number
  std::size_t repeated = 0;  // images with the number of another one
  std::uint32_t step = 1;    // between numbers, where they follow regularly
  std::size_t missing = 0;   // numbers absent between the first and the last
  std::uint32_t first_missing = 0;
};

// Images whose name is `prefix`, a number and `suffix` ("frame-000012.color"), without the ending.
NumberedFiles numbered_images(const std::filesystem::path& folder, std::string_view prefix = {},
                              std::string_view suffix = {});

}  // namespace bole::io
