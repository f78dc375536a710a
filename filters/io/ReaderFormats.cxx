#include "ReaderFormats.h"

#include "BgeoFile.h"
#include "CGNSReader.h"
#include "CaseFolder.h"
#include "ChildProcess.h"
#include "EnSightReader.h"
#include "FileError.h"
#include "FoamReader.h"
#include "GLTFCheck.h"
#include "GLTFReader.h"
#include "GadgetFile.h"
#include "HDF5Particles.h"
#include "LAMMPSDump.h"
#include "LegacyCheck.h"
#include "LegacyReader.h"
#include "OBJReader.h"
#include "PDBReader.h"
#include "PLYReader.h"
#include "PointTable.h"
#include "STLCheck.h"
#include "TextFile.h"
#include "UintahFile.h"
#include "VTKHDFFile.h"
#include "VTKHDFReader.h"
#include "XMLCheck.h"
#include "XMLReaders.h"
#include "vtkMoteCollectionReader.h"
#include "vtkMoteDelimitedPointsReader.h"
#include "vtkMoteFileSeriesReader.h"
#include "vtkMoteGeneratedMeshReader.h"
#include "vtkMoteGeneratedParticlesReader.h"
#include "vtkMoteLAMMPSDumpReader.h"
#include "vtkMoteMeshFileReader.h"
#include "vtkMoteParticleFileReader.h"
#include "vtkMoteParticleFormatsReader.h"
#include "vtkMotePointsReader.h"
#include "vtkMoteXYZReader.h"

#include "kernels/meshes/RlodTreeFile.h"
#include "kernels/particles/GeneratedParticles.h"
#include "kernels/particles/PkdTreeFile.h"

#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkSTLReader.h"

#include <array>
#include <cstring>
#include <fstream>

