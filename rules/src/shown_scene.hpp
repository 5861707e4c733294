// The scene that rule files are asked about.
#pragma once

#include <set>

#include "rule_file.hpp"

namespace scenelore::rules {

/// Shows rule files a scene as long as it lives, so that its planes are made for Lua once for all built-in files.
class ShownScene {
 public:
  explicit ShownScene(const Scene& scene) : scene_(scene) {}
  ShownScene(const ShownScene&) = delete;
  ShownScene& operator=(const ShownScene&) = delete;
  ~ShownScene() {
    for (RuleFile* file : files_) file->look_at(nullptr, nullptr);
  }
  /// The same geometry for all.
  void show_to(RuleFile& file, PairGeometry& geometry) {
    files_.insert(&file);
    file.look_at(&scene_, &geometry);
  }

 private:
  const Scene& scene_;
  std::set<RuleFile*> files_;
};

}  // namespace scenelore::rules
