// Every kind of bad dump: one clear sentence, and an empty output.
#include "IOTestSupport.h"
#include "vtkMoteLAMMPSDumpReader.h"
#include "vtkMoteReaderTable.h"

#include "vtkDataArraySelection.h"
#include "vtkErrorCode.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

namespace
{

class TestLAMMPSReaderErrors : public FileTest
{
protected:
  /// Reads after a good file, so that what is left over from it would show.
  void expectError(const std::string& file, unsigned long code, const std::string& sentence)
  {
    std::string error;
    m_reader->SetFileName(
      write("good.dump", dumpFrame(0, 1, "id type x y z", "1 1 1 1 1\n")).c_str());
    ASSERT_TRUE(vtkMoteReaderTable::Read(m_reader, error));
    ASSERT_EQ(m_reader->GetOutput()->GetNumberOfPoints(), 1);
    m_reader->SetFileName(file.c_str());
    EXPECT_FALSE(vtkMoteReaderTable::Read(m_reader, error));
    EXPECT_EQ(error, m_reader->GetLastErrorMessage());
    EXPECT_EQ(error.find(file + (sentence[0] == ',' ? "" : ": ") + sentence), 0u) << error;
    EXPECT_EQ(m_reader->GetErrorCode(), code) << error;
    EXPECT_EQ(m_reader->GetOutput()->GetNumberOfPoints(), 0);
    EXPECT_EQ(m_reader->GetOutput()->GetNumberOfCells(), 0);
    EXPECT_EQ(m_reader->GetOutput()->GetPointData()->GetNumberOfArrays(), 0);
    std::cout << "  " << error << "\n";
  }

  std::string frame(
    const std::string& rows, long atoms = 2, const std::string& columns = "id type x y z")
  {
    return write("bad.dump", dumpFrame(0, atoms, columns, rows));
  }

