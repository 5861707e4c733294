#include <lzf.h>

#include "bytes.hpp"
#include "formats.hpp"
#include "lines.hpp"
#include "numbers.hpp"
#include "pcd_header.hpp"
#include "scenelore/perception/error.hpp"

namespace scenelore::perception {
namespace {

/// Columns of the fields that are kept: name, or name_0, name_1, … for a field of several values.
void add_columns(PointTable& table, const PcdField& field) {
  for (std::size_t i = 0; i < field.count; ++i) {
    add_column(table, field.count == 1 ? field.name : field.name + "_" + std::to_string(i), field.type);
  }
}

class PcdReader {
 public:
  PcdReader(const MappedFile& file, const std::string& name, std::optional<std::size_t>* rows_at)
      : file_(file), name_(name), rows_at_(rows_at), header_(parse_pcd_header(file.text(), name)) {
    table_.comments = header_.comments;
    table_.viewpoint = header_.viewpoint;
    for (const PcdField& field : header_.fields) {
      if (!field.padding()) add_columns(table_, field);
      stride_in_file_ += field.size();
    }
    if (stride_in_file_ == 0 || table_.stride == 0) throw Error(name_ + ": the points have no values");
  }

  PointTable read() && {
    if (header_.encoding == PcdEncoding::ascii)
      read_ascii();
    else if (header_.encoding == PcdEncoding::binary)
      read_binary();
    else
      read_compressed();
    table_.rows = header_.points;
    return std::move(table_);
  }

 private:
  // Binary ---------------------------------------------------------------------------------------------------------

  void read_binary() {
    const std::size_t left = file_.bytes().size() - header_.body;
    if (header_.points > left / stride_in_file_) {
      fail_truncated(left / stride_in_file_, text_hint(file_.text().substr(header_.body)));
    }
    const std::size_t end = header_.body + header_.points * stride_in_file_;
    if (stride_in_file_ == table_.stride && rows_at_ != nullptr) {
      *rows_at_ = header_.body;
    } else {
      table_.bytes.reserve(header_.points * table_.stride);
      if (stride_in_file_ == table_.stride)
        file_.move_to(header_.body, end, table_.bytes);
      else
        drop_padding();
    }
    check_nothing_follows(file_.text().substr(end), "byte " + std::to_string(end));
  }

  void drop_padding() {
    const std::byte* at = file_.bytes().data() + header_.body;
    for (std::size_t row = 0; row < header_.points; ++row) {
      for (const PcdField& field : header_.fields) {
        if (!field.padding()) table_.bytes.insert(table_.bytes.end(), at, at + field.size());
        at += field.size();
      }
    }
  }

  // Compressed: two lengths, then all values of the first field, all of the second, … compressed together ------------

  void read_compressed() {
    const auto body = file_.bytes().subspan(header_.body);
    if (body.size() < 8) fail_truncated(0, "");
    const std::size_t packed = load<std::uint32_t>(body.data()), unpacked = load<std::uint32_t>(body.data() + 4);
    if (packed > body.size() - 8) {
      throw Error(name_ + ": the file is cut off: " + std::to_string(body.size() - 8) + " of " +
                  std::to_string(packed) + " compressed bytes are there; the file ends at byte " +
                  std::to_string(file_.bytes().size()));
    }
    const bool with_padding = holds(unpacked, stride_in_file_);
    if (!with_padding && !holds(unpacked, table_.stride)) {
      throw Error(name_ + ", byte " + std::to_string(header_.body) + ": " + std::to_string(unpacked) +
                  " bytes are not the " + std::to_string(header_.points) + " points of " +
                  std::to_string(stride_in_file_) + " bytes that the header promises");
    }
    scatter(unpack(body.subspan(8, packed), unpacked), with_padding);
    check_nothing_follows(file_.text().substr(header_.body + 8 + packed),
                          "byte " + std::to_string(header_.body + 8 + packed));
  }

  [[nodiscard]] bool holds(std::size_t bytes, std::size_t stride) const {
    return bytes % stride == 0 && bytes / stride == header_.points;
  }

