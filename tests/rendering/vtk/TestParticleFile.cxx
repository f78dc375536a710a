// Particles written to a .mote file, read back, and drawn from there.
#include "VTKTestSupport.h"

#include "filters/io/IOTestSupport.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkLookupTable.h"
#include "vtkMath.h"
#include "vtkMoteParticleFilePoints.h"
#include "vtkMoteParticleFileReader.h"
#include "vtkMoteParticleFileWriter.h"
#include "vtkMoteReaderTable.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStringArray.h"

#include <cmath>

using namespace mote::testing;

namespace
{

/// 400 particles with arrays, in memory and in a file.
struct Filed : FileTest
{
  vtkSmartPointer<vtkPolyData> data = makeParticles(someBalls(400));
  std::string name = path("a.mote");
  vtkNew<vtkMoteParticleFileReader> reader;

  Filed()
  {
    std::vector<double> values;
    for (int i = 0; i < 400; ++i)
      values.push_back(std::sin(i));
    addValues(data, "energy", values);
    vtkNew<vtkFloatArray> velocity;
    velocity->SetName("v");
    velocity->SetNumberOfComponents(3);
    velocity->SetComponentName(1, "vy");
    for (int i = 0; i < 400; ++i)
      velocity->InsertNextTuple3(i, -i, 0.5 * i);
    data->GetPointData()->AddArray(velocity);
    vtkNew<vtkFloatArray> box;
    box->SetName("box");
    box->InsertNextValue(7.0f);
    data->GetFieldData()->AddArray(box);
    data->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), 3.5);
  }

  vtkPolyData* writeAndRead()
  {
    vtkNew<vtkMoteParticleFileWriter> writer;
    writer->SetInputData(data);
    writer->SetFileName(name.c_str());
    EXPECT_EQ(writer->Write(), 1) << writer->GetErrorMessage();
    reader->SetFileName(name.c_str());
    reader->Modified();
    reader->Update();
    EXPECT_EQ(reader->GetLastErrorMessage(), "");
    return reader->GetOutput();
  }

  static void color(Stage& stage)
  {
    vtkNew<vtkLookupTable> table;
    table->SetRange(-1.0, 1.0);
    stage.mapper->SetScalarModeToUsePointFieldData();
    stage.mapper->SelectColorArray("energy");
    stage.mapper->SetLookupTable(table);
    stage.mapper->UseLookupTableScalarRangeOn();
  }
};

TEST_F(Filed, ReadsBackWhatWasWritten)
{
  vtkPolyData* read = this->writeAndRead();
  ASSERT_EQ(read->GetNumberOfPoints(), 400);
  EXPECT_EQ(read->GetNumberOfCells(), 0);
  vtkDataArray* ids = read->GetPointData()->GetArray("vtkOriginalPointIds");
  ASSERT_TRUE(ids);
  vtkDataArray* velocity = read->GetPointData()->GetArray("v");
  ASSERT_TRUE(velocity);
  EXPECT_EQ(velocity->GetDataType(), VTK_FLOAT);
  EXPECT_STREQ(velocity->GetComponentName(1), "vy");
  std::vector<bool> met(400, false);
  for (int i = 0; i < 400; ++i)
  {
    const auto id = static_cast<vtkIdType>(ids->GetTuple1(i));
    met[id] = true;
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_NEAR(read->GetPoint(i)[k], data->GetPoint(id)[k], 1e-7);
      EXPECT_EQ(
        velocity->GetComponent(i, k), data->GetPointData()->GetArray("v")->GetComponent(id, k));
    }
    EXPECT_EQ(read->GetPointData()->GetArray("energy")->GetTuple1(i), std::sin(double(id)));
  }
  EXPECT_EQ(std::count(met.begin(), met.end(), true), 400);
  EXPECT_EQ(read->GetFieldData()->GetArray("box")->GetTuple1(0), 7.0);
  EXPECT_EQ(read->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()), 3.5);
  std::string error;
  EXPECT_EQ(vtkMoteReaderTable::GetTimeSteps(reader, error), std::vector<double>{3.5});
  for (int k = 0; k < 6; ++k)
    EXPECT_NEAR(read->GetBounds()[k], data->GetBounds()[k], 1e-7);
  for (int k = -1; k < 3; ++k)
  {
    double range[2], finite[2], truth[2];
    velocity->GetRange(range, k);
    velocity->GetFiniteRange(finite, k);
    data->GetPointData()->GetArray("v")->GetFiniteRange(truth, k);
    EXPECT_DOUBLE_EQ(range[0], truth[0]);
    EXPECT_DOUBLE_EQ(range[1], truth[1]);
    EXPECT_DOUBLE_EQ(finite[1], truth[1]);
  }
  vtkNew<vtkPolyData> copy; // ordinary data
  copy->DeepCopy(read);
  EXPECT_EQ(copy->GetPoint(17)[1], read->GetPoint(17)[1]);
  EXPECT_EQ(
    static_cast<double*>(copy->GetPoints()->GetVoidPointer(0))[3 * 17 + 1], read->GetPoint(17)[1]);
  EXPECT_NEAR(copy->GetBounds()[0], data->GetBounds()[0], 1e-7);
  Stage stage(copy);
  stage.mapper->Update();
  EXPECT_EQ(stage.mapper->GetNumberOfBuilds(), 1);
}

