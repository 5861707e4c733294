#include "schema.hpp"

#include <algorithm>
#include <scenelore/embedded_file.hpp>
#include <span>
#include <vector>

#include "plane_rows.hpp"

namespace scenelore::kb {

std::span<const scenelore::EmbeddedFile> schema_files();

namespace {

constexpr std::string_view kMigrations = "schemas/", kPacks = "schemas/knowledge/", kAdded = "schemas/knowledge/add/";

bool starts_with_number(std::string_view name, int version) {
  std::string digits = std::to_string(version);
  digits.insert(0, 4 - digits.size(), '0');
  return name.starts_with(std::string(kMigrations) + digits + "_");
}

std::string_view schema_step(int version) {
  for (const EmbeddedFile& file : schema_files()) {
    if (starts_with_number(file.name, version)) return file.text;
  }
  throw Error("schema version " + std::to_string(version) + " is missing from this program");
}

const EmbeddedFile* pack_file(const std::string& name) {
  for (const EmbeddedFile& file : schema_files()) {
    if (file.name == std::string(kPacks) + name + ".sql") return &file;
  }
  return nullptr;
}

// All the SQL first: what it needs from C++ then finds the newest tables.
void run_steps(Database& database, int from) {
  for (int version = from + 1; version <= kSchemaVersion; ++version) database.execute(schema_step(version));
  if (from < 2) store_missing_footprints(database);
}

std::int64_t integer_of(const Database& database, std::string_view sql) {
  Statement statement = database.prepare(sql);
  auto use = statement.use();
  return use.next() ? use.integer(0) : 0;
}

}  // namespace

void create_schema(Database& database, const std::string& pack) {
  static const std::vector<std::string> kKnown = {"office", "paper", "empty"};
  if (std::find(kKnown.begin(), kKnown.end(), pack) == kKnown.end()) {
    throw Error("there is no knowledge pack '" + pack + "'; known are office, paper and empty");
  }
  Transaction transaction(database);
  run_steps(database, 0);
  database.execute(pack_file("features")->text);
  database.execute(pack_file(pack)->text);
  if (const EmbeddedFile* learned = pack_file(pack + "_learned")) database.execute(learned->text);
  Statement note = database.prepare("UPDATE scenelore_meta SET knowledge_pack = ?");
  note.use()(pack).run();
  transaction.commit();
}

std::vector<std::string> added_packs() {
  std::vector<std::string> names;
  for (const EmbeddedFile& file : schema_files()) {
    const std::string_view name = file.name;
    if (name.starts_with(kAdded)) names.emplace_back(name.substr(kAdded.size(), name.size() - kAdded.size() - 4));
  }
  return names;
}

std::string_view added_pack(const std::string& name) {
  for (const EmbeddedFile& file : schema_files()) {
    if (file.name == std::string(kAdded) + name + ".sql") return file.text;
  }
  std::string known;
  for (const std::string& pack : added_packs()) known += (known.empty() ? "" : ", ") + pack;
  throw Error("there is no knowledge pack '" + name + "' to add: give a file of SQL, or one of: " + known);
}

int check_schema(const Database& database) {
  // The first read also finds a file that is no database, or that is cut short.
  if (integer_of(database, "SELECT count(*) FROM sqlite_master WHERE name = 'scenelore_meta'") == 0) {
    throw Error(database.name() +
                ": a database, but not a Scenelore knowledge base (it has no table scenelore_meta); "
                "make one with: scenelore kb init FILE.gpkg");
  }
  const auto version = integer_of(database, "SELECT schema_version FROM scenelore_meta");
  const auto oldest = integer_of(database, "SELECT oldest_reader FROM scenelore_meta");
  if (version < 1) throw Error(database.name() + ": scenelore_meta has no sensible schema_version");
  if (oldest > kSchemaVersion) {
    throw Error(database.name() + ": was written by a newer Scenelore (schema version " + std::to_string(version) +
                ", this program knows up to " + std::to_string(kSchemaVersion) + "): update Scenelore to open it");
  }
  return static_cast<int>(version);
}

void migrate_schema(Database& database, int from) {
  Transaction transaction(database);
  // Another process may have been faster.
  const auto now = static_cast<int>(integer_of(database, "SELECT schema_version FROM scenelore_meta"));
  run_steps(database, std::max(from, now));
  transaction.commit();
}

}  // namespace scenelore::kb
