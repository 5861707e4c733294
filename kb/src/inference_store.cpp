// What the engine found out: written as a whole, replaced as a whole.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "fact_store.hpp"
#include "implementation.hpp"
#include "kept_result.hpp"
#include "no_triggers.hpp"
#include "update_in_place.hpp"

namespace scenelore::kb {

namespace {

// The id of a scan's run stays what it was, so that repeating a run gives the same rows.
std::optional<std::int64_t> previous_run(const Database& database, ScanId scan) {
  Statement select = database.prepare("SELECT id FROM run WHERE scan_id = ?");
  auto row = select.use();
  return row(scan).next() ? std::optional(row.integer(0)) : std::nullopt;
}

std::optional<double> finite(double value) { return std::isfinite(value) ? std::optional(value) : std::nullopt; }

std::int64_t insert_run(Database& database, ScanId scan, std::optional<std::int64_t> id, const Run& run) {
  database
      .prepare(
          "INSERT INTO run (id, scan_id, outcome, cost, lower_bound, nodes, seconds, knowledge_hash, rules_hash, "
          "engine_version, started_at) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, "
          "strftime('%Y-%m-%dT%H:%M:%SZ', 'now', '-' || ?7 || ' seconds')) "
          "ON CONFLICT (id) DO UPDATE SET outcome = excluded.outcome, cost = excluded.cost, lower_bound = excluded.lower_bound, "
          "nodes = excluded.nodes, seconds = excluded.seconds, knowledge_hash = excluded.knowledge_hash, "
          "rules_hash = excluded.rules_hash, engine_version = excluded.engine_version, started_at = excluded.started_at")
      .use()(id)(scan)(run.outcome)(finite(run.cost))(finite(run.lower_bound))(run.nodes)(run.seconds)(run.knowledge_hash)(
          run.rules_hash)(run.engine_version)
      .run();
  return id ? *id : database.last_id();
}

void replace_evidence_rows(Database& database, ScanId scan, const Inference& inference) {
  const std::size_t classes = inference.classes.size();
  // What was written together has neighbouring ids: read one after another instead of by the index.
  Statement select = database.prepare(
      "SELECT id, probability, plane_id, class FROM evidence NOT INDEXED WHERE id BETWEEN "
      "(SELECT min(id) FROM evidence WHERE plane_id IN (SELECT id FROM plane WHERE scan_id = ?1)) AND "
      "(SELECT max(id) FROM evidence WHERE plane_id IN (SELECT id FROM plane WHERE scan_id = ?1)) "
      "AND plane_id IN (SELECT id FROM plane WHERE scan_id = ?1) ORDER BY id");
  Statement update = database.prepare("UPDATE evidence SET probability = ? WHERE id = ?");
  const auto matches = [&](const Statement::Use& row, std::size_t i) {
    return row.integer(2) == inference.planes[i / classes] && row.view(3) == inference.classes[i % classes];
  };
  const auto value = [&](std::size_t i) { return inference.evidence[i / classes][i % classes]; };
  const std::size_t wanted = inference.planes.size() * classes;
  if (update_in_place(select, update, scan, wanted, matches, value)) return;
  database.prepare("DELETE FROM evidence WHERE plane_id IN (SELECT id FROM plane WHERE scan_id = ?)").use()(scan).run();
  Statement insert = database.prepare("INSERT INTO evidence (plane_id, class, probability) VALUES (?, ?, ?)");
  for (std::size_t i = 0; i < wanted; ++i) {
    insert.use()(inference.planes[i / classes])(inference.classes[i % classes])(value(i)).run();
  }
}

void replace_evidence(Database& database, ScanId scan, const Inference& inference) {
  if (is_kept(database, scan, "evidence", inference.evidence_inputs)) return;
  const NoTriggers own_writing(database);
  replace_evidence_rows(database, scan, inference);
  std::vector<double> values;
  for (const std::vector<double>& row : inference.evidence) values.insert(values.end(), row.begin(), row.end());
  KeptResult kept{inference.evidence_inputs, {}};
  kept.set(values);
  keep_result(database, scan, "evidence", kept);
}

/// Where a plane keeps its class and the next best one, only numbers change, which no index needs to know.
void replace_labels(Database& database, ScanId scan, std::int64_t run, const Inference& inference) {
  std::map<PlaneId, Label> before;
  {
    Statement select = database.prepare(
        "SELECT plane_id, class, probability, margin, runner_up, run_id FROM label WHERE plane_id IN (SELECT id FROM plane WHERE scan_id = ?)");
    auto row = select.use();
    for (row(scan); row.next();) {
      const bool same_run = row.integer(5) == run;  // else without a class that a label could have
      before[row.integer(0)] = {row.integer(0), same_run ? row.text(1) : "", row.real(2), row.real(3), row.optional_text(4)};
    }
  }
  Statement update = database.prepare("UPDATE label SET probability = ?, margin = ? WHERE plane_id = ?");
  std::vector<const Label*> anew;
  for (const Label& l : inference.labels) {
    const auto old = before.find(l.plane);
    if (old == before.end() || old->second.object_class != l.object_class || old->second.runner_up != l.runner_up) {
      anew.push_back(&l);
      continue;
    }
    if (old->second.probability != l.probability || old->second.margin != l.margin) update.use()(l.probability)(l.margin)(l.plane).run();
    old->second.plane = 0;  // stays
  }
  if (anew.empty() && before.size() == inference.labels.size()) return;
  Statement remove = database.prepare("DELETE FROM label WHERE plane_id = ?");
  for (const auto& [plane, label] : before) {
    if (label.plane != 0) remove.use()(plane).run();
  }
  Statement insert = database.prepare(
      "INSERT INTO label (plane_id, class, probability, run_id, margin, runner_up) VALUES (?, ?, ?, ?, ?, ?)");
  for (const Label* l : anew) insert.use()(l->plane)(l->object_class)(l->probability)(run)(l->margin)(l->runner_up).run();
}

void replace_alternatives(Database& database, std::int64_t run, const Inference& inference) {
  database.prepare("DELETE FROM alternative WHERE run_id = ?").use()(run).run();
  Statement alternative = database.prepare("INSERT INTO alternative (run_id, rank, plane_id, class) VALUES (?, ?, ?, ?)");
  for (const Alternative& a : inference.alternatives) alternative.use()(run)(a.rank)(a.plane)(a.object_class).run();
}

constexpr const char* kReasonColumns =
    "plane_id, class, kind, constraint_name, other_plane_id, amount, sentence, feature, value, mean, sigma, against";

/// From the column `first` on.
Reason read_reason(const Statement::Use& row, int first) {
  Reason r{.plane = row.integer(first), .object_class = row.text(first + 1), .kind = row.text(first + 2),
           .constraint_name = row.optional_text(first + 3), .amount = row.real(first + 5), .sentence = row.text(first + 6)};
  if (!row.is_null(first + 4)) r.other_plane = row.integer(first + 4);
  const auto number = [&](int column) { return row.optional_real(column).value_or(std::numeric_limits<double>::quiet_NaN()); };
  if (!row.is_null(first + 7)) r.term = {row.text(first + 7), number(first + 8), number(first + 9), number(first + 10)};
  r.against = row.optional_text(first + 11);
  return r;
}

/// Whether the columns from `first` on hold this reason. Nothing is copied: a run has a thousand of them.
bool holds(const Statement::Use& row, int first, const Reason& r) {
  const auto text = [&](int column, const std::optional<std::string>& wanted) {
    return wanted ? !row.is_null(first + column) && row.view(first + column) == *wanted : row.is_null(first + column);
  };
  const auto number = [&](int column, double wanted) {
    return std::isnan(wanted) ? row.is_null(first + column) : !row.is_null(first + column) && row.real(first + column) == wanted;
  };
  const auto other = [&] { return r.other_plane ? !row.is_null(first + 4) && row.integer(first + 4) == *r.other_plane : row.is_null(first + 4); };
  const auto term = [&] {
    if (!r.term) return row.is_null(first + 7);
    return !row.is_null(first + 7) && row.view(first + 7) == r.term->feature && number(8, r.term->value) && number(9, r.term->mean) && number(10, r.term->sigma);
  };
  return row.integer(first) == r.plane && number(5, r.amount) && other() && row.view(first + 6) == r.sentence && row.view(first + 2) == r.kind &&
         row.view(first + 1) == r.object_class && text(3, r.constraint_name) && text(11, r.against) && term();
}

void bind(Statement::Use& use, const Reason& r) {
  use(r.plane)(r.object_class)(r.kind)(r.constraint_name)(r.other_plane)(r.amount)(r.sentence);
  if (r.term) {
    use(r.term->feature)(r.term->value)(r.term->mean)(r.term->sigma);
  } else {
    use(std::nullopt)(std::nullopt)(std::nullopt)(std::nullopt);
  }
  use(r.against);
}

/// All that a row of a reason holds, as a number: 64 bits, of which a run compares a thousand with those of the run before.
std::uint64_t hash_of(const Reason& r) {
  std::uint64_t hash = 0;
  const auto mix = [&](std::uint64_t value) {
    hash = (hash ^ value) * 0x9E3779B97F4A7C15u;
    hash ^= hash >> 32;
  };
  const auto text = [&](std::string_view bytes) {
    mix(bytes.size());
    for (std::uint64_t word = 0; !bytes.empty(); word = 0) {
      const std::size_t taken = std::min(bytes.size(), sizeof word);
      std::memcpy(&word, bytes.data(), taken);
      mix(word);
      bytes.remove_prefix(taken);
    }
  };
  const auto some = [&](const auto& value, const auto& add) {
    mix(value ? 1 : 0);
    if (value) add(*value);
  };
  const auto number = [&](double value) { mix(std::isnan(value) ? 1 : std::bit_cast<std::uint64_t>(value)); };
  mix(static_cast<std::uint64_t>(r.plane));
  text(r.object_class);
  text(r.kind);
  some(r.constraint_name, text);
  some(r.other_plane, [&](PlaneId plane) { mix(static_cast<std::uint64_t>(plane)); });
  number(r.amount);
  text(r.sentence);
  some(r.term, [&](const Reason::Term& term) {
    text(term.feature);
    for (const double value : {term.value, term.mean, term.sigma}) number(value);
  });
  some(r.against, text);
  return hash;
}

struct KeptReason {
  std::int64_t id;
  std::uint64_t hash;
  bool operator==(const KeptReason&) const = default;
};

/// The rows of the run before, in order. Where nothing is kept of them, those that hold another reason than the one now in their place
/// have a hash that none has.
std::vector<KeptReason> reasons_before(const Database& database, std::int64_t run, const std::optional<KeptResult>& kept,
                                       const std::vector<Reason>& reasons, const std::vector<std::uint64_t>& hashes) {
  if (kept && kept->inputs_sha256 == std::to_string(run)) {
    std::vector<KeptReason> rows = kept->get<KeptReason>();
    Statement count = database.prepare("SELECT count(*) FROM reason WHERE run_id = ?");
    auto row = count.use();
    if (row(run).next() && row.integer(0) == static_cast<std::int64_t>(rows.size())) return rows;  // else somebody cut what is kept
  }
  std::vector<KeptReason> before;
  Statement select = database.prepare("SELECT id, " + std::string(kReasonColumns) + " FROM reason WHERE run_id = ? ORDER BY id");
  auto row = select.use();
  for (row(run); row.next();) {
    const std::size_t i = before.size();
    const bool same = i < reasons.size() && holds(row, 1, reasons[i]);
    before.push_back({row.integer(0), same ? hashes[i] : i < reasons.size() ? ~hashes[i] : 0});
  }
  return before;
}

/// Most reasons are those of the run before: only the rows that differ are written.
void replace_reasons(Database& database, ScanId scan, std::int64_t run, const std::vector<Reason>& reasons) {
  std::vector<std::uint64_t> hashes;
  hashes.reserve(reasons.size());
  for (const Reason& reason : reasons) hashes.push_back(hash_of(reason));
  const std::optional<KeptResult> kept = kept_result(database, scan, "reasons");
  std::vector<KeptReason> rows = reasons_before(database, run, kept, reasons, hashes);
  const NoTriggers own_writing(database);
  if (rows.size() > reasons.size()) {
    const std::int64_t last = reasons.empty() ? 0 : rows[reasons.size() - 1].id;
    database.prepare("DELETE FROM reason WHERE run_id = ? AND id > ?").use()(run)(last).run();
    rows.resize(reasons.size());
  }
  Statement update = database.prepare("UPDATE reason SET (" + std::string(kReasonColumns) + ") = (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?) WHERE id = ?");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].hash == hashes[i]) continue;
    auto use = update.use();
    bind(use, reasons[i]);
    use(rows[i].id).run();
    rows[i].hash = hashes[i];
  }
  Statement insert = database.prepare("INSERT INTO reason (" + std::string(kReasonColumns) + ", run_id) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
  for (std::size_t i = rows.size(); i < reasons.size(); ++i) {
    auto use = insert.use();
    bind(use, reasons[i]);
    use(run).run();
    rows.push_back({database.last_id(), hashes[i]});
  }
  KeptResult now{std::to_string(run), {}};
  now.set(rows);
  if (!kept || kept->inputs_sha256 != now.inputs_sha256 || kept->content != now.content) keep_result(database, scan, "reasons", now);
}

