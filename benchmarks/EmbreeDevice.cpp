#include "EmbreeDevice.h"

#include <kernels/core/Error.h>

#include <string>

namespace mote::bench
{

namespace
{

bool countBytes(void* sum, ssize_t bytes, bool)
{
  *static_cast<std::atomic<ssize_t>*>(sum) += bytes;
  return true;
}

} // namespace

EmbreeDevice::EmbreeDevice(int threads)
{
  // Embree limits itself to 256 bits a vector unless told that wide ones are welcome.
  const std::string config =
    "threads=" + std::to_string(threads) + ",frequency_level=simd512,set_affinity=0";
  device_ = rtcNewDevice(config.c_str());
  if (device_ == nullptr)
    throw Error("Embree cannot start on this machine.");
  rtcSetDeviceMemoryMonitorFunction(device_, countBytes, &bytes_);
}

EmbreeDevice::~EmbreeDevice()
{
  rtcReleaseDevice(device_);
}

void EmbreeDevice::check() const
{
  if (rtcGetDeviceError(device_) != RTC_ERROR_NONE)
    throw Error("Embree could not build its structure over this input.");
}

} // namespace mote::bench
