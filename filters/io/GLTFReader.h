#ifndef MoteGLTFReader_h
#define MoteGLTFReader_h

#include "ColorByte.h"

#include "vtkCompositeDataIterator.h"
#include "vtkDataArray.h"
#include "vtkGLTFReader.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

namespace mote
{

/// VTK's reader of glTF files, which has colours of vertices as float: they are bytes here, which
/// are drawn as colours, as those of PLY and OBJ.
class GLTFReader : public vtkGLTFReader
{
public:
  static GLTFReader* New() { VTK_STANDARD_NEW_BODY(GLTFReader); }

protected:
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override
  {
    const int done = this->vtkGLTFReader::RequestData(request, inputs, outputs);
    vtkMultiBlockDataSet* output = vtkMultiBlockDataSet::GetData(outputs);
    if (!output)
      return done;
    const auto blocks = vtkSmartPointer<vtkCompositeDataIterator>::Take(output->NewIterator());
    for (blocks->InitTraversal(); !blocks->IsDoneWithTraversal(); blocks->GoToNextItem())
      if (auto* block = vtkPointSet::SafeDownCast(blocks->GetCurrentDataObject()))
        makeBytes(block->GetPointData());
    return done;
  }

private:
  static void makeBytes(vtkPointData* arrays)
  {
    vtkDataArray* colors = arrays->GetArray("COLOR_0");
    if (!colors || colors->GetDataType() == VTK_UNSIGNED_CHAR ||
        colors->GetNumberOfComponents() < 3 || colors->GetNumberOfComponents() > 4)
      return;
    vtkNew<vtkUnsignedCharArray> bytes;
    bytes->SetName("COLOR_0");
    bytes->SetNumberOfComponents(colors->GetNumberOfComponents());
    bytes->SetNumberOfTuples(colors->GetNumberOfTuples());
    for (vtkIdType i = 0; i < colors->GetNumberOfTuples(); ++i)
      for (int c = 0; c < colors->GetNumberOfComponents(); ++c)
        bytes->SetTypedComponent(i, c, colorByte(255.0 * colors->GetComponent(i, c)));
    arrays->AddArray(bytes); // in place of the other
  }
};

} // namespace mote

#endif
