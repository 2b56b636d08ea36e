// Tables as people and programs save them, and what is none.
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "liggghts_plugins/objects/csv_table.h"

namespace {

using swellflow::CsvTable;

double x_of(const std::string &text)
{
  const CsvTable table("a.csv", text, {"x", "y"});
  return *table.value(table.rows().front(), "x");
}

TEST(CsvTable, ReadsWhatSpreadsheetsSave)
{
  EXPECT_EQ(x_of("x,y\n1.5,2\n"), 1.5);
  EXPECT_EQ(x_of("\xef\xbb\xbfx,y\r\n1.5,2\r\n"), 1.5);  // a byte order mark, and line ends of another system
  EXPECT_EQ(x_of("# made by hand\n\n x [mm] , y \n 1.5 , 2"), 1.5);
}

TEST(CsvTable, RefusesWhatOnlyBeginsAsANumber)
{
  for (const std::string &cell : {std::string("1.5z"), std::string("1.5\0z", 5), std::string("1.5\0", 4), std::string("inf"), std::string("nan"), std::string(), std::string("1e999"), std::string("1e101")})
    EXPECT_THROW(x_of("x,y\n" + cell + ",2\n"), std::invalid_argument) << cell;
}

TEST(CsvTable, RefusesLinesOfAnotherLengthAndNamesItDoesNotKnow)
{
  for (const char *text : {"x,y\n1\n", "x,y\n1,2,3\n", "x,z\n1,2\n", "x,x\n1,2\n", "x,y\n", "", "\n#\n", "x;y\n1;2\n"}) EXPECT_THROW(x_of(text), std::invalid_argument) << text;
}

}  // namespace
