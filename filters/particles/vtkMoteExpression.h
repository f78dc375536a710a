/**
 * @class   vtkMoteExpression
 * @brief   adds an array that is computed from others by an expression
 *
 * The output is the input with one more array of points or of cells, a number for each, such as of
 * "sqrt(vx^2 + vy^2)" or "c_pe > -3 && type == 2". Names in an expression are
 *
 * - x, y, z: coordinates of points;
 * - names of arrays of one component; 'in quotes' where they hold other characters than letters,
 *   digits and _;
 * - NAME.x, NAME.y, NAME.z, NAME.0, NAME.1... of components of other arrays, NAME.magnitude and
 *   NAME alone of the magnitude, and names that components have of their own;
 * - gradient(NAME), vorticity(NAME), divergence(NAME) and q_criterion(NAME), derivatives in space
 *   of an array on cells, as vtkGradientFilter finds them; of components as above, such as
 *   gradient(p).x and vorticity(U).z;
 * - pi.
 *
 * Points' arrays come before cells'; all arrays of an expression must be of one of the two.
 * Operators are + - * / ^, < <= > >= == !=, && || ! and A ? B : C, which has B where A is not 0;
 * functions are those of muParser, such as abs, sqrt, exp, ln, log10, sin, min, max, rint, and mag,
 * which is the magnitude that NAME alone is. All is computed in double precision, in parallel.
 *
 * Source of the parser: muParser, https://beltoforion.de/en/muparser/.
 */

#ifndef vtkMoteExpression_h
#define vtkMoteExpression_h

#include "MoteFiltersParticlesModule.h" // For export macro
#include "vtkPassInputTypeAlgorithm.h"

#include <string> // For sentences

class vtkDataSet;

class MOTEFILTERSPARTICLES_EXPORT vtkMoteExpression : public vtkPassInputTypeAlgorithm
{
public:
  static vtkMoteExpression* New();
  vtkTypeMacro(vtkMoteExpression, vtkPassInputTypeAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * The expression. None, the default, is an error when the filter runs.
   */
  vtkSetStringMacro(Expression);
  vtkGetStringMacro(Expression);
  //@}

  //@{
  /**
   * Name of the array that is added, in place of one of that name. Default: "result".
   */
  vtkSetStringMacro(ResultArrayName);
  vtkGetStringMacro(ResultArrayName);
  //@}

  //@{
  /**
   * Type of the array's numbers: VTK_DOUBLE, the default, VTK_FLOAT, or VTK_UNSIGNED_CHAR, which
   * says whether the expression holds: 0 where it is 0 or not a number, else 1.
   */
  vtkSetMacro(ResultType, int);
  vtkGetMacro(ResultType, int);
  //@}

  /**
   * Adds the array to the data set itself. Returns what is wrong as a sentence, and nothing where
   * all went well.
   */
  static std::string AddTo(vtkDataSet* data, const std::string& expression,
    const std::string& resultArrayName, int resultType = VTK_DOUBLE);

  /**
   * The same with an array of cells, whatever the expression speaks of: what is of points, places
   * included, counts in a cell as the mean over its points, and there may be arrays of points and
   * of cells in one expression.
   */
  static std::string AddToCells(vtkDataSet* data, const std::string& expression,
    const std::string& resultArrayName, int resultType = VTK_DOUBLE);

  /**
   * What is wrong with an expression whatever the data, as a sentence; nothing where it can be
   * read.
   */
  static std::string Check(const std::string& expression);

protected:
  vtkMoteExpression();
  ~vtkMoteExpression() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int FillInputPortInformation(int port, vtkInformation* info) override;

  char* Expression = nullptr;
  char* ResultArrayName = nullptr;
  int ResultType = VTK_DOUBLE;

private:
  vtkMoteExpression(const vtkMoteExpression&) = delete;
  void operator=(const vtkMoteExpression&) = delete;
};

#endif
