#include "scenelore/engine/problem_file.hpp"

#include <fstream>
#include <istream>
#include <iterator>

#include "file_reader.hpp"
#include "scenelore/engine/error.hpp"

namespace scenelore::engine {

ProblemFile read_problem(std::istream& in, const std::string& name, FileFormat format) {
  std::string content{std::istreambuf_iterator<char>(in), {}};
  if (in.bad()) throw FileError(name + ": reading failed");
  FileText text(std::move(content), name, format == FileFormat::cfn ? "{}[]:," : "", format == FileFormat::cfn);
  switch (format) {
    case FileFormat::cfn:
      return read_cfn(text);
    case FileFormat::wcsp:
      return read_wcsp(text);
    case FileFormat::uai:
      return read_uai(text);
  }
  throw FileError(name + ": unknown format");
}

ProblemFile read_problem_file(const std::string& path) {
  const auto ends = [&](const char* ending) { return path.ends_with(ending); };
  if (ends(".gz") || ends(".xz") || ends(".bz2"))
    throw FileError(path + ": is compressed; unpack it first (gunzip -k, unxz -k, bunzip2 -k)");
  FileFormat format = FileFormat::cfn;
  if (ends(".wcsp"))
    format = FileFormat::wcsp;
  else if (ends(".uai"))
    format = FileFormat::uai;
  else if (!ends(".cfn"))
    throw FileError(path + ": the name must end in .cfn, .wcsp or .uai, which tells the format");
  std::ifstream in(path, std::ios::binary);
  if (!in) throw FileError(path + ": cannot be opened");
  return read_problem(in, path, format);
}

}  // namespace scenelore::engine
