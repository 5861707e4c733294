// Results that stand in the file once more in one piece (table kept_result), so that thousands of rows need neither be made again nor
// be read only to see that nobody has changed them.
#pragma once

#include <cstring>
#include <optional>
#include <string>
#include <vector>

#include "scenelore/kb/evidence.hpp"
#include "scenelore/kb/inference.hpp"
#include "sqlite.hpp"

namespace scenelore::kb {

struct KeptResult {
  std::string inputs_sha256;
  std::string content;  ///< bytes

  template <typename T>
  void set(const std::vector<T>& values) {
    content.assign(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
  }
  template <typename T>
  [[nodiscard]] std::vector<T> get() const {
    std::vector<T> values(content.size() / sizeof(T));
    if (!values.empty()) std::memcpy(values.data(), content.data(), values.size() * sizeof(T));
    return values;
  }
};

/// Nothing when none is kept, or rows have changed since.
std::optional<KeptResult> kept_result(const Database& database, ScanId scan, const std::string& what);
/// Whether what is kept was made from the same.
bool is_kept(const Database& database, ScanId scan, const std::string& what, const std::string& inputs_sha256);
/// After the rows were written, in the same transaction and without triggers. Empty inputs: nothing is known of the rows.
void keep_result(Database& database, ScanId scan, const std::string& what, const KeptResult& result);

/// Of values, their errors and the planes that they are about.
std::string hash_of(const std::vector<PlaneId>& planes, const FeatureTable& features);

}  // namespace scenelore::kb
