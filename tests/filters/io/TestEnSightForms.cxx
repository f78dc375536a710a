// EnSight Gold in all the forms that the check goes through: blocks, every type of element, numbers
// of nodes and elements, steps in one file; and what it refuses.
#include "EnSightFile.h"
#include "IOTestSupport.h"
#include "MeshSamples.h"
#include "vtkMoteReaderTable.h"

#include "vtkAlgorithm.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <string>
#include <vector>

using samples::EnSightFile;

namespace
{

class TestEnSightForms : public FileTest
{
protected:
  using Write = std::function<void(EnSightFile&)>;

  /// A case of a geometry, and of more lines, such as those of variables.
  std::string caseOf(bool isBinary, const Write& geometry, const std::string& more = "")
  {
    EnSightFile file(path("a.geo"), isBinary);
    if (isBinary)
      file.text("C Binary");
    geometry(file);
    return write("a.case", "FORMAT\ntype: ensight gold\nGEOMETRY\nmodel: a.geo\n" + more);
  }

  static void head(EnSightFile& file, const std::string& ids = "off")
  {
    file.text("a mesh");
    file.text("of a test");
    file.text("node id " + ids);
    file.text("element id " + ids);
  }

  static void part(EnSightFile& file, int number, const std::string& name)
  {
    file.text("part");
    file.whole(number);
    file.text(name);
  }

  std::vector<vtkDataSet*> read(const std::string& file, double time = 0.0)
  {
    m_data = nullptr;
    const auto reader = vtkMoteReaderTable::MakeReader(file, m_error);
    if (reader)
      m_data = vtkMoteReaderTable::Read(reader, time, m_error);
    std::vector<vtkDataSet*> sets;
    if (auto* blocks = vtkCompositeDataSet::SafeDownCast(m_data))
    {
      const auto it = vtk::TakeSmartPointer(blocks->NewIterator());
      for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
        if (auto* set = vtkDataSet::SafeDownCast(it->GetCurrentDataObject()))
          sets.push_back(set);
    }
    return sets;
  }

  void expectError(const std::string& file, const std::string& sentence)
  {
    EXPECT_TRUE(this->read(file).empty());
    EXPECT_NE(m_error.find(sentence), std::string::npos) << m_error << " for " << sentence;
    EXPECT_EQ(m_error.find('\n'), std::string::npos) << m_error;
  }

