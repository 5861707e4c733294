// The knowledge base file: one SQLite file that is also a valid GeoPackage (docs/schema.md).
#pragma once

#include <Eigen/Geometry>
#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "scenelore/kb/evidence.hpp"
#include "scenelore/kb/inference.hpp"
#include "scenelore/kb/knowledge.hpp"
#include "scenelore/perception/plane.hpp"

namespace scenelore::kb {

/// A row of `scan`.
struct Scan {
  ScanId id = 0;  ///< 0 = not stored yet
  std::string name;
  std::string source;  ///< path as given by the user
  std::string sha256;  ///< of the source file
  std::int64_t point_count = 0;
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();  ///< scan frame to upright frame
  double floor_z = 0;                                            ///< along upright z
  std::string parameters;                                        ///< JSON
  std::string imported_at;                                       ///< ISO 8601, UTC; set by store_scan when empty
};

struct StoredPlane {
  PlaneId id = 0;
  perception::Plane plane;
};

/// P(C|Φ) of a scan's planes, and what it was made from.
struct Evidence {
  std::vector<std::vector<double>> probabilities;  ///< [plane][class]
  std::string inputs_sha256;                       ///< names all that it depends on: the same again gives the same evidence
};

/// SQLite's storage class of a value.
enum class ValueType { null, integer, real, text, blob };

/// A result row of a query as text, with NULL as nullopt and blobs as hexadecimal digits.
struct QueryRow {
  std::vector<std::optional<std::string>> values;
  std::vector<ValueType> types;
};

/// What stops a query that takes too long.
struct QueryLimits {
  double seconds = std::numeric_limits<double>::infinity();
  const std::atomic<bool>* interrupt = nullptr;  ///< set from a signal handler or another thread
};

enum class Access { read_only, read_write };

/// Owns the connection. Every writing function is one transaction: a kill leaves the file as it was before.
/// Not safe for concurrent use of one object; several processes may read one file. Throws Error naming file and row.
class KnowledgeBase {
 public:
  /// A new file with the schema and the named knowledge pack ("office", "paper", "empty"). Throws when the file exists.
  static KnowledgeBase create(const std::filesystem::path& path, const std::string& knowledge = "office");
  /// Migrates an older file (read_write); refuses a newer one, a file that is no knowledge base, a damaged one.
  static KnowledgeBase open(const std::filesystem::path& path, Access access = Access::read_write);
  KnowledgeBase(KnowledgeBase&&) noexcept;
  KnowledgeBase& operator=(KnowledgeBase&&) noexcept;
  ~KnowledgeBase();

  /// Checked: one fallback class, sigma > 0, ranges, names that exist; the error names table and row.
  [[nodiscard]] Knowledge knowledge() const;
  /// Runs SQL that changes the knowledge tables (a knowledge pack, learned rows) in one transaction, then checks the whole
  /// knowledge: an error names `source` and leaves everything as it was. Other tables, ATTACH and the like are refused.
  void apply_knowledge(const std::string& sql, const std::string& source);
  /// Adds a pack that comes with the program ("home", "kitchen"), or a file of SQL, by apply_knowledge. Throws Error when there is no
  /// such pack, and when a class of it is there already.
  void add_knowledge(const std::string& pack);
  /// The same for what learning changes (priors, weights, Gaussians, densities): undo_knowledge brings back what was there
  /// before, `what` tells in words what it was.
  void learn_knowledge(const std::string& sql, const std::string& what);
  /// Undoes the last learn_knowledge that was not undone yet: priors, weights, Gaussians and densities of the classes and rows of
  /// then are as before it; those added since stay. Returns what was undone, nothing when there is nothing to undo.
  std::optional<std::string> undo_knowledge();
  /// SHA-256 of the knowledge tables' content in a canonical order.
  [[nodiscard]] std::string knowledge_hash() const;

