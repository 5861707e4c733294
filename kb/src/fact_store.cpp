// A relation is asked again only when something it depends on has changed; until then its rows are the answer.
#include "fact_store.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <span>
#include <string>

#include "implementation.hpp"
#include "no_triggers.hpp"

namespace scenelore::kb {

namespace {

using Facts = std::span<const RelationFact>;

constexpr double kNoLimit = std::numeric_limits<double>::infinity();

/// The column `facts` of relation_asked.
struct PackedFact {
  PlaneId a, b;
  double degree;
};
static_assert(sizeof(PackedFact) == 24);

std::vector<PackedFact> packed(Facts facts) {
  std::vector<PackedFact> out;
  out.reserve(facts.size());
  for (const RelationFact& fact : facts) out.push_back({fact.a, fact.b, fact.degree});
  return out;
}

std::vector<RelationFact> unpacked(const std::string& relation, std::span<const std::byte> bytes) {
  std::vector<RelationFact> out;
  out.reserve(bytes.size() / sizeof(PackedFact));
  for (; bytes.size() >= sizeof(PackedFact); bytes = bytes.subspan(sizeof(PackedFact))) {
    PackedFact fact{};
    std::memcpy(&fact, bytes.data(), sizeof fact);
    out.push_back({relation, fact.a, fact.b, fact.degree});
  }
  return out;
}

/// What is known of each relation of the scan that was asked; `stored` where nobody has changed its rows since.
std::map<std::string, RelationAsked> read_asked(const Database& database, ScanId scan) {
  Statement select = database.prepare(
      "SELECT relation, asked, held, within, within_plan, inputs_sha256, facts IS NOT NULL, features FROM relation_asked WHERE scan_id = ?");
  std::map<std::string, RelationAsked> out;
  auto row = select.use();
  for (row(scan); row.next();) {
    out[row.text(0)] = {row.integer(1), row.integer(2), row.optional_real(3).value_or(kNoLimit),
                        row.optional_real(4).value_or(kNoLimit), row.text(5), row.integer(6) != 0, row.text(7)};
  }
  return out;
}

struct StoredFact {
  std::int64_t id = 0;
  PlaneId a = 0, b = 0;
  double degree = 0;
};

/// The rows of one relation of a scan, by a and b. Rows that were written together have neighbouring ids: those are read one
/// after another instead of by the index.
class FactReader {
 public:
  explicit FactReader(const Database& database)
      : ends_(database.prepare("SELECT (SELECT min(id) FROM relation_fact WHERE scan_id = ?1 AND relation = ?2), "
                               "(SELECT max(id) FROM relation_fact WHERE scan_id = ?1 AND relation = ?2)")),
        together_(database.prepare("SELECT id, a, b, degree FROM relation_fact NOT INDEXED "
                                   "WHERE id BETWEEN ?3 AND ?4 AND scan_id = ?1 AND relation = ?2 ORDER BY id")),
        apart_(database.prepare("SELECT id, a, b, degree FROM relation_fact WHERE scan_id = ? AND relation = ? ORDER BY id")) {}

  std::vector<StoredFact> read(ScanId scan, const std::string& relation, std::int64_t expected) {
    std::int64_t first = 0, last = 0;
    {
      auto row = ends_.use();
      if (!row(scan)(relation).next() || row.is_null(0)) return {};
      first = row.integer(0), last = row.integer(1);
    }
    const bool together = last - first < 2 * expected;
    auto row = (together ? together_ : apart_).use();
    row(scan)(relation);
    if (together) row(first)(last);
    std::vector<StoredFact> out;
    out.reserve(static_cast<std::size_t>(expected));
    while (row.next()) out.push_back({row.integer(0), row.integer(1), row.integer(2), row.real(3)});
    const auto before = [](const StoredFact& f, const StoredFact& g) { return std::pair(f.a, f.b) < std::pair(g.a, g.b); };
    if (!std::is_sorted(out.begin(), out.end(), before)) std::sort(out.begin(), out.end(), before);
    return out;
  }

 private:
  Statement ends_, together_, apart_;
};

/// Writes what differs: most facts of an edited rule are those of the one before.
class FactWriter {
 public:
  FactWriter(Database& database, ScanId scan)
      : scan_(scan), reader_(database), remove_(database.prepare("DELETE FROM relation_fact WHERE id = ?")),
        update_(database.prepare("UPDATE relation_fact SET degree = ? WHERE id = ?")),
        insert_(database.prepare("INSERT INTO relation_fact (scan_id, relation, a, b, degree) VALUES (?, ?, ?, ?, ?)")) {}

