// What the engine found out: written as a whole, replaced as a whole.
#include <cmath>
#include <utility>
#include <vector>

#include "fact_store.hpp"
#include "implementation.hpp"
#include "update_in_place.hpp"

namespace scenelore::kb {

namespace {

// The id of a scan's run stays what it was, so that repeating a run gives the same rows.
std::optional<std::int64_t> previous_run(const Database& database, ScanId scan) {
  Statement select = database.prepare("SELECT id FROM run WHERE scan_id = ?");
  auto row = select.use();
  return row(scan).next() ? std::optional(row.integer(0)) : std::nullopt;
}

// Labels, alternatives and reasons go with the run.
void delete_run(Database& database, ScanId scan) { database.prepare("DELETE FROM run WHERE scan_id = ?").use()(scan).run(); }

std::optional<double> finite(double value) { return std::isfinite(value) ? std::optional(value) : std::nullopt; }

std::int64_t insert_run(Database& database, ScanId scan, std::optional<std::int64_t> id, const Run& run) {
  database
      .prepare(
          "INSERT INTO run (id, scan_id, outcome, cost, lower_bound, nodes, seconds, knowledge_hash, rules_hash, "
          "engine_version, started_at) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, "
          "strftime('%Y-%m-%dT%H:%M:%SZ', 'now', '-' || ?7 || ' seconds'))")
      .use()(id)(scan)(run.outcome)(finite(run.cost))(finite(run.lower_bound))(run.nodes)(run.seconds)(run.knowledge_hash)(
          run.rules_hash)(run.engine_version)
      .run();
  return database.last_id();
}

void replace_evidence(Database& database, ScanId scan, const Inference& inference) {
  const std::size_t classes = inference.classes.size();
  Statement select = database.prepare(
      "SELECT id, probability, plane_id, class FROM evidence WHERE plane_id IN (SELECT id FROM plane WHERE scan_id = ?) ORDER BY id");
  Statement update = database.prepare("UPDATE evidence SET probability = ? WHERE id = ?");
  const auto matches = [&](const Statement::Use& row, std::size_t i) {
    return row.integer(2) == inference.planes[i / classes] && row.text(3) == inference.classes[i % classes];
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

void insert_labels(Database& database, std::int64_t run, const Inference& inference) {
  Statement label = database.prepare(
      "INSERT INTO label (plane_id, class, probability, run_id, margin, runner_up) VALUES (?, ?, ?, ?, ?, ?)");
  for (const Label& l : inference.labels) {
    label.use()(l.plane)(l.object_class)(l.probability)(run)(l.margin)(l.runner_up).run();
  }
  Statement alternative = database.prepare("INSERT INTO alternative (run_id, rank, plane_id, class) VALUES (?, ?, ?, ?)");
  for (const Alternative& a : inference.alternatives) alternative.use()(run)(a.rank)(a.plane)(a.object_class).run();
  Statement reason = database.prepare(
      "INSERT INTO reason (run_id, plane_id, class, kind, constraint_name, other_plane_id, amount, sentence) "
      "VALUES (?, ?, ?, ?, ?, ?, ?, ?)");
  for (const Reason& r : inference.reasons) {
    reason.use()(run)(r.plane)(r.object_class)(r.kind)(r.constraint_name)(r.other_plane)(r.amount)(r.sentence).run();
  }
}

}  // namespace

std::int64_t KnowledgeBase::store_inference(ScanId scan, const Inference& inference) {
  Database& database = implementation_->database;
  Transaction transaction(database);
  const std::optional<std::int64_t> previous = previous_run(database, scan);
  delete_run(database, scan);
  const std::int64_t run = insert_run(database, scan, previous, inference.run);
  replace_evidence(database, scan, inference);
  replace_facts(database, scan, inference);
  insert_labels(database, run, inference);
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
  Statement select = implementation_->database.prepare(
      "SELECT plane_id, class, kind, constraint_name, other_plane_id, amount, sentence FROM reason WHERE plane_id = ? "
      "ORDER BY id");
  std::vector<Reason> reasons;
  auto row = select.use();
  for (row(plane); row.next();) {
    reasons.push_back({row.integer(0), row.text(1), row.text(2), row.optional_text(3),
                       row.is_null(4) ? std::nullopt : std::optional(row.integer(4)), row.real(5), row.text(6)});
  }
  return reasons;
}

}  // namespace scenelore::kb
