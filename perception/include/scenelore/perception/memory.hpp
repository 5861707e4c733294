// How a program that perceives holds its memory.
#pragma once

namespace scenelore::perception {

/// Keeps memory that was freed for what comes next, and has it in huge pages where the system lends them. The steps of
/// perception use some dozens of megabytes each for a few milliseconds: by default the C library gives them back and the kernel clears
/// them again for the next step, page by page, which takes as long as all the geometry. For the whole process, so a program
/// calls it, once and before it reads; libraries do not. No effect where the C library has no such switch.
void keep_memory();

}  // namespace scenelore::perception
