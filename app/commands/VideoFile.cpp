#include "VideoFile.h"

#include "base/Failure.h"
#include "base/Messages.h"
#include "base/Text.h"

#include <kernels/core/AtomicFile.h>

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkOggTheoraWriter.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace mote::app
{

namespace
{

namespace fs = std::filesystem;

std::string endingOf(const std::string& file)
{
  return lowerCase(fs::path(file).extension().string());
}

bool isTheora(const std::string& file)
{
  return endingOf(file) == ".ogv" || endingOf(file) == ".ogg";
}

/// "film.ogv" as "film.part.ogv": programs tell the kind by the ending.
std::string partOf(const std::string& file)
{
  fs::path path(file);
  return path.replace_extension("").string() + ".part" + fs::path(file).extension().string();
}

/// The file's names: the one while it grows, which is gone in the end.
class GrowingFile
{
public:
  explicit GrowingFile(const std::string& file)
    : name(file)
    , part(partOf(file))
  {
  }
  ~GrowingFile()
  {
    std::error_code error;
    fs::remove(part, error);
  }
  GrowingFile(const GrowingFile&) = delete;
  GrowingFile& operator=(const GrowingFile&) = delete;

  void finish() const { moveIntoPlace(part, name); }

  const std::string name, part;
};

/// Whether all pages of an Ogg file are there, one after the other, and the last one says that it
/// is. Source: RFC 3533.
bool isWholeOgg(const std::string& file)
{
  std::ifstream in(file, std::ios::binary);
  constexpr int last = 4;
  std::array<char, 27> page;
  int kind = 0;
  for (std::uint32_t expected = 0; in.read(page.data(), page.size()); ++expected)
  {
    std::uint32_t number;
    std::memcpy(&number, &page[18], 4);
    kind = page[5];
    std::array<char, 255> parts;
    const auto count = static_cast<unsigned char>(page[26]);
    if (std::memcmp(page.data(), "OggS", 4) != 0 || number != expected ||
        !in.read(parts.data(), count))
      return false;
    std::streamoff bytes = 0;
    for (int i = 0; i < count; ++i)
      bytes += static_cast<unsigned char>(parts[static_cast<std::size_t>(i)]);
    if (bytes > 0 && (!in.seekg(bytes - 1, std::ios::cur) || in.get() < 0))
      return false;
  }
  return in.gcount() == 0 && (kind & last) != 0;
}

class TheoraFile : public VideoFile
{
public:
  TheoraFile(const std::string& file, const FilmSettings& film)
    : file_(file)
  {
    writer_->SetFileName(file_.part.c_str());
    writer_->SetRate(film.rate);
    writer_->SetQuality(film.quality == "low" ? 0 : film.quality == "medium" ? 1 : 2);
  }
  ~TheoraFile() override
  {
    if (isBegun_)
      writer_->End();
  }

  void add(vtkImageData* image) override
  {
    writer_->SetInputData(image);
    if (!isBegun_)
      writer_->Start();
    isBegun_ = true;
    writer_->Write();
    this->require();
  }

  void finish() override
  {
    if (isBegun_)
      writer_->End();
    isBegun_ = false;
    this->require();
    // The writer does not look whether the disk took what it gave.
    if (!isWholeOgg(file_.part))
      throw Failure(file_.name + " cannot be written: the disk did not take all of it");
    file_.finish();
  }

private:
  void require()
  {
    const std::string error = Messages::takeError();
    if (writer_->GetErrorCode() != 0 || !error.empty())
      throw Failure(file_.name + " cannot be written" + (error.empty() ? "" : ": " + error));
    std::error_code unknown;
    if (const auto room = fs::space(fs::absolute(file_.part).parent_path(), unknown);
        !unknown && room.available == 0)
      throw Failure(file_.name + " cannot be written: the disk is full");
  }

  GrowingFile file_;
  vtkNew<vtkOggTheoraWriter> writer_;
  bool isBegun_ = false;
};

/// Where a program lies among the folders of PATH; empty where it does not.
std::string programNamed(const std::string& name)
{
  const char* path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (const std::string file = (fs::path(folder) / name).string();
        access(file.c_str(), X_OK) == 0 && !fs::is_directory(file))
      return file;
  return {};
}

/// Frames go to ffmpeg through a pipe.
class FfmpegFile : public VideoFile
{
public:
  FfmpegFile(const std::string& program, const std::string& file, const std::array<int, 2>& size,
    const FilmSettings& film)
    : file_(file)
    , size_(size)
  {
    this->start(program, this->words(film));
  }
  ~FfmpegFile() override
  {
    if (process_ > 0)
    {
      close(pipe_);
      kill(process_, SIGKILL);
      waitpid(process_, nullptr, 0);
    }
  }

  void add(vtkImageData* image) override
  {
    // A program that ended breaks the pipe: write() is to say so, and not a signal.
    const auto before = std::signal(SIGPIPE, SIG_IGN);
    bool isTaken = true;
    const auto bytes = static_cast<std::size_t>(3 * size_[0]);
    for (int y = size_[1] - 1; y >= 0 && isTaken; --y) // films begin at the top
    {
      const auto* row = static_cast<const char*>(image->GetScalarPointer(0, y, 0));
      for (std::size_t sent = 0; sent < bytes && isTaken;)
      {
        const ssize_t now = write(pipe_, row + sent, bytes - sent);
        isTaken = now > 0 || errno == EINTR;
        sent += now > 0 ? static_cast<std::size_t>(now) : 0;
      }
    }
    std::signal(SIGPIPE, before);
    if (!isTaken)
      throw Failure("ffmpeg stopped taking frames of " + file_.name + "; it says why above");
  }

  void finish() override
  {
    close(pipe_);
    int status = 0;
    while (waitpid(process_, &status, 0) < 0 && errno == EINTR)
      ;
    process_ = -1;
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
      throw Failure("ffmpeg could not write " + file_.name + "; it says why above");
    file_.finish();
  }

private:
  std::vector<std::string> words(const FilmSettings& film) const
  {
    std::vector<std::string> all = {"ffmpeg", "-nostdin", "-loglevel", "error", "-y", "-f",
      "rawvideo", "-pix_fmt", "rgb24", "-s",
      std::to_string(size_[0]) + "x" + std::to_string(size_[1]), "-r", std::to_string(film.rate),
      "-i", "-", "-an"};
    const auto add = [&](std::initializer_list<std::string> more) { all.insert(all.end(), more); };
    if (endingOf(file_.name) != ".gif")
    {
      // Colours of most players are at half the resolution, and sizes even.
      add({"-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt", "yuv420p"});
      const std::string crf = film.quality == "low" ? "30" : film.quality == "medium" ? "23" : "17";
      if (endingOf(file_.name) == ".webm")
        add({"-c:v", "libvpx-vp9", "-b:v", "0", "-crf", crf});
      else if (endingOf(file_.name) != ".avi")
        add({"-c:v", "libx264", "-crf", crf});
      else
        add({"-q:v", film.quality == "low" ? "10" : film.quality == "medium" ? "5" : "2"});
    }
    all.push_back(fs::path(file_.part).is_absolute() ? file_.part : "./" + file_.part);
    return all;
  }

  void start(const std::string& program, std::vector<std::string> words)
  {
    int ends[2];
    if (pipe(ends) != 0)
      throw Failure(std::string("ffmpeg cannot be started: ") + std::strerror(errno));
    std::vector<char*> arguments;
    for (std::string& word : words)
      arguments.push_back(word.data());
    arguments.push_back(nullptr);
    process_ = fork();
    if (process_ == 0)
    {
      setsid(); // Ctrl-C is for who sends the frames
      dup2(ends[0], STDIN_FILENO);
      close(ends[0]);
      close(ends[1]);
      execv(program.c_str(), arguments.data());
      _exit(127);
    }
    close(ends[0]);
    pipe_ = ends[1];
    if (process_ < 0)
    {
      close(pipe_);
      throw Failure(std::string("ffmpeg cannot be started: ") + std::strerror(errno));
    }
  }

  GrowingFile file_;
  std::array<int, 2> size_;
  int pipe_ = -1;
  pid_t process_ = -1;
};

} // namespace

bool isVideoName(const std::string& file)
{
  static const std::vector<std::string> endings = {
    ".ogv", ".ogg", ".mp4", ".mkv", ".webm", ".mov", ".avi", ".gif"};
  return std::find(endings.begin(), endings.end(), endingOf(file)) != endings.end();
}

bool hasFfmpeg()
{
  return !programNamed("ffmpeg").empty();
}

std::unique_ptr<VideoFile> makeVideoFile(
  const std::string& file, const std::array<int, 2>& size, const FilmSettings& film)
{
  if (isTheora(file))
    return std::make_unique<TheoraFile>(file, film);
  const std::string program = programNamed("ffmpeg");
  if (program.empty())
    throw Failure(endingOf(file) +
                  " films are written by the program ffmpeg, which is not installed; name the film "
                  ".ogv, which mote writes itself, or name pictures, such as frames-%04d.png");
  return std::make_unique<FfmpegFile>(program, file, size, film);
}

} // namespace mote::app
