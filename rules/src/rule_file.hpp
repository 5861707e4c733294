// One rule file in a sandboxed state of its own: a relation or a feature, checked when loaded.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "rule_host.hpp"
#include "scenelore/kb/knowledge.hpp"
#include "scenelore/rules/error.hpp"

namespace scenelore::rules {

/// A text and the name under which messages speak of it.
struct RuleSource {
  std::string shown;
  std::string text;
};

class RuleFile {
 public:
  enum class Kind { relation, feature, constraint };

  /// Runs the file in a state of its own. Throws Error naming file, line and field for anything that is not a relation or feature.
  RuleFile(RuleSource source, const Budget& budget, const std::map<std::string, Overrides>& overrides = {});
  /// The same in a state that it shares with other files, all of them trusted.
  RuleFile(RuleSource source, std::shared_ptr<RuleHost> host);

  [[nodiscard]] Kind kind() const { return kind_; }
  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] const RuleSource& source() const { return source_; }
  [[nodiscard]] const RelationInfo& relation() const { return relation_; }
  [[nodiscard]] const kb::Feature& feature() const { return feature_; }
  [[nodiscard]] const TupleConstraint& constraint() const { return constraint_; }

  /// The planes that degree and value speak of by index; both must live as long as they are asked about, and until another look.
  void look_at(const Scene* scene, PairGeometry* geometry);

  /// In [0, 1]; 0 = does not hold. Throws Error naming relation and both planes.
  double degree(int a, int b);
  /// The same of many ordered pairs, in one call into the state: half of what a short relation takes is the way there and back.
  /// Each pair has the whole budget of a call. `degrees` has room for as many.
  void degrees(std::span<const std::pair<int, int>> pairs, double* degrees);
  /// NaN = not known.
  double value(int plane);
  /// Of a constraint over several planes; nothing where it does not apply.
  std::optional<double> degree(const std::vector<int>& planes);

  /// Features of the catalogue that the file asked planes for since look_at: names, one a line, rising; "?"
  /// for names that are none.
  [[nodiscard]] std::string features_read() const;

  /// Pushes the checked function behind degree or value.
  void push_ask() { lua_rawgeti(host_->lua.get(), LUA_REGISTRYINDEX, ask_); }
  [[nodiscard]] RuleHost& host() { return *host_; }

 private:
  void take_over();
  static int answer_batch(lua_State* state);
  double answer(lua_State* state, int a, int b);
  [[nodiscard]] int function_field(const char* name) const;
  [[nodiscard]] std::string text_field(const char* name) const;
  [[nodiscard]] double number_field(const char* name) const;
  [[nodiscard]] Error located(const Error& error, const std::string& about) const;

  RuleSource source_;
  std::shared_ptr<RuleHost> host_;
  Kind kind_ = Kind::relation;
  std::string name_;
  RelationInfo relation_;
  kb::Feature feature_;
  TupleConstraint constraint_;
  // Registry. `ask_` checks what the others answer and says what is wrong with it.
  int ask_ = LUA_NOREF;
  int applies_ = LUA_NOREF, degree_ = LUA_NOREF, self_ = LUA_NOREF;  // of a relation: its own functions, its tolerances
  int direct_ = LUA_NOREF;         // of a constraint: its `applies`, else its degree
  bool direct_is_filter_ = false;  // the former
};

}  // namespace scenelore::rules
