#pragma once

#include <embree3/rtcore.h>

#include <atomic>
#include <cstddef>

namespace mote::bench
{

/// Embree in the settings that were measured to be its fastest.
class EmbreeDevice
{
public:
  /// Builds with so many threads. Throws Error where Embree cannot start.
  explicit EmbreeDevice(int threads);
  ~EmbreeDevice();
  EmbreeDevice(const EmbreeDevice&) = delete;
  EmbreeDevice& operator=(const EmbreeDevice&) = delete;

  operator RTCDevice() const { return device_; }
  /// Throws Error where anything has failed since.
  void check() const;
  /// What scenes take, besides what they share with others.
  std::size_t bytes() const { return static_cast<std::size_t>(bytes_.load()); }

private:
  std::atomic<ssize_t> bytes_{0};
  RTCDevice device_ = nullptr;
};

inline RTCIntersectContext embreeContext(RTCIntersectContextFlags flags)
{
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = flags;
  return context;
}

} // namespace mote::bench
