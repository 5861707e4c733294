// The bytes of a file, mapped where that is possible (a regular file), read where it is not (a pipe).
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace scenelore::perception {

/// A file under reading: its bytes, and the name by which errors call it. Views stay valid as long as the object lives.
class MappedFile {
 public:
  /// Throws Error when the file cannot be opened or read.
  explicit MappedFile(const std::filesystem::path& path);
  ~MappedFile();
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;

  [[nodiscard]] std::span<const std::byte> bytes() const { return bytes_; }
  [[nodiscard]] std::string_view text() const { return {reinterpret_cast<const char*>(bytes_.data()), bytes_.size()}; }

  /// Appends the bytes [first, last) to `out` and lets go of their pages on the way, so that a file of a gigabyte does
  /// not stand in memory twice. Requires: out has the capacity.
  void move_to(std::size_t first, std::size_t last, std::vector<std::byte>& out) const;

  /// A hint that these bytes will not be needed again soon: whole pages among them are let go. They stay readable.
  void let_go(const std::byte* first, const std::byte* last) const;

 private:
  std::span<const std::byte> bytes_;
  std::vector<std::byte> copy_;  ///< of what cannot be mapped
  void* mapping_ = nullptr;
};

}  // namespace scenelore::perception