  [[nodiscard]] std::vector<Scan> scans() const;                                     ///< by id
  [[nodiscard]] std::optional<Scan> find_scan(const std::string& name) const;
  /// Stores a scan and its planes. A scan of the same name is replaced; its `truth` rows move to the new planes that
  /// share most of their points (more than half of the points of each). The same source and the same planes keep plane ids,
  /// truth and labels. Returns the scan's id (kept on replacement); `warnings` gets a sentence per truth row
  /// that found no plane.
  ScanId store_scan(const Scan& scan, const std::vector<perception::Plane>& planes,
                    const std::vector<std::int32_t>& plane_of_point, std::vector<std::string>* warnings = nullptr);
  [[nodiscard]] std::vector<StoredPlane> planes(ScanId scan) const;                  ///< by id
  /// Plane id of each point of the source file, −1 = none.
  [[nodiscard]] std::vector<std::int64_t> plane_of_point(ScanId scan) const;
  [[nodiscard]] std::vector<std::pair<PlaneId, std::string>> truth(ScanId scan) const;

  /// preclassify() with the knowledge of the file; where the run before had the same, what it found. `features`: one row for each of
  /// `planes`, which are the scan's.
  [[nodiscard]] Evidence evidence(ScanId scan, const std::vector<PlaneId>& planes, const FeatureTable& features) const;

  /// Adds to the catalogue the features that it does not have yet (those of Lua files), with weight 0: a person who wants
  /// one to count sets its weight and writes class_feature rows. Writes nothing when there is none to add.
  void register_features(const std::vector<Feature>& features);
  /// Replaces the feature values of planes of the scan. NaN stores nothing; features that the catalogue lacks are left out.
  void store_features(ScanId scan, const std::vector<PlaneId>& planes, const FeatureTable& features);
  /// NaN where a plane has no value; columns by name.
  [[nodiscard]] FeatureTable features(const std::vector<PlaneId>& planes) const;
  /// Replaces everything inferred about the scan before. Returns the run's id.
  std::int64_t store_inference(ScanId scan, const Inference& inference);
  /// By relation; only those whose rows of relation_fact are as they were written.
  [[nodiscard]] std::map<std::string, StoredFacts> facts(ScanId scan) const;
  /// Empty where nothing is kept.
  [[nodiscard]] StoredGeometry pair_geometry(ScanId scan) const;
  /// What Lua features and constraints answered in the last run, by "feature NAME" or "constraint NAME".
  [[nodiscard]] std::map<std::string, StoredAnswer> rule_answers(ScanId scan) const;
  [[nodiscard]] std::vector<Label> labels(ScanId scan) const;
  [[nodiscard]] std::vector<Reason> reasons(PlaneId plane) const;

  /// Runs one statement that only reads (an authorizer refuses the rest); `header` gets the column names first.
  /// Values print as sqlite3's shell does: reals with up to 15 digits.
  void query(const std::string& sql, const std::function<void(const std::vector<std::string>&)>& header,
             const std::function<void(const QueryRow&)>& row, const QueryLimits& limits = {}) const;

 private:
  void apply_within(const std::string& sql, const std::string& source);
  struct Implementation;
  explicit KnowledgeBase(std::unique_ptr<Implementation> implementation);
  std::unique_ptr<Implementation> implementation_;
};

/// How far planes of a scan that ought to be level or upright are not, in degrees, as a standard deviation: the quantile of 80 %, each plane
/// weighted by the square root of its area, over that of the normal distribution. Of planes of 0.25 m² and more within 15 degrees of
/// level or upright. At least 0.3, also when there are fewer than four such planes: nothing is built and put up truer than that (DIN 18202).
/// Real laser scans have 0.3 to 1.3, a depth camera that bends planes 2 to 5.
[[nodiscard]] double stray_deg(const std::vector<StoredPlane>& planes);

/// Values of the catalogue's built-in features (area_m2, length, …, z_min, z_max, facing_up, …) of planes in the scan's
/// upright frame; x and y are along the upright frame's axes, from the scan's centre. The standard error of tilt_deg is stray_deg.
[[nodiscard]] FeatureTable built_in_features(const Scan& scan, const std::vector<StoredPlane>& planes);

}  // namespace scenelore::kb
