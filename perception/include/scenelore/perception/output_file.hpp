// A file that appears whole or not at all.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace scenelore::perception {

/// Writes beside the target under another name; commit() makes it durable and renames it. Without commit() the target
/// stays as it was. A target that is no regular file (a device, a pipe) is written directly. All functions throw Error.
class OutputFile {
 public:
  explicit OutputFile(const std::filesystem::path& target);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  void write(std::span<const std::byte> bytes);
  void write(std::string_view text) { write(std::as_bytes(std::span(text))); }
  void commit();

  [[nodiscard]] const std::string& name() const { return name_; }  ///< as the user gave it

 private:
  void flush();
  void write_through(std::span<const std::byte> bytes);
  [[noreturn]] void fail(const char* what) const;

  std::string name_;
  std::filesystem::path target_;     ///< links followed
  std::filesystem::path temporary_;  ///< empty when the target is written directly
  std::vector<std::byte> buffer_;
  int fd_ = -1;
};

}  // namespace scenelore::perception