TEST_F(Filed, PiecesAreTheWhole)
{
  vtkNew<vtkPolyData> all;
  all->DeepCopy(this->writeAndRead());
  vtkPointData* whole = all->GetPointData();
  for (const int pieces : {2, 3, 7})
  {
    vtkIdType done = 0;
    double volume = 0.0; // of the pieces' boxes
    for (int piece = 0; piece < pieces; ++piece)
    {
      reader->UpdatePiece(piece, pieces, 0);
      vtkPolyData* own = reader->GetOutput();
      EXPECT_NEAR(own->GetNumberOfPoints(), 400.0 / pieces, 1.0);
      ASSERT_EQ(own->GetFieldData()->GetArray("box")->GetTuple1(0), 7.0);
      vtkDataArray* radii = own->GetPointData()->GetArray("radius");
      ASSERT_TRUE(radii);
      for (vtkIdType i = 0; i < own->GetNumberOfPoints(); ++i, ++done)
      {
        for (int k = 0; k < 3; ++k)
          ASSERT_EQ(own->GetPoint(i)[k], all->GetPoint(done)[k]);
        for (int a = 0; a < whole->GetNumberOfArrays(); ++a)
        {
          vtkDataArray* mine = own->GetPointData()->GetArray(whole->GetArrayName(a));
          ASSERT_EQ(mine->GetDataType(), whole->GetArray(a)->GetDataType());
          for (int c = 0; c < mine->GetNumberOfComponents(); ++c)
            ASSERT_EQ(mine->GetComponent(i, c), whole->GetArray(a)->GetComponent(done, c));
        }
        const auto id =
          static_cast<vtkIdType>(whole->GetArray("vtkOriginalPointIds")->GetTuple1(done));
        EXPECT_NEAR(
          radii->GetTuple1(i), data->GetPointData()->GetArray("radius")->GetTuple1(id), 1e-6);
      }
      const double* box = own->GetBounds();
      volume += (box[1] - box[0]) * (box[3] - box[2]) * (box[5] - box[4]);
    }
    EXPECT_EQ(done, 400);
    const double* box = all->GetBounds();
    // Each of them lies in a part of space: seven slices of the order of the input would take seven
    // times all of it.
    EXPECT_LT(volume, 3.0 * (box[1] - box[0]) * (box[3] - box[2]) * (box[5] - box[4]));
  }
  reader->UpdatePiece(0, 1, 0);
  EXPECT_TRUE(vtkMoteParticleFilePoints::SafeDownCast(reader->GetOutput()->GetPoints()));
}

TEST_F(Filed, IsDrawnFromTheFile)
{
  Stage fromMemory(data), fromFile(this->writeAndRead());
  color(fromMemory);
  color(fromFile);
  vtkDataArray* ids = reader->GetOutput()->GetPointData()->GetArray("vtkOriginalPointIds");
  const Picture a = fromMemory.trace(128, 128), b = fromFile.trace(128, 128);
  EXPECT_EQ(fromFile.mapper->GetNumberOfBuilds(), 0);
  EXPECT_EQ(fromFile.mapper->GetNumberOfParticles(), 400);
  int different = 0;
  for (int i = 0; i < a.count(); ++i)
  {
    const long long id = b.particle(i) < 0 ? -1 : (long long)ids->GetTuple1(b.particle(i));
    bool same = a.particle(i) == id && std::abs(a.depth(i) - b.depth(i)) <= 1e-5f;
    for (int k = 0; k < 3; ++k)
      same = same && std::abs(a.color(i)[k] - b.color(i)[k]) < 1e-4f;
    different += a.particle(i) < 0 && id < 0 ? 0 : !same;
  }
  EXPECT_GT(a.covered(), 2000);
  EXPECT_LE(different, 4);
  for (int k = 0; k < 6; ++k)
    EXPECT_NEAR(fromFile.mapper->GetBounds()[k], fromMemory.mapper->GetBounds()[k], 1e-6);
  EXPECT_EQ(fromFile.mapper->GetParticleValue(5),
    reader->GetOutput()->GetPointData()->GetArray("energy")->GetTuple1(5));
}

