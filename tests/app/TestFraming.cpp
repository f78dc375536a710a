// Whatever the box, the side, the projection and the shape of the picture: all of the box is inside
// the margins, and it could not be larger.

#include "base/Failure.h"
#include "stage/Framing.h"

#include <gtest/gtest.h>
#include <vtkCamera.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>

#include <algorithm>
#include <array>
#include <cmath>

using namespace mote::app;

namespace
{

/// The shares of the picture that stay free: left, right, bottom, top.
std::array<double, 4> freeShares(vtkCamera* camera, const double bounds[6], double aspect)
{
  vtkMatrix4x4* toView = camera->GetCompositeProjectionTransformMatrix(aspect, -1.0, 1.0);
  double low[2] = {1e300, 1e300}, high[2] = {-1e300, -1e300};
  for (int i = 0; i < 8; ++i)
  {
    const double corner[4] = {bounds[i & 1], bounds[2 + ((i >> 1) & 1)], bounds[4 + (i >> 2)], 1.0};
    double seen[4];
    toView->MultiplyPoint(corner, seen);
    EXPECT_GT(seen[3], 0.0) << "a corner behind the eye";
    for (int k = 0; k < 2; ++k)
    {
      low[k] = std::min(low[k], seen[k] / seen[3]);
      high[k] = std::max(high[k], seen[k] / seen[3]);
    }
  }
  return {0.5 * (1.0 + low[0]), 0.5 * (1.0 - high[0]), 0.5 * (1.0 + low[1]), 0.5 * (1.0 - high[1])};
}

} // namespace

TEST(Framing, BoxJustFits)
{
  const double boxes[][6] = {{0, 1, 0, 1, 0, 1}, {-5, 5, -1, 1, 100, 102},
    {1e6, 1e6 + 30, -20, 20, -7, 8}, {0, 1e-9, 0, 2e-9, 0, 3e-9}};
  Margins margins;
  margins.left = 0.02;
  margins.right = 0.2;
  margins.bottom = 0.05;
  margins.top = 0.1;
  for (const auto& box : boxes)
    for (const std::string& side : viewNames())
      for (const double aspect : {0.5, 1.0, 1.8})
        for (const bool parallel : {false, true})
        {
          vtkNew<vtkCamera> camera;
          camera->SetParallelProjection(parallel);
          lookFrom(camera, side == "auto" ? automaticView(box) : side);
          frame(camera, box, aspect, margins);
          const auto spare = freeShares(camera, box, aspect);
          const double slack[2] = {spare[0] - margins.left + spare[1] - margins.right,
            spare[2] - margins.bottom + spare[3] - margins.top};
          SCOPED_TRACE(side + " aspect " + std::to_string(aspect) + (parallel ? " parallel" : ""));
          EXPECT_GE(spare[0], margins.left - 1e-6);
          EXPECT_GE(spare[1], margins.right - 1e-6);
          EXPECT_GE(spare[2], margins.bottom - 1e-6);
          EXPECT_GE(spare[3], margins.top - 1e-6);
          EXPECT_LT(std::min(slack[0], slack[1]), 1e-4) << "the picture wastes room";
        }
}

TEST(Framing, FlatDataShowTheirFace)
{
  const double flatZ[6] = {0, 100, 0, 80, 0, 0}, flatY[6] = {0, 100, 5, 6, 0, 100},
               flatX[6] = {0, 0, 0, 1, 0, 1}, cube[6] = {0, 1, 0, 1, 0, 1}, point[6] = {},
               strip[6] = {5, 5, 0, 100, 0, 3};
  EXPECT_EQ(automaticView(flatZ), "+z");
  EXPECT_EQ(automaticView(flatY), "-y");
  EXPECT_EQ(automaticView(flatX), "+x");
  EXPECT_EQ(automaticView(cube), "iso");
  // A strip that is narrow in one direction, too.
  EXPECT_EQ(automaticView(strip), "+x");
  EXPECT_EQ(automaticView(point), "iso");
}

TEST(Framing, BoundsBeyondAllCamerasAreASentence)
{
  const double boxes[][6] = {{-1e308, 1e308, 0, 1, 0, 1}, {0, 1e300, 0, 1, 0, 1},
    {1e17, 1e17 + 16, 0, 1, 0, 1}, {1e17, 1e17, 1e17, 1e17, 1e17, 1e17},
    {0, std::nan(""), 0, 1, 0, 1}};
  for (const auto& box : boxes)
  {
    vtkNew<vtkCamera> camera;
    lookFrom(camera, "iso");
    EXPECT_THROW(frame(camera, box, 1.5, {}), Failure) << box[0] << " " << box[1];
  }
}

TEST(Framing, OnePointHasAView)
{
  const double point[6] = {3, 3, 4, 4, 5, 5};
  vtkNew<vtkCamera> camera;
  lookFrom(camera, "iso");
  frame(camera, point, 1.5, {});
  EXPECT_TRUE(std::isfinite(camera->GetDistance()));
  EXPECT_GT(camera->GetDistance(), 0.0);
}
