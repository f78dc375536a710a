#ifndef MoteParticleFormatsTest_h
#define MoteParticleFormatsTest_h

// What the tests of formats of particles share.

#include "IOTestSupport.h"
#include "vtkMoteReaderTable.h"

#include "vtkAlgorithm.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

/// The bytes of numbers, or of numbers of the other byte order.
template <class Number>
std::string bytesOf(const std::vector<Number>& numbers, bool swapped = false)
{
  std::string bytes;
  for (const Number& number : numbers)
  {
    std::string one(reinterpret_cast<const char*>(&number), sizeof number);
    if (swapped)
      std::reverse(one.begin(), one.end());
    bytes += one;
  }
  return bytes;
}

/// Reads files of particles through the table of readers.
class ParticleFormatsTest : public FileTest
{
protected:
  vtkPolyData* read(const std::string& file, double time = -1e300)
  {
    m_reader = vtkMoteReaderTable::MakeReader(file, m_error);
    EXPECT_TRUE(m_reader) << m_error;
    if (!m_reader)
      return nullptr;
    m_times = vtkMoteReaderTable::GetTimeSteps(m_reader, m_error);
    m_data = vtkMoteReaderTable::Read(m_reader, time, m_error);
    EXPECT_EQ(m_error, "");
    return vtkPolyData::SafeDownCast(m_data);
  }

  void expectError(const std::string& file, const std::string& sentence)
  {
    std::string error;
    const auto reader = vtkMoteReaderTable::MakeReader(file, error);
    if (reader)
    {
      EXPECT_FALSE(vtkMoteReaderTable::Read(reader, error));
    }
    EXPECT_NE(error.find(sentence), std::string::npos) << error;
    EXPECT_EQ(error.find('\n'), std::string::npos) << error;
  }

  static double value(vtkPolyData* data, const char* array, vtkIdType i, int component = 0)
  {
    vtkDataArray* found = data->GetPointData()->GetArray(array);
    return found ? found->GetComponent(i, component) : HUGE_VAL;
  }

  static void expectPoint(vtkPolyData* data, vtkIdType i, double x, double y, double z)
  {
    ASSERT_LT(i, data->GetNumberOfPoints());
    const double* point = data->GetPoint(i);
    EXPECT_NEAR(point[0], x, 1e-12) << i;
    EXPECT_NEAR(point[1], y, 1e-12) << i;
    EXPECT_NEAR(point[2], z, 1e-12) << i;
  }

  /// Every beginning of a file is refused or holds what the whole does, and two halves are the
  /// whole.
  template <class Reader>
  void cutAndPart(
    const std::string& text, const std::string& ending, vtkIdType points, std::size_t mayLack = 0)
  {
    for (std::size_t size = 0; size < text.size() - mayLack; ++size)
    {
      std::string error;
      const auto reader =
        vtkMoteReaderTable::MakeReader(write("cut" + ending, text.substr(0, size)), error);
      const auto data = reader ? vtkMoteReaderTable::Read(reader, error) : nullptr;
      EXPECT_EQ(data == nullptr, !error.empty()) << size;
      EXPECT_EQ(error.find('\n'), std::string::npos) << error;
    }
    const std::string file = write("whole" + ending, text);
    vtkNew<Reader> all;
    all->SetFileName(file.c_str());
    all->Update();
    ASSERT_EQ(all->GetOutput()->GetNumberOfPoints(), points);
    vtkIdType done = 0;
    for (int piece = 0; piece < 3; ++piece)
    {
      vtkNew<Reader> part;
      part->SetFileName(file.c_str());
      part->UpdateInformation();
      part->UpdatePiece(piece, 3, 0);
      vtkPolyData* own = part->GetOutput();
      vtkPointData *mine = own->GetPointData(), *whole = all->GetOutput()->GetPointData();
      ASSERT_EQ(mine->GetNumberOfArrays(), whole->GetNumberOfArrays());
      for (vtkIdType i = 0; i < own->GetNumberOfPoints(); ++i, ++done)
      {
        for (int axis = 0; axis < 3; ++axis)
          EXPECT_EQ(own->GetPoint(i)[axis], all->GetOutput()->GetPoint(done)[axis]);
        for (int a = 0; a < whole->GetNumberOfArrays(); ++a)
          for (int c = 0; c < whole->GetAbstractArray(a)->GetNumberOfComponents(); ++c)
            expectSame(mine->GetAbstractArray(a), i, whole->GetAbstractArray(a), done, c);
      }
    }
    EXPECT_EQ(done, points);
  }

  static void expectSame(
    vtkAbstractArray* mine, vtkIdType i, vtkAbstractArray* whole, vtkIdType k, int component)
  {
    const int each = whole->GetNumberOfComponents();
    EXPECT_EQ(mine->GetVariantValue(each * i + component).ToString(),
      whole->GetVariantValue(each * k + component).ToString())
      << whole->GetName();
  }

  std::string m_error;
  vtkSmartPointer<vtkAlgorithm> m_reader;
  vtkSmartPointer<vtkDataObject> m_data;
  std::vector<double> m_times;
};

#endif
