#include "scenelore/rules/isolated.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <exception>

#include "scenelore/rules/error.hpp"
#include "scenelore/rules/labelling.hpp"

namespace scenelore::rules {

namespace {

/// Values one after another; both ends run the same program, so numbers go as they lie in memory.
class Writer {
 public:
  template <typename T>
  void number(T value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  void text(const std::string& value) {
    number(value.size());
    bytes += value;
  }
  std::string bytes;
};

/// The reader trusts nothing: what ends too early is an Error.
class Reader {
 public:
  explicit Reader(std::string_view bytes) : rest_(bytes) {}
  template <typename T>
  T number() {
    T value;
    std::memcpy(&value, take(sizeof value).data(), sizeof value);
    return value;
  }
  std::string text() { return std::string(take(number<std::size_t>())); }
  /// Of a list whose entries take at least one byte each.
  std::size_t count() {
    const auto n = number<std::size_t>();
    if (n > rest_.size()) broken();
    return n;
  }

 private:
  [[noreturn]] static void broken() { throw Error("the isolated rules sent an answer that cannot be read"); }
  std::string_view take(std::size_t size) {
    if (size > rest_.size()) broken();
    const std::string_view taken = rest_.substr(0, size);
    rest_.remove_prefix(size);
    return taken;
  }
  std::string_view rest_;
};

void write_answers(Writer& out, const RuleAnswers& answers) {
  out.number(answers.features.size());
  for (const kb::Feature& f : answers.features) {
    out.text(f.name);
    out.text(f.unit);
    out.number(f.scale);
    for (const double value : {f.low, f.high, f.weight}) out.number(value);
    out.text(f.description);
  }
  out.number(answers.table.names.size());
  for (const std::string& name : answers.table.names) out.text(name);
  out.number(answers.table.values.size());
  for (const std::vector<double>& row : answers.table.values) {
    for (const double value : row) out.number(value);
  }
  out.number(answers.facts.facts.size());
  for (const kb::RelationFact& fact : answers.facts.facts) {
    out.text(fact.relation);
    out.number(fact.a);
    out.number(fact.b);
    out.number(fact.degree);
  }
  out.number(answers.facts.asked.size());
  for (const auto& [relation, asked] : answers.facts.asked) {
    out.text(relation);
    out.number(asked.asked);
    out.number(asked.held);
    out.number(asked.within);
    out.number(asked.within_plan);
    out.text(asked.inputs_sha256);
    out.text(asked.facts_sha256);
  }
  out.number(answers.facts.constraints.size());
  for (const TupleConstraint& c : answers.facts.constraints) {
    out.text(c.name);
    out.text(c.summary);
    out.number(c.classes.size());
    for (const std::string& name : c.classes) out.text(name);
    out.number(c.every);
    out.number(c.weight.value_or(-1));
    out.number(c.within);
    out.number(c.tuples.size());
    for (const TupleConstraint::Tuple& tuple : c.tuples) {
      for (const kb::PlaneId plane : tuple.planes) out.number(plane);
      out.number(tuple.degree);
    }
  }
  out.text(answers.hash);
}

RuleAnswers read_answers(Reader& in, std::size_t planes) {
  RuleAnswers out;
  for (std::size_t i = 0, n = in.count(); i < n; ++i) {
    kb::Feature f;
    f.name = in.text();
    f.unit = in.text();
    f.scale = in.number<kb::Scale>();
    if (f.scale != kb::Scale::log && f.scale != kb::Scale::circular) f.scale = kb::Scale::linear;
    f.low = in.number<double>();
    f.high = in.number<double>();
    f.weight = in.number<double>();
    f.description = in.text();
    out.features.push_back(std::move(f));
  }
  for (std::size_t i = 0, n = in.count(); i < n; ++i) out.table.names.push_back(in.text());
  if (in.count() != planes) throw Error("the isolated rules sent features of other planes");
  for (std::size_t i = 0; i < planes; ++i) {
    std::vector<double>& row = out.table.values.emplace_back();
    for (std::size_t f = 0; f < out.table.names.size(); ++f) row.push_back(in.number<double>());
  }
  for (std::size_t i = 0, n = in.count(); i < n; ++i) {
    kb::RelationFact fact{.relation = in.text()};
    fact.a = in.number<kb::PlaneId>();
    fact.b = in.number<kb::PlaneId>();
    fact.degree = in.number<double>();
    out.facts.facts.push_back(std::move(fact));
  }
  for (std::size_t i = 0, n = in.count(); i < n; ++i) {
    const std::string relation = in.text();
    kb::RelationAsked& asked = out.facts.asked[relation];
    asked.asked = in.number<std::int64_t>();
    asked.held = in.number<std::int64_t>();
    asked.within = in.number<double>();
    asked.within_plan = in.number<double>();
    asked.inputs_sha256 = in.text();
    asked.facts_sha256 = in.text();
    out.facts.reach[relation] = {asked.within, asked.within_plan};
  }
  for (std::size_t i = 0, n = in.count(); i < n; ++i) {
    TupleConstraint c{.name = in.text(), .summary = {}, .classes = {}, .weight = {}, .tuples = {}};
    c.summary = in.text();
    for (std::size_t k = 0, m = in.count(); k < m; ++k) c.classes.push_back(in.text());
    c.every = in.number<bool>();
    const auto weight = in.number<double>();
    if (weight > 0) c.weight = weight;
    c.within = in.number<double>();
    for (std::size_t k = 0, m = in.count(); k < m; ++k) {
      TupleConstraint::Tuple& tuple = c.tuples.emplace_back();
      for (std::size_t p = 0; p < c.classes.size(); ++p) tuple.planes.push_back(in.number<kb::PlaneId>());
      tuple.degree = in.number<double>();
    }
    out.facts.constraints.push_back(std::move(c));
  }
  out.hash = in.text();
  return out;
}

void limit(int resource, rlim_t value) {
  const rlimit both{value, value};
  setrlimit(static_cast<__rlimit_resource_t>(resource), &both);
}

void confine(const Isolation& limits) {
  prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL, 0, 0, 0);
  limit(RLIMIT_CPU, limits.cpu_seconds);
  limit(RLIMIT_AS, limits.memory_bytes);
  limit(RLIMIT_FSIZE, 0);
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_NPROC, 0);
  limit(RLIMIT_NOFILE, 32);  // rule files are read one at a time
}

void send(int pipe, const std::string& bytes) {
  for (std::size_t sent = 0; sent < bytes.size();) {
    const ssize_t n = write(pipe, bytes.data() + sent, bytes.size() - sent);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) _exit(3);
    sent += static_cast<std::size_t>(n);
  }
}

