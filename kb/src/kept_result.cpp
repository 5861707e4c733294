#include "kept_result.hpp"

#include <span>

#include "digest.hpp"
#include "implementation.hpp"

namespace scenelore::kb {

std::optional<KeptResult> kept_result(const Database& database, ScanId scan, const std::string& what) {
  Statement select = database.prepare("SELECT inputs_sha256, content FROM kept_result WHERE scan_id = ? AND what = ?");
  auto row = select.use();
  if (!row(scan)(what).next()) return std::nullopt;
  const std::span<const std::byte> bytes = row.blob(1);
  return KeptResult{row.text(0), std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size())};
}

bool is_kept(const Database& database, ScanId scan, const std::string& what, const std::string& inputs_sha256) {
  if (inputs_sha256.empty()) return false;
  Statement select = database.prepare("SELECT 1 FROM kept_result WHERE scan_id = ? AND what = ? AND inputs_sha256 = ?");
  auto row = select.use();
  return row(scan)(what)(inputs_sha256).next();
}

void keep_result(Database& database, ScanId scan, const std::string& what, const KeptResult& result) {
  if (result.inputs_sha256.empty()) {
    database.prepare("DELETE FROM kept_result WHERE scan_id = ? AND what = ?").use()(scan)(what).run();
    return;
  }
  database.prepare("INSERT INTO kept_result (scan_id, what, inputs_sha256, content) VALUES (?, ?, ?, ?) ON CONFLICT (scan_id, what) "
                   "DO UPDATE SET inputs_sha256 = excluded.inputs_sha256, content = excluded.content")
      .use()(scan)(what)(result.inputs_sha256)(std::as_bytes(std::span(result.content))).run();
}

std::string hash_of(const std::vector<PlaneId>& planes, const FeatureTable& features) {
  Digest add;
  for (const PlaneId plane : planes) add(plane);
  for (const std::string& name : features.names) add(name);
  const auto values = [&](const std::vector<double>& row) {
    add(static_cast<std::int64_t>(row.size())).raw({reinterpret_cast<const char*>(row.data()), row.size() * sizeof(double)});
  };
  for (const std::vector<double>& row : features.values) values(row);
  for (const auto& [name, errors] : features.errors) {
    add(name);
    values(errors);
  }
  return add.hex();
}

Evidence KnowledgeBase::evidence(ScanId scan, const std::vector<PlaneId>& planes, const FeatureTable& features) const {
  const Knowledge& knowledge = implementation_->knowledge();
  Evidence evidence;
  // SCENELORE_EVIDENCE: hash of the sources behind preclassify, made by CMake.
  evidence.inputs_sha256 = Digest()(SCENELORE_EVIDENCE)(implementation_->hashes().evidence)(hash_of(planes, features)).hex();
  const std::size_t classes = knowledge.classes.size();
  const std::optional<KeptResult> kept = kept_result(implementation_->database, scan, "evidence");
  const bool same = kept && kept->inputs_sha256 == evidence.inputs_sha256;
  const std::vector<double> values = same ? kept->get<double>() : std::vector<double>{};
  if (!same || values.size() != planes.size() * classes) {
    evidence.probabilities = preclassify(knowledge, features);
    return evidence;
  }
  for (auto row = values.begin(); row != values.end(); row += static_cast<std::ptrdiff_t>(classes)) {
    evidence.probabilities.emplace_back(row, row + static_cast<std::ptrdiff_t>(classes));
  }
  return evidence;
}

}  // namespace scenelore::kb
