#include <charconv>

#include "bytes.hpp"
#include "formats.hpp"

namespace scenelore::perception {

// A line of names and a line a point, nothing else: what every reader of such files takes. Each number is the shortest
// text that reads back as the same value of its type. Comments and viewpoint have no place in it.
void write_csv(OutputFile& out, const PointTable& table) {
  std::string line;
  for (const Column& column : table.columns) line += (line.empty() ? "" : ",") + column.name;
  out.write(line + "\n");
  char number[40];
  for (std::size_t row = 0; row < table.rows; ++row) {
    line.clear();
    for (const Column& column : table.columns) {
      if (!line.empty()) line += ',';
      const std::byte* const at = table.bytes.data() + row * table.stride + column.offset;
      line.append(number, with_type(column.type, [&](auto zero) {
                    return std::to_chars(number, number + sizeof number, load<decltype(zero)>(at)).ptr;
                  }));
    }
    line += '\n';
    out.write(line);
  }
}

}  // namespace scenelore::perception