std::string receive(int pipe) {
  std::string bytes;
  char block[1 << 16];
  for (;;) {
    const ssize_t n = read(pipe, block, sizeof block);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return bytes;
    bytes.append(block, static_cast<std::size_t>(n));
  }
}

std::string how_it_ended(int status) {
  if (WIFSIGNALED(status) && (WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL)) {
    return "the isolated rules used up their processor time, or were killed";
  }
  if (WIFSIGNALED(status)) return "the process of the isolated rules ended with signal " + std::to_string(WTERMSIG(status));
  return "the process of the isolated rules ended without an answer";
}

}  // namespace

RuleAnswers answer(RuleSet& rules, const kb::Knowledge& knowledge, Scene& scene,
                   const std::map<std::string, kb::StoredFacts>& known) {
  RuleAnswers out;
  out.features = rules.features();
  rules.compute_features(scene, scene.features);
  out.table = scene.features;
  out.facts = rules.relate(scene, used_relations(knowledge, rules), known);
  out.facts.constraints = rules.constraints(scene, knowledge);
  out.hash = rules.hash();
  return out;
}

RuleAnswers answer_isolated(const std::vector<std::filesystem::path>& directories, const Budget& budget,
                            const kb::Knowledge& knowledge, const Scene& scene,
                            const std::map<std::string, kb::StoredFacts>& known, const Isolation& limits) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw Error(std::string("no pipe for the isolated rules: ") + std::strerror(errno));
  const pid_t child = fork();
  if (child < 0) {
    close(ends[0]);
    close(ends[1]);
    throw Error(std::string("no process for the isolated rules: ") + std::strerror(errno));
  }
  if (child == 0) {
    close(ends[0]);
    confine(limits);
    Writer out;
    try {
      Scene own = scene;
      RuleSet rules = RuleSet::load(directories, budget, knowledge.settings);
      const RuleAnswers answers = answer(rules, knowledge, own, known);
      out.number('+');
      write_answers(out, answers);
    } catch (const Error& error) {
      out = {};
      out.number('-');
      out.text(error.what());
      out.text(error.traceback());
    } catch (const std::exception& error) {
      out = {};
      out.number('-');
      out.text(std::string("the isolated rules failed: ") + error.what());
      out.text("");
    }
    send(ends[1], out.bytes);
    _exit(0);
  }
  close(ends[1]);
  const std::string bytes = receive(ends[0]);
  close(ends[0]);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0 || bytes.empty()) throw Error(how_it_ended(status));
  Reader in(bytes);
  if (in.number<char>() == '-') {
    const std::string text = in.text();
    throw Error(text, in.text());
  }
  return read_answers(in, scene.planes.size());
}

}  // namespace scenelore::rules