  /// `facts` by a and b.
  void replace(const std::string& relation, Facts facts) {
    const std::vector<StoredFact> stored = reader_.read(scan_, relation, static_cast<std::int64_t>(facts.size()));
    std::vector<const RelationFact*> fresh;
    std::size_t i = 0;
    for (const StoredFact& old : stored) {
      const auto key = std::pair(old.a, old.b);
      for (; i < facts.size() && std::pair(facts[i].a, facts[i].b) < key; ++i) fresh.push_back(&facts[i]);
      if (i < facts.size() && std::pair(facts[i].a, facts[i].b) == key) {
        if (facts[i].degree != old.degree) update_.use()(facts[i].degree)(old.id).run();
        ++i;
      } else {
        remove_.use()(old.id).run();
      }
    }
    for (; i < facts.size(); ++i) fresh.push_back(&facts[i]);
    for (const RelationFact* fact : fresh) insert_.use()(scan_)(relation)(fact->a)(fact->b)(fact->degree).run();
  }

 private:
  ScanId scan_;
  FactReader reader_;
  Statement remove_, update_, insert_;
};

/// Relations of which the scan has facts, each found by one step along the index.
std::vector<std::string> relations_with_facts(const Database& database, ScanId scan) {
  Statement select = database.prepare(
      "WITH RECURSIVE name(n) AS (SELECT min(relation) FROM relation_fact WHERE scan_id = ?1 UNION ALL "
      "SELECT (SELECT min(relation) FROM relation_fact WHERE scan_id = ?1 AND relation > n) FROM name WHERE n IS NOT NULL) "
      "SELECT n FROM name WHERE n IS NOT NULL");
  std::vector<std::string> out;
  auto row = select.use();
  for (row(scan); row.next();) out.push_back(row.text(0));
  return out;
}

/// The facts of each relation, by a and b.
std::map<std::string, std::vector<RelationFact>> by_relation(const std::vector<RelationFact>& facts) {
  std::map<std::string, std::vector<RelationFact>> out;
  std::vector<RelationFact>* current = nullptr;  // of the fact before: they come by relation
  for (const RelationFact& fact : facts) {
    if (current == nullptr || current->back().relation != fact.relation) current = &out[fact.relation];
    current->push_back(fact);
  }
  const auto before = [](const RelationFact& f, const RelationFact& g) { return std::pair(f.a, f.b) < std::pair(g.a, g.b); };
  for (auto& [relation, list] : out) {
    if (!std::is_sorted(list.begin(), list.end(), before)) std::sort(list.begin(), list.end(), before);
  }
  return out;
}

std::optional<double> limit(double value) { return std::isfinite(value) ? std::optional(value) : std::nullopt; }

/// Whether what is stored is what was handed out and taken over.
bool same(const RelationAsked& before, const RelationAsked& now) {
  return before.stored && now.stored && before.inputs_sha256 == now.inputs_sha256;
}

}  // namespace

void replace_facts(Database& database, ScanId scan, const Inference& inference) {
  const std::map<std::string, RelationAsked> before = read_asked(database, scan);
  const auto kept = [&](const std::string& relation) {
    const auto old = before.find(relation), now = inference.asked.find(relation);
    return old != before.end() && now != inference.asked.end() && same(old->second, now->second);
  };
  const bool all = std::all_of(before.begin(), before.end(), [&](const auto& row) { return kept(row.first); });
  if (all && before.size() == inference.asked.size() && !before.empty()) return;

  const NoTriggers own_writing(database);
  std::map<std::string, std::vector<RelationFact>> wanted;  // of the relations that were asked anew
  std::vector<RelationFact> anew;
  const std::string* relation_before = nullptr;
  bool kept_before = false;
  for (const RelationFact& fact : inference.facts) {
    if (relation_before == nullptr || *relation_before != fact.relation) kept_before = kept(fact.relation);
    relation_before = &fact.relation;
    if (!kept_before) anew.push_back(fact);
  }
  wanted = by_relation(anew);
  for (const std::string& relation : relations_with_facts(database, scan)) {
    if (!kept(relation)) wanted.try_emplace(relation);
  }
  FactWriter writer(database, scan);
  for (const auto& [relation, facts] : wanted) writer.replace(relation, facts);

  Statement forget = database.prepare("DELETE FROM relation_asked WHERE scan_id = ? AND relation = ?");
  for (const auto& [relation, asked] : before) {
    if (!kept(relation)) forget.use()(scan)(relation).run();
  }
  Statement note = database.prepare(
      "INSERT INTO relation_asked (scan_id, relation, asked, held, within, within_plan, inputs_sha256, facts, features) "
      "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)");
  for (const auto& [relation, asked] : inference.asked) {
    if (kept(relation)) continue;
    const std::vector<PackedFact> facts = packed(wanted[relation]);
    note.use()(scan)(relation)(asked.asked)(asked.held)(limit(asked.within))(limit(asked.within_plan))(asked.inputs_sha256)(
        std::as_bytes(std::span(facts)))(asked.features).run();
  }
}

void replace_geometry(Database& database, ScanId scan, const StoredGeometry& geometry) {
  if (geometry.answers.empty()) return;
  {
    Statement present = database.prepare("SELECT inputs_sha256, answers FROM pair_geometry WHERE scan_id = ?");
    auto row = present.use();
    const bool same = row(scan).next() && row.text(0) == geometry.inputs_sha256 &&
                      std::ranges::equal(row.blob(1), std::as_bytes(std::span(geometry.answers)));
    if (same) return;
  }
  database.prepare("INSERT OR REPLACE INTO pair_geometry (scan_id, inputs_sha256, answers) VALUES (?, ?, ?)")
      .use()(scan)(geometry.inputs_sha256)(std::as_bytes(std::span(geometry.answers))).run();
}

namespace {

std::string as_text(std::span<const std::byte> bytes) { return {reinterpret_cast<const char*>(bytes.data()), bytes.size()}; }

std::map<std::string, StoredAnswer> read_rule_answers(const Database& database, ScanId scan) {
  Statement select = database.prepare("SELECT rule, features, inputs_sha256, answers FROM rule_answer WHERE scan_id = ?");
  std::map<std::string, StoredAnswer> out;
  auto row = select.use();
  for (row(scan); row.next();) out[row.text(0)] = {row.text(1), row.text(2), as_text(row.blob(3))};
  return out;
}

}  // namespace

void replace_rule_answers(Database& database, ScanId scan, const Inference& inference) {
  if (inference.rule_answers.empty()) return;
  const std::map<std::string, StoredAnswer> before = read_rule_answers(database, scan);
  if (before == inference.rule_answers) return;
  Statement remove = database.prepare("DELETE FROM rule_answer WHERE scan_id = ? AND rule = ?");
  for (const auto& [rule, answer] : before) {
    const auto now = inference.rule_answers.find(rule);
    if (now == inference.rule_answers.end() || now->second != answer) remove.use()(scan)(rule).run();
  }
  Statement insert = database.prepare("INSERT INTO rule_answer (scan_id, rule, features, inputs_sha256, answers) VALUES (?, ?, ?, ?, ?)");
  for (const auto& [rule, answer] : inference.rule_answers) {
    const auto old = before.find(rule);
    if (old != before.end() && old->second == answer) continue;
    insert.use()(scan)(rule)(answer.features)(answer.inputs_sha256)(std::as_bytes(std::span(answer.answers))).run();
  }
}

std::map<std::string, StoredAnswer> KnowledgeBase::rule_answers(ScanId scan) const {
  return read_rule_answers(implementation_->database, scan);
}

StoredGeometry KnowledgeBase::pair_geometry(ScanId scan) const {
  Statement select = implementation_->database.prepare("SELECT inputs_sha256, answers FROM pair_geometry WHERE scan_id = ?");
  auto row = select.use();
  if (!row(scan).next()) return {};
  const std::span<const std::byte> blob = row.blob(1);
  return {row.text(0), std::string(reinterpret_cast<const char*>(blob.data()), blob.size())};
}

std::map<std::string, StoredFacts> KnowledgeBase::facts(ScanId scan) const {
  const Database& database = implementation_->database;
  std::map<std::string, StoredFacts> out;
  for (auto& [relation, asked] : read_asked(database, scan)) {
    if (asked.stored) out[relation].asked = std::move(asked);
  }
  Statement select = database.prepare("SELECT relation, facts FROM relation_asked WHERE scan_id = ? AND facts IS NOT NULL");
  auto row = select.use();
  for (row(scan); row.next();) {
    const std::string relation = row.text(0);
    out[relation].facts = unpacked(relation, row.blob(1));
  }
  return out;
}

}  // namespace scenelore::kb
