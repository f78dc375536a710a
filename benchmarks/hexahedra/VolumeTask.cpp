#include "VolumeTask.h"

#include "../Timing.h"

#include <glm/trigonometric.hpp>

#include <array>
#include <cmath>

namespace mote::bench
{

const Named wholeView = {"whole", "from (1.1, 0.7, 1.5) towards the middle, 35 degrees, as near as "
                                  "the ball around the bounds allows"};

const char* const transferSentence =
  "Colour and extinction are linear in the pressure, or what stands for it, from knot to knot: 2, "
  "4, 8, 16 and 24 per diagonal of the bounds at 0, 1/4, 1/2, 3/4 and 1 of its range; no shading.";

Camera wholeCamera(const Box& bounds, const Vec3d& towards, const Vec3d& up)
{
  Camera camera;
  camera.viewAngle = 35.0;
  const double radius = 0.5 * glm::length(bounds.size());
  const double distance = radius / std::sin(glm::radians(0.5 * camera.viewAngle));
  camera.position = bounds.center() + distance * glm::normalize(towards);
  camera.forward = bounds.center() - camera.position;
  camera.up = up;
  return camera;
}

namespace
{

/// Opacities are told for so short a way that they are extinctions to within 1e-3: then functions
/// that are linear in opacity and in extinction, which is VTK's, are the same.
TransferFunction moderateTransfer(const HexField& field, const Box& bounds)
{
  struct Entry
  {
    double extinction; ///< per diagonal
    Vec3f color;
  };
  static const std::array<Entry, 5> entries = {
    {{2.0, {0.1f, 0.2f, 0.8f}}, {4.0, {0.1f, 0.7f, 0.8f}}, {8.0, {0.8f, 0.8f, 0.3f}},
      {16.0, {0.9f, 0.5f, 0.1f}}, {24.0, {0.8f, 0.1f, 0.1f}}}};
  const double diagonal = glm::length(bounds.size()), parts = 16000.0;
  const bool isConstant = !(field.lower() < field.upper());
  const double range = isConstant ? 1.0 : field.upper() - field.lower();
  const double lower = isConstant ? field.lower() - 0.5 : field.lower();
  TransferFunction transfer;
  transfer.unitDistance = diagonal / parts;
  transfer.knots.clear();
  for (std::size_t k = 0; k < entries.size(); ++k)
    transfer.knots.push_back({lower + 0.25 * static_cast<double>(k) * range,
      Vec4f(entries[k].color, static_cast<float>(-std::expm1(-entries[k].extinction / parts)))});
  return transfer;
}

} // namespace

CloudObject VolumeTask::volume(
  std::shared_ptr<const HexStructure> structure, const VolumeSampling& sampling) const
{
  CloudObject object;
  object.structure = std::move(structure);
  object.field = input.field;
  object.transfer = transfer;
  object.sampling = sampling;
  return object;
}

VolumeTask makeVolumeTask(const Options& options, const std::string& input)
{
  VolumeTask task;
  task.input = makeHexInput(input);
  const Box& bounds = task.input.mesh->bounds();
  task.camera = wholeCamera(bounds, Vec3d(1.1, 0.7, 1.5), Vec3d(0.0, 1.0, 0.0));
  task.transfer = moderateTransfer(*task.input.field, bounds);
  task.width = options.width;
  task.height = options.height;
  task.threads = threadCount(options.threads);
  task.repeat = options.repeat;
  task.singleRays = options.singleRays;
  return task;
}

void integrateReference(VolumeTask& task)
{
  if (task.reference.width > 0)
    return;
  progress("integrating the reference of %s", task.input.name.c_str());
  task.reference = referencePixels(
    *task.input.mesh, *task.input.field, task.transfer, task.rays(), task.width, task.height);
}

} // namespace mote::bench
