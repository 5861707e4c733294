// How a program holds its memory.
#pragma once

#include <vector>

namespace scenelore::perception {

/// What a program does.
enum class Work {
  labelling,   ///< vectors of some megabytes, in two threads
  perception,  ///< clouds of millions of points, step by step
};

/// Keeps memory that was freed for what comes next, and has it in huge pages where the system lends them: 32 MB for labelling, as much as clouds
/// of some ten million points need for perception, of which addresses alone cost nothing. The steps use some megabytes or dozens of them each for a few
/// milliseconds: by default the C library gives them back and the kernel clears them again for the next step, page by page, which takes as
/// long as all the geometry. For the whole process, so a program calls it before it reads, and again where its work turns out to be
/// greater; libraries do not. Advice alone: without it, and where the C library has no such switch, all works the same.
void keep_memory(Work work);

/// Gives back what vectors hold, which `v = {}` does not: that empties them.
template <typename... T>
void release(std::vector<T>&... vectors) {
  (std::vector<T>().swap(vectors), ...);
}

}  // namespace scenelore::perception
