#include "result_table.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace scenelore::tools {

namespace {

bool numeric(kb::ValueType type) { return type == kb::ValueType::integer || type == kb::ValueType::real; }

/// Length in characters, not bytes, so that accents do not shift a column.
std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

std::string aligned(const std::string& text, std::size_t width, bool right, bool last) {
  const std::string padding(width - std::min(width, width_of(text)), ' ');
  if (right) return padding + text + (last ? "\n" : "  ");
  return last ? text + "\n" : text + padding + "  ";
}

/// One record by RFC 4180: fields with a comma, quote or line break are quoted.
std::string csv_record(const std::vector<std::string>& fields) {
  std::string line;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (i > 0) line += ',';
    if (fields[i].find_first_of(",\"\r\n") == std::string::npos) {
      line += fields[i];
      continue;
    }
    line += '"';
    for (const char c : fields[i]) line.append(c == '"' ? 2 : 1, c);
    line += '"';
  }
  return line + "\n";
}

nlohmann::ordered_json json_value(const std::optional<std::string>& text, kb::ValueType type) {
  if (!text) return nullptr;
  if (numeric(type)) {
    const auto number = nlohmann::ordered_json::parse(*text, nullptr, false);
    return number.is_discarded() ? nlohmann::ordered_json(nullptr) : number;  // JSON has no infinity
  }
  return *text;
}

}  // namespace

ResultTable run_query(const kb::KnowledgeBase& base, const std::string& sql) {
  ResultTable table;
  base.query(
      sql, [&](const std::vector<std::string>& header) { table.header = header; },
      [&](const kb::QueryRow& row) { table.rows.push_back(row); });
  return table;
}

std::string to_text(const ResultTable& table) {
  const std::size_t columns = table.header.size();
  std::vector<std::size_t> width(columns);
  std::vector<bool> right(columns, !table.rows.empty());
  for (std::size_t c = 0; c < columns; ++c) {
    width[c] = width_of(table.header[c]);
    for (const kb::QueryRow& row : table.rows) {
      width[c] = std::max(width[c], width_of(row.values[c].value_or("")));
      right[c] = right[c] && (!row.values[c] || numeric(row.types[c]));
    }
  }
  std::string out;
  for (std::size_t c = 0; c < columns; ++c) out += aligned(table.header[c], width[c], right[c], c + 1 == columns);
  for (const kb::QueryRow& row : table.rows) {
    for (std::size_t c = 0; c < columns; ++c) out += aligned(row.values[c].value_or(""), width[c], right[c], c + 1 == columns);
  }
  return out;
}

std::string to_csv(const ResultTable& table) {
  std::string out = csv_record(table.header);
  for (const kb::QueryRow& row : table.rows) {
    std::vector<std::string> fields;
    for (const auto& value : row.values) fields.push_back(value.value_or(""));
    out += csv_record(fields);
  }
  return out;
}

std::string to_json(const ResultTable& table) {
  nlohmann::ordered_json out = nlohmann::ordered_json::array();
  for (const kb::QueryRow& row : table.rows) {
    nlohmann::ordered_json object = nlohmann::ordered_json::object();
    for (std::size_t c = 0; c < table.header.size(); ++c) object[table.header[c]] = json_value(row.values[c], row.types[c]);
    out.push_back(std::move(object));
  }
  return out.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace scenelore::tools