  std::string m_error;
  vtkSmartPointer<vtkDataObject> m_data;
};

TEST_F(TestEnSightForms, Blocks)
{
  for (const bool isBinary : {false, true})
    for (const std::string kind : {"", " curvilinear", " rectilinear", " uniform"})
      for (const bool isBlanked : {false, true})
      {
        const std::string file = this->caseOf(
          isBinary,
          [&](EnSightFile& out)
          {
            head(out);
            part(out, 1, "a block");
            out.text("block" + kind + (isBlanked ? " iblanked" : ""));
            out.whole({3, 2, 2});
            if (kind == " rectilinear")
              out.reals({0, 1, 2, 0, 3, 0, 4});
            else if (kind == " uniform")
              out.reals({0, 0, 0, 1, 3, 4});
            else
              for (int axis = 0; axis < 3; ++axis)
                for (int i = 0; i < 12; ++i)
                  out.real(axis == 0 ? i % 3 : axis == 1 ? 3 * (i / 3 % 2) : 4 * (i / 6));
            if (isBlanked)
              for (int i = 0; i < 12; ++i)
                out.whole(1);
          },
          "VARIABLE\nscalar per node: p a.p\nscalar per element: q a.q\n");
        EnSightFile p(path("a.p"), isBinary), q(path("a.q"), isBinary);
        for (EnSightFile* values : {&p, &q})
        {
          values->text("values");
          values->text("part");
          values->whole(1);
          values->text("block");
        }
        for (int i = 0; i < 12; ++i)
          p.real(i);
        p.close();
        q.reals({5, 6});
        q.close();
        const auto sets = this->read(file);
        ASSERT_EQ(sets.size(), 1u) << m_error << kind << isBinary;
        EXPECT_EQ(sets[0]->GetNumberOfPoints(), 12);
        EXPECT_EQ(sets[0]->GetNumberOfCells(), 2);
        EXPECT_EQ(sets[0]->GetPoint(11)[0], 2.0);
        EXPECT_EQ(sets[0]->GetPoint(11)[1], 3.0);
        EXPECT_EQ(sets[0]->GetPoint(11)[2], 4.0);
        EXPECT_EQ(sets[0]->GetPointData()->GetArray("p")->GetComponent(11, 0), 11.0);
        EXPECT_EQ(sets[0]->GetCellData()->GetArray("q")->GetComponent(1, 0), 6.0);
      }
}

TEST_F(TestEnSightForms, EveryTypeOfElement)
{
  const std::vector<std::pair<std::string, int>> types = {{"point", 1}, {"bar2", 2}, {"bar3", 3},
    {"tria3", 3}, {"tria6", 6}, {"quad4", 4}, {"quad8", 8}, {"tetra4", 4}, {"tetra10", 10},
    {"pyramid5", 5}, {"pyramid13", 13}, {"penta6", 6}, {"penta15", 15}, {"hexa8", 8},
    {"hexa20", 20}};
  for (const bool isBinary : {false, true})
    for (const std::string ids : {"off", "assign", "given", "ignore"})
    {
      const bool hasIds = ids == "given" || ids == "ignore";
      const std::string file = this->caseOf(isBinary,
        [&](EnSightFile& out)
        {
          head(out, ids);
          if (!isBinary && ids == "off")
          {
            out.text("extents");
            for (int axis = 0; axis < 3; ++axis)
              out.text(" 0.00000e+00 2.00000e+01");
          }
          part(out, 1, "all");
          out.text("coordinates");
          out.whole(20);
          if (hasIds)
            for (int i = 0; i < 20; ++i)
              out.whole(100 + i);
          for (int axis = 0; axis < 3; ++axis)
            for (int i = 0; i < 20; ++i)
              out.real(i * (axis + 1) % 7);
          for (const auto& [type, size] : types)
          {
            out.text(type);
            out.whole(2);
            if (hasIds)
            {
              out.whole(7);
              out.whole(8);
            }
            for (int element = 0; element < 2; ++element)
            {
              std::vector<int> nodes;
              for (int i = 0; i < size; ++i)
                nodes.push_back(1 + i);
              out.whole(nodes);
            }
          }
        });
      const auto sets = this->read(file);
      ASSERT_EQ(sets.size(), 1u) << m_error << ' ' << ids << isBinary;
      EXPECT_EQ(sets[0]->GetNumberOfPoints(), 20);
      EXPECT_EQ(sets[0]->GetNumberOfCells(), 30);
      EXPECT_EQ(sets[0]->GetPoint(3)[2], 9 % 7);
    }
}

TEST_F(TestEnSightForms, PolygonsAndPolyhedra)
{
  for (const bool isBinary : {false, true})
  {
    const std::string file = this->caseOf(isBinary,
      [&](EnSightFile& out)
      {
        head(out);
        part(out, 1, "all");
        out.text("coordinates");
        out.whole(5);
        out.reals({0, 1, 0, 0, 1, 0, 0, 1, 0, 1, 0, 0, 0, 1, 0});
        out.text("nsided");
        out.whole(2);
        out.whole(3);
        out.whole(4);
        out.whole({1, 2, 3});
        out.whole({1, 2, 5, 3});
        out.text("nfaced");
        out.whole(1);
        out.whole(4); // faces
        for (int face = 0; face < 4; ++face)
          out.whole(3);
        for (const auto& face :
          std::vector<std::vector<int>>{{1, 3, 2}, {1, 2, 4}, {2, 3, 4}, {3, 1, 4}})
          out.whole(face);
      });
    const auto sets = this->read(file);
    ASSERT_EQ(sets.size(), 1u) << m_error << isBinary;
    EXPECT_EQ(sets[0]->GetNumberOfCells(), 3);
    EXPECT_EQ(sets[0]->GetCellType(2), VTK_POLYHEDRON);
  }
}

TEST_F(TestEnSightForms, StepsInOneFile)
{
  const auto writeCase = [this](const std::string& times, const std::string& files)
  {
    return write(
      "steps.case", "FORMAT\ntype: ensight gold\nGEOMETRY\nmodel: 1 1 steps.geo\nVARIABLE\n"
                    "scalar per node: 1 1 p steps.p\nTIME\ntime set: 1\nnumber of steps: " +
                      times + "FILE\nfile set: 1\n" + files);
  };
  const std::string two = "2\ntime values: 0 0.5\n", three = "3\ntime values: 0 0.5 1\n";
  for (const bool isBinary : {false, true})
  {
    const std::string file = samples::writeEnSightSteps(path(""), isBinary);
    for (const int step : {0, 1})
    {
      const auto sets = this->read(file, 0.5 * step);
      ASSERT_EQ(sets.size(), 1u) << m_error;
      EXPECT_EQ(sets[0]->GetPoint(2)[2], step);
      EXPECT_EQ(sets[0]->GetPointData()->GetArray("p")->GetComponent(0, 0), 1.0 + step);
    }
    this->expectError(writeCase(two, "number of steps: 3\n"), "not the steps of its time set");
    this->expectError(writeCase(two, ""), "not the steps of its time set");
    this->expectError(
      writeCase(two, "filename index: 1\nnumber of steps: 1\n"), "spread over several files");
    EXPECT_EQ(
      this->read(writeCase(two, "number of steps: 2\nfile set: 2\nfilename index: 1\n")).size(),
      1u);
    this->expectError(writeCase(two, "number of steps: x\n"), "has no number");
    this->expectError(
      writeCase(three, "number of steps: 3\n"), "holds 2 of the 3 time steps of its set");
  }
}

TEST_F(TestEnSightForms, TheSecondDescriptionMayBeBlank)
{
  const std::string mesh = "node id off\nelement id off\npart\n1\nwing\ncoordinates\n"
                           "3\n0\n1\n0\n0\n0\n1\n0\n0\n0\ntria3\n1\n1 2 3\n";
  const std::string file = write("a.case", "FORMAT\ntype: ensight gold\nGEOMETRY\nmodel: a.geo\n");
  for (const std::string second : {"", "of a wing", "# wing"})
  {
    write("a.geo", "a\n" + second + "\n" + mesh);
    const auto sets = this->read(file);
    ASSERT_EQ(sets.size(), 1u) << m_error;
    EXPECT_EQ(sets[0]->GetNumberOfCells(), 1);
  }
  // A line more, and VTK's reader found no part, and crashed on values.
  write("a.geo", "a\n\nof a wing\n" + mesh);
  this->expectError(
    file, "expected 'node id' with off, assign, given or ignore, found 'of a wing'");
}

TEST_F(TestEnSightForms, VariablesThatTheReaderWouldCrashOn)
{
  const auto refuse = [this](const std::string& variable, const std::string& sentence)
  {
    this->expectError(
      write("a.case",
        "FORMAT\ntype: ensight gold\nGEOMETRY\nmodel: a.geo\nVARIABLE\n" + variable + " p a.p\n"),
      sentence);
  };
  for (const std::string kind :
    {"vector FILEscalar per node", "tensor per node", "tensor x per node", "scalar per nodes",
      "scalar each node", "scalar symm per node", "per node", "scalar per"})
    refuse(kind + ":", "and not '" + kind + "'");
  refuse("scalar per node:x", "no blank stands behind the colon of 'scalar per node'");
  refuse("scalar per node :", "blanks stand before the colon of 'scalar per node'");
}

TEST_F(TestEnSightForms, WordsAtWhichTheReaderWouldNeverEnd)
{
  const auto refuse = [this](const std::string& lines, const std::string& sentence)
  { this->expectError(write("a.case", "FORMAT\ntype: ensight gold\n" + lines), sentence); };
  const std::string geometry = "GEOMETRY\nmodel: a.geo\n",
                    values = "VARIABLE\nscalar per node: p a.p\n";
  refuse("GEOMETRY\nmodel: none.geo\n" + values + "MATERIAL\na: b\n", "none.geo");
  write("a.geo", "a\n");
  refuse(geometry + "GEOMETRY\nmodel: a.geo\n", "the section GEOMETRY comes twice");
  refuse(geometry + "model: b.geo\n", "names two models");
  refuse("GEOME\n" + geometry, "behind the type of the format comes a section");
  refuse("version: 1\n" + geometry, "behind the type of the format comes a section");
  refuse(geometry + "FILE\nfile set: 1\nnumber of files: 1\n", "have no 'number of files'");
  for (const std::string name : {"MATERIAL", "SCRIPTS", "BLOCK_CONTINUATION"})
  {
    const std::string section = name + "\na: b\n";
    refuse(geometry + section, "the section " + name + " is passed over behind VARIABLE or TIME");
    refuse(
      geometry + values + section + "TIME\n", "the section " + name + " is passed over at the");
  }
  refuse(geometry + "FILE\nfile set: 1\nnumber of steps: 1\n", "the model is of none");
}

TEST_F(TestEnSightForms, WhatIsRefused)
{
  const auto refuse = [this](const std::string& lines, const std::string& sentence)
  {
    write("a.geo", lines);
    this->expectError(
      write("a.case", "FORMAT\ntype: ensight gold\nGEOMETRY\nmodel: a.geo\n"), sentence);
  };
  const std::string head = "a\nb\nnode id off\nelement id off\n", one = head + "part\n1\nx\n";
  const std::string mesh = one + "coordinates\n3\n0\n1\n0\n0\n0\n1\n0\n0\n0\n";
  refuse("a\nb\nnode id perhaps\n", "expected 'node id'");
  refuse("a\nb\nnode id off\nelement\n", "expected 'element id'");
  refuse(head, "there is no part");
  refuse(head + "parts\n", "expected a part");
  refuse(head + "part\n0\n", "a part cannot have the number 0");
  refuse(mesh + "part\n1\ny\n", "a part cannot have the number 1");
  refuse(one + "coordinates\n-3\n", "there cannot be -3 nodes");
  refuse(mesh + "tria3\n-1\n", "there cannot be -1 elements");
  refuse(mesh + "tria3\n1\n1 2 4\n", "names the node 4");
  refuse(mesh + "tria3\n1\n1 2 3\ntria3\n1\n1 2 3\n", "come twice");
  refuse(mesh + "nsided\n1\n0\n", "cannot have the size 0");
  refuse(one + "block range\n", "blocks with 'range' are not read");
  refuse(one + "block\n0 1 1\n", "a block cannot have 0 nodes");
  refuse("BEGIN TIME STEP\n" + mesh, "has no end");
  refuse("BEGIN TIME STEP\n" + mesh + "END TIME STEP\nmore\n", "expected BEGIN TIME STEP");
  const auto refuseValues = [this, &mesh](const std::string& lines, const std::string& sentence)
  {
    write("a.geo", mesh + "tria3\n1\n1 2 3\n");
    write("a.p", lines);
    this->expectError(
      write("a.case",
        "FORMAT\ntype: ensight gold\nGEOMETRY\nmodel: a.geo\nVARIABLE\nscalar per node: p a.p\n"),
      sentence);
  };
  refuseValues("p\nparts\n", "expected a part");
  refuseValues("p\npart\n2\n", "the geometry has no part 2");
  refuseValues("p\npart\n1\ntria3\n1\n", "has no 'tria3' to have these values");
}

} // namespace
