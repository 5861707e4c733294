#pragma once

#include <filesystem>
#include <string_view>

namespace scenelore::pipeline {

/// Writes beside the file and renames, so that the file is replaced whole or not at all.
/// Throws perception::Error when it cannot be written.
void write_text_file(const std::filesystem::path& path, std::string_view text);

}  // namespace scenelore::pipeline
