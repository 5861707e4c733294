#pragma once

namespace scenelore::tools {

/// What the shell sees; documented in docs/cli.md.
enum ExitCode : int {
  kOk = 0,
  kNegative = 1,        ///< ran, but the answer is negative: no planes, no valid world model, a check failed
  kUsage = 2,
  kInput = 3,           ///< a scan or problem file could not be read, or an output not written
  kKnowledge = 4,       ///< knowledge base or rule error
  kLimit = 5,           ///< a limit or an interrupt struck; the best answer so far is stored
  kInternal = 70
};

}  // namespace scenelore::tools
