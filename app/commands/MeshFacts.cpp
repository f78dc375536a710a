#include "MeshFacts.h"

#include "base/Text.h"

#include <vtkDataSet.h>
#include <vtkMoteMeshStatistics.h>
#include <vtkNew.h>
#include <vtkVariant.h>

#include <cmath>
#include <cstdint>
#include <vector>

namespace mote::app
{

MeshFacts::MeshFacts(vtkDataSet* data)
{
  vtkNew<vtkMoteMeshStatistics> statistics;
  statistics->SetInputData(data);
  statistics->Update();
  cells_ = statistics->GetOutput(0);
  arrays_ = statistics->GetOutput(1);
}

double MeshFacts::of(const char* column) const
{
  return cells_->GetValueByName(0, column).ToDouble();
}

bool MeshFacts::any() const
{
  return this->of("cells") > this->of("other") + this->of("non_finite");
}

std::optional<double> MeshFacts::meanOf(const std::string& array, const std::string& place) const
{
  for (vtkIdType row = 0; row < arrays_->GetNumberOfRows(); ++row)
    if (arrays_->GetValueByName(row, "array").ToString() == array &&
        arrays_->GetValueByName(row, "of").ToString() == place)
      if (const double mean = arrays_->GetValueByName(row, "mean").ToDouble(); std::isfinite(mean))
        return mean;
  return {};
}

std::string MeshFacts::counts(
  const std::initializer_list<std::pair<const char*, const char*>>& columns) const
{
  std::vector<std::string> words;
  for (const auto& [column, word] : columns)
    if (const auto count = static_cast<std::int64_t>(this->of(column)); count > 0)
      words.push_back(withThousands(count) + " " + word);
  return joined(words, ", ");
}

std::string MeshFacts::cells() const
{
  return this->counts({{"hexahedra", "hexahedra"}, {"wedges", "wedges"}, {"pyramids", "pyramids"},
    {"tetrahedra", "tetrahedra"}, {"polyhedra", "polyhedra"}, {"other", "of other types"}});
}

std::string MeshFacts::complaints() const
{
  return this->counts({{"inverted", "inverted"}, {"zero_volume", "without volume"},
    {"non_finite", "with corners at no place"}});
}

std::vector<std::pair<std::string, double>> MeshFacts::all() const
{
  std::vector<std::pair<std::string, double>> facts;
  for (vtkIdType column = 0; column < cells_->GetNumberOfColumns(); ++column)
    if (const std::string name = cells_->GetColumnName(column); name != "block")
      facts.emplace_back(name, this->of(name.c_str()));
  return facts;
}

} // namespace mote::app