void replace_objects(Database& database, std::int64_t run, const Inference& inference) {
  database.prepare("DELETE FROM object WHERE run_id = ?").use()(run).run();
  Statement object = database.prepare("INSERT INTO object (run_id, composite, number) VALUES (?, ?, ?)");
  Statement plane = database.prepare("INSERT INTO object_plane (plane_id, object_id, part) VALUES (?, ?, ?)");
  for (const Object& o : inference.objects) {
    object.use()(run)(o.composite)(o.number).run();
    const std::int64_t id = database.last_id();
    for (const auto& [plane_id, part] : o.planes) plane.use()(plane_id)(id)(part).run();
  }
}

}  // namespace

std::int64_t KnowledgeBase::store_inference(ScanId scan, const Inference& inference) {
  Database& database = implementation_->database;
  Transaction transaction(database);
  const std::optional<std::int64_t> previous = previous_run(database, scan);
  const std::int64_t run = insert_run(database, scan, previous, inference.run);
  replace_evidence(database, scan, inference);
  replace_facts(database, scan, inference);
  replace_geometry(database, scan, inference.geometry);
  replace_rule_answers(database, scan, inference);
  replace_labels(database, scan, run, inference);
  replace_alternatives(database, run, inference);
  replace_objects(database, run, inference);
  replace_reasons(database, scan, run, inference.reasons);
  transaction.commit();
  return run;
}

std::vector<Label> KnowledgeBase::labels(ScanId scan) const {
  Statement select = implementation_->database.prepare(
      "SELECT l.plane_id, l.class, l.probability, l.margin, l.runner_up FROM label l JOIN plane p ON p.id = l.plane_id "
      "WHERE p.scan_id = ? ORDER BY l.plane_id");
  std::vector<Label> labels;
  auto row = select.use();
  for (row(scan); row.next();) {
    labels.push_back({row.integer(0), row.text(1), row.real(2), row.real(3), row.optional_text(4)});
  }
  return labels;
}

std::vector<Reason> KnowledgeBase::reasons(PlaneId plane) const {
  Statement select = implementation_->database.prepare("SELECT " + std::string(kReasonColumns) + " FROM reason WHERE plane_id = ? ORDER BY id");
  std::vector<Reason> reasons;
  auto row = select.use();
  for (row(plane); row.next();) reasons.push_back(read_reason(row, 0));
  return reasons;
}

}  // namespace scenelore::kb