namespace mote
{
namespace
{

using FileNames = std::vector<std::string>;

/// The factory of every reader that takes one file name and nothing else.
template <class Reader>
vtkSmartPointer<vtkAlgorithm> make(const FileNames& fileNames)
{
  auto reader = vtkSmartPointer<Reader>::New();
  reader->SetFileName(fileNames.front().c_str());
  return reader;
}

/// The factory of every reader that takes the files of a series.
template <class Reader>
vtkSmartPointer<vtkAlgorithm> makeSeries(const FileNames& fileNames)
{
  auto reader = vtkSmartPointer<Reader>::New();
  for (const std::string& name : fileNames)
    reader->AddFileName(name.c_str());
  return reader;
}

/// The factory of a format that has one time step a file: a file's own reader, or that of a series.
template <class Reader>
vtkSmartPointer<vtkAlgorithm> makeOneOrSeries(const FileNames& fileNames)
{
  return fileNames.size() == 1 ? make<Reader>(fileNames)
                               : makeSeries<vtkMoteFileSeriesReader>(fileNames);
}

vtkSmartPointer<vtkAlgorithm> makePDB(const FileNames& fileNames)
{
  return makePDBReader(fileNames.front());
}

vtkSmartPointer<vtkAlgorithm> makePLY(const FileNames& fileNames)
{
  return makeOneOrSeries<PLYReader>(fileNames);
}

vtkSmartPointer<vtkAlgorithm> makeLegacy(const FileNames& fileNames)
{
  if (fileNames.size() == 1) // those of a series come here one by one
    checkLegacyVTK(fileNames.front());
  return makeOneOrSeries<LegacyReader>(fileNames);
}

vtkSmartPointer<vtkAlgorithm> makeOBJ(const FileNames& fileNames)
{
  return makeOBJReader(fileNames.front());
}

vtkSmartPointer<vtkAlgorithm> makeSTL(const FileNames& fileNames)
{
  checkSTL(fileNames.front());
  return make<vtkSTLReader>(fileNames);
}

vtkSmartPointer<vtkAlgorithm> makeGLTF(const FileNames& fileNames)
{
  const std::string& file = fileNames.front();
  // VTK reads the images, too, which are not drawn, and does not survive damaged ones.
  constexpr unsigned secondsAtMost = 60;
  const auto read = [&]
  {
    vtkNew<vtkGLTFReader> reader;
    reader->SetFileName(file.c_str());
    reader->Update();
  };
  if (checkGLTF(file) && inChildProcess(secondsAtMost, read) == ChildEnd::Died)
    throw FileError(FileError::Kind::Malformed, file,
      "it is damaged: VTK fails when it reads it with its images");
  return make<GLTFReader>(fileNames);
}

/// As makeOneOrSeries(), of VTK's XML files.
template <class Reader>
vtkSmartPointer<vtkAlgorithm> makeXML(const FileNames& fileNames)
{
  if (fileNames.size() == 1) // those of a series come here one by one
    checkVTKXML(fileNames.front());
  return makeOneOrSeries<Reader>(fileNames);
}

vtkSmartPointer<vtkAlgorithm> makeFoam(const FileNames& fileNames)
{
  return makeFoamReader(fileOfFolder(fileNames.front()));
}

/// A control dictionary, which stands for its case.
bool isControlDict(std::string_view beginning)
{
  return beginning.find("FoamFile") != beginning.npos &&
         beginning.find("controlDict") != beginning.npos;
}

vtkSmartPointer<vtkAlgorithm> makeUintah(const FileNames& fileNames)
{
  return make<vtkMoteParticleFormatsReader>({fileOfFolder(fileNames.front())});
}

vtkSmartPointer<vtkAlgorithm> makeEnSight(const FileNames& fileNames)
{
  return makeEnSightReader(fileNames.front());
}

vtkSmartPointer<vtkAlgorithm> makeCGNS(const FileNames& fileNames)
{
  return fileNames.size() == 1 ? makeCGNSReader(fileNames.front())
                               : makeSeries<vtkMoteFileSeriesReader>(fileNames);
}

vtkSmartPointer<vtkAlgorithm> makeVTKHDF(const FileNames& fileNames)
{
  return fileNames.size() == 1 ? makeVTKHDFReader(fileNames.front())
                               : makeSeries<vtkMoteFileSeriesReader>(fileNames);
}

/// Files of HDF5 have the same endings, whatever is in them.
vtkSmartPointer<vtkAlgorithm> makeHDF5(const FileNames& fileNames)
{
  return fileNames.size() == 1 && isVTKHDF(fileNames.front())
           ? makeVTKHDFReader(fileNames.front())
           : makeOneOrSeries<vtkMoteParticleFormatsReader>(fileNames);
}

bool isMote(std::string_view beginning)
{
  return PkdTreeFile::recognises(beginning) || RlodTreeFile::recognises(beginning);
}

vtkSmartPointer<vtkAlgorithm> makeMote(const FileNames& fileNames)
{
  std::array<char, 8> beginning{};
  std::ifstream(fileNames.front(), std::ios::binary).read(beginning.data(), beginning.size());
  // What is neither is told by the reader of particles.
  return RlodTreeFile::recognises({beginning.data(), beginning.size()})
           ? makeOneOrSeries<vtkMoteMeshFileReader>(fileNames)
           : makeOneOrSeries<vtkMoteParticleFileReader>(fileNames);
}

} // namespace

const std::vector<ReaderFormat>& readerFormats()
{
  static const std::vector<ReaderFormat> formats = {
    {{".dump", ".lammpstrj", ".lammps", ".dump.gz", ".lammpstrj.gz", ".lammps.gz", ".bin"},
      "LAMMPS dump, of text or binary", makeSeries<vtkMoteLAMMPSDumpReader>, true,
      looksLikeLAMMPSDump},
    {{".data", ".lmp", ".lammpsdata", ".data.gz", ".lmp.gz", ".lammpsdata.gz"},
      "LAMMPS data file, as write_data writes it", makeSeries<vtkMoteLAMMPSDumpReader>, true},
    {{".mote"}, "Mote's own file of particles or triangles", makeMote, true, isMote},
    {{".xyz", ".xyz.gz", ".extxyz", ".extxyz.gz"}, "XYZ and extended XYZ atoms",
      makeOneOrSeries<vtkMoteXYZReader>, true},
    {{".pts", ".pts.gz"}, "points, x y z a line", makeOneOrSeries<vtkMotePointsReader>, true},
    {{".csv", ".csv.gz", ".tsv", ".tsv.gz"}, "table with columns x, y, z",
      makeOneOrSeries<vtkMoteDelimitedPointsReader>, true},
    {{".txt", ".txt.gz", ".dat", ".dat.gz"}, "table with columns x, y, z, where it is one",
      makeOneOrSeries<vtkMoteDelimitedPointsReader>, true, nullptr, checkPointTable},
    {{".gro", ".gro.gz"}, "GROMACS atoms", makeOneOrSeries<vtkMoteParticleFormatsReader>, true},
    {{".cfg", ".cfg.gz"}, "AtomEye atoms", makeOneOrSeries<vtkMoteParticleFormatsReader>, true},
    {{".h5part", ".hdf5", ".h5"}, "particles of Gadget, SWIFT, AREPO, H5Part and openPMD in HDF5",
      makeHDF5, true, looksLikeHDF5},
    {{".vtkhdf", ".hdf"}, "VTKHDF: grids, polygonal data and images of VTK in HDF5", makeVTKHDF,
      true},
    {{".gadget", ".gadget.gz", ".gadget2", ".gadget2.gz"}, "Gadget binary snapshot",
      makeOneOrSeries<vtkMoteParticleFormatsReader>, true, looksLikeGadget},
    {{".bgeo", ".bgeo.gz", ".bhclassic"}, "points of Houdini, as Partio writes them",
      makeOneOrSeries<vtkMoteParticleFormatsReader>, true, looksLikeBgeo},
    {{".uda"}, "particles of a Uintah data archive, its folder or its index.xml", makeUintah, false,
      looksLikeUintah},
    {{".pdb", ".pdb.gz", ".ent", ".ent.gz"}, "Protein Data Bank atoms, models as time steps",
      makePDB},
    {{".vtp"}, "VTK XML polygonal data", makeXML<WithPointData<PolygonsReader>>, true},
    {{".vtu"}, "VTK XML unstructured grid", makeXML<WithPointData<GridReader>>, true},
    {{".vti"}, "VTK XML image", makeXML<WithPointData<vtkXMLImageDataReader>>, true},
    {{".vts"}, "VTK XML structured grid", makeXML<WithPointData<vtkXMLStructuredGridReader>>, true},
    {{".vtr"}, "VTK XML rectilinear grid", makeXML<WithPointData<vtkXMLRectilinearGridReader>>,
      true},
    {{".vtm", ".vtmb"}, "VTK XML blocks", makeXML<BlocksReader>, true},
    {{".pvtp"}, "VTK XML polygonal data in pieces",
      makeXML<InPieces<vtkXMLPPolyDataReader, PolygonsReader>>, true},
    {{".pvtu"}, "VTK XML unstructured grid in pieces", makeXML<WeldingGridReader>, true},
    {{".pvti"}, "VTK XML image in pieces",
      makeXML<InPieces<vtkXMLPImageDataReader, vtkXMLImageDataReader>>, true},
    {{".pvts"}, "VTK XML structured grid in pieces",
      makeXML<InPieces<vtkXMLPStructuredGridReader, vtkXMLStructuredGridReader>>, true},
    {{".pvtr"}, "VTK XML rectilinear grid in pieces",
      makeXML<InPieces<vtkXMLPRectilinearGridReader, vtkXMLRectilinearGridReader>>, true},
    {{".pvd", ".series"}, "files with their times and parts", make<vtkMoteCollectionReader>},
    {{".vtk"}, "VTK legacy file of points, grids, meshes or blocks", makeLegacy, true},
    {{".ply"}, "Stanford triangle mesh", makePLY, true},
    {{".obj", ".obj.gz"}, "Wavefront mesh", makeOBJ},
    {{".stl"}, "STL triangle mesh", makeSTL},
    {{".gltf", ".glb"}, "glTF triangle meshes and points", makeGLTF},
    {{".case", ".encas"}, "EnSight case", makeEnSight},
    {{".cgns"}, "CGNS mesh", makeCGNS, true},
    {{".foam"}, "OpenFOAM case, also by its controlDict or folder", makeFoam, false, isControlDict},
  };
  return formats;
}

const ReaderFormat* generatedFormat(const std::string& path)
{
  static const ReaderFormat format = {
    {}, "particles that are made", make<vtkMoteGeneratedParticlesReader>};
  static const ReaderFormat meshes = {
    {}, "triangles that are made", make<vtkMoteGeneratedMeshReader>};
  const bool isMesh = namesGeneratedMesh(path);
  if (!(isMesh || namesGeneratedParticles(path)) || vtksys::SystemTools::PathExists(path))
    return nullptr;
  return isMesh ? &meshes : &format;
}

const ReaderFormat* formatOf(const std::string& path, std::string_view beginning)
{
  if (const ReaderFormat* format = generatedFormat(path))
    return format;
  const std::string name = vtksys::SystemTools::LowerCase(path);
  const ReaderFormat* found = nullptr;
  std::size_t longest = 0;
  for (const ReaderFormat& format : readerFormats())
  {
    for (const char* extension : format.extensions)
    {
      const std::size_t length = std::strlen(extension);
      if (length > longest && name.ends_with(extension))
      {
        found = &format;
        longest = length;
      }
    }
  }
  if (found && !found->check)
    return found;
  for (const ReaderFormat& format : readerFormats())
    if (format.recognise && format.recognise(beginning))
      return &format;
  return found;
}

bool isSeriesFile(const std::string& path)
{
  const ReaderFormat* format = formatOf(path, "");
  try
  {
    format = format ? format : formatOf(path, readBeginning(path, 4096));
  }
  catch (const FileError&)
  {
  }
  return format && format->series;
}

} // namespace mote
