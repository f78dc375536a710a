#ifndef MotePiece_h
#define MotePiece_h

#include "vtkAlgorithm.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cstdint>

namespace mote
{

/// What one of several processes takes: a piece, from 0, of so many.
struct Piece
{
  int number = 0, count = 1;

  bool operator==(const Piece&) const = default;
  bool isAll() const { return count <= 1; }
  /// The first of so many things that are in the piece, and how many are.
  std::uint64_t first(std::uint64_t all) const { return this->before(all, number); }
  std::uint64_t size(std::uint64_t all) const { return this->before(all, number + 1) - first(all); }

private:
  /// How many things the first `pieces` have; without a product that could overflow.
  std::uint64_t before(std::uint64_t all, int pieces) const
  {
    const auto of = static_cast<std::uint64_t>(count), some = static_cast<std::uint64_t>(pieces);
    return all / of * some + all % of * some / of;
  }
};

/// For RequestInformation: each process may ask for its piece.
inline void offerPieces(vtkInformation* outputInformation)
{
  outputInformation->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
}

/// For RequestData: the piece that is asked for.
inline Piece requestedPiece(vtkInformation* outputInformation)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  const auto valueOf = [&](vtkInformationIntegerKey* key, int usual)
  { return outputInformation->Has(key) ? outputInformation->Get(key) : usual; };
  const int count = std::max(1, valueOf(Pipeline::UPDATE_NUMBER_OF_PIECES(), 1));
  return {std::clamp(valueOf(Pipeline::UPDATE_PIECE_NUMBER(), 0), 0, count - 1), count};
}

} // namespace mote

#endif
