#include "command.hpp"
#include "scenelore/perception/memory.hpp"

int main(int argc, char** argv) {
  scenelore::perception::keep_memory(scenelore::perception::Work::labelling);
  return scenelore::tools::run_command_line(argc, argv);
}
