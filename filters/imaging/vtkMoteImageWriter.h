/**
 * @class   vtkMoteImageWriter
 * @brief   Writes an image as PNG through libpng, or JPEG, TIFF or OpenEXR through OpenImageIO.
 *
 * The input is a vtkImageData of one slice whose row 0 is the bottom row, as vtkMoteRendererSource
 * makes it. The file's type follows from its name:
 *
 *  - `.png`, `.jpg`, `.jpeg`, `.tif`, `.tiff`: the point array `color`, or the active scalars if
 *    there is none, in 8 bits. Floats in [0, 1] are RGB, RGBA (premultiplied), grey or grey with
 *    alpha; 8-bit values are written as they are. An alpha channel is written only if some pixel
 *    has an alpha below 1; PNG gets colours divided by alpha, as PNG wants them, JPEG, which has no
 *    alpha, the image over white.
 *  - `.exr`: channels R G B and, if not 1 everywhere, A as half floats, then the other point
 * arrays, zip-compressed:
 *      - `depth` becomes Z, float, infinity kept;
 *      - `normal` becomes N.X N.Y N.Z, half;
 *      - integer arrays become uint32 channels of their own name, negative values 0xffffffff;
 *        `particle` becomes that if all its ids are below 0xffffffff, and otherwise the
 *        pair `particle.high` and `particle.low` (id = high * 2^32 + low, both 0xffffffff for
 * none);
 *      - any other array becomes a float channel of its own name, or, with several components,
 *        NAME.X NAME.Y NAME.Z (or NAME.0, NAME.1 ... above three).
 *
 * The colours of the image are those a screen shows (sRGB). An EXR holds light: R, G and B are
 * brought to it, alpha is not, and premultiplies them afterwards.
 *
 * A file is written under a temporary name in the same folder and then renamed: under the
 * name asked for there is always either what was there before or a complete image.
 *
 * Errors: an empty or missing image, no colours, a value type that cannot be written, an unknown
 * ending, a missing or read-only folder, a folder of that name, a full disk. Each is reported by
 * vtkErrorMacro as one sentence with the file's name, kept in GetErrorMessage(), with an ErrorCode.
 */

#ifndef vtkMoteImageWriter_h
#define vtkMoteImageWriter_h

#include "MoteFiltersImagingModule.h" // for export macro
#include "vtkWriter.h"

#include <string>  // for attributes
#include <utility> // for attributes
#include <vector>  // for attributes

class vtkImageData;

class MOTEFILTERSIMAGING_EXPORT vtkMoteImageWriter : public vtkWriter
{
public:
  static vtkMoteImageWriter* New();
  vtkTypeMacro(vtkMoteImageWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * The file to write. Required. Its ending, in upper or lower case, says its type.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  //@}

  /**
   * Update the input and write the file. Returns 1 if the file is complete in its place, and
   * otherwise 0, with GetErrorCode() and GetErrorMessage() set.
   */
  int Write() override;

  /**
   * Whether FileName can be written, as far as can be seen without writing: it has a known ending,
   * its folder exists and is writable, it does not name a folder, and OpenImageIO can be loaded
   * where the ending needs it (some tenths of a second, the first time). Needs no input, so a
   * program can ask before it spends time on an image. Returns 1, or 0 with the error set and
   * reported.
   */
  int CheckFileName();

  /**
   * The reason why the last Write() or CheckFileName() failed, as one sentence with the file's
   * name; empty if it did not fail.
   */
  std::string GetErrorMessage() const;

  /**
   * Whether the ending of this name is one of those that this class writes: 1 or 0.
   */
  static int CanWriteFile(const char* fileName);

  //@{
  /**
   * Text to keep in the file's header, such as "Camera" or "Description". Names of one to 31
   * letters, digits, underscores or inner spaces, that the formats do not need themselves; others
   * are refused with a warning. A name given twice keeps the last value. PNG and EXR keep every
   * name, JPEG and TIFF those that their formats know: "Description", "Artist", "Copyright"...
   * "Software" is set to "Mote x.y.z" if not given.
   */
  void AddAttribute(const char* name, const char* value);
  void ClearAttributes();
  int GetNumberOfAttributes() const;
  //@}

  //@{
  /**
   * Quality of JPEG files, in [1, 100]. Default 95.
   */
  vtkSetClampMacro(Quality, int, 1, 100);
  vtkGetMacro(Quality, int);
  //@}

protected:
  vtkMoteImageWriter();
  ~vtkMoteImageWriter() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  void WriteData() override;

  char* FileName = nullptr;
  int Quality = 95;

private:
  vtkMoteImageWriter(const vtkMoteImageWriter&) = delete;
  void operator=(const vtkMoteImageWriter&) = delete;

  void WriteImage(vtkImageData* image);
  void Fail(unsigned long code, const std::string& sentence);

  std::vector<std::pair<std::string, std::string>> Attributes;
  std::string ErrorMessage;
  bool Written = false;
};

#endif
