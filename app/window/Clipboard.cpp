#include "Clipboard.h"

#include "base/Failure.h"
#include "base/Text.h"

#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <mutex>
#include <thread>

#include <X11/Xatom.h>
#include <X11/Xlib.h>

namespace mote::app
{

namespace
{

Display* ownDisplay = nullptr;
XErrorHandler others = nullptr;

/// A program that asks for the text may be gone when it is given: that is no error of ours.
int onError(Display* display, XErrorEvent* event)
{
  return display == ownDisplay || !others ? 0 : others(display, event);
}

} // namespace

/// Answers those who paste, on a connection and a thread of its own: the window may be at work.
class Clipboard::Owner
{
public:
  Owner()
    : display_(XOpenDisplay(nullptr))
  {
    if (!display_ || pipe(wake_.data()) != 0)
      throw Failure("the clipboard cannot be reached");
    ownDisplay = display_;
    others = XSetErrorHandler(onError);
    window_ = XCreateSimpleWindow(display_, DefaultRootWindow(display_), 0, 0, 1, 1, 0, 0, 0);
    clipboard_ = this->atom("CLIPBOARD");
    targets_ = this->atom("TARGETS");
    utf8_ = this->atom("UTF8_STRING");
    const long extended = XExtendedMaxRequestSize(display_);
    most_ =
      4 * static_cast<std::size_t>(extended > 0 ? extended : XMaxRequestSize(display_)) - 1024;
    thread_ = std::thread([this] { this->serve(); });
  }
  ~Owner()
  {
    this->tell('q');
    thread_.join();
    XCloseDisplay(display_);
    XSetErrorHandler(others);
    ownDisplay = nullptr;
    for (const int end : wake_)
      close(end);
  }
  Owner(const Owner&) = delete;
  Owner& operator=(const Owner&) = delete;

  std::size_t most() const { return most_; }

  void set(const std::string& text)
  {
    {
      const std::lock_guard lock(mutex_);
      text_ = text;
    }
    this->tell('n');
  }

private:
  Atom atom(const char* name) { return XInternAtom(display_, name, False); }

  void tell(char what)
  {
    while (write(wake_[1], &what, 1) < 0 && errno == EINTR)
    {
    }
  }

  void serve()
  {
    for (;;)
    {
      while (XPending(display_) > 0)
      {
        XEvent event;
        XNextEvent(display_, &event);
        if (event.type == SelectionRequest)
          this->answer(event.xselectionrequest);
      }
      std::array<pollfd, 2> sources = {
        {{ConnectionNumber(display_), POLLIN, 0}, {wake_[0], POLLIN, 0}}};
      poll(sources.data(), sources.size(), -1);
      char what = 0;
      if ((sources[1].revents & POLLIN) == 0 || read(wake_[0], &what, 1) != 1)
        continue;
      if (what == 'q')
        return;
      XSetSelectionOwner(display_, clipboard_, window_, CurrentTime);
      XFlush(display_);
    }
  }

  void answer(const XSelectionRequestEvent& request)
  {
    const Atom property = request.property != None ? request.property : request.target;
    XEvent reply{};
    reply.xselection = {SelectionNotify, 0, True, display_, request.requestor, request.selection,
      request.target, property, request.time};
    if (request.target == targets_)
    {
      const Atom offered[] = {targets_, utf8_, XA_STRING};
      XChangeProperty(display_, request.requestor, property, XA_ATOM, 32, PropModeReplace,
        reinterpret_cast<const unsigned char*>(offered), 3);
    }
    else if (request.target == utf8_ || request.target == XA_STRING)
    {
      const std::lock_guard lock(mutex_);
      XChangeProperty(display_, request.requestor, property, request.target, 8, PropModeReplace,
        reinterpret_cast<const unsigned char*>(text_.data()), static_cast<int>(text_.size()));
    }
    else
      reply.xselection.property = None;
    XSendEvent(display_, request.requestor, False, 0, &reply);
    XFlush(display_);
  }

  Display* display_;
  ::Window window_ = None;
  Atom clipboard_ = None, targets_ = None, utf8_ = None;
  std::size_t most_ = 0; ///< bytes
  std::array<int, 2> wake_{};
  std::mutex mutex_;
  std::string text_;
  std::thread thread_;
};

Clipboard::Clipboard() = default;
Clipboard::~Clipboard() = default;

void Clipboard::set(const std::string& text)
{
  if (!owner_)
    owner_ = std::make_unique<Owner>();
  if (text.size() > owner_->most())
    throw Failure("the clipboard takes " + asBytes(static_cast<double>(owner_->most())) +
                  ", and this is " + asBytes(static_cast<double>(text.size())) +
                  "; save it as a file instead");
  owner_->set(text);
}

} // namespace mote::app
