// Work split over threads in pieces of a fixed size, so that no result depends on how many threads there are.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace scenelore::perception {

/// Calls work(begin, end) for consecutive pieces of [0, count). Pieces may run at the same time and in any order: each
/// may write only what belongs to its own range. The first exception is thrown again once all threads have ended.
/// Threads that the system refuses are done without.
template <typename Work>
void parallel_pieces(std::size_t count, std::size_t piece, int threads, Work work) {
  const std::size_t pieces = (count + piece - 1) / piece;
  const std::size_t workers = std::min<std::size_t>(pieces, static_cast<std::size_t>(std::max(1, threads)));
  if (workers <= 1) {
    if (count > 0) work(std::size_t{0}, count);
    return;
  }
  std::atomic<std::size_t> next{0};
  std::exception_ptr error;
  std::mutex guard;
  const auto run = [&] {
    try {
      for (std::size_t i = next++; i < pieces; i = next++) work(i * piece, std::min(count, (i + 1) * piece));
    } catch (...) {
      const std::lock_guard lock(guard);
      if (!error) error = std::current_exception();
      next = pieces;
    }
  };
  {
    std::vector<std::jthread> others;
    try {
      for (std::size_t i = 1; i < workers; ++i) others.emplace_back(run);
    } catch (const std::system_error&) {
    }
    run();
  }
  if (error) std::rethrow_exception(error);
}

}  // namespace scenelore::perception
