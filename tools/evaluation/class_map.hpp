// Which of our classes are right for a label of somebody else's data. One line a label:
//
//   desk  = table
//   chair = chair_seat chair_back      # both are right; the first is the class that counts the object
//   bin   = unknown                    # is none of our classes: any other label on it is wrong
//   other_object = -                   # not judged
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace scenelore::evaluation {

/// Label of the data → right classes; empty = not judged.
using ClassMap = std::map<std::string, std::vector<std::string>>;

/// Throws Error naming line and file for a malformed line, a label that comes twice, and (with "did you mean") for a class
/// that is not among `classes`.
[[nodiscard]] ClassMap parse_class_map(const std::string& text, const std::string& source, const std::vector<std::string>& classes);
/// `name` is a file, or one of the maps that come with the program ("indoor"). Throws Error.
[[nodiscard]] ClassMap read_class_map(const std::string& name, const std::vector<std::string>& classes);

/// Names of label ids from lines `id name`. Throws Error for a malformed line.
[[nodiscard]] std::map<int, std::string> read_label_names(const std::filesystem::path& file);
/// `labels.txt` beside the file or in a folder above it; empty path when there is none.
[[nodiscard]] std::filesystem::path find_label_names(const std::filesystem::path& file);

}  // namespace scenelore::evaluation
