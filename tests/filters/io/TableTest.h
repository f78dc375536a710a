#ifndef MoteTableTest_h
#define MoteTableTest_h

// What tests share that read files by the table of readers, and ask for sentences.

#include "IOTestSupport.h"
#include "vtkMoteReaderTable.h"

#include "vtkAlgorithm.h"
#include "vtkDataObject.h"
#include "vtkSmartPointer.h"

#include <string>

class TableTest : public FileTest
{
protected:
  /// Reads a file into m_data, and answers what was wrong with it; empty where nothing was.
  std::string errorOf(const std::string& file)
  {
    std::string error;
    const auto reader = vtkMoteReaderTable::MakeReader(file, error);
    m_data = reader ? vtkMoteReaderTable::Read(reader, error) : nullptr;
    return error;
  }

  /// One sentence with these words, and no data.
  void expectError(const std::string& file, const std::string& words)
  {
    const std::string error = errorOf(file);
    EXPECT_FALSE(m_data);
    EXPECT_NE(error.find(words), std::string::npos) << error;
    EXPECT_EQ(error.find('\n'), std::string::npos) << error;
  }

  vtkSmartPointer<vtkDataObject> m_data;
};

#endif
