#ifndef MoteReaderFormats_h
#define MoteReaderFormats_h

#include "vtkSmartPointer.h"

#include <string>
#include <string_view>
#include <vector>

class vtkAlgorithm;

namespace mote
{

/// One entry of the table of vtkMoteReaderTable: all there is to say about a file format.
struct ReaderFormat
{
  std::vector<const char*> extensions; ///< with their dots, in lower case; the longest match wins
  const char* description;
  /// A reader that is ready to update. One name, or several if the format knows series. May throw
  /// FileError for what the reader itself would not survive.
  vtkSmartPointer<vtkAlgorithm> (*make)(const std::vector<std::string>& fileNames);
  bool series = false;
  /// Whether a file whose extension says nothing begins like this format; or null.
  bool (*recognise)(std::string_view beginning) = nullptr;
  /// Of a format whose extensions are those of others, too, so that what a file begins like goes
  /// first: throws FileError where the beginning is not this format's. Else null.
  void (*check)(const std::string& path) = nullptr;
};

/// The table.
const std::vector<ReaderFormat>& readerFormats();

/// Whether a name is meant as triangles that are made; see vtkMoteGeneratedMeshReader.
bool namesGeneratedMesh(const std::string& name);

/// The format of particles or triangles that are made, where the path is such a specification (see
/// vtkMoteGeneratedParticlesReader, vtkMoteGeneratedMeshReader) and not that of a file; else null.
const ReaderFormat* generatedFormat(const std::string& path);

/// The format of a file by its name, else by its first bytes; null if it has none.
const ReaderFormat* formatOf(const std::string& path, std::string_view beginning);

/// Whether a file's format knows series; false also for what cannot be opened.
bool isSeriesFile(const std::string& path);

} // namespace mote

#endif
