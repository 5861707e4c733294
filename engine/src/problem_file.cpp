#include "scenelore/engine/problem_file.hpp"

#include <algorithm>
#include <fstream>
#include <istream>
#include <iterator>

#include "file_reader.hpp"
#include "scenelore/engine/error.hpp"

namespace scenelore::engine {

namespace {

int label_of(const Follower& follower, const std::vector<int>& labels) {
  const auto holds = [&](const Literal& literal) { return labels[static_cast<std::size_t>(literal.variable)] == literal.label; };
  if (follower.counted) {
    const int before = follower.before < 0 ? 0 : labels[static_cast<std::size_t>(follower.before)];
    return before + static_cast<int>(std::count_if(follower.counted->begin(), follower.counted->end(), holds));
  }
  int best = follower.otherwise;
  double least = follower.weight;
  if (!holds(follower.owner)) return follower.idle;
  for (const Follower::Choice& choice : follower.choices) {
    if (!holds(choice.when) || choice.cost >= least) continue;
    least = choice.cost;
    best = choice.label;
  }
  return best;
}

}  // namespace

std::vector<int> ProblemFile::in_file(const std::vector<int>& assignment) const {
  std::vector<int> labels;
  for (const FileVariable& variable : variables)
    labels.push_back(variable.in_problem < 0 ? -1 : assignment[static_cast<std::size_t>(variable.in_problem)]);
  for (const Follower& follower : followers) labels[static_cast<std::size_t>(follower.variable)] = label_of(follower, labels);
  return labels;
}

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
