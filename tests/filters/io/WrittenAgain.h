#ifndef MoteWrittenAgain_h
#define MoteWrittenAgain_h

#include "vtkMoteReaderTable.h"

#include "vtkAlgorithm.h"
#include "vtkDataObject.h"
#include "vtkSmartPointer.h"

#include <gtest/gtest.h>
#include <string>

/// What a file holds, read by Mote; null, and a failure of the test, where it cannot be read.
template <typename Data>
vtkSmartPointer<Data> readAgain(const std::string& file)
{
  std::string error;
  const auto reader = vtkMoteReaderTable::MakeReader(file, error);
  EXPECT_TRUE(reader) << error;
  if (!reader)
    return nullptr;
  vtkSmartPointer<vtkDataObject> data = vtkMoteReaderTable::Read(reader, error);
  EXPECT_TRUE(data) << error;
  return Data::SafeDownCast(data);
}

#endif
