/**
 * @class   vtkMotePeriodicPositions
 * @brief   wraps particles into a periodic box, or unwraps them by their image numbers
 *
 * The output is the input with other points; all arrays stay. The box is what readers leave in the
 * field data: "box", nine values that are its three edge vectors, "box_origin", and "boundary",
 * such as "pp pp fm", which says that the box is periodic along its first two edges; without it
 * along all three.
 *
 * WRAPPED moves each particle by whole edge vectors into the box, along the edges where the box is
 * periodic. UNWRAPPED moves particles by the whole numbers of edge vectors that the point arrays
 * "ix", "iy" and "iz" say, as LAMMPS counts images: so that nothing jumps from one face of the box
 * to the other. Positions in the file must be wrapped for that. Points keep the type of their
 * numbers.
 */

#ifndef vtkMotePeriodicPositions_h
#define vtkMotePeriodicPositions_h

#include "MoteFiltersParticlesModule.h" // For export macro
#include "vtkPassInputTypeAlgorithm.h"

#include <string> // For sentences

class vtkPointSet;

class MOTEFILTERSPARTICLES_EXPORT vtkMotePeriodicPositions : public vtkPassInputTypeAlgorithm
{
public:
  static vtkMotePeriodicPositions* New();
  vtkTypeMacro(vtkMotePeriodicPositions, vtkPassInputTypeAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Modes
  {
    WRAPPED = 0,
    UNWRAPPED
  };

  //@{
  /**
   * One of Modes. Default: WRAPPED.
   */
  vtkSetClampMacro(Mode, int, WRAPPED, UNWRAPPED);
  vtkGetMacro(Mode, int);
  void SetModeToWrapped() { this->SetMode(WRAPPED); }
  void SetModeToUnwrapped() { this->SetMode(UNWRAPPED); }
  //@}

  /**
   * Gives the data set itself other points; the old ones stay as they are for whoever else has
   * them. Returns what is wrong as a sentence, and nothing where all went well.
   */
  static std::string Move(vtkPointSet* data, int mode);

protected:
  vtkMotePeriodicPositions() = default;
  ~vtkMotePeriodicPositions() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int FillInputPortInformation(int port, vtkInformation* info) override;

  int Mode = WRAPPED;

private:
  vtkMotePeriodicPositions(const vtkMotePeriodicPositions&) = delete;
  void operator=(const vtkMotePeriodicPositions&) = delete;
};

#endif
