// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The control functions epsilon and eta that steer the normal motion (section 3.2).
 */

#ifndef EVOLVING_CONTROL_FUNCTIONS_H
#define EVOLVING_CONTROL_FUNCTIONS_H

#include "Evolution/FlowOptions.h"
#include "Evolution/ScalarImage.h"
#include "Execution.h"
#include "Types.h"

#include <memory>
#include <vector>

namespace evolving
{

/// epsilon(d) = C1 (1 - exp(-d^2 / C2)) (3.7), length^2/time.
double curvatureControl(double distance, double curvatureSpeed, double curvatureRange);

/**
 * eta(d) = C d ((-grad d . N) - D sqrt(1 - (grad d . N)^2)) (3.8), length/time. The sign of D is
 * the inward one: a surface around its target, with grad d tangential to it, keeps moving in.
 * @param slope -grad d . N for the unit gradient, in [-1, 1]
 */
double advectionControl(
  double distance, double slope, double advectionSpeed, double advectionBalance);

/// epsilon = S0 exp(-lambda k) of smoothing step k = 0, 1, ... (section 6.3).
double smoothingControl(double smoothingSpeed, double smoothingDecay, int smoothingStep);

/// One entry per vertex.
struct ControlValues
{
  std::vector<double> value;  ///< of the field; empty without one
  std::vector<Vec3> gradient; ///< of the field, unit length or zero; empty without one
  std::vector<double> epsilon;
  std::vector<double> eta;
  /// -d eta / d N where that is above 0, of an edge detector; empty for other fields. See
  /// StepInput.
  std::vector<double> stiffness;
};

/**
 * Evaluates the flow of section 3.2 at the vertices of a surface.
 *
 * Distance field: (3.7) and (3.8); where the gradient is shorter than 1e-6, -grad d . N = 0. An
 * unsigned field has D = 0 within two cells of the target, where its gradient turns round.
 * Edge detector: epsilon = b e, eta = -a grad e . N + s e: e is smallest at an edge, so this sign
 * of a draws the surface there; section 3.2 prints the other one, which drives it away (measured).
 * s is the speed of a balloon (Cohen 1991; Caselles, Kimmel, Sapiro 1997): it takes a surface to
 * edges that are too far to be felt, and ends where the image does: outwards it is 0 there. No
 * field: epsilon = C1, eta = 0.
 */
class ControlField
{
public:
  /**
   * @param field null for mean curvature flow
   * @param options in absolute units
   * @throws InputError as automaticEdgeDetector(). @throws Cancelled
   */
  ControlField(std::shared_ptr<const ScalarImage> field, const FlowOptions& options,
    const Execution& execution = {});

  ControlValues evaluate(const std::vector<Vec3>& points, const std::vector<Vec3>& normals,
    const Execution& execution) const;

  /// As evaluate(), with the constant epsilon of a smoothing step and eta = 0.
  ControlValues evaluateSmoothing(
    const std::vector<Vec3>& points, double epsilon, const Execution& execution) const;

  /// The field's values at points; empty without one.
  std::vector<double> valuesAt(const std::vector<Vec3>& points, const Execution& execution) const;

  /// The field where it is the distance from a target, else null.
  const ScalarImage* target() const
  {
    return this->Options.fieldMode == FieldMode::DistanceField ? this->Field.get() : nullptr;
  }

  /// Of FieldMode::Image: as the options say, or the automatic one; else 0. In absolute units.
  double edgeSharpness() const { return this->EdgeSharpness; }

  /// EdgeDetector::blur of an automatic one, else 0.
  double edgeBlur() const { return this->EdgeBlur; }

  /**
   * Limits the move by eta of an edge detector to one cell per step: a longer one jumps over
   * edges. That of a distance field is bounded by the distance, see ExplicitLimits.
   */
  void limitAdvection(double timeStep, ControlValues& values) const;

private:
  ControlValues sampleField(const std::vector<Vec3>& points, const Execution& execution) const;
  double etaOfDistance(double distance, const Vec3& gradient, const Vec3& normal) const;
  double etaOfEdges(const Vec3& point, const Vec3& normal) const;
  double stiffnessOfEdges(const Vec3& point, const Vec3& normal) const;

  std::shared_ptr<const ScalarImage> Field;
  FlowOptions Options;
  double EdgeSharpness = 0.0;
  double EdgeBlur = 0.0;
  double NearTarget = 0.0; ///< |d| below which an unsigned field has D = 0
};

} // namespace evolving

#endif
