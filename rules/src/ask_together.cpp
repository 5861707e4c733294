#include "ask_together.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <deque>
#include <exception>
#include <numeric>
#include <optional>

#include "scenelore/perception/parallel.hpp"
#include "shown_scene.hpp"

namespace scenelore::rules {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::int64_t kWorthAThread = 6000;  // questions, about 4 ms: another thread needs one or two to load its rules
constexpr std::int64_t kPieces = 32;          // so that no thread waits long for the other at the end

/// What the threads have used up of one relation's time.
struct Spent {
  std::atomic<std::int64_t> nanoseconds = 0, asked = 0;
};

/// Bounds of pieces [bounds[i], bounds[i+1]) of the planes with about as many questions each.
std::vector<int> pieces_of(std::size_t planes, const std::vector<AskedRelation>& relations, std::int64_t pieces) {
  std::vector<std::int64_t> questions(planes);
  for (const AskedRelation& relation : relations) {
    for (const auto& [a, b] : *relation.pairs) questions[static_cast<std::size_t>(a)] += static_cast<std::int64_t>(relation.degrees_a_pair());
  }
  const std::int64_t all = std::accumulate(questions.begin(), questions.end(), std::int64_t{0});
  std::vector<int> bounds{0};
  std::int64_t sum = 0;
  for (std::size_t a = 0; a < planes; ++a) {
    sum += questions[a];
    if (sum * pieces >= all * static_cast<std::int64_t>(bounds.size())) bounds.push_back(static_cast<int>(a) + 1);
  }
  return bounds;
}

/// The part of one thread.
class Worker {
 public:
  Worker(LoadedRules& rules, const Scene& scene, PairGeometry& geometry, std::vector<AskedRelation>& relations, std::size_t state)
      : rules_(rules), geometry_(geometry), relations_(relations), shown_(scene), state_(state), features_(relations.size()) {}

  void load() {
    for (const AskedRelation& relation : relations_) files_.push_back(&rules_.relation(relation.name, state_));
  }

  /// About the pairs whose smaller index lies in [begin, end).
  void ask(int begin, int end, std::vector<Spent>& spent) {
    for (std::size_t r = 0; r < relations_.size() && (!failed_ || r < failed_->relation); ++r) {
      try {
        ask(r, begin, end, spent[r]);
      } catch (...) {
        failed_ = {r, begin, std::current_exception()};
      }
    }
  }

  /// To be called by one thread when all have ended.
  void hand_over() {
    for (std::size_t r = 0; r < relations_.size(); ++r) relations_[r].features.merge(features_[r]);
  }

  struct Failure {
    std::size_t relation = 0;
    int piece = 0;  // its first plane
    std::exception_ptr error;
  };
  /// The first one, in the order in which a single thread would have met it.
  [[nodiscard]] const std::optional<Failure>& failed() const { return failed_; }

 private:
  void ask(std::size_t r, int begin, int end, Spent& spent) {
    AskedRelation& relation = relations_[r];
    const auto first = [&](int plane) {
      return std::lower_bound(relation.pairs->begin(), relation.pairs->end(), std::pair(plane, 0)) - relation.pairs->begin();
    };
    const auto from = static_cast<std::size_t>(first(begin)), to = static_cast<std::size_t>(first(end));
    if (from == to) return;
    RuleFile& file = *files_[r];
    shown_.show_to(file, geometry_);
    const Clock::time_point start = Clock::now();
    const Deadline deadline(file, rules_.budget(), std::chrono::nanoseconds(spent.nanoseconds));
    const std::span pairs = std::span(*relation.pairs).subspan(from, to - from);
    put_degrees(file, pairs, deadline, spent.asked, relation.degrees.data() + from * relation.degrees_a_pair());
    spent.nanoseconds += std::chrono::nanoseconds(Clock::now() - start).count();
    spent.asked += static_cast<std::int64_t>((to - from) * relation.degrees_a_pair());
    const auto& read = file.host().features_read;
    features_[r].insert(read.begin(), read.end());
  }

  LoadedRules& rules_;
  PairGeometry& geometry_;
  std::vector<AskedRelation>& relations_;
  ShownScene shown_;
  std::size_t state_;
  std::vector<RuleFile*> files_;
  std::vector<FeatureNames> features_;
  std::optional<Failure> failed_;
};

}  // namespace

void put_degrees(RuleFile& file, std::span<const std::pair<int, int>> pairs, const Deadline& deadline, std::int64_t asked, double* degrees) {
  constexpr std::size_t kQuestions = 64;  // between two looks at the clock
  const bool symmetric = file.relation().symmetric;
  const std::size_t at_once = symmetric ? kQuestions : kQuestions / 2;
  Pairs both_ways;
  for (std::size_t begin = 0; begin < pairs.size(); begin += at_once) {
    deadline.check(asked);
    std::span<const std::pair<int, int>> now = pairs.subspan(begin, std::min(at_once, pairs.size() - begin));
    if (!symmetric) {
      both_ways.clear();
      for (const auto& [a, b] : now) both_ways.insert(both_ways.end(), {{a, b}, {b, a}});
      now = both_ways;
    }
    file.degrees(now, degrees);
    degrees += now.size();
    asked += static_cast<std::int64_t>(now.size());
  }
}

void ask_together(LoadedRules& rules, const Scene& scene, PairGeometry& geometry, std::vector<AskedRelation>& relations, int threads) {
  std::int64_t questions = 0;
  for (AskedRelation& relation : relations) {
    relation.degrees.resize(relation.pairs->size() * relation.degrees_a_pair());
    questions += static_cast<std::int64_t>(relation.degrees.size());
  }
  if (questions == 0) return;
  const auto workers_wanted = static_cast<std::size_t>(questions < kWorthAThread ? 1 : std::max(1, threads));
  const std::vector<int> bounds = pieces_of(scene.planes.size(), relations, workers_wanted > 1 ? kPieces : 1);
  geometry.prepare(static_cast<int>(workers_wanted));
  rules.announce_states(workers_wanted);
  std::deque<Worker> workers;
  for (std::size_t state = 0; state < workers_wanted; ++state) workers.emplace_back(rules, scene, geometry, relations, state);
  std::vector<Spent> spent(relations.size());
  std::atomic<std::size_t> next = 0;
  const std::size_t pieces = bounds.size() - 1;
  perception::parallel_pieces(workers.size(), 1, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t w = begin; w < end && next < pieces; ++w) {
      workers[w].load();  // before it takes a piece that another one could begin with at once
      for (std::size_t piece = next++; piece < pieces; piece = next++) workers[w].ask(bounds[piece], bounds[piece + 1], spent);
    }
  });
  const std::optional<Worker::Failure>* first = nullptr;
  for (Worker& worker : workers) {
    worker.hand_over();
    const auto& failed = worker.failed();
    if (failed && (first == nullptr || std::pair(failed->relation, failed->piece) < std::pair((*first)->relation, (*first)->piece))) first = &failed;
  }
  if (first != nullptr) std::rethrow_exception((*first)->error);
  for (std::size_t r = 0; r < relations.size(); ++r) relations[r].milliseconds = 1e-6 * static_cast<double>(spent[r].nanoseconds);
}

}  // namespace scenelore::rules
