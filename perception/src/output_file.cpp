#include "scenelore/perception/output_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "scenelore/perception/error.hpp"

namespace scenelore::perception {
namespace {

constexpr std::size_t kBuffer = std::size_t{1} << 20;

/// The file behind a link, so that the link survives the rename.
std::filesystem::path followed(const std::filesystem::path& path) {
  std::error_code ignored;
  const auto real = std::filesystem::canonical(path, ignored);
  return ignored ? path : real;
}

}  // namespace

OutputFile::OutputFile(const std::filesystem::path& target) : name_(target.string()), target_(followed(target)) {
  struct stat status {};
  const bool exists = ::stat(target_.c_str(), &status) == 0;
  if (exists && S_ISDIR(status.st_mode)) throw Error(name_ + " is a folder, not a file to write to");
  if (exists && !S_ISREG(status.st_mode)) {
    fd_ = ::open(target_.c_str(), O_WRONLY | O_CLOEXEC);
    if (fd_ < 0) fail("cannot be written");
  } else {
    if (exists && ::access(target_.c_str(), W_OK) != 0) fail("cannot be replaced");
    for (int attempt = 0; fd_ < 0; ++attempt) {
      temporary_ = target_;
      temporary_ += ".part-" + std::to_string(::getpid()) + "-" + std::to_string(attempt);
      fd_ =
          ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, exists ? status.st_mode & 0777U : 0666U);
      if (fd_ < 0 && errno != EEXIST) fail("cannot be written");
    }
  }
  buffer_.reserve(kBuffer);
}

OutputFile::~OutputFile() {
  if (fd_ < 0) return;
  ::close(fd_);
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void OutputFile::write(std::span<const std::byte> bytes) {
  if (buffer_.size() + bytes.size() > kBuffer) flush();
  if (bytes.size() >= kBuffer) return write_through(bytes);
  buffer_.insert(buffer_.end(), bytes.begin(), bytes.end());
}

void OutputFile::commit() {
  flush();
  // A pipe or a device cannot be synchronised and says so; for a regular file it is here that a full disk shows at the
  // latest.
  if (::fsync(fd_) != 0 && !temporary_.empty()) fail("cannot be written");
  const int closed = ::close(fd_);
  fd_ = -1;
  if (!temporary_.empty()) {
    if (closed != 0 || ::rename(temporary_.c_str(), target_.c_str()) != 0) {
      const int error = errno;
      ::unlink(temporary_.c_str());
      errno = error;
      fail("cannot be written");
    }
  } else if (closed != 0) {
    fail("cannot be written");
  }
}

void OutputFile::flush() {
  write_through(buffer_);
  buffer_.clear();
}

void OutputFile::write_through(std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(fd_, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail("cannot be written");
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
}

void OutputFile::fail(const char* what) const { throw Error(name_ + " " + what + ": " + std::strerror(errno)); }

}  // namespace scenelore::perception
