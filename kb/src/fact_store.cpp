// A relation is asked again only when something it depends on has changed; until then its rows are the answer.
#include "fact_store.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <string>

#include "implementation.hpp"
#include "scenelore/kb/sha256.hpp"

namespace scenelore::kb {

namespace {

using Facts = std::span<const RelationFact>;

constexpr double kNoLimit = std::numeric_limits<double>::infinity();

std::string digest(Facts facts) {
  std::string bytes;
  bytes.reserve(facts.size() * 24);
  const auto put = [&](auto value) { bytes.append(reinterpret_cast<const char*>(&value), sizeof value); };
  for (const RelationFact& fact : facts) {
    put(fact.a);
    put(fact.b);
    put(fact.degree);
  }
  return sha256_of(bytes);
}

std::map<std::string, RelationAsked> read_asked(const Database& database, ScanId scan) {
  Statement select = database.prepare(
      "SELECT relation, asked, held, within, within_plan, inputs_sha256, facts_sha256 FROM relation_asked WHERE scan_id = ?");
  std::map<std::string, RelationAsked> out;
  auto row = select.use();
  for (row(scan); row.next();) {
    out[row.text(0)] = {row.integer(1), row.integer(2), row.optional_real(3).value_or(kNoLimit),
                        row.optional_real(4).value_or(kNoLimit), row.text(5), row.text(6)};
  }
  return out;
}

/// The rows of one relation, in the order in which they were written: by a and b.
std::vector<RelationFact> read_facts(Statement& select, ScanId scan, const std::string& relation) {
  std::vector<RelationFact> out;
  auto row = select.use();
  for (row(scan)(relation); row.next();) out.push_back({relation, row.integer(0), row.integer(1), row.real(2)});
  return out;
}

std::optional<double> limit(double value) { return std::isfinite(value) ? std::optional(value) : std::nullopt; }

bool same(const RelationAsked& a, const RelationAsked& b) {
  return a.inputs_sha256 == b.inputs_sha256 && a.facts_sha256 == b.facts_sha256;
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

  Statement stored = database.prepare("SELECT DISTINCT relation FROM relation_fact WHERE scan_id = ? UNION "
                                      "SELECT relation FROM relation_asked WHERE scan_id = ?1");
  Statement remove = database.prepare("DELETE FROM relation_fact WHERE scan_id = ? AND relation = ?");
  Statement forget = database.prepare("DELETE FROM relation_asked WHERE scan_id = ? AND relation = ?");
  std::vector<std::string> gone;
  {
    auto row = stored.use();
    for (row(scan); row.next();) gone.push_back(row.text(0));
  }
  std::erase_if(gone, kept);
  for (const std::string& relation : gone) {
    remove.use()(scan)(relation).run();
    forget.use()(scan)(relation).run();
  }

  Statement insert = database.prepare("INSERT INTO relation_fact (scan_id, relation, a, b, degree) VALUES (?, ?, ?, ?, ?)");
  for (std::size_t i = 0; i < inference.facts.size();) {
    const std::string& relation = inference.facts[i].relation;
    const bool leave = kept(relation);
    for (; i < inference.facts.size() && inference.facts[i].relation == relation; ++i) {
      const RelationFact& fact = inference.facts[i];
      if (!leave) insert.use()(scan)(fact.relation)(fact.a)(fact.b)(fact.degree).run();
    }
  }
  Statement note = database.prepare(
      "INSERT INTO relation_asked (scan_id, relation, asked, held, within, within_plan, inputs_sha256, facts_sha256) "
      "VALUES (?, ?, ?, ?, ?, ?, ?, ?)");
  for (const auto& [relation, asked] : inference.asked) {
    if (kept(relation)) continue;
    const auto begin = std::find_if(inference.facts.begin(), inference.facts.end(),
                                    [&](const RelationFact& f) { return f.relation == relation; });
    const auto end = std::find_if(begin, inference.facts.end(), [&](const RelationFact& f) { return f.relation != relation; });
    note.use()(scan)(relation)(asked.asked)(asked.held)(limit(asked.within))(limit(asked.within_plan))(asked.inputs_sha256)(
        digest({begin, end})).run();
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
  Statement select = database.prepare("SELECT a, b, degree FROM relation_fact WHERE scan_id = ? AND relation = ? ORDER BY id");
  for (auto& [relation, asked] : read_asked(database, scan)) {
    StoredFacts stored{asked, read_facts(select, scan, relation)};
    if (digest(stored.facts) == asked.facts_sha256) out.emplace(relation, std::move(stored));
  }
  return out;
}

}  // namespace scenelore::kb