TEST_F(Filed, ShowsTheSameInRanges)
{
  Stage fromMemory(data), fromFile(this->writeAndRead());
  for (Stage* stage : {&fromMemory, &fromFile})
  {
    stage->mapper->AddRange("energy", 0, -0.5, 0.25);
    stage->mapper->AddRange("v", -1, 10.0, 400.0);
    stage->mapper->SetCenterRange(0, -0.6, 0.7);
    stage->mapper->SetRadiusRange(0.08, HUGE_VAL);
    stage->mapper->Update();
  }
  EXPECT_GT(fromMemory.mapper->GetNumberOfVisibleParticles(), 10);
  EXPECT_EQ(fromMemory.mapper->GetNumberOfVisibleParticles(),
    fromFile.mapper->GetNumberOfVisibleParticles());
  EXPECT_EQ(fromFile.mapper->GetNumberOfBuilds(), 0);
  Stage second(reader->GetOutput()); // is not shown less for that
  second.mapper->Update();
  EXPECT_EQ(second.mapper->GetNumberOfVisibleParticles(), 400);
  EXPECT_GT(second.trace().covered(), fromFile.trace().covered());
}

TEST_F(Filed, IsBuiltWhereOtherRadiiAreWanted)
{
  this->writeAndRead();
  Stage stage(reader->GetOutput()), truth(data);
  const double widest = stage.mapper->GetBounds()[1];
  for (Stage* s : {&stage, &truth})
    s->mapper->SetRadiusScale(2.0);
  EXPECT_GT(stage.mapper->GetBounds()[1], widest);
  EXPECT_EQ(stage.mapper->GetNumberOfBuilds(), 1);
  EXPECT_NEAR(stage.mapper->GetBounds()[1], truth.mapper->GetBounds()[1], 1e-6);
  stage.mapper->SetRadiusModeToSpacing();
  truth.mapper->SetRadiusModeToSpacing();
  stage.mapper->Update();
  truth.mapper->Update();
  EXPECT_DOUBLE_EQ(stage.mapper->GetRadiusInUse(), truth.mapper->GetRadiusInUse());
  stage.mapper->SetRadiusModeToAutomatic();
  stage.mapper->SetRadiusScale(1.0);
  stage.mapper->SetStructureName("coherent-grid");
  EXPECT_NEAR(stage.mapper->GetBounds()[1], widest, 1e-6);
  EXPECT_EQ(stage.mapper->GetNumberOfBuilds(), 3);
  stage.mapper->SetStructureName("auto");
  EXPECT_DOUBLE_EQ(stage.mapper->GetBounds()[1], widest);
  EXPECT_EQ(stage.mapper->GetNumberOfBuilds(), 3); // back to the file
}

