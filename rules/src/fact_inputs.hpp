// What the facts of a relation depend on, as a hash: the same inputs give the same facts.
#pragma once

#include <string>

#include "rule_file.hpp"

namespace scenelore::rules {

/// Of what Lua can see of the planes of a scene, which must live as long.
class SceneDigest {
 public:
  /// Planes that were hashed last: features, relations and constraints all ask about the same, and comparing is cheaper.
  struct Last {
    std::string bytes, digest;
  };
  SceneDigest(const Scene& scene, Last& last);
  /// Of ids, fields and outlines, which every rule may look at.
  [[nodiscard]] const std::string& planes() const { return planes_; }
  /// Of those, and of the named features of the catalogue (one name a line; see RuleFile::features_read).
  [[nodiscard]] std::string with(const std::string& features) const;

 private:
  const Scene& scene_;
  std::string planes_;
};

/// Of a relation's text and the settings for it, the planes (their digest) and the program that answers it.
[[nodiscard]] std::string fact_inputs(const RuleSource& relation, const Overrides& settings, const std::string& planes);

}  // namespace scenelore::rules
