// Any bytes as an image of one format: there are pixels, or there is one sentence.

#include "ScratchFile.h"

#include <vtkImageData.h>
#include <vtkMoteImageReader.h>
#include <vtkNew.h>

#include <cstdio>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  static ScratchFile file(MOTE_FUZZ_ENDING);
  file.write(bytes, size);
  vtkNew<vtkMoteImageReader> reader;
  reader->SetFileName(file.path().c_str());
  reader->GlobalWarningDisplayOff();
  reader->Update();
  const std::string sentence = reader->GetErrorMessage();
  const bool isRead = reader->GetOutput()->GetNumberOfPoints() > 0;
  if (isRead != sentence.empty() || sentence.find('\n') != std::string::npos)
  {
    std::fprintf(stderr, "%d pixels, and the message is '%s'\n",
      static_cast<int>(reader->GetOutput()->GetNumberOfPoints()), sentence.c_str());
    std::abort();
  }
  return 0;
}
