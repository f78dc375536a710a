#include "InputTimeStep.h"

#include "vtkAlgorithm.h"
#include "vtkAlgorithmOutput.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkStreamingDemandDrivenPipeline.h"

namespace mote
{

bool updateInputTimeStep(vtkAlgorithm* algorithm, double time, int piece, int pieces,
  int ghostLevels, const int extents[6])
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkAlgorithmOutput* input =
    algorithm->GetNumberOfInputConnections(0) > 0 ? algorithm->GetInputConnection(0, 0) : nullptr;
  if (!input)
    return false;
  // The request goes to the input's own outputs.
  vtkNew<vtkInformationVector> requests;
  for (int port = 0; port < input->GetProducer()->GetNumberOfOutputPorts(); ++port)
    requests->Append(vtkNew<vtkInformation>());
  vtkInformation* request = requests->GetInformationObject(input->GetIndex());
  request->Set(Pipeline::UPDATE_TIME_STEP(), time);
  if (piece >= 0)
  {
    request->Set(Pipeline::UPDATE_PIECE_NUMBER(), piece);
    request->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), pieces);
    request->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), ghostLevels);
  }
  if (extents)
    request->Set(Pipeline::UPDATE_EXTENT(), extents, 6);
  return input->GetProducer()->Update(input->GetIndex(), requests) != 0;
}

} // namespace mote