TEST_F(Filed, KeepsTheFormUntilAnotherIsWanted)
{
  const auto read = [&](vtkPolyData* from, const char* form, const char* to)
  {
    vtkNew<vtkMoteParticleFileWriter> writer;
    writer->GetMapper()->SetStructureForm(form);
    writer->SetInputData(from);
    writer->SetFileName(path(to).c_str());
    EXPECT_EQ(writer->Write(), 1) << writer->GetErrorMessage();
    EXPECT_EQ(writer->GetMapper()->GetNumberOfBuilds(), from == data || *form != 'a' ? 1 : 0);
    vtkNew<vtkMoteParticleFileReader> reader;
    reader->SetFileName(path(to).c_str());
    reader->Update();
    return vtkSmartPointer<vtkPolyData>(reader->GetOutput());
  };
  const auto pointsOf = [](vtkPolyData* points)
  { return vtkMoteParticleFilePoints::SafeDownCast(points->GetPoints()); };
  const auto exact = read(data, "auto", "exact.mote"), small = read(exact, "4-byte", "4.mote"),
             again = read(small, "auto", "again.mote");
  EXPECT_EQ(pointsOf(exact)->GetForm(), "exact");
  EXPECT_LT(pointsOf(exact)->GetPositionError(), 1e-6);
  for (vtkPolyData* points : {small.Get(), again.Get()})
  {
    EXPECT_EQ(pointsOf(points)->GetForm(), "4-byte");
    EXPECT_GT(pointsOf(points)->GetPositionError(), 1e-5);
  }
  const double error = pointsOf(small)->GetPositionError() + pointsOf(exact)->GetPositionError();
  vtkDataArray* ids = small->GetPointData()->GetArray("vtkOriginalPointIds");
  for (vtkIdType i = 0; i < 400; ++i)
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_NEAR(
        small->GetPoint(i)[k], data->GetPoint(static_cast<vtkIdType>(ids->GetTuple1(i)))[k], error);
      EXPECT_EQ(small->GetPoint(i)[k], again->GetPoint(i)[k]);
    }
  Stage stage(small), truth(data);
  const int covered = truth.trace().covered();
  EXPECT_NEAR(stage.trace().covered(), covered, 0.01 * covered);
  EXPECT_EQ(stage.mapper->GetNumberOfBuilds(), 0);
}

TEST_F(Filed, ArraysOutliveReaderAndFile)
{
  vtkSmartPointer<vtkDataArray> energy;
  {
    vtkNew<vtkMoteParticleFileReader> other;
    this->writeAndRead();
    other->SetFileName(name.c_str());
    other->Update();
    vtkNew<vtkPolyData> shallow;
    shallow->ShallowCopy(other->GetOutput());
    energy = vtkSmartPointer<vtkDataArray>::Take(
      shallow->GetPointData()->GetArray("energy")->NewInstance());
    energy->ShallowCopy(shallow->GetPointData()->GetArray("energy"));
  }
  const double before = energy->GetTuple1(11);
  this->writeAndRead(); // replaces the file, whose pages stay
  ::unlink(name.c_str());
  EXPECT_EQ(energy->GetTuple1(11), before);
  EXPECT_EQ(reader->GetOutput()->GetPointData()->GetArray("energy")->GetTuple1(11), before);
}

TEST_F(Filed, WrittenFromAFileIsTheSame)
{
  this->writeAndRead();
  vtkNew<vtkMoteParticleFileWriter> writer;
  writer->SetInputConnection(reader->GetOutputPort());
  const std::string again = path("b.mote");
  writer->SetFileName(again.c_str());
  ASSERT_EQ(writer->Write(), 1) << writer->GetErrorMessage();
  std::ifstream a(name, std::ios::binary), b(again, std::ios::binary);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(a), {}),
    std::string(std::istreambuf_iterator<char>(b), {}));
}

TEST_F(Filed, SaysWhatIsWrong)
{
  vtkNew<vtkMoteParticleFileWriter> writer;
  Complaints complaints(writer);
  writer->SetFileName(name.c_str());
  EXPECT_EQ(writer->Write(), 0); // no input
  EXPECT_NE(writer->GetErrorMessage().find("no particles"), std::string::npos);
  writer->SetInputData(data);
  writer->SetFileName("/no/such/folder/a.mote");
  EXPECT_EQ(writer->Write(), 0);
  EXPECT_NE(writer->GetErrorMessage().find("folder"), std::string::npos);
  EXPECT_EQ(complaints.errors, 2);
  vtkNew<vtkStringArray> words;
  words->SetName("words");
  words->SetNumberOfValues(400);
  data->GetPointData()->AddArray(words);
  writer->SetFileName(name.c_str());
  EXPECT_EQ(writer->Write(), 1);
  EXPECT_EQ(complaints.warnings, 1);
  EXPECT_NE(complaints.text.find("words"), std::string::npos);

  std::string error;
  EXPECT_FALSE(vtkMoteReaderTable::Read(
    vtkMoteReaderTable::MakeReader(write("c.mote", "rubbish and more"), error), error));
  EXPECT_NE(error.find("c.mote: this is no file of particles"), std::string::npos) << error;
}

} // namespace
