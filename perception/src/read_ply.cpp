#include <algorithm>
#include <cstring>

#include "bytes.hpp"
#include "formats.hpp"
#include "lines.hpp"
#include "numbers.hpp"
#include "ply_header.hpp"
#include "scenelore/perception/error.hpp"

namespace scenelore::perception {
namespace {

std::string quoted_names(const std::vector<PlyElement>& elements) {
  std::string names;
  for (const PlyElement& element : elements) names += (names.empty() ? "" : ", ") + printable(element.name);
  return names.empty() ? "none" : names;
}

constexpr std::string_view kCameraNames[] = {"view_px", "view_py", "view_pz"};

/// What both encodings share: the header's promises, and the table that takes the vertices.
class PlyReader {
 public:
  PlyReader(const MappedFile& file, const std::string& name, std::optional<std::size_t>* rows_at)
      : file_(file), name_(name), rows_at_(rows_at), header_(parse_ply_header(file.text(), name)) {
    table_.comments = header_.comments;
    table_.viewpoint = header_.viewpoint;
    const auto vertex = std::find_if(header_.elements.begin(), header_.elements.end(),
                                     [](const PlyElement& e) { return e.name == "vertex"; });
    if (vertex == header_.elements.end()) {
      throw Error(name_ + ": no element 'vertex', so no points (elements: " + quoted_names(header_.elements) + ")");
    }
    for (const PlyProperty& property : vertex->properties) {
      if (property.list_count) {
        throw Error(name_ + ": property '" + printable(property.name) +
                    "' of the points is a list; points with lists cannot be read, "
                    "write the file without this property");
      }
      add_column(table_, property.name, property.type);
    }
  }

  PointTable read() && {
    if (header_.format == PlyFormat::ascii)
      read_ascii();
    else
      read_binary();
    if (!table_.viewpoint && camera_.allFinite() && !camera_.isZero(0)) table_.viewpoint = camera_;
    return std::move(table_);
  }

 private:
  /// The Point Cloud Library's writer tells the sensor's position in an element 'camera'; 0 0 0 when it does not know
  /// it.
  void note_camera(const PlyProperty& property, double value) {
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      if (property.name == kCameraNames[axis]) camera_[axis] = value;
    }
  }

  // Binary ---------------------------------------------------------------------------------------------------------

  void read_binary() {
    at_ = header_.body;
    for (const PlyElement& element : header_.elements) {
      if (element.name == "vertex")
        take_vertices(element);
      else if (element.has_list())
        skip_lists(element);
      else
        skip_rows(element);
    }
    check_nothing_follows(file_.text().substr(at_), "byte " + std::to_string(at_));
  }

  /// The element's number of rows, after making sure that the file holds them all.
  std::size_t rows_in_file(const PlyElement& element) const {
    const std::size_t size = element.row_size(), left = file_.bytes().size() - at_;
    if (size > 0 && element.count > left / size) fail_truncated(element, left / size);
    return element.count;
  }

  void skip_rows(const PlyElement& element) {
    const std::size_t size = rows_in_file(element) * element.row_size();
    std::size_t at = at_;
    for (const PlyProperty& property : element.properties) {
      if (element.name != "camera" || element.count != 1) break;
      note_camera(property, number_at(property.type, at));
      at += size_of(property.type);
    }
    at_ += size;
  }

  /// The scalar at a byte of the file, which must hold it.
  [[nodiscard]] double number_at(ScalarType type, std::size_t at) const {
    std::byte raw[8];
    std::memcpy(raw, file_.bytes().data() + at, size_of(type));
    if (header_.format == PlyFormat::binary_big_endian) std::reverse(raw, raw + size_of(type));
    return with_type(type, [&](auto zero) { return static_cast<double>(load<decltype(zero)>(raw)); });
  }

  void take_vertices(const PlyElement& element) {
    table_.rows = rows_in_file(element);
    if (table_.stride == 0) return;
    const std::size_t end = at_ + table_.rows * table_.stride;
    if (rows_at_ != nullptr && header_.format == PlyFormat::binary_little_endian) {
      *rows_at_ = at_;
      at_ = end;
      return;
    }
    table_.bytes.reserve(end - at_);
    file_.move_to(at_, end, table_.bytes);
    if (header_.format == PlyFormat::binary_big_endian) swap_bytes();
    at_ = end;
  }

  void swap_bytes() {
    for (std::size_t row = 0; row < table_.rows; ++row) {
      std::byte* const start = table_.bytes.data() + row * table_.stride;
      for (const Column& column : table_.columns) {
        std::reverse(start + column.offset, start + column.offset + size_of(column.type));
      }
    }
  }

  void skip_lists(const PlyElement& element) {
    for (std::size_t row = 0; row < element.count; ++row) {
      for (const PlyProperty& property : element.properties) {
        std::size_t entries = 1;
        if (property.list_count) entries = list_length(element, property, row);
        const std::size_t left = file_.bytes().size() - at_;
        if (entries > left / size_of(property.type)) fail_truncated(element, row);
        at_ += entries * size_of(property.type);
      }
    }
  }

  std::size_t list_length(const PlyElement& element, const PlyProperty& property, std::size_t row) {
    const std::size_t size = size_of(*property.list_count);
    if (file_.bytes().size() - at_ < size) fail_truncated(element, row);
    const double length = number_at(*property.list_count, at_);
    if (length < 0) {
      throw Error(name_ + ", byte " + std::to_string(at_) + ": list '" + printable(property.name) + "' of element '" +
                  printable(element.name) + "' has a negative length");
    }
    at_ += size;
    return static_cast<std::size_t>(length);
  }

