#ifndef MoteGLTFCheck_h
#define MoteGLTFCheck_h

#include <string>

namespace mote
{

/// Throws FileError if a file is no glTF 2.0 (OtherFormat), or if buffers, or the files that they
/// name, lack what is said to be in them (NotFound, Truncated): VTK 9.1's vtkGLTFReader crashes
/// then, or reads what lies behind them in memory. So it does where parts ask for others that are
/// not there (Malformed). Compressed and quantised meshes are refused. Returns whether there are
/// images.
bool checkGLTF(const std::string& path);

} // namespace mote

#endif
