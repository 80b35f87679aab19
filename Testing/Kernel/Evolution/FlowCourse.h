// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * A flow followed to its end, and what every end must be like.
 */

#ifndef EVOLVING_FLOW_COURSE_H
#define EVOLVING_FLOW_COURSE_H

#include "Checks/SurfaceMeasures.h"
#include "Evolution/SurfaceFlow.h"
#include "Mesh/MeshTopology.h"
#include "Redistribution/VanishedComponents.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <optional>
#include <string>

namespace evolving
{

/// What happened on the way to the end of a flow.
struct Course
{
  Index turnedFaces = 0; ///< against the step before, over all steps
  std::vector<Vec3> points;
  FlowRecord record;
  std::string stopReason;
  std::optional<double> extinctionTime;
  int totalSteps = 0;
};

inline bool areFinite(const StateArrays& a)
{
  using checks::areFinite;
  return areFinite(a.distance) && areFinite(a.distanceGradient) && areFinite(a.normal) &&
    areFinite(a.meanCurvature) && areFinite(a.coVolume) && areFinite(a.normalVelocity) &&
    areFinite(a.tangentialVelocity) && areFinite(a.redistributionPotential);
}

/// Runs a flow; expects finite states and an end that is reached or explained.
inline Course follow(const SurfaceMesh& start, const std::shared_ptr<const ScalarImage>& field,
  const FlowOptions& options)
{
  SurfaceFlow flow(start, field, options);
  Course course;
  course.totalSteps = flow.totalSteps();
  SurfaceMesh before = flow.mesh();
  const MeshTopology topology(start);
  VanishedComponents vanished(start, topology); // points have no sides
  while (!flow.isFinished())
  {
    flow.step();
    EXPECT_TRUE(checks::areFinite(flow.mesh().points) && areFinite(flow.arrays()));
    vanished.update(flow.mesh());
    for (Index face = 0; face < start.faceCount(); ++face)
    {
      course.turnedFaces +=
        faceVectorArea(before, face).dot(faceVectorArea(flow.mesh(), face)) < 0.0 &&
        !vanished.contain(start.faceVertex(face, 0));
    }
    before = flow.mesh();
  }
  course.points = flow.mesh().points;
  course.record = flow.record();
  course.stopReason = flow.stopReason();
  course.extinctionTime = flow.extinctionTime();
  EXPECT_TRUE(std::isfinite(course.record.area + course.record.volume + course.record.minAngle));
  EXPECT_TRUE(!course.stopReason.empty() || flow.extinctionTime() || flow.hasConverged() ||
    course.record.iteration == course.totalSteps);
  return course;
}

/// Towards the field's zero set.
inline FlowOptions attraction(double timeStep, int steps)
{
  FlowOptions options;
  options.timeStep = timeStep;
  options.numberOfSteps = steps;
  options.curvatureSpeed = 0.1;
  options.redistribution.volume = 1.0;
  return options;
}

/// One sentence that says when the run ended and what would have been right.
inline void expectSentence(const std::string& text)
{
  EXPECT_EQ(text.find("The evolution ended before step "), 0u) << text;
  EXPECT_NE(text.find("expected"), std::string::npos) << text;
  EXPECT_EQ(text.back(), '.') << text;
}

} // namespace evolving

#endif