  [[nodiscard]] std::vector<std::byte> unpack(std::span<const std::byte> packed, std::size_t size) const {
    // LZF's longest copy is 264 bytes out of 3: what promises more than that lies, and is not allocated for.
    std::vector<std::byte> out;
    if (size > packed.size() * 100) fail_unpack();
    if (size == 0) return out;
    out.resize(size);
    if (lzf_decompress(packed.data(), static_cast<unsigned>(packed.size()), out.data(), static_cast<unsigned>(size)) !=
        size)
      fail_unpack();
    return out;
  }

  void scatter(const std::vector<std::byte>& by_field, bool with_padding) {
    table_.bytes.resize(header_.points * table_.stride);
    const std::byte* at = by_field.data();
    std::size_t offset = 0;
    for (const PcdField& field : header_.fields) {
      const std::size_t size = field.size();
      if (!field.padding()) {
        std::byte* to = table_.bytes.data() + offset;
        for (std::size_t row = 0; row < header_.points; ++row, to += table_.stride)
          std::memcpy(to, at + row * size, size);
        offset += size;
      }
      if (!field.padding() || with_padding) at += header_.points * size;
    }
  }

  // Ascii ----------------------------------------------------------------------------------------------------------

  void read_ascii() {
    const std::string_view body = file_.text().substr(header_.body);
    const std::size_t most = body.size() / (2 * table_.columns.size()) + 1;  // a value and its separator: two bytes
    if (header_.points <= most) table_.bytes.reserve(header_.points * table_.stride);
    Lines lines(body);
    std::size_t rows = 0;
    while (const auto line = lines.next()) {
      const std::string_view text = trimmed(*line);
      if (text.empty() || text.starts_with('#')) continue;
      if (rows++ == header_.points) {
        fail_at(header_.lines + lines.number(),
                "more lines than the " + std::to_string(header_.points) + " points of the header");
      }
      take_row(text, header_.lines + lines.number());
    }
    if (rows < header_.points) fail_truncated(rows, "");
  }

  void take_row(std::string_view line, std::size_t number) {
    std::size_t at = table_.bytes.size();
    table_.bytes.resize(at + table_.stride);
    for (const PcdField& field : header_.fields) {
      for (std::size_t i = 0; i < field.count; ++i) {
        const std::string_view word = take_word(line);
        if (word.empty()) fail_at(number, "no value for field '" + printable(field.name) + "'");
        if (field.padding()) continue;
        if (!parse_scalar(word, field.type, table_.bytes.data() + at)) {
          fail_at(number, "'" + printable(word) + "' is no value of field '" + printable(field.name) + "'");
        }
        at += size_of(field.type);
      }
    }
    const std::string_view word = take_word(line);
    if (!word.empty()) fail_at(number, "'" + printable(word) + "' is one value too many");
  }

  // Errors ---------------------------------------------------------------------------------------------------------

  /// Zeros may follow: some writers fill up the last page of memory.
  void check_nothing_follows(std::string_view rest, const std::string& where) const {
    if (rest.find_first_not_of(std::string_view(" \t\r\n\0", 5)) == std::string_view::npos) return;
    throw Error(name_ + ", " + where + ": the points of the header end here, but " + std::to_string(rest.size()) +
                " bytes follow; the header does not describe this file");
  }

  [[noreturn]] void fail_truncated(std::size_t present, const std::string& hint) const {
    throw Error(name_ + ": the file is cut off: " + std::to_string(present) + " of the " +
                std::to_string(header_.points) + " points that the header promises are there; the file ends at byte " +
                std::to_string(file_.bytes().size()) + hint);
  }
  [[noreturn]] void fail_unpack() const {
    throw Error(name_ + ", byte " + std::to_string(header_.body + 8) + ": the compressed points are damaged");
  }
  [[noreturn]] void fail_at(std::size_t line, const std::string& what) const {
    throw Error(name_ + ", line " + std::to_string(line) + ": " + what);
  }

  const MappedFile& file_;
  const std::string& name_;
  std::optional<std::size_t>* rows_at_;
  PcdHeader header_;
  PointTable table_;
  std::size_t stride_in_file_ = 0;  ///< bytes of a binary row, padding included
};

}  // namespace

bool looks_like_pcd(std::string_view text) { return text.starts_with("# .PCD") || text.starts_with("VERSION "); }

PointTable read_pcd(const MappedFile& file, const std::string& file_name, std::optional<std::size_t>* rows_at) {
  return PcdReader(file, file_name, rows_at).read();
}

}  // namespace scenelore::perception
