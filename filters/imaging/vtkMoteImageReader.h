/**
 * @class   vtkMoteImageReader
 * @brief   Reads an image through OpenImageIO, with all channels that it has.
 *
 * OpenEXR, TIFF, PNG, JPEG and what else OpenImageIO reads, from any program; what
 * vtkMoteImageWriter writes comes back as it was, but for what the file's numbers round. The output
 * is a vtkImageData of one slice whose row 0 is the bottom row, with these point arrays:
 *
 *  - `color`: the channels R G B and, if there is one, A, or Y and A, float; of a file without
 * them, the first layer that has R, G and B. Colours are those that a screen shows (sRGB), those of
 *    files that hold light (OpenEXR) being brought to it, and premultiplied by alpha. They are the
 *    scalars.
 *  - `depth`: the channel Z, float; of a file without it, the first channel of a layer that is
 *    called depth, or whose last part is Z or depth and has no X and Y beside it. A file with one
 *    channel of floats has depth alone. Depths are the scalars where there are no colours.
 *  - `normal`: N.X N.Y N.Z, float.
 *  - NAME, float, for channels NAME.X NAME.Y (NAME.Z), NAME.R NAME.G NAME.B (NAME.A), or NAME.0
 *    NAME.1 ...
 *  - NAME, 64-bit integers, for channels of 32-bit integers; 0xffffffff, "none", is -1. Those
 * called NAME.high and NAME.low are the halves of one of 64 bits.
 *  - any other channel, float, under its own name.
 *
 * The first image of a file that holds several is read.
 *
 * Errors: no name, no such file, a folder, a file that is no image or is damaged, a deep image, one
 * that does not fit in memory. Each is reported by vtkErrorMacro as one sentence with the file's
 * name, and kept in GetErrorMessage(), with an ErrorCode; the output is empty then.
 */

#ifndef vtkMoteImageReader_h
#define vtkMoteImageReader_h

#include "MoteFiltersImagingModule.h" // for export macro
#include "vtkImageAlgorithm.h"

#include <string> // for attributes

class MOTEFILTERSIMAGING_EXPORT vtkMoteImageReader : public vtkImageAlgorithm
{
public:
  static vtkMoteImageReader* New();
  vtkTypeMacro(vtkMoteImageReader, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * The file to read. Required.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  //@}

  /**
   * Whether this file is there and has the beginning of an image: 1 or 0.
   */
  static int CanReadFile(const char* fileName);

  /**
   * Why the last update failed, as one sentence with the file's name; empty if it did not.
   */
  std::string GetErrorMessage() const { return this->ErrorMessage; }

protected:
  vtkMoteImageReader();
  ~vtkMoteImageReader() override;

  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector) override;
  int RequestData(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector) override;

  char* FileName = nullptr;

private:
  vtkMoteImageReader(const vtkMoteImageReader&) = delete;
  void operator=(const vtkMoteImageReader&) = delete;

  template <typename Work>
  int Try(const Work& work);

  std::string ErrorMessage;
};

#endif
