// Making, opening and closing the file; what it knows.
#include "scenelore/kb/knowledge_base.hpp"

#include <unistd.h>

#include <fstream>
#include <iterator>

#include "guard.hpp"
#include "implementation.hpp"
#include "knowledge_rows.hpp"
#include "schema.hpp"
#include "snapshot.hpp"

namespace scenelore::kb {

namespace fs = std::filesystem;

namespace {

// Deletes a file that was not finished.
class TemporaryFile {
 public:
  explicit TemporaryFile(fs::path path) : path_(std::move(path)) { remove(); }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() { remove(); }
  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  void remove() const {
    std::error_code ignored;
    fs::remove(path_, ignored);
  }
  fs::path path_;
};

[[noreturn]] void refuse_existing(const fs::path& path) {
  throw Error(path.string() + ": exists already and is never overwritten; choose another name or delete it first");
}

// Gives a finished file its name. A hard link fails where the name is taken, in one step; some file systems have none.
void publish(const fs::path& from, const fs::path& to) {
  std::error_code error;
  fs::create_hard_link(from, to, error);
  if (!error) return;
  if (fs::exists(to)) refuse_existing(to);
  fs::rename(from, to, error);
  if (error) throw Error(to.string() + ": cannot be written: " + error.message());
}

void check_exists(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) {
    throw Error(path.string() + ": there is no such file; make one with: scenelore kb init " + path.string());
  }
  if (fs::is_directory(status)) throw Error(path.string() + ": is a folder, not a knowledge base file");
  const auto size = fs::file_size(path, error);
  if (!error && size == 0) throw Error(path.string() + ": is empty, so no knowledge base");
}

// At rest the file has one part. GIS programs leave it in WAL mode, which this undoes; a writer that was killed before it
// changed anything leaves a journal without content, which the next change removes. Both fail, and do not matter, while
// another program has the file open.
void tidy(Database& database) {
  try {
    database.execute("PRAGMA journal_mode = DELETE");
    if (std::filesystem::exists(database.name() + "-journal")) database.execute("UPDATE scenelore_meta SET id = id");
  } catch (const Error&) {
  }
}

// A writer that was killed leaves its journal, which only a connection that may write can roll back. False where none may.
bool roll_back(const fs::path& path) {
  try {
    Database database(path, OpenMode::read_write);
    (void)check_schema(database);  // the first look at the file does it
    return !database.read_only();
  } catch (const Error&) {
    return false;
  }
}

// A file in WAL mode in a folder where nothing may be written can be read only as if it never changed; that is safe
// when no journal lies beside it.
bool has_no_journal(const fs::path& path) {
  for (const char* const suffix : {"-wal", "-journal"}) {
    std::error_code error;
    const auto size = fs::file_size(path.string() + suffix, error);
    if (!error && size > 0) return false;
  }
  return true;
}

}  // namespace

KnowledgeBase::KnowledgeBase(std::unique_ptr<Implementation> implementation) : implementation_(std::move(implementation)) {}
KnowledgeBase::KnowledgeBase(KnowledgeBase&&) noexcept = default;
KnowledgeBase& KnowledgeBase::operator=(KnowledgeBase&&) noexcept = default;
KnowledgeBase::~KnowledgeBase() = default;

KnowledgeBase KnowledgeBase::create(const fs::path& path, const std::string& knowledge) {
  if (fs::exists(path)) refuse_existing(path);
  const TemporaryFile temporary(path.string() + "." + std::to_string(getpid()) + ".tmp");
  {
    Database database(temporary.path(), OpenMode::create);
    database.execute("PRAGMA journal_mode = MEMORY");  // nothing to save from a crash yet
    create_schema(database, knowledge);
    validate(read_knowledge(database), "knowledge pack " + knowledge);
  }
  publish(temporary.path(), path);
  return open(path);
}

