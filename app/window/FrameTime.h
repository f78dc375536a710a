#pragma once

namespace mote::app
{

/// How long rays may take in a frame, from what the frames before took beside them.
/// A frame that follows a time step has more beside its rays: whoever asks for a step waits for
/// what reading it takes, and legend and histograms are made anew. Its time is kept apart.
class FrameTime
{
public:
  /// A time step was read and built in `seconds`, and no frame shows it yet.
  void loaded(double seconds) { loading_ = seconds; }

  /// The time of the rays of the frame that begins, s: `wanted` less the rest, but `least` in any
  /// case. What a step took is taken off, but for half of `wanted`, unless `steady`, when frames
  /// have their time whatever came before them.
  double forRays(double wanted, double least, bool steady);

  /// A frame with rays took `frame` seconds, its rays `rays` of them.
  void traced(double frame, double rays);

private:
  double loading_ = 0.0;      // of a step that no frame has shown, s
  bool ofStep_ = false;       // what the present frame is
  double beside_ = 0.0;       // of the last frame of a step that stays, s
  double besideOfStep_ = 0.0; // of the last frame that was the first of its step, s
};

} // namespace mote::app
