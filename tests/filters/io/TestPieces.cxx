// Readers that give each of several processes its piece: together the pieces are the whole.
#include "IOTestSupport.h"
#include "vtkMoteFileSeriesReader.h"
#include "vtkMoteLAMMPSDumpReader.h"
#include "vtkMotePointsReader.h"
#include "vtkMoteXYZReader.h"

#include "vtkDataArray.h"
#include "vtkDataArraySelection.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <random>
#include <sstream>
#include <vector>

namespace
{

class TestPieces : public FileTest
{
protected:
  /// Lines of a table of random points, as many as asked for; the last has a word of its own.
  static std::string rows(int count, bool hasIds)
  {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> uniform(0.0, 10.0);
    const char* const words[] = {"Cu", "Zr", "Al"};
    std::ostringstream text;
    for (int i = 0; i < count; ++i)
    {
      if (hasIds)
        text << 1000 + i << ' ';
      text << (i + 1 == count ? "Ag" : words[static_cast<std::size_t>(i) % 3]) << ' ';
      for (int axis = 0; axis < 3; ++axis)
        text << uniform(random) << (axis < 2 ? ' ' : '\n');
    }
    return text.str();
  }

  /// All points of the pieces, one piece after the other, must be those of the whole, and their
  /// arrays too.
  template <class Reader>
  void expectWhole(const std::string& file, vtkIdType count)
  {
    vtkNew<Reader> all;
    all->SetFileName(file.c_str());
    all->Update();
    ASSERT_EQ(all->GetOutput()->GetNumberOfPoints(), count);
    for (const int pieces : {1, 2, 3, 7})
    {
      SCOPED_TRACE(file + " in " + std::to_string(pieces));
      vtkIdType done = 0;
      for (int piece = 0; piece < pieces; ++piece)
      {
        vtkNew<Reader> part;
        part->SetFileName(file.c_str());
        part->UpdateInformation();
        part->UpdatePiece(piece, pieces, 0);
        ASSERT_EQ(part->GetLastErrorMessage(), "");
        vtkPolyData* own = part->GetOutput();
        EXPECT_EQ(own->GetNumberOfVerts(), own->GetNumberOfPoints());
        EXPECT_NEAR(own->GetNumberOfPoints(), static_cast<double>(count) / pieces, 1.0);
        this->expectRows(own, all->GetOutput(), done);
        done += own->GetNumberOfPoints();
      }
      EXPECT_EQ(done, count);
    }
  }

  void expectRows(vtkPolyData* own, vtkPolyData* all, vtkIdType first)
  {
    vtkPointData *mine = own->GetPointData(), *whole = all->GetPointData();
    ASSERT_EQ(mine->GetNumberOfArrays(), whole->GetNumberOfArrays());
    EXPECT_EQ(own->GetFieldData()->GetNumberOfArrays(), all->GetFieldData()->GetNumberOfArrays());
    for (vtkIdType i = 0; i < own->GetNumberOfPoints(); ++i)
    {
      for (int axis = 0; axis < 3; ++axis)
        ASSERT_EQ(own->GetPoint(i)[axis], all->GetPoint(first + i)[axis]) << i;
      for (int a = 0; a < whole->GetNumberOfArrays(); ++a)
      {
        ASSERT_EQ(mine->GetAbstractArray(a)->GetVariantValue(i),
          whole->GetAbstractArray(a)->GetVariantValue(first + i))
          << whole->GetAbstractArray(a)->GetName() << " " << i;
      }
    }
  }
};

TEST_F(TestPieces, OfDumps)
{
  for (const int count : {0, 1, 5, 20'000})
  {
    const std::string columns = "id element xs ys zs";
    const std::string frames = dumpFrame(1, count, columns, rows(count, true)) +
                               dumpFrame(2, 2, columns, "1 Ni 0 0 0\n2 Ni 1 1 1\n");
    this->expectWhole<vtkMoteLAMMPSDumpReader>(write("a.dump", frames), count);
    this->expectWhole<vtkMoteLAMMPSDumpReader>(writeGzip("b.dump.gz", frames), count);
  }
}

TEST_F(TestPieces, OfXYZ)
{
  for (const int count : {1, 5, 20'000})
  {
    const std::string text = std::to_string(count) + "\nof atoms\n" + rows(count, false);
    this->expectWhole<vtkMoteXYZReader>(write("a.xyz", text), count);
    this->expectWhole<vtkMoteXYZReader>(writeGzip("b.xyz.gz", text), count);
  }
}

TEST_F(TestPieces, OfASeries)
{
  vtkNew<vtkMoteFileSeriesReader> reader;
  for (const int number : {0, 1})
  {
    const std::string name = "a." + std::to_string(number) + ".xyz";
    reader->AddFileName(
      this->write(name, std::to_string(90 + number) + "\nof atoms\n" + rows(90 + number, false))
        .c_str());
  }
  for (const int step : {1, 0})
  {
    vtkIdType count = 0;
    for (const int piece : {0, 1, 2, 3})
    {
      reader->UpdateInformation();
      reader->UpdateTimeStep(step, piece, 4, 0);
      ASSERT_EQ(reader->GetLastErrorMessage(), "");
      auto* own = vtkPolyData::SafeDownCast(reader->GetOutputDataObject(0));
      ASSERT_TRUE(own);
      EXPECT_LE(own->GetNumberOfPoints(), 23);
      count += own->GetNumberOfPoints();
    }
    EXPECT_EQ(count, 90 + step);
  }
}

TEST_F(TestPieces, OfPoints)
{
  std::string text;
  for (int i = 0; i < 10'001; ++i)
    text += std::to_string(i) + " 0.5 -" + std::to_string(i) + "\n";
  this->expectWhole<vtkMotePointsReader>(write("a.pts", text), 10'001);
  text.pop_back(); // the last line may lack its end
  this->expectWhole<vtkMotePointsReader>(write("b.pts", text), 10'001);
}

TEST_F(TestPieces, DamageIsToldByWhomItConcerns)
{
  std::string text = rows(1000, true);
  text.replace(text.rfind("Ag"), 2, "Ag Ag"); // one value too many, in the last line
  const std::string file = write("a.dump", dumpFrame(1, 1000, "id element x y z", text));
  for (const int piece : {0, 3})
  {
    vtkNew<vtkMoteLAMMPSDumpReader> reader;
    reader->GetPointDataArraySelection()->DisableAllArrays();
    reader->SetFileName(file.c_str());
    reader->UpdateInformation();
    reader->GetPointDataArraySelection()->DisableAllArrays();
    vtkObject::GlobalWarningDisplayOff();
    reader->UpdatePiece(piece, 4, 0);
    vtkObject::GlobalWarningDisplayOn();
    EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), piece == 0 ? 250 : 0);
    const std::string said = reader->GetLastErrorMessage();
    EXPECT_EQ(said.empty(), piece == 0) << said;
    const bool namesLine = said.find("1009") != std::string::npos;
    EXPECT_EQ(namesLine, piece == 3) << said << ": the line of the file";
  }
}

} // namespace
