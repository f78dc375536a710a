#include "SharedImage.h"

#include <X11/Xutil.h>

#include <sys/ipc.h>
#include <sys/shm.h>

namespace mote::app
{

namespace
{

bool isRefused = false;

int noteRefusal(::Display*, XErrorEvent*)
{
  isRefused = true;
  return 0;
}

/// A server on another machine says that it has the extension, and cannot attach the memory.
bool attach(::Display* display, XShmSegmentInfo& segment)
{
  XSync(display, False);
  isRefused = false;
  const XErrorHandler others = XSetErrorHandler(noteRefusal);
  XShmAttach(display, &segment);
  XSync(display, False);
  XSetErrorHandler(others);
  return !isRefused;
}

} // namespace

std::unique_ptr<SharedImage> SharedImage::create(::Display* display, ::Window window)
{
  XWindowAttributes attributes;
  if (!XShmQueryExtension(display) || !XGetWindowAttributes(display, window, &attributes))
    return nullptr;
  const ::Visual& visual = *attributes.visual;
  if (attributes.depth < 24 || visual.red_mask != 0xff0000 || visual.green_mask != 0xff00 ||
      visual.blue_mask != 0xff)
    return nullptr;
  std::unique_ptr<SharedImage> image(new SharedImage(display, window, attributes));
  if (!image->fit(1, 1) || image->image_->bits_per_pixel != 32 ||
      image->image_->byte_order != LSBFirst)
    return nullptr;
  return image;
}

SharedImage::SharedImage(::Display* display, ::Window window, const XWindowAttributes& attributes)
  : display_(display)
  , window_(window)
  , visual_(attributes.visual)
  , depth_(static_cast<unsigned>(attributes.depth))
  , gc_(XCreateGC(display, window, 0, nullptr))
{
}

SharedImage::~SharedImage()
{
  this->release();
  XFreeGC(display_, gc_);
}

void SharedImage::release()
{
  if (!image_)
    return;
  XShmDetach(display_, &segment_);
  XSync(display_, False);
  image_->data = nullptr;
  XDestroyImage(image_);
  image_ = nullptr;
  shmdt(segment_.shmaddr);
}

bool SharedImage::fit(int width, int height)
{
  if (image_ && image_->width == width && image_->height == height)
    return true;
  this->release();
  image_ = XShmCreateImage(display_, visual_, depth_, ZPixmap, nullptr, &segment_,
    static_cast<unsigned>(width), static_cast<unsigned>(height));
  if (!image_)
    return false;
  const auto bytes =
    static_cast<std::size_t>(image_->bytes_per_line) * static_cast<unsigned>(height);
  segment_.shmid = shmget(IPC_PRIVATE, bytes, IPC_CREAT | 0600);
  void* memory = segment_.shmid < 0 ? nullptr : shmat(segment_.shmid, nullptr, 0);
  const bool isMapped = memory && memory != reinterpret_cast<void*>(-1);
  segment_.shmaddr = image_->data = isMapped ? static_cast<char*>(memory) : nullptr;
  segment_.readOnly = False;
  const bool isShared = isMapped && attach(display_, segment_);
  // It goes with the last who has it attached, even if that is one who crashed.
  if (segment_.shmid >= 0)
    shmctl(segment_.shmid, IPC_RMID, nullptr);
  if (isShared)
    return true;
  if (isMapped)
    shmdt(memory);
  image_->data = nullptr;
  XDestroyImage(image_);
  image_ = nullptr;
  return false;
}

std::uint32_t* SharedImage::row(int y) const
{
  return reinterpret_cast<std::uint32_t*>(
    image_->data + std::ptrdiff_t(y) * image_->bytes_per_line);
}

void SharedImage::show(int first, int last) const
{
  XShmPutImage(display_, window_, gc_, image_, first, 0, first, 0,
    static_cast<unsigned>(last - first), static_cast<unsigned>(image_->height), False);
  XSync(display_, False);
}

} // namespace mote::app
