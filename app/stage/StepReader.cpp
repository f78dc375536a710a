#include "StepReader.h"

#include "Calculated.h"
#include "base/Background.h"

#include <utility>

namespace mote::app
{

StepReader::StepReader(std::unique_ptr<Input> input, const Settings& settings, Look look)
  : input_(std::move(input))
  , settings_(settings)
  , look_(std::move(look))
  , steps_(input_->numberOfSteps())
  , thread_([this] { inBackground([this] { this->run(); }); })
{
}

StepReader::~StepReader()
{
  stop_ = true;
  thread_.join();
}

void StepReader::run()
{
  const Runner runner = quietly([this](double) { return !stop_; });
  for (int step = 0; step < steps_ && !stop_; ++step)
  {
    std::vector<NamedData> data;
    try
    {
      KnownExpressions known;
      data = withCalculated(input_->read(step, runner), settings_, known);
    }
    catch (const std::exception&)
    {
      // A step that cannot be read is a gap; who shows it is told why.
    }
    look_(data);
  }
}

} // namespace mote::app
