#ifndef MoteBgeoFile_h
#define MoteBgeoFile_h

#include "StepSource.h"

namespace mote
{

/// Whether bytes begin like a .bgeo file of Houdini, a classic or a new one.
bool looksLikeBgeo(std::string_view beginning);

/// The points of a classic .bgeo file of Houdini, of version 5, plain or gzip: what Partio and the
/// programs that use it (SPlisHSPlasH) write, and Houdini as .bhclassic. Source: the reader of
/// Partio, src/lib/io/BGEO.cpp.
///
/// Every attribute of points: numbers as Float32 or Int32, text as text. Primitives are not read.
/// Throws FileError, also for the format of Houdini 12 and later, with a sentence that says what to
/// do.
std::unique_ptr<StepSource> openBgeo(const std::string& path);

} // namespace mote

#endif