  [[noreturn]] void fail_truncated(const PlyElement& element, std::size_t present) const {
    throw Error(name_ + ": the file is cut off: element '" + printable(element.name) + "' has " +
                std::to_string(present) + " of the " + std::to_string(element.count) +
                " rows that the header promises; the file ends at byte " + std::to_string(file_.bytes().size()) +
                hint());
  }

  /// More data than promised means a wrong count or a wrong type in the header: whatever was read is not to be trusted.
  void check_nothing_follows(std::string_view rest, const std::string& where) const {
    if (rest.find_first_not_of(" \t\r\n") == std::string_view::npos) return;
    throw Error(name_ + ", " + where + ": the elements of the header end here, but " + std::to_string(rest.size()) +
                " bytes follow; the header does not describe this file" + hint());
  }

  [[nodiscard]] std::string hint() const {
    return header_.format == PlyFormat::ascii ? "" : text_hint(file_.text().substr(header_.body));
  }

  // Ascii ----------------------------------------------------------------------------------------------------------

  void read_ascii() {
    const std::string_view body = file_.text().substr(header_.body);
    Lines lines(body);
    for (const PlyElement& element : header_.elements) {
      if (element.properties.empty()) continue;
      const bool vertices = element.name == "vertex";
      if (vertices) reserve_ascii(element, body.size() - lines.position());
      for (std::size_t row = 0; row < element.count; ++row) {
        const std::string_view line = next_line(lines, element, row);
        if (vertices)
          take_ascii_row(element, line, header_.lines + lines.number());
        else
          check_ascii_row(element, line, header_.lines + lines.number());
      }
      if (vertices) table_.rows = element.count;
    }
    check_nothing_follows(body.substr(lines.position()), "line " + std::to_string(header_.lines + lines.number() + 1));
  }

  /// A value and its separator take two bytes at least; a count that the file cannot hold must not be allocated.
  void reserve_ascii(const PlyElement& element, std::size_t bytes_left) {
    const std::size_t most = bytes_left / (2 * element.properties.size()) + 1;
    if (element.count <= most) table_.bytes.reserve(element.count * table_.stride);
  }

  std::string_view next_line(Lines& lines, const PlyElement& element, std::size_t row) const {
    while (const auto line = lines.next()) {
      if (!trimmed(*line).empty()) return *line;
    }
    fail_truncated(element, row);
  }

  void take_ascii_row(const PlyElement& element, std::string_view line, std::size_t number) {
    const std::size_t start = table_.bytes.size();
    table_.bytes.resize(start + table_.stride);
    for (const Column& column : table_.columns) {
      const std::string_view word = take_word(line);
      if (word.empty())
        fail_at(number,
                "no value for property '" + printable(column.name) + "' of element '" + printable(element.name) + "'");
      if (!parse_scalar(word, column.type, table_.bytes.data() + start + column.offset)) {
        fail_at(number, "'" + printable(word) + "' is no " + std::string(*ply_type_name(column.type)) + ", property '" +
                            printable(column.name) + "' of element '" + printable(element.name) + "'");
      }
    }
    check_line_ends(element, line, number);
  }

  void check_ascii_row(const PlyElement& element, std::string_view line, std::size_t number) {
    for (const PlyProperty& property : element.properties) {
      std::size_t entries = 1;
      if (property.list_count) {
        const std::string_view word = take_word(line);
        const auto length = parse_count(word);
        if (!length)
          fail_at(number, "'" + printable(word) + "' is no length of list '" + printable(property.name) + "'");
        entries = *length;
      }
      std::byte value[8];
      for (std::size_t entry = 0; entry < entries; ++entry) {
        const std::string_view word = take_word(line);
        if (!parse_scalar(word, property.type, value)) {
          fail_at(number, "'" + printable(word) + "' is no value of property '" + printable(property.name) +
                              "' of element '" + printable(element.name) + "'");
        }
      }
      if (element.name == "camera" && !property.list_count) {
        note_camera(property, with_type(property.type,
                                        [&](auto zero) { return static_cast<double>(load<decltype(zero)>(value)); }));
      }
    }
    check_line_ends(element, line, number);
  }

  void check_line_ends(const PlyElement& element, std::string_view rest, std::size_t number) const {
    const std::string_view word = take_word(rest);
    if (!word.empty()) {
      fail_at(number, "'" + printable(word) + "' is one value too many: element '" + printable(element.name) +
                          "' has " + std::to_string(element.properties.size()) + " properties");
    }
  }

  [[noreturn]] void fail_at(std::size_t line, const std::string& what) const {
    throw Error(name_ + ", line " + std::to_string(line) + ": " + what);
  }

  const MappedFile& file_;
  const std::string& name_;
  std::optional<std::size_t>* rows_at_;
  PlyHeader header_;
  PointTable table_;
  Eigen::Vector3d camera_ = Eigen::Vector3d::Zero();
  std::size_t at_ = 0;  ///< next byte, in a binary file
};

}  // namespace

bool looks_like_ply(std::string_view text) {
  return text.starts_with("ply") && (text.size() == 3 || text[3] == '\n' || text[3] == '\r' || text[3] == ' ');
}

PointTable read_ply(const MappedFile& file, const std::string& file_name, std::optional<std::size_t>* rows_at) {
  return PlyReader(file, file_name, rows_at).read();
}

}  // namespace scenelore::perception
