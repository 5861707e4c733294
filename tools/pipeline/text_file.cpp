#include "pipeline/text_file.hpp"

#include "scenelore/perception/output_file.hpp"

namespace scenelore::pipeline {

void write_text_file(const std::filesystem::path& path, std::string_view text) {
  perception::OutputFile file(path);
  file.write(text);
  file.commit();
}

}  // namespace scenelore::pipeline
