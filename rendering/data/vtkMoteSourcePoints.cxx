#include "vtkMoteSourcePoints.h"

#include "Bounds.h"
#include "SourcePositions.h"

#include "kernels/particles/ParticleSet.h"

#include "vtkNew.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkMoteSourcePoints);

vtkMoteSourcePoints::vtkMoteSourcePoints() = default;
vtkMoteSourcePoints::~vtkMoteSourcePoints() = default;

void vtkMoteSourcePoints::SetSource(std::shared_ptr<const mote::ParticleSource> source)
{
  vtkNew<mote::SourcePositions> positions;
  positions->SetSource(std::move(source));
  this->SetData(positions);
  this->Modified();
}

std::shared_ptr<const mote::ParticleSource> vtkMoteSourcePoints::GetSource() const
{
  auto* positions = dynamic_cast<mote::SourcePositions*>(this->Data);
  return positions ? positions->GetSource() : nullptr;
}

void vtkMoteSourcePoints::ComputeBounds()
{
  const auto source = this->GetSource();
  if (!source || source->count() == 0)
  {
    this->Superclass::ComputeBounds();
    return;
  }
  if (this->ComputeTime > this->GetMTime())
    return;
  mote::copyBounds(mote::examine(mote::ParticleSet::of(source)).centers, this->Bounds);
  this->ComputeTime.Modified();
}

void vtkMoteSourcePoints::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Source: " << (this->GetSource() ? "yes" : "none") << "\n";
}
