# Run by scenelore_embed: writes OUT, a C++ source that holds FILES as string literals.
set(entries "")
foreach(file IN LISTS FILES)
  file(READ ${file} text)
  file(RELATIVE_PATH relative ${ROOT} ${file})
  # A string literal may be as long as the compiler likes, g++ takes megabytes; pieces of 8,000 characters keep to
  # what the standard asks of every compiler together.
  set(literal "")
  string(LENGTH "${text}" length)
  set(at 0)
  while(at LESS length)
    string(SUBSTRING "${text}" ${at} 8000 piece)
    string(APPEND literal "R\"sl_embed(${piece})sl_embed\"\n")
    math(EXPR at "${at} + 8000")
  endwhile()
  # Told its length: compilers count no more than 2^18 characters of a constant.
  string(APPEND entries "    {\"${relative}\", ${literal}\"\"sv},\n")
endforeach()
file(WRITE ${OUT} "#include <scenelore/embedded_file.hpp>
#include <span>
namespace ${NAMESPACE} {
std::span<const scenelore::EmbeddedFile> ${NAME}();
std::span<const scenelore::EmbeddedFile> ${NAME}() {
  using namespace std::string_view_literals;
  static constexpr scenelore::EmbeddedFile files[] = {
${entries}  };
  return files;
}
}  // namespace ${NAMESPACE}
")
