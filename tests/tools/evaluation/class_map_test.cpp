#include "evaluation/class_map.hpp"

#include <gmock/gmock.h>

#include "evaluation/error.hpp"
#include "temporary_folder.hpp"

namespace scenelore::evaluation {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::vector<std::string> kClasses{"unknown", "floor", "table", "chair_seat", "chair_back"};

std::string error_of(const std::string& text) {
  try {
    (void)parse_class_map(text, "some.txt", kClasses);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(ClassMap, ReadsOneSeveralAndNoClasses) {
  const ClassMap map = parse_class_map("# head\n\ndesk = table  # a note\nchair=chair_seat chair_back\nother = -\n", "some.txt", kClasses);
  ASSERT_EQ(map.size(), 3u);
  EXPECT_THAT(map.at("desk"), ElementsAre("table"));
  EXPECT_THAT(map.at("chair"), ElementsAre("chair_seat", "chair_back"));
  EXPECT_TRUE(map.at("other").empty());
}

TEST(ClassMap, NamesTheLineOfWhatIsWrong) {
  EXPECT_THAT(error_of("desk = tabel\n"), testing::AllOf(HasSubstr("some.txt:1"), HasSubstr("did you mean 'table'")));
  EXPECT_THAT(error_of("desk = table\ndesk = floor\n"), testing::AllOf(HasSubstr("some.txt:2"), HasSubstr("twice")));
  EXPECT_THAT(error_of("desk table\n"), HasSubstr("some.txt:1"));
  EXPECT_THAT(error_of("desk =\n"), HasSubstr("some.txt:1"));
  EXPECT_THAT(error_of("two words = table\n"), HasSubstr("some.txt:1"));
}

TEST(ClassMap, ThatComesWithTheProgramSuitsTheDefaultKnowledge) {
  std::vector<std::string> office{"unknown", "floor", "ceiling", "wall", "table", "flat_screen", "keyboard", "chair_seat", "chair_back",
                                  "door", "window", "whiteboard", "shelf", "cabinet"};
  EXPECT_THAT(read_class_map("indoor", office).at("monitor"), ElementsAre("flat_screen"));
  EXPECT_THROW((void)read_class_map("outdoor", office), Error);
}

TEST(ClassMap, FindsLabelNamesAboveTheCloud) {
  test::TemporaryFolder folder;
  test::write_file(folder / "labels.txt", "0 unlabelled\n5 desk\n");
  test::write_file(folder / "kinect/office.ply", "");
  const auto file = find_label_names(folder / "kinect/office.ply");
  EXPECT_EQ(file, folder / "labels.txt");
  EXPECT_EQ(read_label_names(file).at(5), "desk");
  test::write_file(folder / "labels.txt", "five desk\n");
  EXPECT_THROW((void)read_label_names(folder / "labels.txt"), Error);
}

}  // namespace
}  // namespace scenelore::evaluation
