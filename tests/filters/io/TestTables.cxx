// Tables of points as programs write them, and as they are damaged.
#include "ReaderTest.h"
#include "vtkMoteDelimitedPointsReader.h"

#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace
{

using TestTables = ReaderTest<vtkMoteDelimitedPointsReader>;

vtkDataArray* numbers(vtkPolyData* data, const char* name)
{
  return data->GetPointData()->GetArray(name);
}

std::string word(vtkPolyData* data, const char* name, vtkIdType row)
{
  auto* words = vtkStringArray::SafeDownCast(data->GetPointData()->GetAbstractArray(name));
  return words ? std::string(words->GetValue(row)) : "no text";
}

TEST_F(TestTables, NamesOfCoordinates)
{
  const char* const heads[] = {
    "x,y,z,T",
    "T,x-coordinate,    y-coordinate,    z-coordinate",
    "\"X (m)\",\"Y (m)\",\"Z (m)\",T",
    "[Name]\nPlane 1\n\n[Data]\nX [ m ], Y [ m ], Z [ m ], T",
    "\"Points:0\",\"Points:1\",\"Points:2\",T",
    "Points_0,Points_1,Points_2,T",
    "position_x,position_y,position_z,T",
    "Position.X,Position.Y,Position.Z,T",
    "x_pos,y_pos,z_pos,T",
    "coord_z,coord_y,coord_x,T",
    "Points:0,Points:1,Points:2,z,y,x,T", // the plain names are better
    "# made by a program\n# x y z\nx,y,z,T",
    "\xEF\xBB\xBFx,y,z,T",
  };
  for (const std::string head : heads)
  {
    const std::size_t columns = 1 + static_cast<std::size_t>(std::count(
                                      head.begin() + head.rfind('\n') + 1, head.end(), ','));
    std::string row = "1";
    for (std::size_t i = 1; i < columns; ++i)
      row.append(",").append(std::to_string(i + 1));
    const auto good = this->read(head + "\n" + row + "\n");
    ASSERT_EQ(m_error, "") << head;
    ASSERT_EQ(good->GetNumberOfPoints(), 1) << head;
    double p[3];
    good->GetPoint(0, p);
    const bool isBehind = head.starts_with("T,");
    if (head.starts_with("coord_z"))
      EXPECT_TRUE(p[0] == 3 && p[1] == 2 && p[2] == 1) << head;
    else if (columns == 7)
      EXPECT_TRUE(p[0] == 6 && p[1] == 5 && p[2] == 4) << head;
    else
      EXPECT_TRUE(p[0] == 1 + isBehind && p[1] == 2 + isBehind && p[2] == 3 + isBehind) << head;
    ASSERT_TRUE(numbers(good, "T")) << head;
    EXPECT_EQ(numbers(good, "T")->GetTuple1(0), isBehind ? 1 : double(columns)) << head;
    EXPECT_EQ(good->GetPointData()->GetNumberOfArrays(), columns == 7 ? 2 : 1) << head;
  }
}

TEST_F(TestTables, BlanksSeparateToo)
{
  for (const std::string text : {"# x y z T\n1 2 3 0.5\n", "x   y\tz  T\n  1 2\t\t3 0.5  \n\n",
         "% a comment\n%  x  y  z  T\n1 2 3 0.5\n", "// x y z T\r\n1 2 3 0.5\r\n"})
  {
    const auto data = this->read(text);
    ASSERT_EQ(data->GetNumberOfPoints(), 1) << text << m_error;
    EXPECT_EQ(data->GetPoint(0)[2], 3) << text;
    ASSERT_TRUE(numbers(data, "T")) << text;
    EXPECT_EQ(numbers(data, "T")->GetTuple1(0), 0.5);
  }
}

TEST_F(TestTables, NumbersWithoutNames)
{
  for (const std::string text : {"1 2 3 4\n5 6 7 8.5\n", "1,2,3,4\n5,6,7,8.5\n",
         "# four numbers\n1\t2\t3\t4\n5\t6\t7\t8.5\n", "1;2,0;3;4\n5;6;7;8,5\n"})
  {
    const auto data = this->read(text);
    ASSERT_EQ(data->GetNumberOfPoints(), 2) << text << m_error;
    EXPECT_EQ(data->GetPoint(1)[2], 7) << text;
    EXPECT_EQ(numbers(data, "column4")->GetTuple1(1), 8.5) << text;
  }
  expectError("1,2\n3,4\n", "no column is named 'x'");
  expectError("a,b,c\n1,2,3\n", "line 1: no column is named 'x'");
}

TEST_F(TestTables, DecimalCommas)
{
  const auto data = this->read("name;x;y;z;T\na,b;0,5;-1,25e3;3;7,5\n\"c;d\";1;2;3;\n");
  ASSERT_EQ(data->GetNumberOfPoints(), 2) << m_error;
  EXPECT_EQ(data->GetPoint(0)[0], 0.5);
  EXPECT_EQ(data->GetPoint(0)[1], -1250);
  EXPECT_EQ(numbers(data, "T")->GetTuple1(0), 7.5);
  EXPECT_TRUE(std::isnan(numbers(data, "T")->GetTuple1(1)));
  EXPECT_EQ(word(data, "name", 0), "a,b") << "a comma of a text stays one";
  EXPECT_EQ(word(data, "name", 1), "c;d");
  const auto blanks = this->read("x y z name\n0,5 1 2 a,b\n1 2 3 c\n");
  ASSERT_EQ(blanks->GetNumberOfPoints(), 2) << m_error;
  EXPECT_EQ(blanks->GetPoint(0)[0], 0.5);
  EXPECT_EQ(word(blanks, "name", 0), "a,b");
}

TEST_F(TestTables, QuotesAndEmptyValues)
{
  const auto data = this->read("x,y,z,\"a,b\",n,\n"
                               "\"1\", \"2.5\" ,3,\"p,q\",1,\n"
                               "4,5,6, r \"s\" t ,,\n"
                               "\n"
                               "7,8,9,\"u \"\"v\"\"\",3,\n"
                               ",,,\"\",,\n");
  ASSERT_EQ(data->GetNumberOfPoints(), 3) << m_error;
  EXPECT_EQ(data->GetPointData()->GetNumberOfArrays(), 2);
  EXPECT_EQ(data->GetPoint(0)[1], 2.5);
  EXPECT_EQ(word(data, "a,b", 0), "p,q");
  EXPECT_EQ(word(data, "a,b", 1), "r \"s\" t");
  EXPECT_EQ(word(data, "a,b", 2), "u \"v\"");
  EXPECT_EQ(numbers(data, "n")->GetTuple1(0), 1);
  EXPECT_TRUE(std::isnan(numbers(data, "n")->GetTuple1(1)));
  expectError("x,y,z\n1,2,3\n4,,6\n", "line 3, column 3: expected a number for 'y', found nothing");
  expectError(
    "x,y,z\n1,2,3\n\n4,\"two\",6\n", "line 4, column 3: expected a number for 'y', found 'two'");
  expectError("x,y,z\n1,2,3\n4,5\n", "line 3, column 4: expected 3 values, found only 2");
  expectError("x,y,z\n1,2,3\n4,5,6,7\n", "line 3, column 7: expected 3 values, found 4");
  expectError("x,y,z\n1,2,3\n4,5 m,6\n", "expected a number for 'y', found '5 m'");
}

TEST_F(TestTables, TypesAreAsWideAsTheirValues)
{
  const auto data = this->read("x,y,z,small,large,real,text,late\n"
                               "1,2,3,1,1,1,1,1\n"
                               "1,2,3,-5,3000000000,1.5,N/A,2.5\n"
                               "1,2,3,7,4,2,3,word\n");
  ASSERT_EQ(data->GetNumberOfPoints(), 3) << m_error;
  EXPECT_EQ(numbers(data, "small")->GetDataType(), VTK_INT);
  EXPECT_EQ(numbers(data, "large")->GetDataTypeSize(), 8);
  EXPECT_EQ(numbers(data, "large")->GetTuple1(1), 3e9);
  EXPECT_EQ(numbers(data, "real")->GetDataType(), VTK_DOUBLE);
  EXPECT_EQ(word(data, "text", 1), "N/A");
  EXPECT_EQ(word(data, "late", 0), "1");
  EXPECT_EQ(word(data, "late", 2), "word");
}

TEST_F(TestTables, VectorsOfParaView)
{
  const auto data = this->read("Points:0,Points:1,Points:2,U:0,U:1,U:2,s:0,w:0,w:1,T_0,T_1\n"
                               "1,2,3,4,5,6,7,8,9,10,11\n1,2,3,4,0.5,6,7,8,none,10,11\n");
  ASSERT_EQ(data->GetNumberOfPoints(), 2) << m_error;
  vtkDataArray* u = numbers(data, "U");
  ASSERT_TRUE(u);
  EXPECT_EQ(u->GetNumberOfComponents(), 3);
  EXPECT_FALSE(u->HasAComponentName()) << "they are x, y and z, and not U:0, U:1 and U:2";
  EXPECT_EQ(u->GetComponent(1, 1), 0.5);
  EXPECT_EQ(u->GetComponent(1, 2), 6);
  EXPECT_EQ(numbers(data, "s:0")->GetTuple1(0), 7) << "one component makes no vector";
  EXPECT_EQ(numbers(data, "w:0")->GetTuple1(0), 8) << "nor do words";
  EXPECT_EQ(word(data, "w:1", 1), "none");
  EXPECT_EQ(numbers(data, "T_0")->GetTuple1(0), 10);
  const auto newer = this->read("Points_0,Points_1,Points_2,U_0,U_1\n1,2,3,4,5\n");
  ASSERT_TRUE(numbers(newer, "U")) << m_error;
  EXPECT_EQ(numbers(newer, "U")->GetComponent(0, 1), 5);
}

/// A table of random values with everything that may stand around them, and what they are.
struct RandomTable
{
  std::string text;
  std::vector<std::array<double, 4>> rows;
  std::vector<std::string> names;
};

RandomTable makeTable(std::mt19937& random, char separator, int rows)
{
  const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  RandomTable table;
  const std::string mark(1, separator);
  table.text = "x" + mark + "y" + mark + "name" + mark + "z" + mark + "n\n";
  for (int row = 0; row < rows; ++row)
  {
    for (int blank = below(40) == 0 ? 1 + below(3) : 0; blank > 0; --blank)
      table.text += below(2) ? "\n" : " " + mark + mark + "\r\n";
    std::array<double, 4> values{};
    const auto number = [&](double& value)
    {
      value = (below(2000001) - 1000000) / 1000.0;
      std::ostringstream out;
      out << value;
      value = std::stod(out.str());
      const std::string around = below(8) == 0 ? " " : "";
      const std::string quote = below(8) == 0 ? "\"" : "";
      return around + quote + out.str() + quote + around;
    };
    const std::string x = number(values[0]), y = number(values[1]), z = number(values[2]);
    std::string n = number(values[3]);
    if (below(10) == 0)
    {
      n = below(2) ? "" : " ";
      values[3] = std::nan("");
    }
    const std::string name = below(3) == 0 ? "q" + mark + "r\"s" : "w" + std::to_string(row);
    std::string written;
    for (const char c : name)
      written.append(c == '"' ? 2 : 1, c);
    const bool isQuoted = name.find(separator) != name.npos || below(4) == 0;
    const std::string quote(isQuoted ? 1 : 0, '"');
    table.text += x + mark + y + mark + quote + written + quote + mark + z + mark + n;
    table.text += (below(5) == 0 ? mark : "") + (below(2) ? "\n" : "\r\n");
    table.rows.push_back(values);
    table.names.push_back(name);
  }
  return table;
}

TEST_F(TestTables, RandomTablesInPieces)
{
  std::mt19937 random(7);
  for (const char separator : {',', ';', '\t'})
    for (const int count : {1, 10, 20000})
    {
      const RandomTable table = makeTable(random, separator, count);
      const std::string file =
        count == 10 ? writeGzip("t.csv.gz", table.text) : write("t.csv", table.text);
      for (const int pieces : {1, 3})
      {
        std::size_t row = 0;
        for (int piece = 0; piece < pieces; ++piece)
        {
          vtkNew<vtkMoteDelimitedPointsReader> reader;
          reader->SetFileName(file.c_str());
          reader->UpdatePiece(piece, pieces, 0);
          vtkPolyData* data = reader->GetOutput();
          for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i, ++row)
          {
            ASSERT_LT(row, table.rows.size());
            for (int axis = 0; axis < 3; ++axis)
              ASSERT_EQ(data->GetPoint(i)[axis], table.rows[row][axis]) << row;
            ASSERT_EQ(word(data, "name", i), table.names[row]) << row;
            const double n = numbers(data, "n")->GetTuple1(i);
            ASSERT_TRUE(
              n == table.rows[row][3] || (std::isnan(n) && std::isnan(table.rows[row][3])));
          }
        }
        EXPECT_EQ(row, table.rows.size()) << count << " in " << pieces;
      }
    }
}

TEST_F(TestTables, CutAtEveryByte)
{
  std::mt19937 random(8);
  for (const char separator : {',', ';'})
  {
    const RandomTable table = makeTable(random, separator, 8);
    for (std::size_t bytes = 0; bytes < table.text.size(); ++bytes)
    {
      const auto data = this->read(table.text.substr(0, bytes));
      // Either rows that are there, or one sentence.
      ASSERT_EQ(data->GetNumberOfPoints() == 0, !m_error.empty()) << bytes;
      ASSERT_LE(data->GetNumberOfPoints(), 8);
      ASSERT_EQ(m_error.find('\n'), std::string::npos) << m_error;
    }
  }
}

} // namespace
