#pragma once

#include <kernels/core/Camera.h>
#include <kernels/hexahedra/HexField.h>
#include <kernels/shading/TransferFunction.h>

#include <limits>
#include <vector>

namespace mote::bench
{

/// Colours of every 7th pixel in each direction, the 4th first: premultiplied red, green, blue and
/// alpha, row after row from the bottom.
struct ReferencePixels
{
  static constexpr int first = 3, stride = 7;
  int width = 0, height = 0; ///< of the image
  std::vector<Vec4d> colors;

  int columns() const { return count(width); }
  int rows() const { return count(height); }
  static int count(int pixels) { return (pixels - first + stride - 1) / stride; }
};

/// What a perspective camera outside of the mesh sees at the pixels' centres, in double.
///
/// It uses no structure: every cell is projected and cut by the rays within its projection. In a
/// cell emission and absorption along the ray, dC = T c e ds and dT = -T e ds, are integrated by
/// the classical Runge-Kutta method with steps that are halved until two halves and the whole agree
/// to 1e-9, of a trilinear field whose coordinates come from Newton's method at each place. A ray
/// has some hundred such steps: the colours are right to better than 1e-6. Rays never end early.
ReferencePixels referencePixels(const HexMesh& mesh, const HexField& field,
  const TransferFunction& transfer, const CameraRays& rays, int width, int height);

/// How far an image is from the reference, over the pixels of the reference that are not empty in
/// both, and over their four channels. NaN where there is no such pixel.
struct ColorErrors
{
  double rms = std::numeric_limits<double>::quiet_NaN();
  double max = std::numeric_limits<double>::quiet_NaN();
  std::size_t checked = 0; ///< pixels
};

/// `rgba` is premultiplied, row after row from the bottom, of all pixels of the image.
ColorErrors compare(const ReferencePixels& reference, const float* rgba);

} // namespace mote::bench
