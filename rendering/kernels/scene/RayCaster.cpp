#include "RayCaster.h"

#include "../shading/Shader.h"

#include <tbb/blocked_range2d.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <glm/matrix.hpp>
#include <mutex>

namespace mote
{

namespace
{

constexpr int blockSize = 8; ///< pixels a side of a packet
constexpr int tileSize = 32; ///< pixels a side of a task

/// What one tracing of the film needs, made once before the tiles.
struct Tracing
{
  const Scene& scene;
  Film& film;
  CameraRays rays;
  std::vector<CameraRays> localRays; ///< a scene object each
  std::vector<ParticleShader> shaders;
  double jitterX = 0.0, jitterY = 0.0;

  Tracing(const Scene& s, const Camera& camera, Film& f)
    : scene(s)
    , film(f)
    , rays(camera, f.width(), f.height())
  {
    RayCaster::sampleOffset(film.samples(), jitterX, jitterY);
    for (const ParticleObject& object : scene.particles)
    {
      localRays.push_back(rays.transformed(glm::inverse(object.toWorld)));
      shaders.emplace_back(object, scene.lights);
    }
  }

  void traceBlock(int x0, int y0) const
  {
    RayPacket packet;
    packet.count = 0;
    for (std::size_t k = 0; k < scene.particles.size(); ++k)
    {
      if (k == 0)
        localRays[k].fillBlock(packet, x0, y0, jitterX, jitterY);
      else
        moveTo(localRays[k], x0, y0, packet);
      withStructure(*scene.particles[k].structure,
        [&](const auto& s) { s.cast(packet, static_cast<std::int32_t>(k)); });
    }
    if (packet.count == 0)
      rays.fillBlock(packet, x0, y0, jitterX, jitterY);
    shadeBlock(packet, x0, y0);
  }

  /// Expresses the rays in another object's coordinates; hits are kept.
  void moveTo(const CameraRays& local, int x0, int y0, RayPacket& packet) const
  {
    RayPacket moved;
    local.fillBlock(moved, x0, y0, jitterX, jitterY);
    std::copy_n(&moved.origin[0][0], 3 * RayPacket::capacity, &packet.origin[0][0]);
    std::copy_n(&moved.direction[0][0], 3 * RayPacket::capacity, &packet.direction[0][0]);
  }

  void shadeBlock(const RayPacket& packet, int x0, int y0) const
  {
    for (int i = 0; i < RayPacket::capacity; ++i)
    {
      int dx = 0, dy = 0;
      packetOffset(i, dx, dy);
      const int x = x0 + dx, y = y0 + dy;
      if (x < film.width() && y < film.height())
        shadePixel(packet, i, x, y);
    }
  }

  void shadePixel(const RayPacket& packet, int i, int x, int y) const
  {
    const std::size_t pixel = static_cast<std::size_t>(y) * film.width() + x;
    const bool hit = packet.object[i] >= 0;
    ShadedHit shaded;
    if (hit)
    {
      const double px = x + 0.5 + jitterX, py = y + 0.5 + jitterY;
      shaded = shaders[static_cast<std::size_t>(packet.object[i])].shade(
        rays.originAt(px, py), rays.directionAt(px, py), packet.t[i], packet.slot[i]);
    }
    const float depth =
      hit ? static_cast<float>(packet.t[i]) : std::numeric_limits<float>::infinity();
    addColor(pixel, shaded.color);
    if (film.samples() > 0)
    {
      film.nearestDepth()[pixel] = std::min(film.nearestDepth()[pixel], depth);
      return;
    }
    film.depth()[pixel] = depth;
    if (film.has(Film::Id))
    {
      film.id()[pixel] = hit ? shaded.particle : Film::noId;
      film.object()[pixel] = packet.object[i];
    }
    if (film.has(Film::Normal))
      std::copy_n(&shaded.normal.x, 3, film.normal() + 3 * pixel);
  }

  void addColor(std::size_t pixel, const Vec4f& color) const
  {
    float* mean = film.color() + 4 * pixel;
    const auto n = static_cast<float>(film.samples());
    for (int c = 0; c < 4; ++c)
      mean[c] = film.samples() == 0 ? color[c] : mean[c] + (color[c] - mean[c]) / (n + 1.0f);
  }
};

} // namespace

void RayCaster::sampleOffset(int sample, double& x, double& y)
{
  // The R2 sequence of M. Roberts, "The Unreasonable Effectiveness of Quasirandom Sequences"
  // (2018), shifted so that its first point is the pixel's centre.
  const auto part = [](double v) { return v - std::floor(v) - 0.5; };
  x = part(0.5 + sample * 0.7548776662466927);
  y = part(0.5 + sample * 0.5698402909980532);
}

bool RayCaster::addSample(const Camera& camera, Film& film, const Progress& progress) const
{
  const Tracing tracing(scene_, camera, film);
  if (film.samples() > 0)
    film.splitNearestDepth();
  const int columns = (film.width() + tileSize - 1) / tileSize;
  const int rows = (film.height() + tileSize - 1) / tileSize;
  std::atomic<int> done{0};
  std::atomic<bool> stop{false};
  std::mutex reporting;
  const auto report = [&]
  {
    const int n = ++done;
    // Whoever finds another thread reporting goes on with its next tile.
    if (progress && reporting.try_lock())
    {
      if (!progress(double(n) / (columns * rows)))
        stop = true;
      reporting.unlock();
    }
  };
  const auto trace = [&]
  {
    tbb::parallel_for(tbb::blocked_range2d<int>(0, rows, 1, 0, columns, 1),
      [&](const tbb::blocked_range2d<int>& tiles)
      {
        for (int row = tiles.rows().begin(); row != tiles.rows().end(); ++row)
          for (int column = tiles.cols().begin(); column != tiles.cols().end(); ++column)
          {
            if (stop)
              return;
            const int right = std::min(film.width(), (column + 1) * tileSize);
            const int top = std::min(film.height(), (row + 1) * tileSize);
            for (int y = row * tileSize; y < top; y += blockSize)
              for (int x = column * tileSize; x < right; x += blockSize)
                tracing.traceBlock(x, y);
            report();
          }
      });
  };
  if (threads_ > 0)
    tbb::task_arena(threads_).execute(trace);
  else
    trace();
  if (progress && !stop)
    stop = !progress(1.0);
  film.setSamples(stop ? 0 : film.samples() + 1);
  return !stop;
}

} // namespace mote
