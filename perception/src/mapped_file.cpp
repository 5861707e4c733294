#include "mapped_file.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "scenelore/perception/error.hpp"

namespace scenelore::perception {
namespace {

/// Closes on every way out.
struct Descriptor {
  int fd;
  explicit Descriptor(const char* path) : fd(::open(path, O_RDONLY | O_CLOEXEC)) {}
  ~Descriptor() {
    if (fd >= 0) ::close(fd);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
};

[[noreturn]] void fail(const std::string& name, const char* what) {
  throw Error(name + ": " + what + ": " + std::strerror(errno));
}

std::vector<std::byte> read_all(int fd, const std::string& name) {
  std::vector<std::byte> all;
  std::size_t used = 0;
  for (;;) {
    if (used == all.size()) all.resize(std::max<std::size_t>(1 << 16, 2 * all.size()));
    const ssize_t got = ::read(fd, all.data() + used, all.size() - used);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail(name, "cannot be read");
    if (got == 0) break;
    used += static_cast<std::size_t>(got);
  }
  all.resize(used);
  return all;
}

}  // namespace

MappedFile::MappedFile(const std::filesystem::path& path) {
  const std::string name = path.string();
  const Descriptor file(path.c_str());
  if (file.fd < 0) fail(name, "cannot be opened");
  struct stat status {};
  if (::fstat(file.fd, &status) != 0) fail(name, "cannot be read");
  if (S_ISDIR(status.st_mode)) throw Error(name + " is a folder, not a point file");
  if (S_ISREG(status.st_mode) && status.st_size > 0) {
    const auto size = static_cast<std::size_t>(status.st_size);
    void* const mapping = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file.fd, 0);
    if (mapping != MAP_FAILED) {
      ::madvise(mapping, size, MADV_SEQUENTIAL);
      mapping_ = mapping;
      bytes_ = {static_cast<const std::byte*>(mapping), size};
      return;
    }
  }
  copy_ = read_all(file.fd, name);
  bytes_ = copy_;
}

MappedFile::~MappedFile() {
  if (mapping_ != nullptr) ::munmap(mapping_, bytes_.size());
}

void MappedFile::let_go(const std::byte* first, const std::byte* last) const {
  if (mapping_ == nullptr) return;
  constexpr std::size_t kPage = 4096;
  const auto from = (static_cast<std::size_t>(first - bytes_.data()) + kPage - 1) / kPage * kPage;
  const auto to = static_cast<std::size_t>(last - bytes_.data()) / kPage * kPage;
  if (from < to) ::madvise(static_cast<std::byte*>(mapping_) + from, to - from, MADV_DONTNEED);
}

void MappedFile::move_to(std::size_t first, std::size_t last, std::vector<std::byte>& out) const {
  constexpr std::size_t kChunk = std::size_t{8} << 20;
  while (first < last) {
    const std::size_t end = std::min(last, (first / kChunk + 1) * kChunk);  // chunks begin on page boundaries
    out.insert(out.end(), bytes_.begin() + static_cast<std::ptrdiff_t>(first),
               bytes_.begin() + static_cast<std::ptrdiff_t>(end));
    if (mapping_ != nullptr) {
      const std::size_t page = first / kChunk * kChunk;
      ::madvise(static_cast<std::byte*>(mapping_) + page, end - page, MADV_DONTNEED);  // a hint: still readable
    }
    first = end;
  }
}

}  // namespace scenelore::perception
