#pragma once

namespace mote
{

class Film;

/// Fills colours and depths of a film, which has no samples yet, with those of another film of the
/// same view and any size: something to show where its first sample is not traced yet. Colours are
/// interpolated, depths are those of the nearest pixel, and so are ids where both films have them.
/// The other channels stay undefined.
void fillFrom(const Film& other, Film& film);

/// Makes a film show nothing, in all channels.
void fillWithNothing(Film& film);

} // namespace mote
