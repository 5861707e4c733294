// Answers that need not be believed: a proof as text, and a small verifier that knows nothing of the search.
//
// The proof rests on one fact: moving cost between a constraint and the labels of its variables changes no world's
// cost, so whatever has been moved, the least costs of the labels and of the constraints add up to a lower bound (Cooper
// et al., "Soft arc consistency revisited", AIJ 2010). The verifier needs no rule about how to move: it adds up these
// minima anew, in whole numbers. docs/search.md tells the format line by line, and what the verifier trusts.
#pragma once

#include <cstddef>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "scenelore/engine/problem.hpp"
#include "scenelore/engine/solver.hpp"

namespace scenelore::engine {

struct CertificateOptions {
  Limits limits;
  std::size_t most_bytes = std::size_t{1} << 28;
};

/// The proof of an answer of Solver::solve without assumptions: `proved` or `infeasible`. A second search, which knows
/// the optimum, writes it down. Nothing when a limit strikes. Throws: Error when the outcome is another one, or when the
/// answer is not that of the problem.
std::optional<std::string> certificate(const Problem& problem, const Solution& solution,
                                       const CertificateOptions& options = {});

struct Verdict {
  bool accepted = false;
  std::string reason;                      ///< when not accepted: the line and what is wrong there
  Outcome outcome = Outcome::infeasible;   ///< what is shown: proved or infeasible
  double cost = 0;                         ///< of the certificate's world, from the problem; infinite: there is none
  double tolerance = 0;                    ///< no world is cheaper than cost − tolerance: costs are rounded once each
  std::vector<int> assignment;             ///< the certificate's world
};

/// Reads and verifies a certificate, whoever wrote it. Shares with the search only the rounding of costs.
[[nodiscard]] Verdict verify(const Problem& problem, std::istream& certificate);

}  // namespace scenelore::engine
