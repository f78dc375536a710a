#ifndef MoteReaderTest_h
#define MoteReaderTest_h

#include "IOTestSupport.h"
#include "vtkMoteReaderTable.h"

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>

/// Reads texts with one reader.
template <class Reader>
class ReaderTest : public FileTest
{
protected:
  /// The points of a text; none after an error, which m_error tells.
  vtkSmartPointer<vtkPolyData> read(const std::string& text)
  {
    vtkNew<Reader> reader;
    reader->SetFileName(write("a.txt", text).c_str());
    m_error.clear();
    vtkMoteReaderTable::Read(reader, m_error);
    return reader->GetOutput();
  }

  void expectError(const std::string& text, const std::string& sentence)
  {
    EXPECT_EQ(this->read(text)->GetNumberOfPoints(), 0) << text;
    EXPECT_NE(m_error.find(sentence), std::string::npos) << m_error;
  }

  std::string m_error;
};

#endif