  vtkNew<vtkMoteLAMMPSDumpReader> m_reader;
};

TEST_F(TestLAMMPSReaderErrors, FilesThatCannotBeRead)
{
  expectError(path("missing.dump"), vtkErrorCode::FileNotFoundError, "there is no such file");
  expectError(path("."), vtkErrorCode::CannotOpenFileError, "this is a directory, not a file");
  expectError("/dev/null", vtkErrorCode::CannotOpenFileError, "this is not a regular file");
  expectError(write("empty.dump", ""), vtkErrorCode::PrematureEndOfFileError, "the file is empty");
  expectError(
    writeGzip("empty.dump.gz", ""), vtkErrorCode::PrematureEndOfFileError, "the file is empty");
}

TEST_F(TestLAMMPSReaderErrors, NoPermission)
{
  if (::geteuid() == 0)
    GTEST_SKIP() << "root may read every file";
  const std::string file = write("secret.dump", dumpFrame(0, 0, "x y z", ""));
  std::filesystem::permissions(file, std::filesystem::perms::none);
  expectError(file, vtkErrorCode::CannotOpenFileError, "you have no permission to read this file");
}

TEST_F(TestLAMMPSReaderErrors, OtherFormats)
{
  expectError(write("a.dump", "hello world\n"), vtkErrorCode::UnrecognizedFileTypeError,
    ", line 1: this is no LAMMPS text dump: expected 'ITEM: TIMESTEP', found 'hello world'");
  expectError(write("b.dump", std::string("\x01\0\x02\0", 4)),
    vtkErrorCode::UnrecognizedFileTypeError, "this is a binary file, not a LAMMPS text dump");
  expectError(write("c.dump", std::string("\xf8\xff\xff\xff\xff\xff\xff\xff", 8) + "DUMPATOM"),
    vtkErrorCode::PrematureEndOfFileError, "the file ends within a time step: it is truncated");
  expectError(write("d.dump", "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ENTRIES\n3\n"),
    vtkErrorCode::FileFormatError,
    ", line 3: 'ITEM: NUMBER OF ENTRIES' belongs to no dump of atoms");
}

TEST_F(TestLAMMPSReaderErrors, Truncation)
{
  expectError(frame("1 1 1 1 1\n"), vtkErrorCode::PrematureEndOfFileError,
    ", line 11: step 0 announces 2 atoms, but the file ends after 1: it is truncated");
  expectError(frame("1 1 1 1 1\n2 1 0.1 0.1 0."), vtkErrorCode::PrematureEndOfFileError,
    ", line 11: the last line has no line end, so the file may have been cut short");
  expectError(write("head.dump", "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n"),
    vtkErrorCode::PrematureEndOfFileError, ", line 4: the file ends where the number of atoms");
  expectError(write("step.dump", "ITEM: TIMESTEP\n"), vtkErrorCode::PrematureEndOfFileError,
    ", line 2: the file ends where the number of the time step");
}

TEST_F(TestLAMMPSReaderErrors, DamagedGzip)
{
  std::string rows;
  for (int i = 0; i < 5000; ++i)
    rows += std::to_string(i) + " 1 " + std::to_string(i * 0.37) + " 1 1\n";
  const std::string file = writeGzip("a.dump.gz", dumpFrame(0, 5000, "id type x y z", rows));
  const auto bytes = std::filesystem::file_size(file);
  truncate("a.dump.gz", bytes * 2 / 3);
  expectError(file, vtkErrorCode::PrematureEndOfFileError,
    "the gzip data end too early: the file is truncated");
  truncate("a.dump.gz", 5);
  expectError(file, vtkErrorCode::PrematureEndOfFileError, "the gzip data end too early");
  writeGzip("a.dump.gz", dumpFrame(0, 5000, "id type x y z", rows));
  std::fstream damage(file, std::ios::in | std::ios::out | std::ios::binary);
  damage.seekp(static_cast<std::streamoff>(bytes / 2));
  damage << std::string(64, '\xff');
  damage.close();
  std::string error;
  m_reader->SetFileName(file.c_str());
  EXPECT_FALSE(vtkMoteReaderTable::Read(m_reader, error));
  EXPECT_EQ(m_reader->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_NE(error, "");
}

TEST_F(TestLAMMPSReaderErrors, AtomCounts)
{
  expectError(frame("1 1 1 1 1\n", 0), vtkErrorCode::FileFormatError,
    ", line 10: step 0 announces 0 atoms, but more follow: '1 1 1 1 1'");
  expectError(frame("1 1 1 1 1\n2 1 1 1 1\n3 1 1 1 1\n"), vtkErrorCode::FileFormatError,
    ", line 12: step 0 announces 2 atoms, but more follow: '3 1 1 1 1'");
  expectError(write("few.dump", dumpFrame(0, 3, "id type x y z", "1 1 1 1 1\n") +
                                  dumpFrame(1, 0, "id type x y z", "")),
    vtkErrorCode::FileFormatError,
    ", line 11: step 0 announces 3 atoms, but 'ITEM: TIMESTEP' follows after 1");
  expectError(frame("", -5), vtkErrorCode::FileFormatError,
    ", line 4: expected the number of atoms, an integer from 0 on, found '-5'");
  expectError(frame("1 1 1 1 1\n", 9000000000000000000L), vtkErrorCode::PrematureEndOfFileError,
    ", line 11: step 0 announces 9000000000000000000 atoms, but the file ends after 1");
  expectError(
    write("huge.dump", "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n99999999999999999999\n"),
    vtkErrorCode::FileFormatError, ", line 4: expected the number of atoms");
}

TEST_F(TestLAMMPSReaderErrors, Values)
{
  expectError(frame("1 1 1 1 1\n2 1 1 abc 1\n"), vtkErrorCode::FileFormatError,
    ", line 11, column 7: expected a number for 'y', found 'abc'");
  expectError(frame("one 1 1 1 1\n2 1 1 1 1\n"), vtkErrorCode::FileFormatError,
    ", line 10, column 1: expected a number for 'id', found 'one'");
  expectError(frame("1 1 1 1 1\n2 1 1 1\n"), vtkErrorCode::FileFormatError,
    ", line 11, column 8: expected 5 values, found only 4 ('z' is missing)");
  expectError(frame("1 1 1 1 1 1\n2 1 1 1 1\n"), vtkErrorCode::FileFormatError,
    ", line 10, column 11: expected 5 values, found 6");
  expectError(frame("1 1 1 1 1\n\n"), vtkErrorCode::FileFormatError,
    ", line 11, column 1: expected 5 values, found an empty line");
}

TEST_F(TestLAMMPSReaderErrors, Headers)
{
  expectError(frame("1 1 1 1\n2 1 1 1\n", 2, "id type x z"), vtkErrorCode::FileFormatError,
    ", line 9: no column gives the y coordinate (y, yu, ys or ysu); the columns are id type x z");
  expectError(write("a.dump", "ITEM: TIMESTEP\nsoon\n"), vtkErrorCode::FileFormatError,
    ", line 2: expected the number of the time step, found 'soon'");
  expectError(write("b.dump", dumpFrame(0, 0, "x y z", "", "pp pp pp\n0 1\n0\n0 1\n")),
    vtkErrorCode::FileFormatError, ", line 7: expected low and high bounds (2 numbers), found '0'");
  expectError(write("c.dump", "ITEM: TIMESTEP\n0\nITEM: ATOMS x y z\n"),
    vtkErrorCode::FileFormatError, ", line 3: 'ITEM: ATOMS' without a number of atoms before it");
  expectError(
    write("d.dump", "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: ATOMS xs y z\n0 0 0\n"),
    vtkErrorCode::FileFormatError, ", line 5: scaled coordinates need 'ITEM: BOX BOUNDS'");
  expectError(write("e.dump", dumpFrame(0, 1, "xs y z", "0 0 0\n",
                                "abc origin pp pp pp\n1 0 0 0\n0 1 0 0\n0 0 1 0\n")),
    vtkErrorCode::FileFormatError, ", line 9: in a general triclinic box");
}

TEST_F(TestLAMMPSReaderErrors, UnknownArray)
{
  const std::string file = frame("1 1 1 1 1\n2 1 1 1 1\n");
  m_reader->GetPointDataArraySelection()->EnableArray("c_nothing");
  m_reader->SetFileName(file.c_str());
  std::string error;
  EXPECT_FALSE(vtkMoteReaderTable::Read(m_reader, error));
  EXPECT_EQ(error, file + ": there is no array 'c_nothing' to read; there are 'id', 'type'");
  EXPECT_EQ(m_reader->GetOutput()->GetNumberOfPoints(), 0);
  m_reader->GetPointDataArraySelection()->DisableArray("c_nothing");
  EXPECT_TRUE(vtkMoteReaderTable::Read(m_reader, error)) << error;
}

TEST_F(TestLAMMPSReaderErrors, NoFileNameAndSeriesWithAMissingFile)
{
  std::string error;
  EXPECT_FALSE(vtkMoteReaderTable::Read(m_reader, error));
  EXPECT_NE(error.find("no file name has been set"), std::string::npos) << error;
  m_reader->AddFileName(frame("1 1 1 1 1\n2 1 1 1 1\n").c_str());
  m_reader->AddFileName(path("missing.dump").c_str());
  EXPECT_FALSE(vtkMoteReaderTable::Read(m_reader, error));
  EXPECT_NE(error.find("missing.dump: there is no such file"), std::string::npos) << error;
  EXPECT_EQ(m_reader->GetOutput()->GetNumberOfPoints(), 0);
}

TEST_F(TestLAMMPSReaderErrors, ADamagedStepIsAnErrorOnlyWhenAskedFor)
{
  const std::string file =
    write("a.dump", dumpFrame(0, 1, "x y z", "1 2 3\n") + dumpFrame(1, 2, "x y z", "1 2 3\n"));
  m_reader->SetFileName(file.c_str());
  std::string error;
  EXPECT_TRUE(vtkMoteReaderTable::Read(m_reader, error)) << error;
  EXPECT_EQ(m_reader->GetOutput()->GetNumberOfPoints(), 1);
  EXPECT_FALSE(vtkMoteReaderTable::Read(m_reader, 1.0, error));
  EXPECT_NE(error.find("step 1 announces 2 atoms"), std::string::npos) << error;
  EXPECT_EQ(m_reader->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_TRUE(vtkMoteReaderTable::Read(m_reader, 0.0, error)) << error;
  EXPECT_EQ(m_reader->GetOutput()->GetNumberOfPoints(), 1);
}

} // namespace