KnowledgeBase KnowledgeBase::open(const fs::path& path, Access access) {
  check_exists(path);
  const OpenMode mode = access == Access::read_only ? OpenMode::read_only : OpenMode::read_write;
  auto implementation = std::make_unique<Implementation>(path, mode);
  int version = 0;
  try {
    version = check_schema(implementation->database);
  } catch (const Error&) {
    if (access == Access::read_write && !implementation->database.read_only()) {
      if (::access(path.parent_path().empty() ? "." : path.parent_path().c_str(), W_OK) == 0) throw;
    }
    const bool at_rest = has_no_journal(path);
    if (!at_rest && !(access == Access::read_only && roll_back(path))) throw;
    implementation = std::make_unique<Implementation>(path, at_rest ? OpenMode::immutable : mode);
    version = check_schema(implementation->database);
  }
  Database& database = implementation->database;
  if (version < kSchemaVersion) {
    if (access == Access::read_only || database.read_only()) {
      throw Error(database.name() + ": has the older schema version " + std::to_string(version) +
                  " and must be brought up to version " + std::to_string(kSchemaVersion) +
                  ": open it once for writing, where you may write");
    }
    migrate_schema(database, version);
  }
  if (version > kSchemaVersion && access == Access::read_write) {
    throw Error(database.name() + ": was written by a newer Scenelore (schema version " + std::to_string(version) +
                "); this program can read it, but must not write it: update Scenelore");
  }
  if (access == Access::read_write && !database.read_only()) tidy(database);
  return KnowledgeBase(std::move(implementation));
}

const Knowledge& KnowledgeBase::Implementation::knowledge() {
  Statement pragma = database.prepare("PRAGMA data_version");
  auto row = pragma.use();
  const std::int64_t version = row.next() ? row.integer(0) : 0;
  if (!read || read->version != version) {
    read.reset();
    Knowledge fresh = read_knowledge(database);
    validate(fresh, database.name());
    read = {version, std::move(fresh)};
  }
  return read->knowledge;
}

Knowledge KnowledgeBase::knowledge() const { return implementation_->knowledge(); }

// Within the caller's transaction.
void KnowledgeBase::apply_within(const std::string& sql, const std::string& source) {
  Database& database = implementation_->database;
  implementation_->read.reset();
  try {
    const Guard guard(database, Permission::knowledge);
    try {
      database.execute(sql);
    } catch (const Error& error) {
      guard.explain(error);
    }
  } catch (const Error& error) {
    throw Error(source + ": " + error.what());
  }
  validate(read_knowledge(database), source + ": " + database.name());
}

void KnowledgeBase::apply_knowledge(const std::string& sql, const std::string& source) {
  Transaction transaction(implementation_->database);
  apply_within(sql, source);
  transaction.commit();
}

void KnowledgeBase::add_knowledge(const std::string& pack) {
  std::string sql;
  if (fs::is_regular_file(pack)) {
    std::ifstream stream(pack);
    sql.assign(std::istreambuf_iterator<char>(stream), {});
  } else {
    sql = added_pack(pack);
  }
  try {
    apply_knowledge(sql, "knowledge pack " + pack);
  } catch (const Error& error) {
    const std::string text = error.what();
    if (text.find("UNIQUE constraint failed") == std::string::npos) throw;
    throw Error(text + ": the pack is there already, or one of its names or ids is taken");
  }
}

void KnowledgeBase::learn_knowledge(const std::string& sql, const std::string& what) {
  Database& database = implementation_->database;
  Transaction transaction(database);
  const std::string before = snapshot_sql(read_knowledge(database));
  apply_within(sql, what);
  database.prepare("INSERT INTO knowledge_undo (made_at, what, sql) VALUES (strftime('%Y-%m-%dT%H:%M:%SZ', 'now'), ?, ?)").use()(what)(before).run();
  transaction.commit();
}

std::optional<std::string> KnowledgeBase::undo_knowledge() {
  Database& database = implementation_->database;
  Transaction transaction(database);
  std::string what, sql;
  std::int64_t id = 0;
  {
    Statement select = database.prepare("SELECT id, what, sql FROM knowledge_undo ORDER BY id DESC LIMIT 1");
    auto row = select.use();
    if (!row.next()) return std::nullopt;
    id = row.integer(0), what = row.text(1), sql = row.text(2);
  }
  apply_within(sql, "undoing '" + what + "'");
  database.prepare("DELETE FROM knowledge_undo WHERE id = ?").use()(id).run();
  transaction.commit();
  return what;
}

const KnowledgeHashes& KnowledgeBase::Implementation::hashes() {
  const Knowledge& now = knowledge();
  if (!read->hashes) read->hashes = hash_knowledge(now);
  return *read->hashes;
}

std::string KnowledgeBase::knowledge_hash() const { return implementation_->hashes().all; }

}  // namespace scenelore::kb
