#include "command.hpp"

int main(int argc, char** argv) { return scenelore::tools::run_command_line(argc, argv); }
